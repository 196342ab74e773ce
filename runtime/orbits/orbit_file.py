"""Orbits in files: JSON with every digit, refused when it is cut, edited or foreign.

Numbers are decimal strings that give back the very same double or mpmath number; given
values are kept as they were written. An orbit that is read has to solve the equations of the
kernels that are there, or, phase by phase, to be one by the tables of its system.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal, InvalidOperation
from typing import Annotated, Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import BlankText, Codec, Several
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.core.values import Value, decimal_string
from nonsmooth.runtime.model.completion import check_relations, follow
from nonsmooth.runtime.model.kernels import SystemKernels, load_orbit
from nonsmooth.runtime.model.parameters import in_domain, system_parameters
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, system_in
from nonsmooth.runtime.orbits.kernel_problem import KernelProblem, kernel_problem
from nonsmooth.runtime.orbits.orbit import DOUBLE, PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import OrbitProblem
from nonsmooth.runtime.orbits.refine import MOST_DIGITS
from nonsmooth.runtime.orbits.table_solve import with_routes_at
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import numbers_in
from nonsmooth.runtime.shooting.symmetry import symmetry_of
from nonsmooth.runtime.shooting.translations import projection_along

_DOUBLE_BITS = 53
_MOST_BITS = 8 * MOST_DIGITS
_LARGEST_EXPONENT, _LEAST_EXPONENT = 308, -10 * MOST_DIGITS  # decimal
_SLACK = 100  # times the error that the stated digits allow
_MOST_MISSED = 1e-9  # the solver's residual by tables, in units of the data


@dataclass(frozen=True, kw_only=True)
class ProblemEntries:
    """Entries for what an orbit solves: the equations of an orbit of a system, or its tables."""

    system: str
    tables: SavedSystem | None
    orbit: str  # name among the orbits of the system; empty for its tables
    # of an orbit by tables; empty for one with kernels
    label: BlankText
    itinerary: tuple[tuple[str, str], ...]
    names: tuple[str, ...]  # of the unknowns, where a declaration gives them


def _problem_entries(problem: OrbitProblem) -> ProblemEntries:
    derived = isinstance(problem, KernelProblem)
    own = problem.kernels.orbit if problem.kernels else ""
    label = "" if derived else problem.label or ""
    system, held, saved = named(problem.system, own or label)
    return ProblemEntries(
        system=system,
        tables=saved,
        orbit=own,
        label=held if label else None,
        itinerary=() if derived else problem.itinerary,
        names=() if derived else problem.names,
    )


def _problem(entries: ProblemEntries) -> OrbitProblem:
    system, name = system_in(entries.system, entries.tables), entries.orbit
    if not name:
        if not entries.itinerary:
            raise InputError("'itinerary' is empty, and no orbit is named")
        return OrbitProblem(system, entries.itinerary, None, entries.label, entries.names)
    known = [own for own, table in system.module.ORBITS.items() if table["derived"]]
    if name not in known:
        raise unknown_name("orbit", name, known)
    return kernel_problem(load_orbit(f"{system.name}{'/' if system.built_in else ':'}{name}"))


@dataclass(frozen=True, kw_only=True)
class OrbitEntries:
    """Entries of the file of an orbit; numbers have as many digits as `bits` need."""

    problem: Annotated[OrbitProblem, Several(ProblemEntries, _problem_entries, _problem)]
    derivation: str
    given: Mapping[str, Value]
    opened: Mapping[str, Value]
    unknowns: Mapping[str, str]
    # of an orbit by tables: the starts of the phases behind the first, and what closes a part of it
    starts: tuple[tuple[str, ...], ...]
    symmetry: tuple[tuple[float, ...], ...]
    arithmetic: Literal["double", "mpmath"]
    bits: int
    residual: str
    digits: int
    iterations: int
    status: int


ORBIT = FileFormat(
    name="nonsmooth orbit",
    what="saved orbit",
    entries=OrbitEntries,
    version=3 + SAVED_VERSION,
    most=50_000_000,
)


def save_orbit(orbit: Orbit, path: str | os.PathLike[str]) -> None:
    """Write a converged orbit to a JSON file, and make the folders above it.

    Floats and mpmath numbers keep every digit. The file is replaced only when the new one
    is complete. `InputError` is raised if the orbit has not converged or the file cannot be
    written.
    """
    ORBIT.write(path, _entries(orbit))


def orbit_content(orbit: Orbit) -> dict[str, Any]:
    """Content of an orbit's file, ready for JSON; `InputError` if the orbit has not converged."""
    return ORBIT.content(_entries(orbit))


def load_orbit_file(path: str | os.PathLike[str]) -> Orbit:
    """Read an orbit that `Orbit.save` wrote, with every digit.

    Kernels of another derivation are accepted if they have the same unknowns and parameters
    and the orbit solves their equations. An `InputError` with the file's name is raised if
    the file cannot be read, is cut, edited or foreign, or holds what is no orbit of the
    installed kernels.

    Examples
    --------
    >>> from nonsmooth.runtime.orbits.solve import solve
    >>> solve("dry-friction/global-stick").save("orbit.json")
    >>> load_orbit_file("orbit.json").converged
    True
    """
    with naming(path) as file:
        return _orbit(ORBIT.read(file))


def orbit_in(content: Any) -> Orbit:
    """The orbit that the content of a file (read as JSON) describes, with the same numbers.

    `InputError` is raised as by `load_orbit_file`, but without the name of a file.
    """
    return _orbit(ORBIT.check(content))


# a field of a record: an orbit, whose entry is the whole content of its own file
KeptOrbit = Annotated[Orbit, Codec(orbit_content, orbit_in, {"type": "object"})]


def _entries(orbit: Orbit) -> OrbitEntries:
    if not orbit.converged:
        raise InputError(f"{orbit.name} is not saved: {orbit.message}")
    by_tables = not orbit.problem.derived
    starts = orbit.states[1:].tolist() if by_tables else []
    symmetry = orbit.symmetry
    numbers = (*orbit.unknowns.values(), *(x for row in starts for x in row), orbit.residual)
    bits = max(map(_bits_of, numbers))
    return OrbitEntries(
        problem=orbit.problem,
        derivation=_derivation(orbit.system),
        given=orbit.given,
        opened=orbit.opened,
        unknowns={name: _text(number, bits) for name, number in orbit.unknowns.items()},
        starts=tuple(tuple(_text(number, bits) for number in row) for row in starts),
        symmetry=symmetry.matrix.tolist() if by_tables and symmetry is not None else (),
        arithmetic="mpmath" if orbit.precise else "double",
        bits=bits,
        residual=_text(orbit.residual, bits),
        digits=orbit.digits,
        iterations=orbit.iterations,
        status=orbit.status,
    )


def _orbit(entries: OrbitEntries) -> Orbit:
    """The orbit that a file's entries describe, with the same numbers.

    `InputError` is raised if these are no orbit, or not this one with the kernels or tables
    that are there.
    """
    _check_counts(entries)
    bits = None if entries.arithmetic == "double" else entries.bits
    orbit = Orbit(
        entries.problem,
        entries.given,
        {name: _number(name, text, bits) for name, text in entries.unknowns.items()},
        entries.opened,
        _number("residual", entries.residual, bits),
        entries.digits,
        entries.iterations,
        entries.status,
    )
    if isinstance(orbit.problem, KernelProblem):
        if entries.starts or entries.symmetry:
            raise InputError("it has numbers that only an orbit by tables has")
        _check_names(orbit)
        _check_domains(orbit)
    else:
        starts = [[_number("starts", text, bits) for text in row] for row in entries.starts]
        orbit = _by_tables(orbit, starts, entries.symmetry)
    here = _derivation(orbit.system)
    check_solves(orbit, f" (its derivation {entries.derivation}, here {here})")
    return orbit


def check_solves(orbit: Orbit, which: str = "") -> None:
    """Raise `InputError` unless an orbit of a file is one of the installed system.

    It is refused if its equations are not solved, and one by tables if a dwell time is not
    positive; `which` says something about the kernels in the message.
    """
    by_tables = not orbit.problem.derived
    if by_tables and not (orbit.dwell_times > 0).all():
        raise InputError("a dwell time is not positive")
    if not (_phases_follow if by_tables else _equations_hold)(orbit):
        name = orbit.system.name if by_tables else orbit.name
        raise InputError(
            f"not a solution of {name} to {orbit.digits} digits with the kernels that are"
            f" installed{which}"
        )


def _derivation(kernels: SystemKernels) -> str:
    return str(kernels.module.DERIVATION)


def _by_tables(
    orbit: Orbit, later: list[list[Any]], symmetry: tuple[tuple[float, ...], ...]
) -> Orbit:
    """The same orbit by the tables of its system, of whose phases all but the first start `later`.

    The `symmetry` closes a part of it; it is empty where there is none.
    """
    problem, given, names = orbit.problem, dict(orbit.given), orbit.problem.unknown_names
    period = {PERIOD: given.pop(PERIOD)} if PERIOD in given else {}
    parameters = system_parameters(problem.system, given)
    if orbit.opened:
        raise InputError("it has numbers that no orbit by tables has")
    count, size = len(problem.itinerary), len(problem.state_names)
    if len({*names}) != count + size or orbit.unknowns.keys() != {*names}:
        raise InputError(f"its unknowns are not those of {count} phases and {size} states")
    if len(later) != count - 1 or any(len(row) != size for row in later):
        raise InputError("'starts' are not those of its phases")
    unknowns = {name: orbit.unknowns[name] for name in names}
    states = np.array([[*unknowns.values()][count:], *later])
    point = piecewise(problem.system, parameters)
    mirror = symmetry_of(point, symmetry) if symmetry else None
    if mirror is not None and count % mirror.order:
        raise InputError("its phases are no multiple of those that the symmetry closes")
    routes = problem.itinerary, np.array([*unknowns.values()][:count]), states
    return replace(
        orbit,
        problem=replace(
            problem,
            system=with_routes_at(problem.system, point, *routes),
            symmetry=mirror,
        ),
        given={**parameters, **period},
        unknowns=unknowns,
        starts=states,
    )


def _check_counts(entries: OrbitEntries) -> None:
    """Raise `InputError` for counts of bits, digits and iterations that no orbit has."""
    double = entries.arithmetic == "double"
    allowed = {
        "bits": (_DOUBLE_BITS, _DOUBLE_BITS if double else _MOST_BITS),
        "digits": (0, DOUBLE if double else MOST_DIGITS),
        "iterations": (0, math.inf),
        "status": (CONVERGED, CONVERGED),
    }
    for name, (least, most) in allowed.items():
        count = getattr(entries, name)
        if not least <= count <= most:
            raise InputError(f"{name} is {count}, which no saved orbit has")


def _check_names(orbit: Orbit) -> None:
    kernels = orbit.kernels
    known = sorted([*kernels.parameter_names, *kernels.unknowns])
    found = sorted([*orbit.given, *orbit.unknowns])
    fixed = {*kernels.parameter_names, *kernels.required, *kernels.solved_for}
    opened = [name for name in kernels.tables if name not in fixed]
    if found != known or len(orbit.unknowns) != len(kernels.unknowns):
        raise InputError(
            f"{kernels.name} has {', '.join(known)}, the file has {', '.join(found) or 'nothing'}"
        )
    for name in orbit.opened:
        if name not in opened:
            raise unknown_name("open parameter", name, opened)


def _check_domains(orbit: Orbit) -> None:
    kernels = orbit.kernels
    check_relations(kernels, {**orbit.given, **orbit.opened})
    values = {name: float(x) for name, x in {**orbit.values, **orbit.opened}.items()}
    values |= follow(kernels, values)
    for table in kernels.tables.values():
        if table.name in values and not in_domain(table, values[table.name]):
            raise InputError(f"{table.name} is outside its domain")
    for name, duration in zip(orbit.dwell_time_names, orbit.dwell_times, strict=True):
        if not duration >= 0:
            raise InputError(f"dwell time {name} is negative")


def _equations_hold(orbit: Orbit) -> bool:
    """Whether the equations hold as well as the digits of the unknowns allow.

    An error of 10^-digits max(1, |x|) in each number x moves an equation by at most the sum
    of these errors, times the absolute values of its derivatives.
    """
    rough = replace(orbit, unknowns={n: float(x) for n, x in orbit.unknowns.items()})
    names = (*orbit.kernels.unknowns, *orbit.kernels.parameter_names)
    scale = np.array([max(1.0, abs(rough.values[name])) for name in names])
    unit = 10**orbit.digits
    try:
        with np.errstate(all="ignore"):
            derivatives = np.hstack(rough.evaluate("jacobian", "parameter_jacobian"))
            bounds = [float(bound) for bound in _SLACK * np.abs(derivatives) @ scale]
            sizes = [abs(r) * unit for r in orbit.evaluate("residual")]
    except ArithmeticError:
        return False
    return all(math.isfinite(b) and s <= b for s, b in zip(sizes, bounds, strict=True))


def _phases_follow(orbit: Orbit) -> bool:
    """Whether each phase ends on its boundary, and the next begins where its reset leads.

    An error of 10^-digits max(1, |x|) in each number x moves these by at most the sum of
    these errors times the absolute values of the derivatives.
    """
    tables, lib = orbit.tables, orbit.arithmetic.mp
    numbers, cycle = numbers_in(tables.piecewise), tables.cycle
    unit = lib.mpf(10) ** -orbit.digits if orbit.precise else 10.0**-DOUBLE
    missed = 2 * abs(orbit.residual)
    size = orbit.states.shape[1]
    flows = tables.shooting.flows
    following = np.roll(orbit.states, -1, axis=0)
    projection = projection_along(tables.translations)
    for place, (start, end_start) in enumerate(zip(orbit.states, following, strict=True)):
        flow, row = flows[place], numbers.rows[cycle.rows[place]]
        reset = numbers.resets[cycle.transitions[place].reset]
        field = numbers.fields[cycle.configurations[place]]
        end = flow[:, :size] @ start + flow[:, size]
        speed = field[:, :size] @ end + field[:, size]
        scale = np.maximum(1, abs(start))
        reach = abs(flow[:, :size]) @ scale + abs(flow[:, size])
        moved = reach + abs(speed) * max(1, abs(orbit.dwell_times[place]))
        gap, terms = row[:size] @ end + row[size], abs(row[:size]) @ moved + abs(row[size])
        jump = reset[:, :size] @ end + reset[:, size] - end_start
        if place == len(cycle) - 1:
            jump = projection @ jump
        sizes = abs(reset[:, :size]) @ moved + abs(reset[:, size]) + np.maximum(1, abs(end_start))
        if not missed <= _MOST_MISSED * max(terms, max(sizes)):
            return False
        if not abs(gap) <= _SLACK * unit * terms + missed:
            return False
        if not (abs(jump) <= _SLACK * unit * sizes + missed).all():
            return False
    return True


def _bits_of(number: Any) -> int:
    """Precision in bits of a number: of a double, or of the mpmath context that made it."""
    if isinstance(number, float):
        return _DOUBLE_BITS
    return max(int(number.man_exp[0]).bit_length(), int(number.context.prec))


def _text(number: Any, bits: int) -> str:
    """Decimal text that determines a number with a precision of `bits`."""
    if isinstance(number, float):
        return float.__repr__(number)
    return decimal_string(number, math.ceil(bits * math.log10(2)))


def _number(name: str, text: str, bits: int | None) -> Any:
    """The double, or the mpmath number of so many bits, nearest to a decimal text.

    It is a double if `bits` is None. `name` is for the message of the `InputError`, which
    is raised if the text is no finite decimal of a usual size.
    """
    try:
        decimal = Decimal(text)
    except InvalidOperation:
        raise InputError(f"{name} is not a decimal number") from None
    if not decimal.is_finite():
        raise InputError(f"{name} is {text}, not a finite number")
    if decimal and not _LEAST_EXPONENT <= decimal.adjusted() < _LARGEST_EXPONENT:
        raise InputError(f"{name} is too large or too small")
    if bits is None:
        return float(text)
    from mpmath import MPContext, libmp

    context = MPContext()
    context.prec = bits
    return context.make_mpf(libmp.from_rational(*decimal.as_integer_ratio(), bits, "n"))
