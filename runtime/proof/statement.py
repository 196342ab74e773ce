"""The exact system of a certificate: its numbers, and how the file states it for the checker.

Numbers are rational or rational functions where the parameters are, else balls. A declaration is
stated as functions of the parameters that the file names. So every name and value that is printed
is bound to the tables that are proved about: who reads the file evaluates them at its values.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from flint import arb, ctx, fmpq, fmpz

from nonsmooth.runtime.checker.stated.exact import Entries
from nonsmooth.runtime.checker.stated.parameters import number_at
from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.irrational_numbers import irrationals
from nonsmooth.runtime.core.rational_functions import RationalFunction
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.contacts.law import Law
from nonsmooth.runtime.model.contacts.stages import Path, Stage
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.saved_system import saved_of
from nonsmooth.runtime.model.structure import Structure, structure_of
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

if TYPE_CHECKING:
    from nonsmooth.runtime.proof.orbit_to_prove import ClosureConditions

_SHARP = 256  # bits that tell what irrational numbers make zero

Row = tuple["fmpq", ...]  # n y + c: n, then c
Matrix = tuple[Row, ...]  # acts on (y, 1)


class NotRational(Exception):
    """The declaration takes `function`, a root or a sine say, of its parameters."""

    def __init__(self, function: str) -> None:
        super().__init__(f"the declaration takes {function} of its parameters")
        self.function = function


@dataclass(frozen=True, eq=False)
class Tables:
    """The numbers of a system: fields and resets (N + 1, N + 1) on (y, 1), and rows (N + 1)."""

    fields: tuple[Matrix, ...]
    rows: tuple[Row, ...]
    resets: tuple[Matrix, ...]
    exact: bool  # entries are rational numbers or functions; else they are balls
    # irrational numbers that do not vary: the last variables of the entries' functions
    constants: tuple[Value, ...] = ()

    def near(self, entry: Any, values: Sequence[Any] = ()) -> float:
        """Return the middle of an entry's ball, at values of the parameters that vary."""
        known = [value.ball(ctx.prec) for value in self.constants]
        return float(number_at([*values, *known])(entry).mid())


class _Exactly:
    """The arithmetic that exact kernels need: rationals, and irrational numbers that are known.

    Any other function that a kernel asks for raises `NotRational`.
    """

    def __init__(self, numbers: Mapping[str, Any]) -> None:
        self._numbers = numbers

    @staticmethod
    def rational(numerator: int, denominator: int) -> Any:
        return fmpq(numerator, denominator)

    def constant(self, text: str) -> Any:
        return self._numbers[text]

    def __getattr__(self, name: str) -> Any:
        raise NotRational(name)


def exact_tables(kernels: SystemKernels, values: Mapping[str, Value], bits: int) -> Tables:
    """Return the tables of a system at the values of all its parameters, in their order.

    They are exact: rational, or functions of irrational numbers. Where the declaration takes a root
    or a sine of its parameters, the entries are balls of `bits`.
    """
    with suppress(NotRational, ArithmeticError):
        return tables_over(kernels, (), values)
    return _tables(kernels, [value.ball(bits) for value in values.values()], Balls(), exact=False)


@lru_cache(maxsize=64)
def declared_constants(kernels: SystemKernels) -> tuple[str, ...]:
    """Return the texts of the irrational numbers in a declaration, as `parse` takes them."""
    saved = saved_of(kernels)
    functions = [] if saved is None else [saved.functions[k] for k in ("fields", "rows", "resets")]
    return tuple(dict.fromkeys(text for function in functions for text in function.constants))


def tables_over(
    kernels: SystemKernels,
    names: Iterable[str],
    fixed: Mapping[str, Value] | None = None,
    *,
    beside: Iterable[Value] = (),
    orbit: OrbitKernels | None = None,
) -> Tables:
    """Return exact tables of a system some of whose parameters vary: rational functions of these.

    `names` are the parameters that vary, `fixed` has the values of others. `orbit` holds an orbit's
    functions where these are its parameters, from which the system's follow. The irrational ones of
    `fixed`, of values `beside` and of the declaration are the last variables. `NotRational` is
    raised if the declaration takes a root or a sine of its parameters, `ArithmeticError` if a
    number divides by what may be zero, or a literal is enormous.
    """
    given = {} if fixed is None else fixed
    told = (value.text for value in (*given.values(), *beside) if value.exact is None)
    texts = (*told, *declared_constants(kernels))
    return _tables_over(kernels, tuple(names), tuple(given.items()), texts, orbit)


@lru_cache(maxsize=128)
def _tables_over(
    kernels: SystemKernels,
    names: tuple[str, ...],
    fixed: tuple[tuple[str, Value], ...],
    texts: tuple[str, ...],
    orbit: OrbitKernels | None,
) -> Tables:
    required = {} if orbit is None else {n: parse(text) for n, text in orbit.required.items()}
    own = [value.text for value in required.values() if value.exact is None]
    known = irrationals(names, [*texts, *own], lambda text: parse(text).ball(_SHARP))
    found: Entries = {
        name: known.numbers[v.text] if v.exact is None else rational_of(v.exact)
        for name, v in (*required.items(), *fixed)
    }
    found |= zip(names, known.variables, strict=True)
    if orbit is not None:
        found |= follow(orbit, found, rational_of)
        if missing := [table.name for table in kernels.parameters if table.name not in found]:
            raise InputError(f"{orbit.name}: {', '.join(missing)} left open")
    point = [found[table.name] for table in kernels.parameters]
    tables = _tables(kernels, point, _Exactly(known.numbers), exact=True)
    return replace(tables, constants=tuple(map(parse, known.generators)))


class ExactSystem(NamedTuple):
    """A system at one parameter point, with rational numbers."""

    structure: Structure
    values: dict[str, Value]
    exact: Tables


def exact_system(
    system: str | SystemKernels | DeclaredSystem, parameters: Mapping[str, object]
) -> ExactSystem:
    """Return a system at one parameter point; all of its parameters have to be given and rational.

    A declaration that takes a root or a sine of them is refused.
    """
    kernels = kernels_of(system)
    structure, values = structure_of(kernels), system_parameters(kernels, parameters)
    for name, value in values.items():
        if value.exact is None:
            raise InputError(f"a proof needs rational parameters, and {name} = {value} is not")
    try:
        if declared_constants(kernels):
            raise NotRational("an irrational number")
        return ExactSystem(structure, values, tables_over(kernels, (), values))
    except NotRational as problem:
        raise InputError(
            f"a proof needs rational rows, fields and resets, and {problem.function} is not"
        ) from None


def floats_of(numbers: Any) -> np.ndarray:
    """Return exact rational numbers, in lists of lists, as an array of doubles."""
    exact = np.array(numbers, dtype=object)
    return np.array([int(x.p) / int(x.q) for x in exact.flat]).reshape(exact.shape)


def rational_of(value: Fraction) -> fmpq:
    """Return a fraction as FLINT's rational number."""
    return fmpq(value.numerator, value.denominator)


def _tables(kernels: SystemKernels, point: Sequence[Any], lib: Any, *, exact: bool) -> Tables:
    number: Any = fmpq if exact else arb
    size = len(kernels.table["states"])
    fields, rows, resets = (
        [
            tuple(number(0) + entry for entry in row)
            for row in kernels.source(kernel)(point, lib=lib)
        ]
        for kernel in ("fields", "rows", "resets")
    )

    def cut(stacked: list[Row], last: int) -> tuple[Matrix, ...]:
        below = (*(number(0),) * size, number(last))
        return tuple((*stacked[i : i + size], below) for i in range(0, len(stacked), size))

    return Tables(cut(fields, 0), tuple(rows), cut(resets, 1), exact)


PERIOD = "period"  # its name among the parameters at one point
_RADIUS = 3  # digits that a radius needs


def decimals(ball: arb, bits: int, digits: int = _RADIUS) -> tuple[str, str]:
    """Return middle and radius of a decimal ball around a ball, with as many digits as count.

    The radius has `digits` digits. Of an exact number `bits` bits are kept. `ValueError` refuses
    a ball that is not finite: no decimal ball contains it.
    """
    if not ball.is_finite():
        raise ValueError(f"the ball {ball} is not finite")
    if ball.is_zero():
        return "0e0", "0e0"
    middle, radius, exponent = ball.mid_rad_10exp(int(bits * 0.302) + 5)
    drop = max(0, len(radius.str()) - digits)
    unit = 10**drop
    middle, power = (2 * middle + unit) // (2 * unit), int(exponent) + drop
    return scientific(middle, power), scientific(radius // unit + 2, power)


def scientific(integer: fmpz, exponent: int, form: str = "d") -> str:
    """Return an integer times a power of 10 as a decimal text; `form` is that of its exponent."""
    digits = abs(integer).str()  # Python's own integers have no text beyond some digits
    sign, tail = "-" * (integer < 0), digits[1:]
    return f"{sign}{digits[0]}{'.' * bool(tail)}{tail}e{exponent + len(tail):{form}}"


def system_declaration(
    kernels: SystemKernels,
    cycle: ItineraryShape,
    tables: Tables,
    start: Sequence[str],
    dwell: Sequence[str],
    *,
    timed: bool,
) -> Entries:
    """Return the declaration over all parameters of the system, as `declaration_json` gives it.

    If `timed`, the given period is one more parameter. Where the declaration takes a root or a sine
    of its parameters there are no such functions: then it is that of the tables, which hold the
    numbers at the orbit's parameters. `start` and `dwell` are names of states and dwell times.
    """
    names = tuple(table.name for table in kernels.parameters) + (PERIOD,) * timed
    try:
        over = tables_over(kernels, names, beside=tables.constants if timed else ())
    except NotRational:
        names, over = (), tables
    return declaration_json(over, cycle, names, start, dwell)


def declaration_json(
    tables: Tables,
    cycle: ItineraryShape,
    parameters: Sequence[str],
    start: Sequence[str],
    dwell: Sequence[str],
    *,
    whole: bool = False,
) -> Entries:
    """Return the configurations and transitions of a proof as JSON, with their numbers as texts.

    All configurations are stated if the declaration is of the `whole` system.

    `parameters` are the variables of the tables' entries, in the order of their exponents; the
    tables' constants follow. `start` and `dwell` are names of states and dwell times.
    """
    structure = cycle.structure
    places = range(len(structure.configurations)) if whole else cycle.configurations
    needed = set(places)
    transitions: list[dict[str, Any]] = []
    phases = []
    own: dict[int, int] = {}  # places of the transitions that are stated
    for configuration, taken in zip(cycle.configurations, cycle.transitions, strict=True):
        shapes = structure.boundaries[configuration]
        names = structure.configurations
        for other in structure.transitions[configuration]:
            if other.boundaries != taken.boundaries or id(other) in own:
                continue
            entry: Entries = {
                "source": names[configuration],
                "boundaries": sorted(shapes[b].name for b in other.boundaries),
                "conditions": [
                    [_row(tables.rows[row]), names[along], holds]
                    for row, along, holds in other.conditions
                ],
                "reset": [_row(row) for row in tables.resets[other.reset][:-1]],
                "target": names[other.target],
            }
            if other.order:
                entry["order"] = other.order
            if other.path is not None and structure.law is not None:
                entry["steps"] = _steps_json(structure.law, other.path)
            needed |= {along for _, along, _ in other.conditions}
            if entry not in transitions:
                transitions.append(entry)
            own[id(other)] = transitions.index(entry)
        phases.append((configuration, own.get(id(taken), -1)))
    law: Entries = {}
    if structure.law is not None and any("steps" in entry for entry in transitions):
        law["law"] = _law_json(structure.law, {*places}, lambda row: _row(tables.rows[row]))
    constants = [value.text for value in tables.constants]
    return {
        "parameters": list(parameters),
        **({"constants": constants} if constants else {}),
        "states": list(structure.states),
        "start": list(start),
        "forcing": [list(pair) for pair in structure.forcing],
        "configurations": {
            structure.configurations[c]: {
                "field": [_row(row) for row in tables.fields[c][:-1]],
                "boundaries": {b.name: _row(tables.rows[b.row]) for b in structure.boundaries[c]},
                "held": [_row(tables.rows[row]) for row in structure.constraints[c]],
            }
            for c in sorted(needed)
        },
        "transitions": transitions,
        "phases": [
            {
                "configuration": structure.configurations[c],
                "boundaries": cycle.itinerary[place][1].split("+"),
                "transition": number,
                "dwell_time": dwell[place],
            }
            for place, (c, number) in enumerate(phases)
        ],
        **law,
    }


def closing_json(
    closing: ClosureConditions,
    cycle: ItineraryShape,
    parameters: Sequence[str],
    variables: Sequence[str],
    period: str,
) -> Entries:
    """Return how a cycle closes, with the energy's form where there is one, as JSON with texts.

    `parameters` are what the declaration is over, its constants too. `variables` are those of them
    that the form's entries are functions of, in order. `period` names the parameter that the dwell
    times sum up to.
    """
    told: Entries = {"kind": closing.kind}
    if closing.kind == "forcing":
        told["turns"] = closing.turns
    if closing.translations:
        told["translations"] = [_row(row) for row in closing.translations]
    if closing.form is not None:
        places, count = [parameters.index(name) for name in variables], len(parameters)
        names, form = cycle.structure.configurations, closing.form
        told |= {
            "period": period,
            "dropped": closing.dropped,
            "form": [[_moved(x, places, count) for x in row] for row in form.omega],
            "constants": {names[c]: _moved(x, places, count) for c, x in form.constants.items()},
        }
    return told


def _moved(number: Any, places: Sequence[int], count: int) -> Any:
    """Return an entry as a function of `count` variables, its own ones being at these places."""
    found = _entry(number)
    for terms in found.values() if isinstance(found, dict) else ():
        for term in terms:
            exponents = [0] * count
            for place, exponent in zip(places, term[1], strict=True):
                exponents[place] = exponent
            term[1] = exponents
    return found


def _terms(polynomial: Any) -> list[list[Any]]:
    """Return the coefficients and exponents of a polynomial."""
    terms = polynomial.to_dict().items()
    return [[str(c), [int(e) for e in exponents]] for exponents, c in terms]


def _row(row: Sequence[Any]) -> list[Any]:
    return [_entry(number) for number in row]


def _entry(number: Any) -> Any:
    """Return a number as JSON: a text, a quotient of polynomials, or a ball's middle and radius."""
    if isinstance(number, RationalFunction):
        return {"above": _terms(number.above), "below": _terms(number.below)}
    if not hasattr(number, "rad"):
        return str(number)
    if number.is_exact():
        return number.fmpq().str()
    middle, radius = decimals(number, max(64, number.rel_accuracy_bits() + 32))
    return {"mid": middle, "rad": radius}


def _steps_json(law: Law, path: Path) -> list[Entries]:
    """Return for each stage of a path the contacts at their "kinetic" limit and all "regimes"."""
    return [
        {
            "kinetic": [law.contacts[i].name for i in sorted(stage.reached)],
            "regimes": list(stage.regimes),
        }
        for stage in path
    ]


def _law_json(law: Law, needed: Collection[int], row: Callable[[int], list[Any]]) -> Entries:
    """Return the contact law as JSON, as far as some configurations concern it.

    It holds contacts, coupling, arrivals, limits, configurations and the rows of free contacts;
    `row` writes the row of a number as a list.
    """
    places = sorted(needed)
    others = dict.fromkeys(law.others[c] for c in places)
    return {
        "contacts": [
            {
                "name": contact.name,
                "friction": contact.friction,
                "static": row(contact.static),
                "kinetic": row(contact.kinetic),
                "slipping": row(contact.slipping),
                "overshooting": row(contact.overshooting),
            }
            for contact in law.contacts
        ],
        "coupling": [[row(entry)[-1] for entry in each] for each in law.coupling],
        "arrivals": dict(law.arrivals),
        "limits": dict(law.limits),
        "configurations": {
            law.configurations[c]: {
                "regimes": list(law.regimes[c]),
                "others": law.others[c],
                "idle": list(law.idle[c]),
            }
            for c in places
        },
        "free": {name: [row(each) for each in law.free[name]] for name in others},
    }


def kernels_with(kernels: SystemKernels, declaration: Mapping[str, Any]) -> SystemKernels:
    """Return kernels that list the routes in a certificate's declaration.

    Without a law of contacts the kernels are returned unchanged. A declaration without steps of a
    contact law is refused.
    """
    law = structure_of(kernels).law
    if law is None:
        return kernels
    try:
        routes = [
            Route(
                entry["source"],
                tuple(entry["boundaries"]),
                entry["target"],
                tuple(_stage(law, step) for step in entry["steps"]),
            )
            for entry in declaration["transitions"]
            if "steps" in entry
        ]
        return unfolded(kernels, routes)
    except (KeyError, TypeError, ValueError):
        raise InputError("the declaration holds no steps of a contact law") from None


def _stage(law: Law, step: Mapping[str, Sequence[str]]) -> Stage:
    names = [contact.name for contact in law.contacts]
    reached = frozenset(names.index(name) for name in step["kinetic"])
    regimes = tuple(step["regimes"])
    if not all(map(set.__contains__, map(set, zip(*law.regimes, strict=True)), regimes)):
        raise ValueError(regimes)
    return Stage(reached, regimes)
