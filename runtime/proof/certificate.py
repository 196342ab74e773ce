"""What is proved of an orbit, with enclosures; as JSON everything that is needed to check it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.checker.exact import exact
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.registry import Kept
from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.model.saved_system import SAVED_VERSION
from nonsmooth.runtime.proof.motion.motion_proof import Enclosure
from nonsmooth.runtime.proof.statement import decimals

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "CLAIMS",
    "FORMAT",
    "GUARD",
    "VERSION",
    "Certificate",
    "Stated",
    "Unknown",
    "balls_json",
    "file_json",
    "orbit_json",
]

FORMAT = "nonsmooth certificate"
VERSION = 3 + SAVED_VERSION
GUARD = 32  # bits beyond those of the enclosures
NO_ORBIT = "no orbit is proved to exist"  # why there are no other claims
CLAIMS = ("existence", "admissibility", "stability")


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
        from flint import arb

        with flint_precision(2 * bits + 64):
            ball = arb(exact(middle)) + arb(0, arb(exact(radius)))
        return Stated(ball, bits, (middle, radius))

    @staticmethod
    def around(ball: arb, bits: int, digits: int = 3) -> Stated:
        """Return a stated ball, a bit wider than a given one, whose radius has `digits` digits."""
        return Stated.of(*decimals(ball, bits, digits), bits)

    def _decimals(self) -> tuple[str, str]:
        return self.texts


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Certificate(Kept):
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
    start_names, dwell_names : tuple of str
        Of the enclosures.
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

    _kept_by = "save_certificate"

    orbit: str
    system: str
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: tuple[tuple[str, str], ...]
    claims: Mapping[str, str]
    stability: str
    reasons: Mapping[str, str]
    enclosures: Mapping[str, Stated]
    multipliers: tuple[tuple[Stated, Stated], ...]
    other_multipliers: str
    margins: tuple[Mapping[str, Any], ...]
    box: tuple[Unknown, ...]
    bits: int
    start_names: tuple[str, ...]
    dwell_names: tuple[str, ...]
    given_period: Value | None
    declaration: Mapping[str, Any] = field(repr=False)
    closing: Mapping[str, Any] = field(repr=False)
    derivatives: Mapping[str, Mapping[str, Stated]] = field(default_factory=dict)
    directions: Mapping[str, Mapping[str, Fraction]] = field(default_factory=dict)
    no_derivatives: Mapping[str, str] = field(default_factory=dict)

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

    def to_json(self) -> dict[str, Any]:
        """Give the certificate as JSON: numbers as decimal strings or fractions.

        Returns
        -------
        dict
            The certificate, ready for `json.dumps`.
        """
        told: dict[str, Any] = {}
        if self.derivatives:
            of = self.derivatives
            told["derivatives"] = {name: balls_json(rates) for name, rates in of.items()}
            told["directions"] = {
                name: {parameter: str(rate) for parameter, rate in direction.items()}
                for name, direction in self.directions.items()
            }
        if self.no_derivatives:
            told["no_derivatives"] = dict(self.no_derivatives)
        return {
            **orbit_json(self),
            "chosen": list(self.chosen),
            "given_period": "" if self.given_period is None else self.given_period.text,
            "bits": self.bits,
            "claims": dict(self.claims),
            "stability": self.stability,
            "reasons": dict(self.reasons),
            "enclosures": balls_json(self.enclosures),
            "multipliers": [
                {"re": re.to_json(), "im": im.to_json()} for re, im in self.multipliers
            ],
            "other_multipliers": self.other_multipliers,
            "margins": [dict(margin) for margin in self.margins],
            "box": [asdict(x) for x in self.box],
            **told,
        }


def file_json(found: Any) -> dict[str, Any]:
    """Return a result's JSON with the declaration of its system and its closing.

    `found` is a `Certificate`, `BoxCertificate`, `CertifiedBranch` or `EventCertificate`.
    """
    own = {"declaration": dict(found.declaration), "closing": dict(found.closing)}
    return {**found.to_json(), "tables": None, **own}


def orbit_json(found: Any) -> dict[str, Any]:
    """Return the JSON that names an orbit: orbit, system, parameters as texts, and itinerary.

    `found` is a `Certificate`, `BoxCertificate`, `Census` or `EventCertificate`.
    """
    return {
        "orbit": found.orbit,
        "system": found.system,
        "parameters": {name: value.text for name, value in found.parameters.items()},
        "itinerary": [list(phase) for phase in found.itinerary],
    }


def balls_json(enclosures: Mapping[str, Enclosure]) -> dict[str, dict[str, str]]:
    """Return enclosures by name as decimal texts "mid" and "rad"."""
    return {name: enclosure.to_json() for name, enclosure in enclosures.items()}
