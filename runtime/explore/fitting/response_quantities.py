"""What is measured of a steady response: peaks, amplitudes, averages and the first harmonic.

Extremes are guaranteed, and differentiated where they are attained.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.explore.fitting.affine_outputs import Output, output_of
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives

__all__ = ["KINDS", "ResponseQuantity", "response_quantity"]


class ResponseQuantity(NamedTuple):
    """A number that is measured of a steady response."""

    kind: str  # a key of `KINDS`
    output: Output
    text: str  # as it was written

    @property
    def periodic(self) -> bool:
        """Whether it is an angle, which is the same after a full turn."""
        return self.kind == "phase"

    def of(self, derivatives: OrbitDerivatives) -> tuple[float, np.ndarray]:
        """Its value along an orbit (by tables), and its derivatives (q,).

        Raises `InputError` if there is no derivative.
        """
        value, rates = KINDS[self.kind](derivatives.along, self.output, self.text)
        return float(value), rates


def response_quantity(text: str, structure: Structure) -> ResponseQuantity:
    """A quantity of a steady response, from its text ``KIND:OUTPUT``.

    KIND is a key of `KINDS` and OUTPUT an affine function of states, accelerations and forces,
    such as ``amplitude:x1 - x2`` or ``rms:acceleration:x``. Refused are an unknown kind, a
    function that is not affine, and a first harmonic without a forcing.
    """
    kind, colon, output = (part.strip() for part in text.partition(":"))
    if not colon or not output:
        raise InputError(f"response {text!r} is not KIND:OUTPUT; kinds are {', '.join(KINDS)}")
    if kind not in KINDS:
        raise unknown_name("kind of response", kind, KINDS)
    if kind in _OF_FORCING and not structure.forcing:
        raise InputError(
            f"response {text!r} belongs to a forcing, which {shown_name(structure.name)} has not"
        )
    return ResponseQuantity(kind, output_of(output, structure), text)


Value = tuple[float, np.ndarray]


def _row(along: OrbitMotionDerivatives, output: Output) -> np.ndarray:
    """The output (q, configurations, N + 1), with complex steps."""
    return output.in_configurations(along.structure, along.numbers.fields, along.numbers.rows)


def _maximum(along: OrbitMotionDerivatives, output: Output, _: str) -> Value:
    return along.extremes(_row(along, output))[0][:2]


def _minimum(along: OrbitMotionDerivatives, output: Output, _: str) -> Value:
    return along.extremes(_row(along, output))[1][:2]


def _peak(along: OrbitMotionDerivatives, output: Output, text: str) -> Value:
    return along.peak(_row(along, output), text)[:2]


def _amplitude(along: OrbitMotionDerivatives, output: Output, _: str) -> Value:
    high, low = along.extremes(_row(along, output))
    return (high.value - low.value) / 2, (high.rates - low.rates) / 2


def _mean(along: OrbitMotionDerivatives, output: Output, _: str) -> Value:
    return _parts(_averages(along, output)[0])


def _rms(along: OrbitMotionDerivatives, output: Output, text: str) -> Value:
    square = _averages(along, output)[1]
    if not square[0].real > 0:
        raise InputError(f"{text} is zero: it has no derivative")
    return _parts(np.sqrt(square))


def _harmonic(along: OrbitMotionDerivatives, output: Output, text: str) -> Value:
    _, _, cosine, sine = _averages(along, output)
    square = 4 * (cosine**2 + sine**2)
    if not square[0].real > 0:
        raise InputError(f"{text} is zero: it has no derivative")
    return _parts(np.sqrt(square))


def _phase(along: OrbitMotionDerivatives, output: Output, text: str) -> Value:
    _, _, cosine, sine = _averages(along, output)
    (c, by_c), (s, by_s) = _parts(cosine), _parts(sine)
    square = c**2 + s**2
    if not square > 0:
        raise InputError(f"{text}: there is no first harmonic")
    return float(np.arctan2(-s, c)), (s * by_c - c * by_s) / square


def _parts(number: np.ndarray) -> Value:
    return float(number[0].real), imaginary_parts(number, None)


def _averages(along: OrbitMotionDerivatives, output: Output) -> np.ndarray:
    """Averages (4, q) of f, f^2, f cos and f sin, with complex steps.

    The angle is that of the first forcing; without one there are zeros.
    """
    row, forcing = _row(along, output)[:, :, None], along.structure.forcing
    units = np.eye(row.shape[-1])[list(forcing[0] if forcing else ())]
    angles = np.broadcast_to(units, (*row.shape[:2], *units.shape))
    moments = along.moved.moments(np.concatenate([row, angles], axis=2))[:, 0]
    parts = [moments[:, -1], moments[:, 0], *moments[:, 1:-1].T]
    parts += [0 * parts[0]] * (4 - len(parts))
    period = stepped(float(along.period), along.moved.rates[1, :, -1], None)
    return np.asarray(np.array(parts) / period)


_OF_FORCING = ("harmonic", "phase")
KINDS: Mapping[str, Callable[[OrbitMotionDerivatives, Output, str], Value]] = {
    "maximum": _maximum,
    "minimum": _minimum,
    "peak": _peak,
    "amplitude": _amplitude,
    "mean": _mean,
    "rms": _rms,
    "harmonic": _harmonic,
    "phase": _phase,
}
