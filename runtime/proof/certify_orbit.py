"""Certify a periodic orbit: existence, admissibility and stability, proved in ball arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.checker.points import check
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.admissibility import Judgement, Margin
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, region_at
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    GUARD,
    NO_ORBIT,
    Certificate,
    Stated,
    file_json,
)
from nonsmooth.runtime.proof.enclosure import IsolatedOrbit, Missing, locate
from nonsmooth.runtime.proof.orbit_claims import MapClaim, claim_of_map, judged, named_numbers
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    Subject,
    subject_of,
    system_of,
)
from nonsmooth.runtime.proof.parameter_derivatives import (
    ProvedDerivatives,
    asked_parameters,
    derivatives_along,
    directions,
)
from nonsmooth.runtime.proof.parametric_declaration import PERIOD, system_declaration
from nonsmooth.runtime.proof.refusals import accepted, as_file
from nonsmooth.runtime.proof.statement import closing_json, decimals
from nonsmooth.runtime.proof.vanishing import vanishing_along

if TYPE_CHECKING:
    from flint import arb

__all__ = ["FEWEST_BITS", "MOST_BITS", "certify", "stated"]

FEWEST_BITS, MOST_BITS = 53, 400_000
_SLACK = 8  # radii are stated so much larger than they are found
_ENOUGH = 128  # bits that do for admissibility, as a rule
_NOTHING = ProvedDerivatives()


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
    if isinstance(bits, bool) or not isinstance(bits, int) or not FEWEST_BITS <= bits <= MOST_BITS:
        raise InputError(f"bits = {bits!r} is not an integer from {FEWEST_BITS} to {MOST_BITS}")
    by = asked_parameters(orbit, derivatives)
    try:
        subject = subject_of(orbit)
    except NotCovered as reason:
        return _uncovered(orbit, bits, str(reason), by)
    found = _proved(orbit, subject, bits, by, begin)
    begin("check")
    parts = [name for name, verdict in found.claims.items() if verdict != "undecided"]
    parts += ["derivatives"] * bool(found.derivatives)
    parts += ["other_multipliers"] * bool(found.other_multipliers)
    return accepted(found, parts, _without, lambda found: check(as_file(file_json(found))))


def _without(found: Certificate, left: Mapping[str, str]) -> Certificate:
    """Return a certificate without the claims in `left`, each with the reason why.

    Without existence no other claim is left.
    """
    by = (*found.directions, *found.no_derivatives)
    if "existence" in left:
        return replace(
            found,
            claims=dict.fromkeys(CLAIMS, "undecided"),
            stability="stable",
            reasons={"existence": left["existence"]} | dict.fromkeys(CLAIMS[1:], NO_ORBIT),
            enclosures={},
            multipliers=(),
            other_multipliers="",
            margins=(),
            box=(),
            given_period=None,
            declaration={},
            closing={},
            derivatives={},
            directions={},
            no_derivatives=dict.fromkeys(by, NO_ORBIT),
        )
    judged = {name: why for name, why in left.items() if name in CLAIMS}
    found = replace(
        found,
        claims={**found.claims, **dict.fromkeys(judged, "undecided")},
        reasons={**found.reasons, **judged},
    )
    if "admissibility" in left:
        found = replace(found, margins=())
    if "other_multipliers" in left:
        found = replace(found, other_multipliers="")
    if "stability" in left:
        enclosures = {name: x for name, x in found.enclosures.items() if name != "trace"}
        found = replace(found, enclosures=enclosures, multipliers=(), other_multipliers="")
    if "derivatives" in left or "stability" in left:
        why = left.get("derivatives", left.get("stability", ""))
        missing = {**dict.fromkeys(found.directions, why), **found.no_derivatives}
        found = replace(found, derivatives={}, directions={}, no_derivatives=missing)
    return found


def _proved(
    orbit: Orbit,
    subject: Subject,
    bits: int,
    by: Sequence[str],
    begin: Callable[[str], object],
) -> Certificate:
    """Return the certificate of an orbit as it is proved, before the checker sees it."""
    work = bits + GUARD
    with flint_precision(work):
        region = None
        try:
            region = region_at(subject, work)
            _ = region.plans  # divides exactly
            begin("existence")
            root = locate(region, bits)
        except (NotCovered, ZeroDivisionError) as reason:
            return _certificate(subject, region, bits, Missing("undecided", str(reason)), by)
        except Missing as missing:
            return _certificate(subject, region, bits, missing, by)
        begin("stability")
        number = region.tables.number_at()
        stability = claim_of_map(region, number, root.equations, root.linearised.shooting)
        begin("admissibility")
        dwell = root.equations.dwell(root.contraction.image)
        if region.tables.exact and any(len(t.boundaries) > 1 for t in region.cycle.transitions):
            region = _with_vanishing(region, root, dwell)
        judgement = _admissible(region, root, dwell, work)
        found = _NOTHING
        if by:
            begin("derivatives")
            along = directions(orbit, subject.chosen, by)
            found = derivatives_along(region, root, stability.multipliers(region), along)
        return _certificate(subject, region, bits, root, by, stability, judgement, found)


def _with_vanishing(region: Region, root: IsolatedOrbit, dwell: Sequence[arb]) -> Region:
    """Return the region with functions that vanish along this orbit alone, because it closes."""
    closing, start = region.closing, root.linearised.shooting.starts[0].entries()[:-1]
    found = vanishing_along(region.tables, region.cycle, closing.translations, start, dwell)
    return replace(region, closing=replace(closing, vanishing=found))


def _admissible(region: Region, root: IsolatedOrbit, dwell: Sequence[arb], work: int) -> Judgement:
    """Judge whether the orbit is admissible, with few bits first and with all bits if these fail.

    The width of the orbit's own enclosure hardly matters for the inequalities.
    """
    found: Judgement | None = None
    for bits in sorted({min(_ENOUGH, work), work}):
        with flint_precision(bits):
            number = region.tables.number_at()
            found = judged(region, number, region.phases(number), root.linearised.shooting, dwell)
        if found.verdict != "undecided":
            break
    assert found is not None
    return found


def _certificate(
    subject: Subject,
    region: Region | None,
    bits: int,
    root: IsolatedOrbit | Missing,
    by: Sequence[str],
    stability: MapClaim | None = None,
    judgement: Judgement | None = None,
    found: ProvedDerivatives = _NOTHING,
) -> Certificate:
    """Return the certificate with all claims, enclosures and margins by name."""
    claims = dict.fromkeys(CLAIMS, "undecided")
    reasons: dict[str, str] = {}
    enclosures: dict[str, Stated] = {}
    multipliers: tuple[tuple[Stated, Stated], ...] = ()
    others = ""
    margins: tuple[dict[str, Any], ...] = ()
    if isinstance(root, Missing):
        claims["existence"], reasons["existence"] = root.verdict, root.reason
        reasons |= dict.fromkeys(CLAIMS[1:], NO_ORBIT)
        found = ProvedDerivatives(missing=dict.fromkeys(by, NO_ORBIT))
    else:
        assert region is not None
        assert stability is not None
        assert judgement is not None
        claims = dict(zip(CLAIMS, ("proved", judgement.verdict, stability.verdict), strict=True))
        told = zip(CLAIMS[1:], (judgement.reason, stability.reason), strict=True)
        reasons = {name: reason for name, reason in told if reason}
        dwell = root.equations.dwell(root.contraction.image)
        named = named_numbers(
            region, root.equations, root.linearised.shooting, dwell, stability.trace
        )
        enclosures = {name: stated(x, bits, int(name == "trace")) for name, x in named.items()}
        known = stability.multipliers(region)
        multipliers = tuple((stated(m.real, bits, 1), stated(m.imag, bits, 1)) for m in known)
        others = stability.others_below(region, known)
        margins = tuple(_margin(m) for m in judgement.margins)
    declaration: dict[str, Any] = {}
    how: dict[str, Any] = {}
    if region is not None and claims["existence"] != "undecided":
        declaration, how = _statement(region, found)
    return Certificate(
        orbit=subject.label,
        system=subject.kernels.name,
        parameters=subject.values,
        chosen=subject.chosen,
        itinerary=subject.cycle.itinerary,
        claims=claims,
        stability="stable" if region is None or stability is None else region.closing.stability,
        reasons=reasons,
        enclosures=enclosures,
        multipliers=multipliers,
        other_multipliers=others,
        margins=margins,
        box=root.box if declaration else (),
        bits=bits,
        start_names=subject.start_names,
        dwell_names=subject.dwell_names,
        given_period=region.closing.period if region is not None and declaration else None,
        declaration=declaration,
        closing=how,
        derivatives={
            quantity: {name: stated(x, bits, found.size(name)) for name, x in rates.items()}
            for quantity, rates in found.rates.items()
        },
        directions=found.directions,
        no_derivatives=found.missing,
    )


def _statement(region: Region, found: ProvedDerivatives) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return declaration and closing as the file states them.

    They are functions of the parameters of which derivatives are proved, if there are any.
    """
    subject, tables = region.subject, region.tables
    closing = region.closing if found.closing is None else found.closing
    cycle, timed = subject.cycle, closing.kind == "period"
    declared = system_declaration(
        subject.kernels, cycle, tables, subject.start_names, subject.dwell_names, timed=timed
    )
    constants = (value.text for value in tables.constants)
    variables = [*found.moving, *(constants if found.closing is None else found.constants)]
    over = [*declared["parameters"], *declared.get("constants", ())]
    return declared, closing_json(closing, cycle, over, variables, PERIOD)


def stated(ball: arb, bits: int, size: arb | int = 0) -> Stated:
    """Return a stated ball, somewhat wider than a given one.

    The checker computes it anew, with other roundings. `size` is the size of the numbers that the
    ball is computed from, which may be much larger than the ball's own middle.
    """
    from flint import arb

    unit = arb(2) ** -bits
    wide = ball.mid() + arb(0, _SLACK * (ball.rad() + (abs(ball) + size) * unit) + unit * unit)
    return Stated.around(wide, bits)


def _margin(margin: Margin) -> dict[str, Any]:
    text, _ = decimals(margin.least * 0.99, 8)  # rounded down: few digits are enough
    return {
        "phase": margin.phase + 1,  # counted from 1, as in all that is shown
        "configuration": margin.configuration,
        "boundary": margin.boundary,
        "quantity": margin.quantity,
        "least": text,
    }


def _uncovered(orbit: Orbit, bits: int, reason: str, by: Sequence[str]) -> Certificate:
    """Return the undecided certificate of an orbit that the method cannot be applied to."""
    reasons = {CLAIMS[0]: reason} | dict.fromkeys(CLAIMS[1:], NO_ORBIT)
    claims = dict.fromkeys(CLAIMS, "undecided")
    return Certificate(
        orbit=orbit.name,
        system=system_of(orbit),
        parameters=dict(orbit.given),
        chosen=(),
        itinerary=(),
        claims=claims,
        stability="stable",
        reasons=reasons,
        enclosures={},
        multipliers=(),
        other_multipliers="",
        margins=(),
        box=(),
        bits=bits,
        start_names=(),
        dwell_names=(),
        given_period=None,
        declaration={},
        closing={},
        no_derivatives=dict.fromkeys(by, NO_ORBIT),
    )
