"""Certify a periodic orbit: propose where it is, and state what the checker proves of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, fmpq

from nonsmooth.runtime.checker.orbits.motion import Margin
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.checker.stated.exact import Elimination, Entries, Failure
from nonsmooth.runtime.core.errors import check_integer, chosen_names
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.proof.asking import Begin
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    GUARD,
    NO_ORBIT,
    Certificate,
    Stated,
    Unknown,
    file_json,
)
from nonsmooth.runtime.proof.orbit_to_prove import (
    ClosureConditions,
    NotCovered,
    Region,
    closing_of,
    region_at,
    subject_near,
)
from nonsmooth.runtime.proof.statement import (
    PERIOD,
    NotRational,
    Row,
    closing_json,
    decimals,
    rational_of,
    system_declaration,
    tables_over,
)

Direction = Mapping[str, Fraction]  # how parameters of the system, or the period, move

_NEAR = 1e-5  # how far from the given numbers an orbit is still theirs, in units of the states
_ROUGH = 53  # bits that do for what nothing depends on
_DOUBLE = 40  # bits that a root in double precision has at least, as a rule
_SHARES = (0.5, 0.7, 0.85)  # of the bits: radii of the boxes that are tried
_SMALL = 1e-8  # of a function that may vanish
_LARGEST_DENOMINATOR = 1000  # of its factors


def asked_parameters(orbit: Orbit, by: Sequence[str] | str | bool | None) -> tuple[str, ...]:
    """Return the names of the given numbers by which derivatives are asked for, each once.

    True stands for all that was given, None and False for nothing. What was not given is refused.
    """
    if by is None or isinstance(by, bool):
        return tuple(orbit.given) if by else ()
    return tuple(dict.fromkeys(chosen_names("given parameter", by, orbit.given)))


def directions(orbit: Orbit, chosen: Iterable[str], by: Iterable[str]) -> dict[str, Direction]:
    """Return how the system's parameters, and the period, move with each given number in `by`.

    The other given numbers, and the parameters in `chosen`, which the orbit leaves open, stay.
    """
    problem = orbit.problem
    known = {*orbit.given, *orbit.opened, *chosen, *problem.required}
    sums = problem.followers(known)
    found: dict[str, Direction] = {}
    for name in by:
        if name == problem.period_name:
            found[name] = {PERIOD: Fraction(1)}
            continue
        rates = {
            table.name: Fraction(table.name == name)
            if table.name in known
            else sums[table.name].get(name, Fraction(0))
            for table in orbit.system.parameters
        }
        found[name] = {parameter: rate for parameter, rate in rates.items() if rate}
    return found


def proposed(
    region: Region, about: Certificate, along: Mapping[str, Direction]
) -> tuple[Certificate, dict[str, str]]:
    """Return the certificate that states an orbit, but for its box, and of which nothing is proved.

    `along` are the directions by which derivatives are asked for. Those along which nothing can be
    stated are left out, and returned with the reason.
    """
    subject, tables, closing = region.subject, region.tables, region.closing
    timed, missing = closing.kind == "period", {}
    variables = [value.text for value in tables.constants]
    if timed and along:
        for name, direction in along.items():
            try:
                _moving(region, tuple(direction))
            except NotCovered as reason:
                missing[name] = str(reason)
        along = {name: direction for name, direction in along.items() if name not in missing}
        closing, variables = _moving(region, tuple({n for rates in along.values() for n in rates}))
    declaration = system_declaration(
        subject.kernels, subject.cycle, tables, subject.start_names, subject.dwell_names,
        timed=timed,
    )  # fmt: skip
    over = [*declaration["parameters"], *declaration.get("constants", ())]
    return replace(
        about,
        given_period=subject.period if timed else None,
        declaration=declaration,
        closing=closing_json(closing, subject.cycle, over, variables, PERIOD),
        directions=along,
    ), missing


def _moving(region: Region, names: tuple[str, ...]) -> tuple[ClosureConditions, list[str]]:
    """Return how a cycle of given period closes, as functions of variables, and their names.

    These are the named parameters, then irrational numbers. `NotCovered` is raised if the cycle
    closes in another way at other values of the parameters.
    """
    subject = region.subject
    values = subject.values
    still = {name: value for name, value in values.items() if name not in names}
    try:
        tables = tables_over(subject.kernels, names, still)
        own: dict[str, Any] = {**values, PERIOD: subject.period}
        closing = closing_of(subject, tables, [own[name].ball(_ROUGH) for name in names])
    except (NotRational, ArithmeticError) as problem:
        raise NotCovered(str(problem)) from None
    if closing.dropped != region.closing.dropped:
        raise NotCovered("the cycle closes in another way at other values")
    return closing, [*names, *(value.text for value in tables.constants)]


def boxes(judge: JudgedOrbit, guess: Sequence[arb]) -> Iterator[tuple[Unknown, ...]]:
    """Yield boxes in which the orbit may be alone, sharper ones first.

    If Newton's method does not find it near the guess, a box around that is the only one, and
    behind it `NotCovered` is raised.
    """
    bits, names = judge.bits, judge.declared.unknowns
    with flint_precision(_ROUGH):
        sizes = _sizes(judge.equations(), guess)
    try:
        # the boxes are much wider than this point is exact, and Krawczyk's map finds the rest
        point = refined(lambda point: judge.equations().near(point), guess, bits // 2 + 16)
        near = all(abs(x - g) < _NEAR * s for x, g, s in zip(point, guess, sizes, strict=True))
    except Failure:
        near = False
    if not near:
        yield _box(names, guess, [_NEAR * size for size in sizes], bits)
        raise NotCovered("Newton's method leaves the given numbers")
    for share in _SHARES:
        unit = arb(2) ** -max(24, int(bits * share))
        yield _box(names, point, [unit * size for size in sizes], bits)


def refined(
    step: Callable[[Sequence[arb]], Sequence[arb]], guess: Sequence[arb], bits: int
) -> Sequence[arb]:
    """Return a point near a root, by Newton's method at rising precisions up to `bits`.

    `step` gives such a point at the working precision, from one nearby.
    """
    precisions = [bits]
    while precisions[-1] > 2 * _DOUBLE:
        precisions.append(precisions[-1] // 2 + 8)
    for precision in reversed(precisions):
        with flint_precision(precision + 16):
            guess = step(guess)
    return guess


def _sizes(orbit: CheckedOrbit, point: Sequence[arb]) -> list[arb]:
    """Return units of the unknowns: the largest values of states and dwell times along the cycle.

    The changes of a state along the phases count too.
    """
    orbit.along(point)
    dwell, now = [abs(t).mid() for t in orbit.dwell], orbit.now
    rates = [b * y for b, y in zip(orbit.chain.fields, now.ends, strict=True)]
    sizes = []
    for k in orbit.declared.free:
        seen = [abs(y[k, 0]) for y in (*now.starts, *now.ends)]
        seen += [abs(f[k, 0] * t) for f, t in zip(rates, dwell, strict=True)]
        size = max((x.mid() for x in seen), key=float)
        sizes.append(size if size > 0 else arb(1))
    return [*sizes, *(max(dwell, key=float) for _ in range(orbit.count - len(sizes)))]


def _box(
    names: Sequence[str], centre: Sequence[arb], radii: Sequence[Any], bits: int
) -> tuple[Unknown, ...]:
    """Return a box with decimal middles and radii."""
    return tuple(
        Unknown(name, *decimals(arb(x.mid(), r), bits))
        for name, x, r in zip(names, centre, radii, strict=True)
    )


def nearly_vanishing(region: Region) -> tuple[Row, ...]:
    """Return rational functions that seem to be zero in the first phase and last there.

    They are exact rows (N + 1), as of x1 - x2 along an orbit that is symmetric.
    """
    from scipy.linalg import expm

    subject, tables = region.subject, region.tables
    field = tables.fields[subject.cycle.configurations[0]]
    rates = np.array([[tables.near(x) for x in row] for row in field])
    size, dwell = len(rates), float(subject.dwell[0])
    state = np.array([*map(float, subject.start), 1.0])
    states = np.array([expm(rates * t) @ state for t in np.linspace(0, dwell, 4 * size)])
    *_, sizes, turned = np.linalg.svd(states)
    left = turned[sizes < _SMALL * sizes[0]]
    found: list[np.ndarray] = []
    for column in range(size):
        if not len(left):
            break
        place = int(np.argmax(abs(left[:, column])))
        if abs(left[place, column]) > _SMALL:
            taken = left[place] / left[place, column]
            left = np.delete(left, place, axis=0)
            left = left - left[:, column, None] * taken
            found = [*(row - row[column] * taken for row in found), taken]
    near = [[Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in row] for row in found]
    exactly = Elimination()
    facts = exactly.echelon([[rational_of(x) for x in row] for row in near])
    rows = tuple(exactly.lasting(facts, field))
    return rows if all(isinstance(x, fmpq) for row in rows for x in row) else ()


FEWEST_BITS, MOST_BITS = 53, 400_000
_SLACK = 8  # radii are stated so much larger than they are found
_LEAST_OTHER = 1e-6  # less is not told apart from zero
_SHARE = 24  # bits


def certify(
    orbit: Orbit,
    bits: int = 128,
    *,
    derivatives: Sequence[str] | str | bool | None = None,
    begin: Begin = lambda step: None,
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
            asked, missing = proposed(region, undecided, directions(orbit, subject.chosen, by))
            begin("existence")
            told = file_json(asked)
            del told["box"]
            found = JudgedOrbit(told)
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
        asked, stability=found.kind, box=box, closing=found.proposal["closing"], directions={}
    )
    if found.existence.claim == "refuted":
        undecided = replace(undecided, claims={**undecided.claims, CLAIMS[0]: "refuted"})
        return _because(undecided, found.existence.reason)
    return _stated(replace(undecided, directions=asked.directions), found, missing, begin)


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
    begin: Begin,
) -> Certificate:
    """Return the certificate of an orbit that exists, with all that is found of it.

    `missing` says by which numbers no derivative was proposed, and why.
    """
    bits, along = about.bits, about.directions
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
            directions={name: along[name] for name in rates},
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


def _margin(margin: Margin) -> Entries:
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
