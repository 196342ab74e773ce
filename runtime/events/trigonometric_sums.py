"""Guaranteed maxima of trigonometric sums.

Inside a configuration a boundary function along the orbit is

    g(t) = a0 + a1 t + sum_j [ c_j cos(w_j t) + s_j sin(w_j t) ].

Closed bounds on its derivatives see to it that nothing hides between two samples. They hold at
all times, so a maximum can be guaranteed too: derived kernels ask for that, and for nothing that
`quasi_polynomials` has beside it; functions along motions with decay are `linear_motions`.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Self, overload

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.guaranteed_maxima import LONGEST_PHASE, CurveSamples, Maximum, largest


@dataclass(frozen=True)
class TrigonometricSum:
    """A boundary function a0 + a1 t + sum_j [c_j cos(w_j t) + s_j sin(w_j t)], nondimensional.

    An `InputError` refuses tuples that differ in length, numbers that are not finite and
    negative frequencies.
    """

    constant: float  # a0
    slope: float  # a1
    cosine: tuple[float, ...]  # amplitudes c_j, (n,)
    sine: tuple[float, ...]  # amplitudes s_j, (n,)
    frequency: tuple[float, ...]  # angular frequencies w_j >= 0, (n,)

    def __post_init__(self) -> None:
        if not len(self.cosine) == len(self.sine) == len(self.frequency):
            raise InputError("cosine, sine and frequency must have equal lengths")
        numbers = (self.constant, self.slope, *self.cosine, *self.sine, *self.frequency)
        if not all(map(math.isfinite, numbers)) or min(self.frequency, default=0.0) < 0:
            raise InputError("the coefficients must be finite, the frequencies also not negative")

    @overload
    def __call__(self, t: float) -> float: ...
    @overload
    def __call__(self, t: NDArray[np.float64]) -> NDArray[np.float64]: ...
    def __call__(self, t: Any) -> Any:
        """Return g(t) for a time or an array of times of any shape."""
        cos, sin = (np.cos, np.sin) if isinstance(t, np.ndarray) else (math.cos, math.sin)
        value = self.constant + self.slope * t
        for c, s, w in self.terms():
            value = value + (c * cos(w * t) + s * sin(w * t))
        return value

    def derivative(self) -> "TrigonometricSum":
        """Return g' as a sum of the same kind."""
        cosine = tuple(s * w for _, s, w in self.terms())
        sine = tuple(-c * w for c, _, w in self.terms())
        return TrigonometricSum(self.slope, 0.0, cosine, sine, self.frequency)

    def raised(self, by: float) -> Self:
        """The function g plus a constant."""
        return replace(self, constant=self.constant + by)

    def rounding(self, duration: float) -> float:
        """The rounding error 32 eps (|a0| + |a1| T + sum (|c| + |s|)(1 + w T)) of g over [0, T].

        T is the duration, nondimensional. Each product may underflow too.
        """
        waves = sum((abs(c) + abs(s)) * (1 + w * duration) for c, s, w in self.terms())
        relative = 2.0**-47 * (abs(self.constant) + abs(self.slope) * duration + waves)
        return relative + (1 + 2 * len(self.frequency)) * math.ulp(0.0)

    def rises(self, noise: float) -> bool:
        """Whether g rises at 0 beyond the error of its slope, where g itself errs by noise."""
        slope = self.slope + sum(s * w for _, s, w in self.terms())
        size = abs(self.slope) + sum((abs(c) + abs(s)) * w for c, s, w in self.terms())
        return slope > 2.0**-47 * size + max(self.frequency, default=0.0) * noise

    @property
    def fastest(self) -> float:
        """Largest angular frequency."""
        return max(self.frequency, default=0.0)

    def maximum(self, duration: float, floor: float = -math.inf) -> Maximum:
        """The guaranteed maximum of g over [0, duration], or the floor.

        That is max(floor, max g) and the time where it is attained; where g stays at or below the
        floor, the floor and NaN. A floor of -inf asks for the global maximum. No value of g
        exceeds it by more than ``rounding(duration)``; the duration is nondimensional. An
        `InputError` refuses NaN, a duration that is negative or longer than 1e5 / max w, and a g
        that overflows.

        Examples
        --------
        >>> TrigonometricSum(0.0, 0.0, (1.0,), (0.0,), (2.0,)).maximum(4.0)
        Maximum(value=1.0, time=0.0)
        """
        cells = 1 + int(_phase(self, duration) / 0.6)
        if math.isnan(floor):
            raise InputError("the floor must be a number, not NaN")
        width = duration / cells
        excess = sum((abs(c) + abs(s)) * (w * width) ** 4 for c, s, w in self.terms()) / 144
        slope = self.derivative()
        curvature = slope.derivative()
        time = np.linspace(0.0, duration, cells + 1)
        return largest(
            CurveSamples(self(time), time, slope(time)),
            np.full(cells, excess),
            lambda _: lambda t: (self(t), slope(t), curvature(t)),
            self.rounding(duration) / 4,
            floor,
        )

    def terms(self) -> Iterator[tuple[float, float, float]]:
        """Amplitudes and frequency (c_j, s_j, w_j) of each term."""
        return zip(self.cosine, self.sine, self.frequency, strict=True)


def _phase(function: TrigonometricSum, duration: float) -> float:
    """Return w T for the largest frequency, or raise where no guarantee can be given."""
    phase = duration * function.fastest
    if not (duration >= 0 and phase <= LONGEST_PHASE and function.rounding(duration) < 1e290):
        raise InputError(f"the duration {duration} is not within 0 and 1e5 / max w, or g overflows")
    return phase
