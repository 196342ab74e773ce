"""Completion of parameter points: from what is given to all that an orbit and its system take.

The equations of an orbit may take sums of physical parameters, such as e1 = ur1 - us1: of the
parameters of such a relation any one follows from the others, and all of them together must
not contradict each other. What is given may be exact values, floats, arrays or rational
functions: `followers` says what follows from which names, and each arithmetic sums up. `complete`
takes one exact point, `complete_arrays` many points at once, as arrays that broadcast.

What an orbit leaves open
-------------------------
An orbit that is given by e1 and e2 leaves us1 and us2 open: its equations do not depend on
them, and it is admissible for all that exceed a bound. `solve` and `chart` leave
them open and tell the bound. A proof, a branch that is switched at an event and whatever else
needs all parameters of the system chooses those that are open, in the system's order, by one
rule, and tells what it chose:

1. What follows from others is never chosen: with e1 and us1, ur1 = us1 + e1.
2. Where a sum is open too, it takes the least value of its domain: an orbit that does not
   depend on e1 either has e1 = 0, so that ur1 = us1.
3. Any other takes 1, or, where its bound is 0.9 or more, the first tenth that is not below
   11/10 of the bound.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, parse, real_array
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.parameters import (
    check_constraints,
    check_domain,
    domain_text,
    in_domain,
    number_of,
    system_parameters,
)

Terms = dict[str, Fraction]


@dataclass(frozen=True)
class Point:
    """Exact parameters of one orbit."""

    values: dict[str, Value]  # given parameters of the equations, in the kernels' order
    opened: dict[str, Value]  # given parameters that only admissibility depends on


@dataclass(frozen=True)
class SystemPoint:
    """Exact values of all parameters of a system."""

    values: dict[str, Value]  # in the system's order
    chosen: tuple[str, ...]  # parameters that were left open and got a chosen value


def default_parameters(kernels: OrbitKernels) -> dict[str, str]:
    """Parameters of the orbit's reference point as decimal text; empty if it has none.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_orbit
    >>> default_parameters(load_orbit("dry-friction/symmetric"))
    {'chi': '0.4', 'eta': '4', 'V': '0.6773', 'e2': '0.5'}
    """
    reference = kernels.table["reference"]
    return dict(reference["parameters"]) if reference else {}


def complete(
    kernels: OrbitKernels, given: Mapping[str, object], without: Iterable[str] = ()
) -> Point:
    """Check the given parameters of an orbit and complete them, exactly and in declared units.

    They are parameters of the equations, or the physical ones in their place (us1, ur1 in place
    of e1 = ur1 - us1). What is absent takes the reference point's value; parameters in
    `without` are to be solved for and take none. Raises `InputError` for unknown names, values
    outside their domains and contradictions, and `NoConvergence` if a parameter has a value
    with which no such orbit exists.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_orbit
    >>> point = complete(load_orbit("dry-friction/symmetric"), {"eta": "1.02"})
    >>> {name: value.text for name, value in point.values.items()}
    {'chi': '0.4', 'eta': '1.02', 'V': '0.6773', 'e2': '0.5'}
    """
    if given:
        return _completed(kernels, given, set(without))
    point = _reference_point(kernels, frozenset(without))
    return Point(dict(point.values), dict(point.opened))


@lru_cache(maxsize=256)
def _reference_point(kernels: OrbitKernels, without: frozenset[str]) -> Point:
    """The orbit's parameters if none is given: those of its reference point."""
    return _completed(kernels, {}, set(without))


def _completed(kernels: OrbitKernels, given: Mapping[str, object], without: set[str]) -> Point:
    """Check and complete the given parameters; `without` grows by what is always solved for."""
    known = {name: number_of(f"parameter {name}", value) for name, value in given.items()}
    tables = kernels.tables
    for name, value in known.items():
        if name not in tables:
            raise unknown_name("parameter", str(name), list(tables))
        if name in without:
            raise InputError(f"parameter {name} is both given and to be solved for")
        if name in kernels.solved_for:
            raise InputError(
                f"{name} is an unknown of {kernels.name}: to give it, solve for another"
                f" parameter in its place (--unknown NAME --given {name}={value})"
            )
        check_domain(tables[name], value)
    for name, text in kernels.required.items():
        if name in known and not _same(known[name], parse(text)):
            raise NoConvergence(
                f"{kernels.name} exists only for {name} = {text}: with {name} = {known[name]}"
                " no orbit has this itinerary"
            )
    without.update(kernels.solved_for)
    _check_free(kernels, known, without)
    check_relations(kernels, known)
    known |= _follow_exactly(kernels, known)
    defaults = default_parameters(kernels)
    point, missing = {}, []
    for name in kernels.parameter_names:
        if name in without:
            continue
        if name in known:
            point[name] = known[name]
        elif name in defaults:
            point[name] = known[name] = parse(defaults[name])
        else:
            missing.append(name)
    if missing:
        raise InputError(f"{kernels.name} needs a value for: {', '.join(missing)}")
    known |= _follow_exactly(kernels, known)
    opened: dict[str, Value] = {}
    for table in (*kernels.open_parameters, *kernels.other_parameters):
        name = table.name
        if name not in known and name not in defaults:
            continue
        if name in kernels.required or name in kernels.solved_for:
            continue
        if name in followers(kernels, {**point, **opened}):
            continue
        if name not in known:  # an orbit that was saved with it
            known[name] = parse(defaults[name])
            known |= _follow_exactly(kernels, known)
        opened[name] = known[name]
    for name, value in known.items():
        check_domain(tables[name], value)
    check_constraints(kernels.system, known)
    return Point(point, opened)


def complete_system(
    kernels: OrbitKernels, given: Mapping[str, Value], bounds: Mapping[str, float] | None = None
) -> SystemPoint:
    """All parameters of an orbit's system; a value is chosen for those that are left open.

    `given` holds parameters and unknowns of the orbit as `Point` does, and may hold others.
    `bounds` are numbers that open parameters have to exceed.
    """
    known = {name: as_value(text) for name, text in kernels.required.items()} | dict(given)
    known |= _follow_exactly(kernels, known)
    names = [table.name for table in kernels.system.parameters]
    chosen = []
    for name in names:
        if name not in known:
            known[name] = _chosen(kernels, name, known, bounds or {})
            known |= _follow_exactly(kernels, known)
            chosen.append(name)
    values = system_parameters(kernels.system, {name: known[name] for name in names})
    return SystemPoint(values, tuple(chosen))


def chosen_value(bound: float) -> Value:
    """The value of an open parameter that has to exceed a bound.

    It is 1 for a bound below 0.9, else 11/10 of the bound, rounded up to tenths.

    Examples
    --------
    >>> [chosen_value(bound).text for bound in (0.0, 0.7228, 0.95, 3.0)]
    ['1', '1', '11/10', '33/10']
    """
    return as_value("1" if not bound >= 0.9 else f"{math.ceil(11 * bound)}/10")


def left_open(kernels: OrbitKernels) -> tuple[str, ...]:
    """Parameters of the system that its orbit's equations do not fix, in the system's order.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_orbit
    >>> left_open(load_orbit("dry-friction/symmetric"))
    ('us1', 'ur1', 'us2', 'ur2')
    """
    fixed = {*kernels.parameter_names, *kernels.required}
    return tuple(t.name for t in kernels.system.parameters if t.name not in fixed)


def followers(kernels: OrbitKernels, known: Iterable[str]) -> dict[str, Terms]:
    """Parameters that follow from the known ones, each with the factors of the known ones.

    Each is a sum of multiples of known parameters by a declared relation; they come in the
    order of the relations.
    """
    return _followers(kernels, frozenset(known)) if kernels.combined else {}


def follow(
    kernels: OrbitKernels, known: Mapping[str, Any], number: Callable[[Fraction], Any] = float
) -> dict[str, Any]:
    """Values of the parameters that follow from known numbers, arrays or functions.

    `number` converts the fractions that are the factors of the terms.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_orbit
    >>> follow(load_orbit("dry-friction/global-stick"), {"e1": 3.0, "us1": 0.5})
    {'ur1': 3.5}
    """
    return _sums(
        kernels, known, lambda terms: sum(number(factor) * value for factor, value in terms)
    )


def check_relations(kernels: OrbitKernels, values: Mapping[str, Value]) -> None:
    """Check the relations of which all parameters, or all but the sum, have values.

    The `InputError` names the values that contradict each other or lead out of a domain.
    """
    for name, terms in kernels.combined.items():
        if not terms.keys() <= values.keys():
            continue
        total = _exact_sum([(Fraction(factor), values[term]) for term, factor in terms.items()])
        text = f"{_sum_text(terms)} = {float(total)!r}"
        if name in values and not _same(values[name], total):
            raise InputError(f"{name} = {values[name]} contradicts {text}")
        table = kernels.tables[name]
        if not in_domain(table, float(total)):
            given = ", ".join(f"{term} = {values[term]}" for term in terms)
            raise InputError(
                f"{given}: {name} = {_sum_text(terms)} is {float(total)!r},"
                f" outside its domain {domain_text(table)}"
            )


def _check_free(
    kernels: OrbitKernels, values: Mapping[str, Value], without: Collection[str]
) -> None:
    """Refuse values that would fix, or only seem to fix, a sum that is to be solved for."""
    for name, terms in kernels.combined.items():
        if name not in without:
            continue
        opened = {p.name for p in kernels.open_parameters}
        if all(term in values for term in terms):
            raise InputError(f"parameter {name} is to be solved for, but {', '.join(terms)} fix it")
        for term in terms:
            if term in values and term not in opened:
                raise InputError(
                    f"parameter {term} decides nothing while {name} is to be solved for:"
                    f" give {' or '.join(opened & terms.keys())} instead"
                )


def _chosen(
    kernels: OrbitKernels, name: str, known: Mapping[str, Value], bounds: Mapping[str, float]
) -> Value:
    """The value of a parameter that is left open: see the module's docstring."""
    for combined in kernels.combined:
        table = kernels.tables[combined]
        if combined not in known and table.closed and table.lower is not None:
            least = {**known, combined: as_value(table.lower)}
            terms = followers(kernels, least).get(name, {})
            if combined in terms:
                return _exact_sum([(factor, least[term]) for term, factor in terms.items()])
    return chosen_value(bounds.get(name, 0.0))


def _follow_exactly(kernels: OrbitKernels, known: Mapping[str, Value]) -> dict[str, Value]:
    return _sums(kernels, known, _exact_sum)


def _sums(
    kernels: OrbitKernels,
    known: Mapping[str, Any],
    total: Callable[[list[tuple[Fraction, Any]]], Any],
) -> dict[str, Any]:
    found: dict[str, Any] = {}
    numbers = dict(known)
    while following := followers(kernels, numbers):
        for name, terms in following.items():
            numbers[name] = total([(factor, numbers[term]) for term, factor in terms.items()])
            found[name] = numbers[name]
    return found


@lru_cache(maxsize=1024)
def _followers(kernels: OrbitKernels, known: frozenset[str]) -> dict[str, Terms]:
    found: dict[str, Terms] = {}
    for combined, terms in kernels.combined.items():
        relation = {combined: Fraction(-1), **{t: Fraction(f) for t, f in terms.items()}}
        absent = [name for name in relation if name not in known]
        if len(absent) == 1:
            own = -relation.pop(absent[0])
            found[absent[0]] = {name: factor / own for name, factor in relation.items()}
    return found


def _exact_sum(terms: Iterable[tuple[Fraction, Value]]) -> Value:
    """Sum of multiples of values: an exact fraction where all of them are."""
    terms = list(terms)
    exact = [factor * value.exact for factor, value in terms if value.exact is not None]
    if len(exact) == len(terms):
        return as_value(sum(exact, Fraction(0)))
    return parse(" + ".join(f"({factor})*({value.text})" for factor, value in terms))


def _same(first: Value, second: Value) -> bool:
    if first.exact is not None and second.exact is not None:
        return first.exact == second.exact
    return bool(first.ball(256).overlaps(second.ball(256)))


def _sum_text(terms: Mapping[str, int]) -> str:
    text = ""
    for name, factor in terms.items():
        sign = "-" if factor < 0 else "+" if text else ""
        size = "" if abs(factor) == 1 else f"{abs(factor)} "
        text += f"{' ' if text else ''}{sign}{' ' if text else ''}{size}{name}"
    return text


@dataclass(frozen=True, eq=False)
class Batch:
    """How the parameters of many points are completed."""

    kernels: OrbitKernels
    known: tuple[str, ...]  # parameters that need values
    opened: tuple[str, ...]  # open parameters that have values or follow
    # parameters that follow, each with the factors of the known ones whose sum it is
    completed: dict[str, Terms]

    def complete(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Arrays of all parameters of the equations, and of open ones, from those that are known.

        The arrays broadcast. A point at which another parameter is outside its domain is NaN.
        """
        found, own = dict(values), self.kernels.parameter_names
        for name, terms in self.completed.items():
            parts = (float(factor) * found[term] for term, factor in terms.items())
            found[name] = np.asarray(sum(parts))
        for name in [name for name in found if name not in own]:
            inside = in_domain(self.kernels.tables[name], found[name])
            if not inside.all():
                found[own[0]] = np.where(inside, found[own[0]], np.nan)
        return {name: found[name] for name in (*own, *self.opened)}


def complete_batch(kernels: OrbitKernels, given: Iterable[str]) -> Batch:
    """Which parameters of many points are given, follow, or stay open.

    `given` has the names of those that are fixed or swept. Raises `InputError` for a name that
    fixes nothing, or names that fix one parameter twice.
    """
    given, tables, own = list(given), kernels.tables, kernels.parameter_names
    opened = [table.name for table in kernels.open_parameters]
    relations = {name: terms for name, terms in kernels.combined.items() if name in own}
    replacing = [t for terms in relations.values() for t in terms if t not in opened]
    for name in given:
        if name not in tables:
            raise unknown_name("parameter", str(name), [*own, *opened, *replacing])
    for name, terms in relations.items():
        if {name, *terms} <= set(given):
            raise InputError(f"{name} follows from {' and '.join(terms)}: leave one of them out")
    completed = {n: terms for n, terms in followers(kernels, given).items() if n in own}
    following = followers(kernels, {*given, *own})
    completed |= {n: terms for n, terms in following.items() if n in opened}
    used = {*own, *opened, *(term for terms in completed.values() for term in terms)}
    for name in given:
        if name not in used:
            raise InputError(f"{name} decides nothing about {kernels.name}: leave it out")
    defaults = default_parameters(kernels)
    saved = [n for n in opened if n in defaults and n not in given and n not in completed]
    known = [name for name in own if name not in completed]
    known += [*(name for name in given if name not in own), *saved]
    told = [name for name in opened if name in known or name in completed]
    return Batch(kernels, tuple(known), tuple(told), completed)


def complete_arrays(kernels: OrbitKernels, given: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Arrays of parameters for a batch: the given ones, and the rest from the reference point.

    Given are parameters of the equations or the physical ones in their place; returned are
    those of the equations, then open ones as far as they are given. Values outside a domain
    stay: their points get a status of their own. Raises `InputError` as `complete_batch` does,
    for a missing name, and for anything but arrays of real numbers.
    """
    batch, defaults = complete_batch(kernels, given), default_parameters(kernels)
    found = {}
    for name in batch.known:
        value = given.get(name, defaults.get(name))
        if value is None:
            raise InputError(f"{kernels.name} needs a value for: {name}")
        found[name] = real_array(f"parameter {name}", value)
    try:
        return batch.complete(found)
    except ValueError as error:
        raise InputError(f"the parameter arrays do not broadcast: {error}") from None
