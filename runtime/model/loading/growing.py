"""Systems whose configurations are made when they are first visited, as modules that grow.

A declaration with too many configurations to list hands out pieces: one configuration with its
boundaries and what follows them, or what follows several boundaries that are reached at one
instant. Their tables joined are a module of tables and kernels as any other. Nothing that is in
it changes its place when a piece is added, so that indices of configurations stay as they are.
A configuration that pieces only lead to has the boundary `NOT_VISITED`, which is passed already.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice, product
from threading import RLock
from types import ModuleType
from typing import Any, Protocol, runtime_checkable

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.loading.caching import cached, module_of_text, stored
from nonsmooth.runtime.model.loading.declared import DeclaredSystem

NOT_VISITED = "not-visited"
Visit = tuple[str, tuple[str, ...]]  # a configuration, and boundaries reached together, or none
_MOST_TRIED = 4096  # combinations of regimes
_KINDS = ("fields", "rows", "resets")


@runtime_checkable
class GrowingDeclaration(DeclaredSystem, Protocol):
    """A declared system that is derived in pieces: see `nonsmooth.derive.building.growing`."""

    @property
    def regimes(self) -> Sequence[tuple[str, tuple[str, ...]]]:
        """Name and regimes of each part; the name of a configuration joins one regime of each."""
        ...

    def has(self, name: str) -> bool:
        """Whether there is a configuration of this name."""
        ...

    def piece(self, name: str, boundaries: Collection[str] = ()) -> str:
        """Python text of a configuration with what follows its boundaries.

        With several boundaries it is what follows if these are reached at one instant.
        """
        ...

    def composed(self, orbit: Any) -> dict[str, Any]:
        """The table of an orbit that is composed from the system's own tables and kernels."""
        ...


@dataclass(eq=False)
class Growth:
    """All pieces of a declaration that were made so far, joined."""

    declared: GrowingDeclaration
    key: str  # hash of the declaration
    _pieces: dict[Visit, tuple[str, ModuleType]] = field(default_factory=dict)
    _union: _Union = field(default_factory=lambda: _Union())
    _joined: tuple[str, ModuleType] | None = None
    _lock: Any = field(default_factory=RLock)

    def joined(
        self, visits: Iterable[Visit] = (), orbits: Sequence[Any] = ()
    ) -> tuple[str, ModuleType]:
        """Make missing pieces and join all: the module, and the key under which it is stored.

        The phases of the orbits are visited too, and their tables are in the module. Without orbits
        it is the same module as before if nothing was added. Raises `InputError` if there is no
        such configuration, or no piece of it.
        """
        phases = [
            (str(p.configuration), tuple(sorted(str(p.boundary).split("+"))))
            for orbit in orbits
            for p in orbit.phases
        ]
        wanted = [(self._first, ()), *visits, *phases]
        with self._lock:
            before = len(self._pieces)
            for name, boundaries in dict.fromkeys(wanted):
                self._add((name, ()))
                if len(boundaries) > 1:
                    self._add((name, tuple(sorted(boundaries))))
            if self._joined is None or len(self._pieces) > before:
                self._joined = self._join({})
            if not orbits:
                return self._joined
            return self._join({orbit.name: self.declared.composed(orbit) for orbit in orbits})

    @property
    def starts(self) -> list[dict[str, tuple[list[int], list[int]]]]:
        """For each part and regime the rows that are not positive in it, and those that vanish."""
        first: list[dict[str, tuple[list[int], list[int]]]] = self._pieces[self._first, ()][
            1
        ].STARTS
        return first

    def first_of(self, regimes: Sequence[Sequence[str]]) -> str | None:
        """The first existing configuration with one of the given regimes of each part.

        None if no combination exists, or if too many would have to be tried.
        """
        names = islice(_names(regimes), _MOST_TRIED)
        return next((name for name in names if self.declared.has(name)), None)

    @property
    def _first(self) -> str:
        """The first existing configuration in the order of all regimes of each part."""
        if self._pieces:
            return next(iter(self._pieces))[0]
        found = self.first_of([names for _, names in self.declared.regimes])
        if found is None:
            raise InputError(f"{self.declared.name} has no configuration to begin with")
        return found

    def _add(self, visit: Visit) -> None:
        if visit in self._pieces:
            return
        name, boundaries = visit
        key = hashlib.sha256(repr((self.key, *visit)).encode()).hexdigest()[:16]
        try:
            text = cached(key, lambda: self.declared.piece(name, boundaries))
        except InputError:
            raise
        except ValueError as problem:
            raise InputError(" ".join(str(problem).split())) from problem
        module = module_of_text(text, f"<{self.declared.name}@{key}>")
        self._union.add(module)
        self._pieces[visit] = key, module

    def _join(self, orbits: dict[str, Any]) -> tuple[str, ModuleType]:
        keys = tuple(key for key, _ in self._pieces.values())
        own = hashlib.sha256(repr((keys, orbits)).encode()).hexdigest()[:16]
        text = (
            "from nonsmooth.runtime.model.loading.growing import recalled\n\n"
            f"globals().update(recalled({keys!r}, {orbits!r}))\n"
        )
        cached(own, lambda: text)
        module = ModuleType("nonsmooth_emitted")
        module.__file__ = f"<{self.declared.name}@{own}>"
        vars(module).update(self._union.contents(orbits))
        _GROWTHS[module] = self
        return own, module


_GROWTHS: dict[ModuleType, Growth] = {}  # of every module that was joined
_DECLARED: dict[str, Growth] = {}


def growth_of(module: ModuleType) -> Growth | None:
    """The growth that joined a module; None for all others, even if joined in another process."""
    return _GROWTHS.get(module)


def growth_for(declared: GrowingDeclaration) -> Growth:
    """The growth of a declaration; equal declarations share one."""
    key = declared.fingerprint()
    return _DECLARED.setdefault(key, Growth(declared, key))


def recalled(keys: Sequence[str], orbits: dict[str, Any]) -> dict[str, Any]:
    """Contents of a module that another process joined, from the stored pieces.

    `keys` are those of the pieces, `orbits` the tables of orbits. Raises `InputError` if a piece
    is no longer stored.
    """
    union = _Union()
    for key in keys:
        text = stored(key)
        if text is None:
            raise InputError("a part of a stored system is gone: hand over the System itself again")
        union.add(module_of_text(text, f"<{key}>"))
    return union.contents(orbits)


def _names(regimes: Sequence[Sequence[str]]) -> Iterable[str]:
    return ("-".join(each) for each in product(*regimes))


class _Places:
    """Places of the rows or resets of all pieces; equal names share one place."""

    def __init__(self) -> None:
        self.origins: list[tuple[int, int]] = []
        self._known: dict[str, int] = {}

    def added(self, piece: int, names: Sequence[str]) -> list[int]:
        """The places of a piece's rows or resets, by their names."""
        for own, name in enumerate(names):
            if name not in self._known:
                self._known[name] = len(self.origins)
                self.origins.append((piece, own))
        return [self._known[name] for name in names]


class _Union:
    """Tables and kernels of pieces joined one after the other; earlier ones keep their places."""

    def __init__(self) -> None:
        self.pieces: list[ModuleType] = []
        self.parts: list[dict[str, _Part]] = []
        self.rows, self.resets = _Places(), _Places()
        self.fields: dict[str, tuple[int, int] | None] = {}
        self.tables: dict[str, dict[str, Any]] = {
            name: {} for name in ("configurations", "held", "constraint_rows", "boundary_rows")
        }
        self.transitions: list[dict[str, Any]] = []
        self.forces: dict[str, dict[str, int]] = {}

    def add(self, piece: ModuleType) -> None:
        """Join one more piece."""
        place, table = len(self.pieces), piece.SYSTEM
        row, reset = self.rows.added(place, piece.ROWS), self.resets.added(place, piece.RESETS)
        # what the first one says of rows holds for all
        assert place or row == list(range(len(row)))
        for name in (*piece.FIELDS, *piece.LED):
            if name not in self.fields:
                self.fields[name] = None
                self.tables["configurations"][name] = [
                    {"name": NOT_VISITED, "acts_when": "exceeded"}
                ]
                self.tables["boundary_rows"][name] = [row[piece.ONE]]
                self.tables["held"][name] = self.tables["constraint_rows"][name] = []
        for own, name in enumerate(piece.FIELDS):
            if own == 0 or self.fields[name] is None:
                self.fields[name] = place, own
        ((name, boundaries),) = table["configurations"].items()
        self.tables["configurations"][name] = boundaries
        self.tables["held"][name] = table["held"][name]
        for kind in ("constraint_rows", "boundary_rows"):
            self.tables[kind][name] = [row[r] for r in table[kind][name]]
        for contact, found in table["contacts"].items():
            forces = self.forces.setdefault(contact, {})
            forces |= {c: row[r] for c, r in found["forces"].items()}
        self.transitions += [
            {
                **entry,
                "conditions": [[row[r], along, holds] for r, along, holds in entry["conditions"]],
                "reset": reset[entry["reset"]],
            }
            for entry in table["transitions"]
        ]
        self.pieces.append(piece)
        self.parts.append({kind: _part(piece, kind) for kind in _KINDS})

    def contents(self, orbits: dict[str, Any]) -> dict[str, Any]:
        """Contents of a module of all pieces joined so far."""
        first = self.pieces[0].SYSTEM
        size, points = len(first["states"]), len(first["parameters"])
        contacts = {
            name: {**found, "forces": dict(self.forces[name])}
            for name, found in first["contacts"].items()
        }
        origins: dict[str, list[tuple[int, int] | None]] = {
            "fields": list(self.fields.values()),
            "rows": list(self.rows.origins),
            "resets": list(self.resets.origins),
        }
        heights = {"fields": size, "rows": 1, "resets": size}
        derivation = hashlib.sha256(repr([piece.DERIVATION for piece in self.pieces]).encode())
        return {
            "DERIVATION": derivation.hexdigest()[:16],
            "SYSTEM": {
                **first,
                **{name: dict(table) for name, table in self.tables.items()},
                "transitions": list(self.transitions),
                "contacts": contacts,
            },
            "ORBITS": orbits,
            "KERNELS": {
                kind: (
                    [((points,), 0)],
                    [(kind, (len(origins[kind]) * heights[kind], size + 1))],
                )
                for kind in _KINDS
            },
            **{
                kind: JoinedKernel(
                    [part[kind] for part in self.parts],
                    [piece.SHAPES[kind][0] // heights[kind] for piece in self.pieces],
                    origins[kind],
                    heights[kind],
                    size + 1,
                )
                for kind in _KINDS
            },
        }


@dataclass(frozen=True)
class _Part:
    """The entries of a matrix that one piece defines."""

    numbers: np.ndarray  # (n, 4) of object: row, column, and the fraction p / q
    places: np.ndarray  # (m, 2) of int: row and column of each entry that depends on parameters
    entries: Callable[..., Sequence[Any]]  # gives the values of these entries


def _part(piece: ModuleType, kind: str) -> _Part:
    return _Part(
        np.array(piece.NUMBERS[kind], dtype=object).reshape(-1, 4),
        np.array(piece.PLACES[kind], dtype=int).reshape(-1, 2),
        getattr(piece, f"{kind}_entries"),
    )


class JoinedKernel:
    """A matrix of a joined system over any arithmetic; entries that no piece has are zero.

    The matrix consists of blocks of rows of one `height` and `width`. `parts` has the entries of
    each piece and `counts` the number of its blocks; `origins` gives for each block of the
    matrix its piece and its place there.
    """

    def __init__(
        self,
        parts: Sequence[_Part],
        counts: Sequence[int],
        origins: Sequence[tuple[int, int] | None],
        height: int,
        width: int,
    ) -> None:
        self._shape = len(origins) * height, width
        blocks = [np.full(count, -1) for count in counts]
        for place, origin in enumerate(origins):
            if origin is not None:
                blocks[origin[0]][origin[1]] = place
        self._known: list[np.ndarray] = []
        self._open: list[tuple[Callable[..., Sequence[Any]], np.ndarray, np.ndarray]] = []
        for part, block in zip(parts, blocks, strict=True):
            rows = part.numbers[:, 0].astype(int)
            found = block[rows // height]
            kept, moved = found >= 0, part.numbers.copy()
            moved[:, 0] = found * height + rows % height
            self._known.append(moved[kept])
            found = block[part.places[:, 0] // height]
            kept, places = found >= 0, part.places.copy()
            places[:, 0] = found * height + places[:, 0] % height
            if kept.any():
                self._open.append((part.entries, np.flatnonzero(kept), places[kept]))

    def __call__(self, parameters: Sequence[Any], *, lib: Any) -> list[list[Any]]:
        """The matrix as a list of rows, at one point in the arithmetic `lib`."""
        found: list[list[Any]] = [[0] * self._shape[1] for _ in range(self._shape[0])]
        for known in self._known:
            for row, column, p, q in known:
                found[row][column] = p if q == 1 else lib.rational(p, q)
        for entries, which, places in self._open:
            made = entries(parameters, lib=lib)
            for k, (row, column) in zip(which, places, strict=True):
                found[row][column] = made[k]
        return found

    @cached_property
    def _constant(self) -> np.ndarray:
        found = np.zeros(self._shape)
        for known in self._known:
            values = [p / q for p, q in known[:, 2:]]
            found[known[:, 0].astype(int), known[:, 1].astype(int)] = values
        found.flags.writeable = False
        return found

    def evaluated(self, parameters: Any, lib: Any) -> np.ndarray:
        """The matrices (..., rows, columns) at points (..., p), in double precision."""
        points = np.asarray(parameters)
        points = points if np.iscomplexobj(points) else points.astype(float)
        shape = *points.shape[:-1], *self._shape
        found = np.broadcast_to(self._constant, shape).astype(points.dtype)
        each = np.moveaxis(points, -1, 0)
        for entries, which, places in self._open:
            made = entries(each, lib=lib)
            for k, (row, column) in zip(which, places, strict=True):
                found[..., row, column] = made[k]
        return found
