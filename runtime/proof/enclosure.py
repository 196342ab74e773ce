"""Where an orbit is: a box that contains exactly one solution of its equations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.checker.exact import exact
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.certificate import Unknown
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.krawczyk import Contraction, krawczyk, newton
from nonsmooth.runtime.proof.orbit_claims import NOT_CONSERVED, conserved
from nonsmooth.runtime.proof.orbit_equations import Equations, Linearised
from nonsmooth.runtime.proof.orbit_to_prove import Subject
from nonsmooth.runtime.proof.statement import decimals

if TYPE_CHECKING:
    from flint import arb

__all__ = ["IsolatedOrbit", "Missing", "locate", "unknown_names"]

_NEAR = 1e-5  # how far from the given numbers an orbit is still theirs, in units of the states
_ROUGH = 53  # bits that do for what nothing depends on
_SHARES = (0.5, 0.7, 0.85)  # of the bits: radii of the boxes that are tried


class IsolatedOrbit(NamedTuple):
    """An orbit that is proved to be the only one in a box, at the working precision."""

    equations: Equations
    contraction: Contraction
    linearised: Linearised  # over the contraction's image
    box: tuple[Unknown, ...]


class Missing(Exception):
    """Existence is not proved: it is "refuted" or "undecided", for a stated reason."""

    def __init__(self, verdict: str, reason: str, box: tuple[Unknown, ...] = ()) -> None:
        super().__init__(reason)
        self.verdict, self.reason, self.box = verdict, reason, box


def locate(region: Region, bits: int) -> IsolatedOrbit:
    """Return an orbit with a box in which it is proved to be the only one.

    The region is one parameter point, and `bits` is the precision of the enclosures, below the
    working precision. If existence is refuted or cannot be proved, `Missing` is raised.
    """
    from flint import arb

    closing, guess, number_at = region.closing, region.guess, region.tables.number_at
    number = number_at()
    equations = region.equations(number)
    with flint_precision(_ROUGH):
        sizes = _sizes(region.equations(number_at()), guess)
    names = unknown_names(region.subject, closing)
    # the box is much wider than this point is exact, and Krawczyk's map finds the rest
    enough = bits // 2 + 16
    point = newton(lambda: region.equations(number_at()), guess, enough)
    if point is None or not all(
        abs(x - g) < _NEAR * size for x, g, size in zip(point, guess, sizes, strict=True)
    ):
        box, centre, radii = _box(names, guess, [_NEAR * size for size in sizes], bits)
        # of a forced orbit one of the equations is a choice: how often the forcing turns
        if not closing.pairs and krawczyk(equations, centre, radii).empty:
            raise Missing("refuted", "no orbit is near the given numbers", box)
        raise Missing("undecided", "Newton's method leaves the given numbers", box)
    for share in _SHARES:
        unit = arb(2) ** -max(24, int(bits * share))
        box, centre, radii = _box(names, point, [unit * size for size in sizes], bits)
        found = krawczyk(equations, centre, radii)
        if found.unique:
            break
    else:
        raise Missing(
            "undecided",
            "Krawczyk's test fails: the equations are singular here, or nearly so, or more bits"
            " are needed",
        )
    linearised = equations.linearised(found.image, found.flows)
    if not conserved(region, number, linearised.shooting):
        raise Missing("undecided", NOT_CONSERVED)
    return IsolatedOrbit(equations, found, linearised, box)


def _sizes(equations: Equations, point: Sequence[arb]) -> list[arb]:
    """Return units of the unknowns: the largest values of states and dwell times along the cycle.

    The changes of a state along the phases count too.
    """
    from flint import arb

    now = equations.linearised(point, equations.near(point)).shooting
    dwell = [abs(t).mid() for t in equations.dwell(point)]
    sizes = []
    for k in equations.free:
        seen = [abs(y[k, 0]) for y in (*now.starts, *now.ends)]
        seen += [abs(f[k, 0] * t) for f, t in zip(now.velocities, dwell, strict=True)]
        size = max((x.mid() for x in seen), key=float)
        sizes.append(size if size > 0 else arb(1))
    longest = max(dwell, key=float)
    if equations.closing.pairs:
        sizes.append(longest)
    return [*sizes, *(longest for _ in dwell)]


def _box(
    names: Sequence[str], centre: Sequence[arb], radii: Sequence[Any], bits: int
) -> tuple[tuple[Unknown, ...], list[arb], list[arb]]:
    """Return a box with decimal middles and radii, and these middles and radii as balls."""
    from flint import arb

    box = tuple(
        Unknown(name, *decimals(arb(x.mid(), r), bits))
        for name, x, r in zip(names, centre, radii, strict=True)
    )
    return box, [arb(exact(x.mid)) for x in box], [arb(exact(x.rad)) for x in box]


def unknown_names(subject: Subject, closing: ClosureConditions) -> list[str]:
    """Return the unknowns' names: free states at the start, the forcing's time, dwell times."""
    free = [name for k, name in enumerate(subject.start_names) if k not in closing.forced]
    return [*free, *(["forcing time"] if closing.pairs else []), *subject.dwell_names]
