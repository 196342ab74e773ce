"""Certify a periodic orbit: existence, admissibility and stability, proved in ball arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.admissibility import Judgement, Margin, judge
from nonsmooth.runtime.proof.admissibility_conditions import plan_of
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    GUARD,
    NO_ORBIT,
    Certificate,
    Stated,
)
from nonsmooth.runtime.proof.closure import Closing
from nonsmooth.runtime.proof.cycle_equations import phases_of
from nonsmooth.runtime.proof.enclosure import Missing, Root, locate
from nonsmooth.runtime.proof.exact_tables import Tables, exact_tables
from nonsmooth.runtime.proof.invariants import Known, known_of
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.proof.multipliers import (
    CORNER,
    apart,
    eigenvalues_of,
    inside_circle,
    neutral_pairs,
    product_of,
    reduced_map,
    trace_of,
)
from nonsmooth.runtime.proof.orbit_cycle import (
    NotCovered,
    Subject,
    closing_of,
    subject_of,
    system_of,
)
from nonsmooth.runtime.proof.parametric_declaration import PERIOD, system_declaration
from nonsmooth.runtime.proof.statement import closing_json, decimals
from nonsmooth.runtime.proof.vanishing import vanishing_along

if TYPE_CHECKING:
    from flint import acb, arb

__all__ = ["FEWEST_BITS", "MOST_BITS", "certify", "stated"]

FEWEST_BITS, MOST_BITS = 53, 400_000
_SLACK = 8  # radii are stated so much larger than they are found
_ENOUGH = 128  # bits that do for admissibility, as a rule


def certify(
    orbit: Orbit | ComposedOrbit,
    bits: int = 128,
    *,
    begin: Callable[[str], object] = lambda step: None,
) -> Certificate:
    """Prove that there is an orbit near a computed one, that it is a motion, and its stability.

    Nothing is taken from how the orbit was computed: its full cycle is composed again in
    physical coordinates from the system's fields, boundaries and resets, with the parameters
    exactly as they were given. The existence claimed is that of one orbit in the stated box,
    which lies within 1e-5 of the numbers given, in units of the states' sizes.

    Parameters
    ----------
    orbit : Orbit or ComposedOrbit
        A converged one.
    bits : int
        The enclosures have about so many bits.
    begin : function of a text, optional
        Is told which step begins.

    Returns
    -------
    Certificate

    Raises
    ------
    InputError
        For an orbit that has not converged, or bits outside 53 ... 400000.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> certificate = ns.certify(ns.solve("dry-friction/global-stick"))
    >>> certificate.proved, certificate.trace.contains("0.5")
    (True, False)
    """
    if isinstance(bits, bool) or not isinstance(bits, int) or not FEWEST_BITS <= bits <= MOST_BITS:
        raise InputError(f"bits = {bits!r} is not an integer from {FEWEST_BITS} to {MOST_BITS}")
    try:
        subject = subject_of(orbit)
    except NotCovered as reason:
        return _uncovered(orbit, bits, str(reason))
    work = bits + GUARD
    with flint_precision(work):
        tables = exact_tables(subject.kernels, tuple(subject.values.values()), work)
        closing = Closing("state")
        try:
            closing = closing_of(subject, tables, [float(x) for x in subject.start])
            shifts = closing.translations
            known = known_of(tables, subject.cycle, shifts) if tables.exact else None
            begin("existence")
            root = locate(subject, closing, bits)
        except (NotCovered, ZeroDivisionError) as reason:
            missing = Missing("undecided", str(reason))
            return _certificate(subject, tables, closing, bits, missing)
        except Missing as missing:
            return _certificate(subject, tables, closing, bits, missing)
        begin("stability")
        stability = stability_of(subject, tables, closing, known, root)
        begin("admissibility")
        if known is not None and any(len(t.boundaries) > 1 for t in subject.cycle.transitions):
            start = root.linearised.shooting.starts[0].entries()[:-1]
            dwell = root.equations.dwell(root.contraction.image)
            zero = vanishing_along(tables, subject.cycle, shifts, start, dwell)
            closing = replace(closing, vanishing=zero)
            known = known_of(tables, subject.cycle, shifts, zero)
        judgement = _admissible(subject, tables, shifts, known, root, work)
        return _certificate(subject, tables, closing, bits, root, stability, judgement)


class Stability(NamedTuple):
    """What is claimed of the multipliers, the verdict and its reason, trace and multipliers."""

    claim: str
    verdict: str
    reason: str
    trace: arb | None
    multipliers: tuple[acb, ...]


def stability_of(
    subject: Subject, tables: Tables, closing: Closing, known: Known | None, root: Root
) -> Stability:
    """Trace, multipliers and the verdict, over the enclosure of the orbit."""
    claim = closing.stability
    maps = root.equations.maps(root.linearised.shooting)
    if not all(x.is_finite() for matrix in maps for x in matrix.entries()):
        return Stability(claim, "undecided", "a boundary may be reached tangentially", None, ())
    square = reduced_map(maps, known, closing, tables.number)
    trace = trace_of(square) + len(closing.translations)
    if closing.form is not None:
        inside, pairs = neutral_pairs(product_of(maps), trace)
    else:
        inside, pairs = inside_circle(square), eigenvalues_of(square)
    multipliers = apart(pairs or (), len(root.equations.free), trivial=closing.form is not None)
    multipliers = tuple(sorted(multipliers, key=lambda m: -float(abs(m).mid())))
    if subject.cycle.one_sided:
        return Stability(claim, "undecided", CORNER, trace, ())
    if inside is None:
        reason = "a multiplier cannot be told from the unit circle"
        if closing.form is not None:
            reason = "a nontrivial pair of multipliers cannot be told from a double one"
        return Stability(claim, "undecided", reason, trace, multipliers)
    if not inside:
        reason = "a multiplier lies outside the unit circle"
        return Stability(claim, "refuted", reason, trace, multipliers)
    return Stability(claim, "proved", "", trace, multipliers)


def _admissible(
    subject: Subject,
    tables: Tables,
    translations: Sequence[Row],
    known: Known | None,
    root: Root,
    work: int,
) -> Judgement:
    """Judge the orbit, with few bits first: that it is as sharp as it is does not matter here."""
    if known is None:
        reason = "the declaration takes a root or a sine: what is exactly zero is not known"
        return Judgement("undecided", reason, ())
    dwell = root.equations.dwell(root.contraction.image)
    plans = plan_of(tables, subject.cycle, known)
    found: Judgement | None = None
    for bits in sorted({min(_ENOUGH, work), work}):
        with flint_precision(bits):
            phases = phases_of(tables, subject.cycle, None, translations)
            here = [plan.at(tables.number) for plan in plans]
            found = judge(here, phases, root.linearised.shooting, dwell)
        if found.verdict != "undecided":
            break
    assert found is not None
    return found


def _certificate(
    subject: Subject,
    tables: Tables,
    closing: Closing,
    bits: int,
    root: Root | Missing,
    stability: Stability | None = None,
    judgement: Judgement | None = None,
) -> Certificate:
    """Everything by name."""
    claims = dict.fromkeys(CLAIMS, "undecided")
    reasons: dict[str, str] = {}
    enclosures: dict[str, Stated] = {}
    multipliers: tuple[tuple[Stated, Stated], ...] = ()
    margins: tuple[dict[str, Any], ...] = ()
    if isinstance(root, Missing):
        claims["existence"], reasons["existence"] = root.verdict, root.reason
        reasons |= dict.fromkeys(CLAIMS[1:], NO_ORBIT)
    else:
        assert stability is not None
        assert judgement is not None
        claims = dict(zip(CLAIMS, ("proved", judgement.verdict, stability.verdict), strict=True))
        told = zip(CLAIMS[1:], (judgement.reason, stability.reason), strict=True)
        reasons = {name: reason for name, reason in told if reason}
        enclosures = _enclosures(subject, root, stability.trace, bits)
        multipliers = tuple(
            (stated(m.real, bits, 1), stated(m.imag, bits, 1)) for m in stability.multipliers
        )
        margins = tuple(_margin(m) for m in judgement.margins)
    return Certificate(
        subject.label,
        subject.kernels.name,
        subject.values,
        subject.chosen,
        subject.cycle.itinerary,
        claims,
        "stable" if stability is None else stability.claim,
        reasons,
        enclosures,
        multipliers,
        margins,
        root.box,
        bits,
        subject.start_names,
        subject.dwell_names,
        closing.period,
        *_statement(subject, tables, closing, claimed=claims["existence"] != "undecided"),
    )


def _statement(
    subject: Subject, tables: Tables, closing: Closing, *, claimed: bool
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Declaration and closing as the file states them; empty where nothing is claimed."""
    if not claimed:
        return {}, {}
    cycle, timed = subject.cycle, closing.kind == "period"
    declared = system_declaration(
        subject.kernels, cycle, tables, subject.start_names, subject.dwell_names, timed=timed
    )
    own = {value: name for name, value in reversed(subject.values.items())}
    variables = [own[value] for value in tables.constants]
    return declared, closing_json(closing, cycle, declared["parameters"], variables, PERIOD)


def _enclosures(subject: Subject, root: Root, trace: arb | None, bits: int) -> dict[str, Stated]:
    from flint import arb

    dwell = root.equations.dwell(root.contraction.image)
    period = root.equations.period
    found = {} if trace is None else {"trace": trace}
    found["period"] = sum(dwell, arb(0)) if period is None else period
    found |= dict(zip(subject.dwell_names, dwell, strict=True))
    start = root.linearised.shooting.starts[0].entries()[:-1]
    found |= dict(zip(subject.start_names, start, strict=True))
    return {name: stated(ball, bits, int(name == "trace")) for name, ball in found.items()}


def stated(ball: arb, bits: int, size: int = 0) -> Stated:
    """A wider ball than was found: the check computes it anew, with other roundings.

    A number that is computed from others of a size may be much smaller than these.
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


def _uncovered(orbit: Orbit | ComposedOrbit, bits: int, reason: str) -> Certificate:
    """The certificate of an orbit that no proof can be about."""
    reasons = {CLAIMS[0]: reason} | dict.fromkeys(CLAIMS[1:], NO_ORBIT)
    claims = dict.fromkeys(CLAIMS, "undecided")
    return Certificate(
        orbit.name, system_of(orbit), dict(orbit.given), (), (), claims, "stable", reasons, {}, (),
        (), (), bits, (), (), None, {}, {},
    )  # fmt: skip
