"""Systems as data: what files of results hold of a system that is not built in.

A `SavedSystem` holds the system's tables, and its numbers as expressions in all its parameters.
`saved_of` writes it down, `kernels_of_saved` makes tables and kernels of it again: nothing is
executed, nothing but the data is needed, and the numbers are the same to the last bit.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import chain
from types import ModuleType
from typing import Annotated, Any, Literal

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import Several, decode, encode
from nonsmooth.runtime.model.contacts.law import ContactRows
from nonsmooth.runtime.model.expressions import Function, written
from nonsmooth.runtime.model.kernels import (
    ParameterTable,
    SystemKernels,
    known_system,
    load_system,
    system_names,
)
from nonsmooth.runtime.model.loading.load import remember

# part of the version of each format whose files hold a system: raised when what it holds changes
SAVED_VERSION = 2
_EXACT = ("fields", "rows", "resets")
_MODES = ("spectrum", "modes")
_PRODUCT = re.compile(r"1|[^\W\d]\w*(\*\*\d{1,3})?(\*[^\W\d]\w*(\*\*\d{1,3})?)*")
_LONGEST_MODE = 64


@dataclass(frozen=True, kw_only=True)
class ConstraintEntries:
    """Products of parameters with factors, whose sum must not be negative."""

    text: str
    terms: Mapping[str, int]


@dataclass(frozen=True, kw_only=True)
class BoundaryEntries:
    """A boundary of a configuration."""

    name: str
    acts_when: Literal["reached", "exceeded"]


@dataclass(frozen=True, kw_only=True)
class ModeEntries:
    """A mode of a configuration's flow."""

    length: int
    oscillates: bool


@dataclass(frozen=True, kw_only=True)
class TransitionEntries:
    """What follows when these boundaries are reached; rows and resets by index, from 0."""

    source: str
    boundaries: tuple[str, ...]
    conditions: tuple[tuple[int, str, bool], ...]
    reset: int
    target: str
    order: int


@dataclass(frozen=True, kw_only=True)
class ContactEntries:
    """Rows of a contact: of its force by configuration, and of two velocities."""

    forces: Mapping[str, int]
    velocity: int
    surface: int


@dataclass(frozen=True, kw_only=True)
class LawEntries:
    """The law of coupled contacts."""

    contacts: tuple[ContactRows, ...]
    coupling: tuple[tuple[int, ...], ...]
    couples: tuple[tuple[bool, ...], ...]
    regimes: Mapping[str, tuple[str, ...]]
    others: Mapping[str, str]
    free: Mapping[str, tuple[int, ...]]
    arrivals: Mapping[str, int]
    limits: Mapping[str, int]
    switches: Mapping[str, Mapping[str, str]]
    idle: Mapping[str, tuple[int, ...]]
    resets: Mapping[str, Mapping[str, int]]


@dataclass(frozen=True, kw_only=True)
class TableEntries:
    """The tables that no parameter changes; rows and resets by index, from 0."""

    name: str
    description: str
    states: tuple[str, ...]
    parameters: tuple[ParameterTable, ...]
    constraints: tuple[ConstraintEntries, ...]
    configurations: Mapping[str, tuple[BoundaryEntries, ...]]
    spectrum: tuple[str, ...]
    spectrum_parameters: tuple[str, ...]
    modes: Mapping[str, tuple[ModeEntries, ...]] | None
    forcing: tuple[tuple[str, str], ...]
    forcing_row: int | None
    coordinates: tuple[tuple[str, str], ...]
    held: Mapping[str, tuple[str, ...]]
    constraint_rows: Mapping[str, tuple[int, ...]]
    boundary_rows: Mapping[str, tuple[int, ...]]
    transitions: tuple[TransitionEntries, ...]
    contacts: Mapping[str, ContactEntries]
    law: LawEntries | None


@dataclass(frozen=True, kw_only=True)
class SavedSystem:
    """A system as data."""

    derivation: str  # hash of the declaration
    table: TableEntries
    # fields, rows and resets; spectrum and modes if the flows have a closed form; the functions of
    # the orbits
    functions: Mapping[str, Function]
    orbits: Mapping[str, Any]  # tables of those of its orbits that are in the file

    @cached_property
    def name(self) -> str:
        """Name of the system with the hash of its data, as a file calls it."""
        data = {name: entry for name, entry in encode(self).items() if name != "derivation"}
        content = json.dumps(data)  # in order: fields stand in that of the configurations
        return f"{self.table.name}@{hashlib.sha256(content.encode()).hexdigest()[:16]}"


def named(kernels: SystemKernels, orbit: str = "") -> tuple[str, str, SavedSystem | None]:
    """The names that a file gives to a system and an orbit of it, and the system as data.

    A system that is not built in is called ``NAME@HASH``, the hash of its data; a built-in one
    has no data, but None. `orbit` may be given with the system's name in front or without.
    """
    if kernels.built_in:
        return kernels.name, orbit, None
    rest = orbit.removeprefix(kernels.name)
    saved = saved_of(kernels, rest.removeprefix(":"))
    assert saved is not None
    return saved.name, orbit if rest == orbit else saved.name + rest, saved


def same_system(kernels: SystemKernels, other: SystemKernels) -> bool:
    """Whether two systems have the same tables, whatever they are called and derived from."""
    one, two = saved_of(kernels), saved_of(other)
    if one is None or two is None:
        return kernels.name == other.name
    numbers = [[found.functions[name] for name in _EXACT] for found in (one, two)]
    return one.table == two.table and numbers[0] == numbers[1]


def check_same_system(what: str, asked: SystemKernels, known: SystemKernels) -> None:
    """Raise `InputError` if the tables of two systems differ; `what` names what was stored."""
    if not same_system(known, asked):
        raise InputError(f"{asked.name} is not the system of the {what} to resume, or has changed")


def saved_of(kernels: SystemKernels, orbit: str = "") -> SavedSystem | None:
    """A system as data, None for a built-in one, with the table of one orbit if it declares it.

    An empty name stands for no orbit.
    """
    if kernels.built_in:
        return None
    return _saved(kernels.module, orbit if orbit in kernels.module.ORBITS else "")


@cache
def _saved(module: ModuleType, orbit: str) -> SavedSystem:
    known: SavedSystem | None = getattr(module, "SAVED", None)
    if known is not None:
        return known
    table, orbits = module.SYSTEM, {orbit: module.ORBITS[orbit]} if orbit else {}
    names = {
        "parameters": [parameter["name"] for parameter in table["parameters"]],
        "spectrum": table["spectrum"],
        "spectrum_parameters": table["spectrum_parameters"],
    }
    wanted = [*_EXACT, *(_MODES if table["modes"] is not None else ())]
    for name, found in orbits.items():
        if found["derived"]:
            prefix = f"{name}_".replace("-", "_")
            flows = {f"flow_{c}".replace("-", "_") for c, _, _ in found["phases"]}
            wanted += [k for k in module.KERNELS if k.startswith(prefix) or k in flows]
            wanted += ["spectrum"] * ("spectrum" not in wanted)
    full = {
        **table,
        "forcing_row": table.get("forcing_row"),
        "law": table.get("law"),
        "transitions": [{"order": 0, **entry} for entry in table["transitions"]],
    }
    return SavedSystem(
        derivation=str(module.DERIVATION),
        table=decode(TableEntries, full),
        functions={name: _function(module, name, names) for name in wanted},
        orbits=orbits,
    )


def _function(module: ModuleType, name: str, names: Mapping[str, Sequence[str]]) -> Function:
    inputs, outputs = module.KERNELS[name]
    known = {
        "spectrum": (names["spectrum_parameters"],),
        "modes": (names["parameters"], names["spectrum"]),
    }.get(name, (names["parameters"],) if name in _EXACT else ())
    takes = known or [
        [f"{chr(ord('a') + place)}{k + 1}" for k in range(math.prod(shape))]
        for place, (shape, _) in enumerate(inputs)
    ]
    return written(getattr(module, name), takes, inputs, outputs)


def system_in(name: str, saved: SavedSystem | None) -> SystemKernels:
    """The system of a file: the built-in one of that name, or the one that the file holds.

    Raises `InputError` with a message of one line if it is neither, or if the data are not
    consistent.
    """
    if saved is None:
        if name not in system_names():
            raise unknown_name("system", name, system_names())
        return load_system(name)
    if saved.name != name:
        raise InputError(f"'system' is {name!r}, and the file holds {saved.name!r}")
    return kernels_of_saved(saved)


@dataclass(frozen=True, kw_only=True)
class SystemEntries:
    """A system in a file: its name there, and its data if it is not built in."""

    system: str
    tables: SavedSystem | None


def _system_entries(kernels: SystemKernels) -> SystemEntries:
    name, _, saved = named(kernels)
    return SystemEntries(system=name, tables=saved)


# fields of records that files hold: a system, or its name
KeptSystem = Annotated[
    SystemKernels,
    Several(SystemEntries, _system_entries, lambda found: system_in(found.system, found.tables)),
]
KeptSystemName = Annotated[
    str,
    Several(
        SystemEntries,
        lambda name: _system_entries(known_system(name)),
        lambda found: system_in(found.system, found.tables).name,
    ),
]


@dataclass(frozen=True, kw_only=True)
class OrbitNameEntries:
    """An orbit and its system in a file, by the names that the file gives to both."""

    orbit: str
    system: str
    tables: SavedSystem | None


def _orbit_name_entries(orbit: str, system: str) -> OrbitNameEntries:
    """The entries for an orbit, whose system is as it was loaded for this orbit.

    A declared system may be derived with the orbit's symmetry, unlike the system alone.
    """
    label = orbit.removeprefix(f"{system}:")
    name, called, saved = named(known_system(system, None if label == orbit else label), orbit)
    return OrbitNameEntries(orbit=called, system=name, tables=saved)


def _orbit_name(found: OrbitNameEntries) -> tuple[str, str]:
    return found.orbit, system_in(found.system, found.tables).name


# a field of records that files hold: the name of an orbit, beside a field `system`
KeptOrbitName = Annotated[
    str, Several(OrbitNameEntries, _orbit_name_entries, _orbit_name, ("orbit", "system"))
]


def kernels_of_saved(saved: SavedSystem) -> SystemKernels:
    """Tables and kernels of a system that is given as data; `load_system` loads it by its name.

    Raises `InputError` with a message of one line if names, indices, shapes or expressions are
    not consistent.
    """
    _check(saved)
    module = ModuleType("nonsmooth_saved")
    entries = encode(saved)
    own = entries["table"]
    kept = {name: entry for name, entry in own.items() if entry is not None or name == "modes"}
    contents: dict[str, Any] = {
        **saved.functions,
        "SAVED": saved,
        "SYSTEM": kept,
        "ORBITS": dict(saved.orbits),
        "KERNELS": {
            name: (
                [*zip(found.inputs, found.since, strict=True)],
                [*zip(found.names, found.outputs, strict=True)],
            )
            for name, found in saved.functions.items()
        },
        "DERIVATION": saved.derivation,
    }
    vars(module).update(contents)
    return load_system(remember(SystemKernels(saved.name, module)).name)


def _check(saved: SavedSystem) -> None:
    """Refuse data whose parts are not consistent: the engine in C does not check them."""
    table, functions = saved.table, saved.functions
    names = [parameter.name for parameter in table.parameters]
    _once("parameter", names)
    _once("state", table.states)
    size, places = len(table.states), range(len(table.configurations))
    if not re.fullmatch(r"[\w-]{1,200}", table.name) or not size or not places:
        raise InputError("the system has no name, no states or no configurations")
    for parameter in table.parameters:
        _ = parameter.ends
    for constraint in table.constraints:
        for text in constraint.terms:
            if not _PRODUCT.fullmatch(text):
                raise InputError(f"{text[:60]!r} is no product of parameters")
    wanted = {*_EXACT} if table.modes is None else {*_EXACT, *_MODES}
    own = dict(chain.from_iterable(_orbit_shapes(saved, name) for name in saved.orbits))
    for name, function in functions.items():
        if name not in {*wanted, *own, "spectrum"}:
            raise InputError(f"{name[:60]!r} is no function of a system")
        try:
            function.check(exactly=name in _EXACT)
        except InputError as problem:
            raise InputError(f"{name}: {problem}") from None
    if own:
        wanted |= {"spectrum", *(name for name, shapes in own.items() if shapes.needed)}
    if missing := wanted - {*functions}:
        raise InputError(f"{min(missing)!r} is missing among the functions")
    for name in _EXACT:
        _check_shapes(functions, name, _Shapes([(len(names),)], {name: (None, size + 1)}))
    for name in own.keys() & functions.keys():
        _check_shapes(functions, name, own[name])
    rows = functions["rows"].outputs[0][0]
    resets, rest = divmod(functions["resets"].outputs[0][0], size)
    if rest or functions["fields"].outputs[0][0] != size * len(places):
        raise InputError("fields and resets are not as many as the configurations need")
    if "spectrum" in functions:
        given, found = len(table.spectrum_parameters), len(table.spectrum)
        _known("parameter", table.spectrum_parameters, names)
        results = {"spectrum": (found,), "spectrum_derivatives": (found, given)}
        _check_shapes(functions, "spectrum", _Shapes([(given,)], results))
    if table.modes is not None:
        _same_keys("modes", table.modes, table.configurations)
        modes = [mode for name in table.configurations for mode in table.modes[name]]
        if not all(0 < mode.length <= _LONGEST_MODE for mode in modes):
            raise InputError("a mode of no possible length")
        count = sum(mode.length * (1 + mode.oscillates) for mode in modes)
        results = {"exponents": (len(modes), 2), "coefficients": (count * size, size + 1)}
        taken = [(len(names),), (len(table.spectrum),)]
        _check_shapes(functions, "modes", _Shapes(taken, results))
    _check_table(table, rows, resets)


def _check_table(table: TableEntries, rows: int, resets: int) -> None:
    """Refuse names and indices that do not exist."""
    for name in ("held", "constraint_rows", "boundary_rows"):
        _same_keys(name, getattr(table, name), table.configurations)
    for name, boundaries in table.configurations.items():
        _once(f"boundary of {name}", [boundary.name for boundary in boundaries])
        if len(table.boundary_rows[name]) != len(boundaries):
            raise InputError(f"the boundaries of {name} have other rows")
        _known("state", table.held[name], table.states)
    for pair in (*table.forcing, *table.coordinates):
        _known("state", pair, table.states)
    used = [*chain(*table.constraint_rows.values(), *table.boundary_rows.values())]
    used += [0 if table.forcing_row is None else table.forcing_row]
    reset = []
    for transition in table.transitions:
        configurations = [transition.source, transition.target]
        configurations += [along for _, along, _ in transition.conditions]
        _known("configuration", configurations, table.configurations)
        known = [boundary.name for boundary in table.configurations[transition.source]]
        _known("boundary", transition.boundaries, known)
        used += [row for row, _, _ in transition.conditions]
        reset.append(transition.reset)
        _indices("order", [transition.order], 1 << 16)
    for contact in table.contacts.values():
        _known("configuration", contact.forces, table.configurations)
        used += [*contact.forces.values(), contact.velocity, contact.surface]
    if table.law is not None:
        _check_law(table.law, table)
        law = table.law
        for entry in law.contacts:
            used += [row for name, row in vars(entry).items() if name not in ("name", "friction")]
        used += [*chain(*law.coupling, *law.free.values())]
        reset += [place for found in law.resets.values() for place in found.values()]
    _indices("row", used, rows)
    _indices("reset", reset, resets)


def _check_law(law: LawEntries, table: TableEntries) -> None:
    count = len(law.contacts)
    for name in ("regimes", "others", "idle"):
        _same_keys(name, getattr(law, name), table.configurations)
    square = (law.coupling, law.couples)
    if any(len(matrix) != count or {*map(len, matrix)} - {count} for matrix in square):
        raise InputError("'coupling' is not of the law's contacts")
    if {*map(len, law.regimes.values()), *map(len, law.free.values())} - {count}:
        raise InputError("'regimes' are not of the law's contacts")
    _indices("contact", [*law.arrivals.values(), *law.limits.values()], count)
    _indices("contact", chain(*law.idle.values()), count)


_Shape = tuple[int | None, ...]


@dataclass(frozen=True)
class _Shapes:
    """Shapes of a function's arguments and results; None stands for any size above 0."""

    inputs: Sequence[tuple[int, ...]]
    outputs: Mapping[str, _Shape]
    last_since: int = 0  # place of the first result that takes the last argument
    needed: bool = False  # by an orbit


def _orbit_shapes(saved: SavedSystem, name: str) -> Iterator[tuple[str, _Shapes]]:
    """Names of the functions that an orbit may have, with their shapes."""
    table, orbit = saved.table, saved.orbits[name]
    configurations = [configuration for configuration, _, _ in orbit["phases"]]
    _known("configuration", configurations, table.configurations)
    if not all(isinstance(text, str) for text in chain.from_iterable(orbit["phases"])):
        raise InputError(f"a phase of {name} is not in order")
    if not orbit["derived"]:
        return
    prefix = f"{name}_".replace("-", "_")
    given, unknowns, reduced, section, size = (
        len(orbit[entry]) for entry in ("parameters", "unknowns", "reduced", "section", "states")
    )
    spectrum, phases, boundaries = len(table.spectrum), len(configurations), orbit["boundaries"]
    known = [(given,), (spectrum,)]
    point = [*known, (unknowns,)]
    moved = [*point, (spectrum, len(table.spectrum_parameters))]
    along: dict[str, _Shape] = {
        "fields": (phases * size, size + 1),
        "ends": (phases, size),
        "boundaries": (len(boundaries), size + 1),
    }
    if (terms := orbit["terms"]) is not None:
        amplitudes = sum(2 + 2 * terms[boundary[0]] for boundary in boundaries)
        along = {"coefficients": (amplitudes,), "frequencies": (sum(terms),)}
    left: dict[str, _Shape] = {
        "determinants": (None,),
        "reduced_residual": (reduced,),
        "reduced_jacobian": (reduced, reduced),
    }
    own = saved.functions.get(f"{prefix}reduced")
    if own is not None and "determinants" not in own.names:
        del left["determinants"]
    if not reduced:
        del left["reduced_residual"], left["reduced_jacobian"]
    kernels = {
        "equations": _Shapes(
            moved,
            {
                "residual": (unknowns,),
                "jacobian": (unknowns, unknowns),
                "parameter_jacobian": (unknowns, given),
            },
            2,
        ),
        "trace": _Shapes(moved, {"trace": (), "trace_gradient": (unknowns + given,)}, 1),
        "passage": _Shapes(point, {"states": (phases + 1, size), **along}),
        "linearisation": _Shapes(
            point,
            {
                "poincare_jacobian": (section, section),
                "saltations": (phases * size, size),
                "monodromy": (size, size),
            },
        ),
        "reduced": _Shapes(
            [*known, *([(reduced,)] if reduced else [])], {"unknowns": (unknowns,), **left}
        ),
    }
    yield from ((prefix + kind, replace(shapes, needed=True)) for kind, shapes in kernels.items())
    turn: dict[str, _Shape] = {
        "period_map": (size, size + 1),
        "linear_start": (None,),
        "compatibility": (None,),
    }
    yield f"{prefix}period_map", _Shapes(point, turn)
    for configuration in configurations:
        flow = f"flow_{configuration}".replace("-", "_")
        yield prefix + flow, _Shapes([*known, (), (size,)], {"state_after": (size,)})
        every, states = (len(table.parameters),), (len(table.states),)
        yield flow, _Shapes([every, (spectrum,), (), states], {"state_after": states})


def _check_shapes(functions: Mapping[str, Function], name: str, shapes: _Shapes) -> None:
    """Refuse a function with arguments or results of other names or shapes than these."""
    found, wanted = functions[name], shapes.outputs
    since = [0] * len(shapes.inputs)
    since[-1] = shapes.last_since
    fits = [*found.inputs] == [*shapes.inputs] and [*found.since] == since
    fits = fits and [*found.names] == [*wanted]
    for shape, known in zip(found.outputs, wanted.values(), strict=False):
        fits = fits and len(shape) == len(known)
        fits = fits and all(
            n > 0 if k is None else n == k for n, k in zip(shape, known, strict=False)
        )
    if not fits:
        raise InputError(f"what {name!r} takes or gives is not of the system's names and sizes")


def _once(kind: str, names: Sequence[str]) -> None:
    if len({*names}) < len(names):
        raise InputError(f"a {kind} is there twice")


def _known(kind: str, names: Iterable[str], known: Iterable[str]) -> None:
    if unknown := {*names} - {*known}:
        raise InputError(f"unknown {kind} {min(unknown)[:60]!r}")


def _same_keys(what: str, found: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    if found.keys() != wanted.keys():
        raise InputError(f"{what!r} is not of the system's configurations")


def _indices(kind: str, found: Iterable[int], count: int) -> None:
    if not all(0 <= place < count for place in found):
        raise InputError(f"there is no such {kind}")
