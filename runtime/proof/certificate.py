"""What is proved of an orbit or a motion, with enclosures; as JSON all that a check needs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.stated.exact import Entries, exact
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import (
    IN_FILES,
    BlankExact,
    BlankValue,
    Codec,
    Exact,
    Inconsistent,
    by,
    named_as,
    one_of,
    stated,
)
from nonsmooth.runtime.core.registry import Certified, Shown
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import LARGEST_EXPONENT, Value, as_value, flint_precision
from nonsmooth.runtime.model.saved_system import KeptOrbitName
from nonsmooth.runtime.proof.statement import decimals, scientific

if TYPE_CHECKING:
    from flint import arb


@dataclass(frozen=True, eq=False)
class Enclosure:
    """A real number between two others.

    Attributes
    ----------
    ball : flint.arb
    bits : int
        Precision at which it was computed.

    Examples
    --------
    >>> from flint import arb
    >>> third = Enclosure(arb(1) / 3, 53)
    >>> third.mid[:8], float(third.rad) < 1e-15, third.contains("1/3")
    ('3.333333', True, True)
    """

    ball: arb
    bits: int

    @property
    def mid(self) -> str:
        """Middle, in decimal: the number differs from it by at most `rad`."""
        return self._decimals()[0]

    @property
    def rad(self) -> str:
        """Radius, in decimal, rounded up."""
        return self._decimals()[1]

    def to_json(self) -> dict[str, str]:
        """Give both decimal texts.

        Returns
        -------
        dict of str to str
            "mid" and "rad".
        """
        return {"mid": self.mid, "rad": self.rad}

    @property
    def lower(self) -> float:
        """A double below the number."""
        return _outward(self.ball.lower(), -math.inf)

    @property
    def upper(self) -> float:
        """A double above the number."""
        return _outward(self.ball.upper(), math.inf)

    def __float__(self) -> float:
        return float(self.ball.mid())

    def __str__(self) -> str:
        """Give the digits that are certain, and the radius."""
        return str(self.ball.str(max(5, int(self.bits * 0.302))))

    def contains(self, number: object) -> bool:
        """Whether a number lies inside; text and fractions exactly, floats too.

        Parameters
        ----------
        number : arb, str, Fraction, int or float
            Not rounded.

        Returns
        -------
        bool
            True if that is certain.
        """
        from flint import arb

        if isinstance(number, arb):
            return bool(self.ball.contains(number))
        with flint_precision(2 * self.bits + 64):
            return bool(self.ball.contains(exactly(number, "a number")))

    def _decimals(self) -> tuple[str, str]:
        digits = max(5, int(self.bits * 0.302))
        middle, radius, exponent = self.ball.mid_rad_10exp(digits)
        return scientific(middle, int(exponent), "+d"), scientific(radius, int(exponent), "+d")


def _outward(end: arb, towards: float) -> float:
    return float(np.nextafter(float(end.mid()), towards))


@dataclass(frozen=True, eq=False, repr=False)
class Proof(Shown):
    """What is proved of one motion.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
    configurations : tuple of str
        The start's, and the one behind each proved transition.
    sets : tuple of tuple of str
        Boundaries reached at each transition: one entry fewer.
    times : tuple of Enclosure
        0, and the time of each transition.
    states : tuple of tuple of Enclosure
        The start, and the state behind each transition.
    decided : bool
        All that was asked for is proved: so many transitions, or that no further one
        follows.
    reason : str or None
        Why there are fewer transitions; None if there are not.
    instant : Enclosure or None
        When the motion cannot be decided; before it everything is proved.
    bits : int
        The precision that was needed.
    """

    system: str
    parameters: dict[str, Value]
    configurations: tuple[str, ...]
    sets: tuple[tuple[str, ...], ...]
    times: tuple[Enclosure, ...]
    states: tuple[tuple[Enclosure, ...], ...]
    decided: bool
    reason: str | None
    instant: Enclosure | None
    bits: int

    @property
    def phase(self) -> int:
        """The last phase, counted from 0: the one that cannot be decided, if any."""
        return len(self.configurations) - 1

    @property
    def transitions(self) -> int:
        """How many transitions are proved."""
        return len(self.sets)


def exactly(number: object, name: str) -> Any:
    """Return the rational number that a text, fraction or float stands for, without rounding.

    Any other number is refused; `name` is that of the number in the message.
    """
    from flint import fmpq

    if isinstance(number, float) and math.isfinite(number):
        number = Fraction(float(number))
    exact = as_value(number).exact
    if exact is None:
        raise InputError(f"{name} = {number} is not rational")
    return fmpq(exact.numerator, exact.denominator)


GUARD = 32  # bits beyond those of the enclosures
NO_ORBIT = "no orbit is proved to exist"  # why there are no other claims
CLAIMS = ("existence", "admissibility", "stability")


Verdict = Annotated[str, one_of(("proved", "refuted", "undecided"))]
Decided = Annotated[str, one_of(("proved", "undecided"))]
Stability = Annotated[str, one_of(("stable", "neutral"))]
Claims = Annotated[Mapping[str, str], named_as(CLAIMS, Verdict)]


def _declaration(entry: Any) -> Any:
    """A declaration as read; `InputError` for exponents that are too large to compute with."""
    if type(entry) is not dict:
        raise InputError("it is no object")
    if not all(abs(number) <= LARGEST_EXPONENT for number in _integers(entry)):
        raise Inconsistent(f" holds an exponent beyond {LARGEST_EXPONENT}")
    return entry


def _integers(entry: Any) -> Iterator[int]:
    """Yield all integers of a declaration: exponents and places; other numbers are texts."""
    parts = entry.values() if isinstance(entry, Mapping) else entry
    for part in parts if isinstance(entry, Mapping | list) else ():
        yield from _integers(part)
    if isinstance(entry, int):
        yield entry


# the system as functions of its parameters, or how a cycle closes; the checker knows what is in it
Declaration = Annotated[Mapping[str, Any], Codec(dict, _declaration, {"type": "object"}), IN_FILES]


@dataclass(frozen=True, eq=False)
class Unknown:
    """One side of the box in which the orbit is unique: decimal texts, exactly."""

    name: str
    mid: Exact
    rad: Exact


@dataclass(frozen=True, eq=False)
class Stated(Enclosure):
    """An enclosure with the decimal texts of middle and radius by which a file states it."""

    texts: tuple[str, str]

    @staticmethod
    def of(middle: str, radius: str, bits: int) -> Stated:
        """Return a ball that contains what two decimal texts, middle and radius, state exactly."""
        with flint_precision(2 * bits + 64):
            ball = arb(exact(middle)) + arb(0, arb(exact(radius)))
        return Stated(ball, bits, (middle, radius))

    @staticmethod
    def around(ball: arb, bits: int, digits: int = 3) -> Stated:
        """Return a stated ball, a bit wider than a given one, whose radius has `digits` digits."""
        return Stated.of(*decimals(ball, bits, digits), bits)

    def _decimals(self) -> tuple[str, str]:
        return self.texts


@dataclass(frozen=True, kw_only=True)
class Ball:
    """An enclosure as decimal texts, which state it exactly."""

    mid: Exact
    rad: Exact


def ball_of(bits: int) -> Codec:
    """The way to write and read balls, as precise as so many bits; of 0 as their record says."""
    return by(
        Ball,
        lambda own: Ball(mid=own.mid, rad=own.rad),
        lambda found: Stated.of(found.mid, found.rad, bits),
    )


def precise(found: Any, bits: int) -> Any:
    """Balls of a file, in tuples and by names, as precise as `bits` where they are not yet."""
    match found:
        case Stated(bits=0):
            return Stated.of(*found.texts, bits)
        case Mapping():
            return {name: precise(each, bits) for name, each in found.items()}
        case tuple():
            return tuple(precise(each, bits) for each in found)
    return found


KeptBall = Annotated[Stated, ball_of(0)]
Enclosures = Mapping[str, KeptBall]


@dataclass(frozen=True, kw_only=True)
class MultiplierBalls:
    """Enclosures of the real and imaginary part of a multiplier."""

    re: KeptBall
    im: KeptBall


@dataclass(frozen=True, kw_only=True)
class MarginEntries:
    """How clearly a boundary is respected, with phases counted from 1."""

    phase: int
    configuration: str
    boundary: str
    quantity: Annotated[str, one_of(("distance", "departure", "speed"))]
    least: Exact


Multiplier = Annotated[
    tuple[Stated, Stated],
    by(
        MultiplierBalls,
        lambda parts: MultiplierBalls(re=parts[0], im=parts[1]),
        lambda found: (found.re, found.im),
    ),
]
Margin = Annotated[Mapping[str, Any], by(MarginEntries, lambda told: MarginEntries(**told), vars)]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class StatedOrbits(Certified):
    """A record of orbits of one itinerary, with all that their equations are made from.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All that is given, exactly.
    chosen : tuple of str
        Those that the orbit leaves open and that were chosen.
    itinerary : tuple of (configuration, boundary)
    declaration, closing : dict
        The system, as functions of its parameters, and the way in which the cycle closes, as
        in the file; empty where nothing is claimed.
    """

    orbit: KeptOrbitName
    system: str
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: tuple[tuple[str, str], ...]
    declaration: Declaration = field(repr=False)
    closing: Declaration = field(repr=False)


def check_same_orbits(asked: StatedOrbits, known: StatedOrbits, *names: str) -> None:
    """Refuse to go on with a state of other orbits, or over another range.

    `names` are those of attributes that say which range it is.
    """
    told = ("orbit", "itinerary", *names, "chosen", *asked.parameters, "declaration", "closing")
    # a file calls the system by its data, and holds it
    wanted, found = (
        {**vars(each), **each.parameters, "orbit": each.orbit.removeprefix(each.system)}
        for each in (asked, known)
    )
    check_same_question("state", {name: wanted[name] for name in told}, found)


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Certificate(StatedOrbits):
    """What ball arithmetic proves of one orbit at one parameter point.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All physical parameters of the system, exactly.
    chosen : tuple of str
        Those among them that the orbit leaves open: the certificate is for these values.
    itinerary : tuple of (configuration, boundary)
    claims : dict of str to {"proved", "refuted", "undecided"}
        "existence": the box contains exactly one orbit of the itinerary's equations.
        "admissibility": that is a motion of the real system. "stability": it is what
        `stability` says.
    stability : {"stable", "neutral"}
        What is claimed: every multiplier strictly inside the unit circle, or, of a
        conservative orbit, every nontrivial one on it, and none of them twice.
    reasons : dict of str to str
        Why a claim is not proved.
    enclosures : dict of str to Stated
        Trace, period, dwell times, and the physical state at the start.
    multipliers : tuple of (Stated, Stated)
        Real and imaginary part of each nontrivial one that is clearly apart from the others
        and from zero.
    other_multipliers : str
        What no other nontrivial one exceeds in absolute value: 1e-6 where all that are not zero
        are listed, empty where nothing is known of them.
    margins : tuple of dict
        How clearly boundaries are respected: phase, configuration, boundary, quantity
        ("distance", "departure" or "speed") and what it is at least. Those that are not listed
        are respected too where admissibility is proved.
    box : tuple of Unknown
        Where the orbit is unique.
    bits : int
    given_period : Value or None
        What the dwell times sum up to, where a conservative orbit's was given.
    declaration, closing : dict
        The system, as functions of its parameters, and the way in which the cycle closes, as
        in the file; empty where nothing is claimed.
    derivatives : dict of str to dict of str to Stated
        Of each quantity that is enclosed, by each parameter that was asked for.
    directions : dict of str to dict of str to Fraction
        How the system's parameters, and the "period", move with each of these: e1 = ur1 - us1
        moves ur1 where us1 was chosen.
    no_derivatives : dict of str to str
        By which of those that were asked for there is no derivative, and why.
    """

    claims: Claims
    stability: Stability
    reasons: Mapping[str, str]
    enclosures: Enclosures
    multipliers: tuple[Multiplier, ...]
    other_multipliers: BlankExact
    margins: tuple[Margin, ...]
    box: tuple[Unknown, ...]
    bits: int
    given_period: BlankValue
    derivatives: Mapping[str, Enclosures] = field(default_factory=dict)
    directions: Mapping[str, Mapping[str, Fraction]] = field(default_factory=dict)
    no_derivatives: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("enclosures", "multipliers", "derivatives"):
            object.__setattr__(self, name, precise(getattr(self, name), self.bits))

    @property
    def start_names(self) -> tuple[str, ...]:
        """Names of the physical states at the start; none where nothing is claimed."""
        return tuple(self.declaration.get("start", ()))

    @property
    def dwell_names(self) -> tuple[str, ...]:
        """Names of the dwell times; none where nothing is claimed."""
        return tuple(phase["dwell_time"] for phase in self.declaration.get("phases", ()))

    @property
    def proved(self) -> bool:
        """Whether all claims are proved."""
        return set(self.claims.values()) == {"proved"}

    @property
    def decided(self) -> bool:
        """Whether no claim is undecided, for another reason than that another one is refuted."""
        return self.claims["existence"] == "refuted" or "undecided" not in self.claims.values()

    @property
    def trace(self) -> Stated:
        """Enclosure of the trace of the Poincare map's Jacobian.

        Raises
        ------
        InputError
            If no orbit is proved to exist, or a boundary may be reached tangentially.
        """
        if "trace" not in self.enclosures:
            name = "stability" if self.claims["existence"] == "proved" else "existence"
            told = f"{name} is {self.claims[name]}: {self.reasons[name]}"
            raise InputError(f"{self.orbit} has no trace that is enclosed: {told}")
        return self.enclosures["trace"]


def file_json(found: Any) -> Entries:
    """Return a proof of orbits as its file has it, but for the system's data and name there."""
    return {**stated(found), "tables": None}
