"""Certify a periodic orbit: propose where it is, and state what the checker proves of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, replace
from fractions import Fraction
from typing import Any

from flint import arb

from nonsmooth.runtime.checker.orbits.motion import Margin
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.core.errors import check_integer
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.proof.boxes.orbit_over_box import region_at
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    GUARD,
    NO_ORBIT,
    Certificate,
    Stated,
)
from nonsmooth.runtime.proof.exact_tables import Row
from nonsmooth.runtime.proof.orbit_proposal import (
    asked_parameters,
    boxes,
    directions,
    nearly_vanishing,
    proposed,
)
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered, subject_near
from nonsmooth.runtime.proof.statement import decimals

__all__ = ["FEWEST_BITS", "MOST_BITS", "certify", "stated"]

FEWEST_BITS, MOST_BITS = 53, 400_000
_SLACK = 8  # radii are stated so much larger than they are found
_LEAST_OTHER = 1e-6  # less is not told apart from zero
_SHARE = 24  # bits


def certify(
    orbit: Orbit,
    bits: int = 128,
    *,
    derivatives: Sequence[str] | str | bool | None = None,
    begin: Callable[[str], object] = lambda step: None,
) -> Certificate:
    """Prove that there is an orbit near a computed one, that it is a motion, and its stability.

    Nothing is taken from how the orbit was computed: its full cycle is composed again in
    physical coordinates from the system's fields, boundaries and resets, with the parameters
    exactly as they were given. The existence claimed is that of one orbit in the stated box,
    which lies within 1e-5 of the numbers given, in units of the states' sizes.

    Parameters
    ----------
    orbit : Orbit
        A converged one.
    bits : int
        The enclosures have about so many bits.
    derivatives : sequence of str, str or bool, optional
        Enclose the derivatives of start, dwell times, period, trace and multipliers by these
        numbers that were given for the orbit, the others kept; True for all of them.
    begin : function of a text, optional
        Is told which step begins.

    Returns
    -------
    Certificate

    Raises
    ------
    InputError
        For an orbit that has not converged, bits outside 53 ... 400000, or derivatives by
        what was not given.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> certificate = ns.certify(ns.solve("dry-friction/global-stick"))
    >>> certificate.proved, certificate.trace.contains("0.5")
    (True, False)
    >>> orbit = ns.solve("dry-friction/global-stick")
    >>> rates = ns.certify(orbit, derivatives="eta").derivatives
    >>> round(float(rates["trace"]["eta"]), 12)
    0.027461473206
    """
    check_integer("bits", bits, FEWEST_BITS, MOST_BITS)
    check_converged(orbit, "certified")
    by = asked_parameters(orbit, derivatives)
    undecided = _undecided(orbit, bits, by)
    try:
        subject = subject_near(orbit)
        undecided = replace(
            undecided,
            parameters=subject.values,
            chosen=subject.chosen,
            itinerary=subject.cycle.itinerary,
        )
        with flint_precision(bits + GUARD):
            region = region_at(subject, bits + GUARD)
            proposal, missing = proposed(region, bits, directions(orbit, subject.chosen, by))
            begin("existence")
            found = JudgedOrbit(proposal)
            for box in () if found.existence.reason else boxes(found, region.guess):
                if found.locate([asdict(side) for side in box]).claim != "undecided":
                    break
            if found.existence.claim == "undecided":
                return _because(undecided, found.existence.reason)
            if region.tables.exact and not found.declared.alone:
                begin("admissibility")
                found = _with_vanishing(found, nearly_vanishing(region))
    except NotCovered as reason:
        return _because(undecided, str(reason))
    except ZeroDivisionError as problem:
        return _because(undecided, f"its numbers cannot be enclosed: {problem}")
    undecided = replace(
        undecided,
        stability=found.kind,
        box=box,
        given_period=subject.period if proposal["given_period"] else None,
        declaration=proposal["declaration"],
        closing=found.proposal["closing"],
    )
    if found.existence.claim == "refuted":
        undecided = replace(undecided, claims={**undecided.claims, CLAIMS[0]: "refuted"})
        return _because(undecided, found.existence.reason)
    return _stated(undecided, found, missing, begin)


def _with_vanishing(found: JudgedOrbit, rows: Sequence[Row]) -> JudgedOrbit:
    """Return what is proved with functions that may vanish along the orbit, where that decides.

    It concerns the admissibility of orbits that reach several boundaries at one instant.
    """
    if not rows or found.existence.claim != "proved" or found.admissibility.claim != "undecided":
        return found
    closing = found.proposal["closing"] | {"vanishing": [[*map(str, row)] for row in rows]}
    other = JudgedOrbit(found.proposal | {"closing": closing})
    return found if other.admissibility.claim == "undecided" else other


def _stated(
    about: Certificate,
    found: JudgedOrbit,
    missing: Mapping[str, str],
    begin: Callable[[str], object],
) -> Certificate:
    """Return the certificate of an orbit that exists, with all that is found of it.

    `missing` says by which numbers no derivative was proposed, and why.
    """
    bits, along = about.bits, found.proposal["directions"]
    with flint_precision(bits + GUARD):
        begin("stability")
        stability, multipliers, below = found.stability, found.multipliers, found.others_below
        begin("admissibility")
        admissibility = found.admissibility
        if along:
            begin("derivatives")
        rates = {name: told.found for name, told in found.derivatives.items() if told.found}
        left = {name: told.reason for name, told in found.derivatives.items() if not told.found}
        names = [name for name in ("trace", "period", *about.dwell_names, *about.start_names)
                 if name in found.enclosures]  # fmt: skip
        derivatives: dict[str, dict[str, Stated]] = {}
        for name, own in rates.items():
            share = _share_of_largest(own)
            for quantity in dict.fromkeys([*names, *own]):
                ball = stated(own[quantity], bits, share)
                derivatives.setdefault(quantity, {})[name] = ball
        verdicts = dict(zip(CLAIMS, (found.existence, admissibility, stability), strict=True))
        known = below is not None and below.is_finite()
        return replace(
            about,
            claims={name: verdict.claim for name, verdict in verdicts.items()},
            reasons={name: verdict.reason for name, verdict in verdicts.items() if verdict.reason},
            enclosures={
                name: stated(found.enclosures[name], bits, int(name == "trace")) for name in names
            },
            multipliers=tuple(
                (stated(m.real, bits, 1), stated(m.imag, bits, 1)) for m in multipliers
            ),
            other_multipliers=f"{max(2 * float(below), _LEAST_OTHER):.1e}" if known else "",
            margins=tuple(map(_margin, admissibility.found)),
            derivatives=derivatives,
            directions={
                name: {parameter: Fraction(rate) for parameter, rate in along[name].items()}
                for name in rates
            },
            no_derivatives={**missing, **left},
        )


def _share_of_largest(rates: Mapping[str, arb]) -> arb:
    """Return a small share of the largest derivative by a number.

    Derivatives that are zero are computed from numbers of such a size.
    """
    return max((abs(rate).mid() for rate in rates.values()), key=float) * arb(2) ** -_SHARE


def stated(ball: arb, bits: int, size: arb | int = 0) -> Stated:
    """Return a stated ball, somewhat wider than a given one.

    Another version of the arithmetic may round otherwise. `size` is the size of the numbers that
    the ball is computed from, which may be much larger than the ball's own middle.
    """
    unit = arb(2) ** -bits
    wide = ball.mid() + arb(0, _SLACK * (ball.rad() + (abs(ball) + size) * unit) + unit * unit)
    return Stated.around(wide, bits)


def _margin(margin: Margin) -> dict[str, Any]:
    text, _ = decimals(margin.least * 0.99, 8)  # rounded down: few digits are enough
    told = margin._asdict()
    return told | {"phase": margin.phase + 1, "least": text}  # as in all that is shown


def _undecided(orbit: Orbit, bits: int, by: Sequence[str]) -> Certificate:
    """Return the certificate of an orbit of which nothing is proved."""
    return Certificate(
        orbit=orbit.name,
        system=orbit.system.name,
        parameters=dict(orbit.given),
        chosen=(),
        itinerary=(),
        claims=dict.fromkeys(CLAIMS, "undecided"),
        stability="stable",
        reasons={},
        enclosures={},
        multipliers=(),
        other_multipliers="",
        margins=(),
        box=(),
        bits=bits,
        given_period=None,
        declaration={},
        closing={},
        no_derivatives=dict.fromkeys(by, NO_ORBIT),
    )


def _because(undecided: Certificate, reason: str) -> Certificate:
    """Return the certificate with the reason why no orbit is proved to exist."""
    reasons = {CLAIMS[0]: reason} | dict.fromkeys(CLAIMS[1:], NO_ORBIT)
    return replace(undecided, reasons=reasons)
