"""Records of the emitted tables and kernels: of a system, and of an orbit."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, partial
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.loading.growing import JoinedKernel
from nonsmooth.runtime.model.vectorised import filled, vectorised

# kernels of an orbit, the last of which some have not
_KINDS = ("equations", "trace", "passage", "linearisation", "reduced", "period_map")
_quiet = np.errstate(all="ignore")  # who takes a kernel's numbers looks whether they are finite


@dataclass(frozen=True)
class ParameterTable:
    """Name, meaning and domain of a parameter; an absent end is infinite.

    `closed` says whether the lower end belongs to the domain, `upper_closed` the upper one.
    """

    name: str
    description: str
    lower: str | None
    upper: str | None
    closed: bool
    upper_closed: bool

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Both ends of the domain."""
        lower = -math.inf if self.lower is None else float(parse(self.lower))
        return lower, math.inf if self.upper is None else float(parse(self.upper))


@dataclass(frozen=True)
class Boundary:
    """A boundary that is watched along one phase: one row of the boundary functions."""

    phase: int
    name: str
    open_parameter: str | None  # left open by the orbit's equations
    open_coefficient: float  # factor of the open parameter's value in the function
    begins: bool  # whether the phase begins on the boundary


@dataclass(frozen=True)
class SystemKernels:
    """Tables and kernels of one system."""

    # what loads it again: built-in name, whole path of a user's file or folder, or ``NAME@HASH`` of
    # a System declared in Python
    name: str
    module: ModuleType  # the emitted tables and kernels
    compiled: ModuleType | None = None  # the same kernels in C, as many as there are

    def __hash__(self) -> int:
        """Hash that is computed once: caches are keyed by systems on every path."""
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.name, self.module, self.compiled))

    @property
    def built_in(self) -> bool:
        """Whether this is one of the package's own systems."""
        return self.module.__name__.startswith("nonsmooth.generated.")

    @property
    def table(self) -> dict[str, Any]:
        """The generated table of the system."""
        table: dict[str, Any] = self.module.SYSTEM
        return table

    @cached_property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """Physical parameters and their domains."""
        return tuple(ParameterTable(**entry) for entry in self.table["parameters"])

    @property
    def configurations(self) -> tuple[str, ...]:
        """Names of the configurations."""
        return tuple(self.table["configurations"])

    @property
    def rows(self) -> int:
        """Number of affine functions that the system declares."""
        return self._height("rows")

    @property
    def resets(self) -> int:
        """Number of affine resets that the system declares."""
        return self._height("resets") // len(self.table["states"])

    def _height(self, kernel: str) -> int:
        ((_, shape),) = self.module.KERNELS[kernel][1]
        return int(shape[0])

    def source(self, kernel: str) -> Callable[..., Any]:
        """A kernel over any arithmetic; it takes its arrays as sequences, and ``lib``."""
        function: Callable[..., Any] = getattr(self.module, kernel)
        return function

    def evaluate(self, kernel: str, *arrays: Any, outputs: int | None = None) -> Any:
        """Values of a kernel in double precision; its arguments broadcast over leading axes.

        It gives as many of its outputs as are asked for; arrays at the end that these do not need
        are left out. A tiny imaginary part of an argument comes out as a derivative.
        """
        arrays = arrays[: len(self._shapes(kernel, outputs)[0])]
        if any(map(np.iscomplexobj, arrays)):
            return self._on_numpy(kernel, outputs)(*arrays)
        return self.function(kernel, outputs)(*arrays)

    @cache  # noqa: B019 - as long as `loading.load.remember` keeps the system
    def function(self, kernel: str, outputs: int | None = None) -> Callable[..., Any]:
        """The function that evaluates a kernel in double precision, in C if it is compiled."""
        shapes = self._shapes(kernel, outputs)
        name = f"{self.table['name'].replace('-', '_')}_{kernel}_{len(shapes[1])}"
        compiled = getattr(self.compiled, name, None)
        if compiled is None:
            return self._on_numpy(kernel, outputs)
        return _quiet(filled(compiled, *shapes))

    @cache  # noqa: B019 - as `function`
    def _on_numpy(self, kernel: str, outputs: int | None) -> Callable[..., Any]:
        source = self.source(kernel)
        if isinstance(source, JoinedKernel):
            return _quiet(partial(source.evaluated, lib=FLOATS))
        inputs, given = self._shapes(kernel, outputs)
        if len(given) < len(self.module.KERNELS[kernel][1]):
            source = partial(source, outputs=len(given))
        return _quiet(vectorised(source, inputs, given))

    @cache  # noqa: B019 - as `function`
    def _shapes(
        self, kernel: str, outputs: int | None
    ) -> tuple[list[tuple[int, ...]], list[tuple[int, ...]]]:
        """Core shapes of the first outputs of a kernel, and of the arguments that they need."""
        takes, gives = self.module.KERNELS[kernel]
        given = [tuple(shape) for _, shape in gives[:outputs]]
        return [tuple(shape) for shape, since in takes if since < len(given)], given


class KernelCall(NamedTuple):
    """How quantities of one kernel are computed."""

    function: Callable[..., Any]  # in doubles
    source: Callable[..., Any]  # over any arithmetic
    arrays: int  # how many it takes
    places: list[int] | None  # of the quantities among the results; None if they are all


@dataclass(frozen=True, eq=False)
class SavedTable:
    """The table of an orbit from a file of results; that orbit is its reference."""

    name: str  # of the orbit; the address if the orbit has none
    address: str  # what loads it again: the whole path ``FILE.json:N``
    entries: dict[str, Any]  # as in the table of a declared orbit


@dataclass(frozen=True)
class OrbitKernels:
    """Tables and kernels of one orbit of a system."""

    system: SystemKernels
    orbit: str  # name among the system's orbits; empty if the system does not declare it
    saved: SavedTable | None = None  # its table if a file of results holds it

    def __hash__(self) -> int:
        """Hash that is computed once, as that of the system."""
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.system, self.orbit, self.saved))

    @property
    def name(self) -> str:
        """``system/orbit``, or ``FILE.py:orbit`` and the like where it is not built in."""
        if self.saved is not None:
            return self.saved.name
        return f"{self.system.name}{'/' if self.system.built_in else ':'}{self.orbit}"

    @property
    def address(self) -> str:
        """The name with which the orbit can be loaded again."""
        return self.name if self.saved is None else self.saved.address

    @property
    def derived(self) -> bool:
        """Whether this orbit has kernels of its own; else it is composed from its system's.

        The table of a composed orbit holds the phases, the reason, the names of the start's
        unknowns, the parameter that gives the period, and a reference; nothing else here applies.
        """
        return bool(self.table["derived"])

    @property
    def table(self) -> dict[str, Any]:
        """The table of the orbit, generated or saved."""
        if self.saved is not None:
            return self.saved.entries
        table: dict[str, Any] = self.system.module.ORBITS[self.orbit]
        return table

    @cached_property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """Parameters of the equations."""
        return tuple(ParameterTable(**entry) for entry in self.table["parameters"])

    @cached_property
    def open_parameters(self) -> tuple[ParameterTable, ...]:
        """Parameters that only admissibility depends on."""
        return tuple(ParameterTable(**entry) for entry in self.table["open_parameters"])

    @cached_property
    def other_parameters(self) -> tuple[ParameterTable, ...]:
        """Parameters of the system that this orbit does not depend on, or does not leave free."""
        return tuple(ParameterTable(**entry) for entry in self.table["other_parameters"])

    @cached_property
    def tables(self) -> dict[str, ParameterTable]:
        """All parameters that may be given, by name, those of the equations first."""
        every = (*self.parameters, *self.open_parameters, *self.other_parameters)
        return {table.name: table for table in every}

    @cached_property
    def required(self) -> dict[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""
        return dict(self.table["required"])

    @cached_property
    def solved_for(self) -> tuple[str, ...]:
        """Names of the parameters among the unknowns."""
        others = [p.name for p in self.other_parameters]
        return tuple(name for name in self.unknowns if name in others)

    @cached_property
    def parameter_names(self) -> tuple[str, ...]:
        """Names of the equations' parameters, in the kernels' order."""
        return tuple(p.name for p in self.parameters)

    @cached_property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns, in the kernels' order."""
        return tuple(self.table["unknowns"])

    @cached_property
    def dwell_times(self) -> tuple[str, ...]:
        """Names of the dwell times, one for each phase; not all need be unknowns."""
        return tuple(self.table["dwell_times"])

    @cached_property
    def timed(self) -> tuple[str, ...]:
        """Names of the dwell times among the unknowns."""
        return tuple(name for name in self.unknowns if name in self.dwell_times)

    def durations(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Dwell time of each phase by name, from parameters and unknowns (numbers or arrays).

        A dwell time that is no unknown is the period, what the others leave of it, or zero.
        """
        return {
            name: _total(
                values[term] if factor == 1 else factor * values[term]
                for term, factor in terms.items()
            )
            for name, terms in zip(self.dwell_times, self.table["durations"], strict=True)
        }

    @cached_property
    def period_name(self) -> str | None:
        """The parameter that is the sum of a conservative orbit's dwell times; None for others."""
        total: dict[str, int] = {}
        for terms in self.table["durations"]:
            for name, factor in terms.items():
                total[name] = total.get(name, 0) + factor
        left = [name for name, factor in total.items() if factor]
        return left[0] if len(left) == 1 and total[left[0]] == 1 else None

    @cached_property
    def reduced(self) -> tuple[str, ...]:
        """Names of the reduced unknowns."""
        return tuple(self.table["reduced"])

    @cached_property
    def boundaries(self) -> tuple[Boundary, ...]:
        """Rows of the boundary functions."""
        return tuple(Boundary(*row) for row in self.table["boundaries"])

    @property
    def trigonometric(self) -> bool:
        """Whether boundary functions are trigonometric sums, in all phases."""
        return self.table["terms"] is not None

    @cached_property
    def combined(self) -> dict[str, dict[str, int]]:
        """Parameters that are sums of multiples of physical ones, e = ur - us."""
        return dict(self.table["combined"])

    @cached_property
    def spectrum_places(self) -> np.ndarray:
        """Indices of the spectrum's parameters among the equations' parameters."""
        names = self.system.table["spectrum_parameters"]
        return np.array([self.parameter_names.index(name) for name in names], dtype=np.intp)

    @cached_property
    def frequency_places(self) -> list[int]:
        """Indices of the frequencies in the spectrum."""
        names = self.system.table["spectrum"]
        return [place for place, name in enumerate(names) if name.startswith("omega")]

    def evaluate(self, *quantities: str, at: Sequence[Any], lib: Any = None) -> Any:
        """Value of a quantity, or a tuple of several that one kernel gives.

        `at` holds the arrays that the kernel takes: parameters, spectrum, unknowns (or reduced
        ones), then the spectrum's derivatives for what needs them. Without ``lib`` they are floats
        that broadcast over leading axes, else one point in that arithmetic.

        ========================================  ===========================================
        residual, jacobian, parameter_jacobian    of the equations
        trace, trace_gradient                     of the Poincare map's Jacobian
        states                                    at the start and behind each transition
        coefficients, frequencies                 of the boundaries along the phases, or
        fields, ends, boundaries                  if they are no trigonometric sums
        poincare_jacobian, saltations, monodromy  of the orbit
        unknowns, determinants                    all unknowns from the reduced ones
        reduced_residual, reduced_jacobian        of the reduced equations
        period_map, linear_start, compatibility   the map of a turn, and what follows from it
        ========================================  ===========================================

        Raises `InputError` for a quantity that this orbit has not, and for several of two kernels.
        """
        call = self._calls.get(quantities) or self._call_of(quantities)
        if lib is None:
            found = call.function(*at[: call.arrays])
        else:
            found = call.source(*at[: call.arrays], lib=lib)
        if call.places is None:
            return found
        return tuple(found[place] for place in call.places) if len(quantities) > 1 else found[-1]

    def has(self, quantity: str) -> bool:
        """Whether a kernel of this orbit gives a quantity."""
        return quantity in self._quantities

    @cached_property
    def of_equations(self) -> tuple[str, ...]:
        """Quantities at all unknowns; those of the reduced equations are not among them."""
        known = self._quantities.items()
        return tuple(name for name, (kernel, _) in known if not kernel.endswith("_reduced"))

    @cached_property
    def _quantities(self) -> dict[str, tuple[str, int]]:
        """Kernel and place among its outputs, by the name of what it gives."""
        kernels, prefix = self.system.module.KERNELS, self.orbit.replace("-", "_")
        names = [f"{prefix}_{kind}" for kind in _KINDS]
        return {
            quantity: (name, place)
            for name in names
            if name in kernels
            for place, (quantity, _) in enumerate(kernels[name][1])
        }

    @cached_property
    def _calls(self) -> dict[tuple[str, ...], KernelCall]:
        """How the quantities are computed that were asked for so far."""
        return {}

    def _call_of(self, quantities: tuple[str, ...]) -> KernelCall:
        for quantity in quantities:
            if quantity not in self._quantities:
                raise unknown_name("quantity", quantity, self._quantities)
        known = [self._quantities[quantity] for quantity in quantities]
        kernel = known[0][0] if known else ""
        if {name for name, _ in known} != {kernel}:
            together: dict[str, list[str]] = {}
            for quantity, (name, _) in self._quantities.items():
                together.setdefault(name, []).append(quantity)
            wrong = (
                f"no kernel gives {' and '.join(quantities)}" if known else "no quantity is named"
            )
            groups = "; ".join(map(", ".join, together.values()))
            raise InputError(f"{wrong}; together there are: {groups}")
        places, system = [place for _, place in known], self.system
        count, total = max(places) + 1, len(system.module.KERNELS[kernel][1])
        source = system.source(kernel)
        call = KernelCall(
            system.function(kernel, count),
            source if total == 1 else partial(source, outputs=count),
            sum(since < count for _, since in system.module.KERNELS[kernel][0]),
            None if places == [*range(count)] else places,
        )
        self._calls[quantities] = call
        return call

    def spectrum(self, parameters: Any, lib: Any = None) -> tuple[Any, Any]:
        """The spectrum and its derivatives at the equations' parameters, in their order.

        Without ``lib`` the parameters are an array (..., p) of floats; with it they are one point
        in that arithmetic.
        """
        if lib is not None:
            found: tuple[Any, Any] = self.system.source("spectrum")(
                [parameters[i] for i in self.spectrum_places], lib=lib
            )
            return found
        values = np.asarray(parameters, dtype=float)
        result: tuple[Any, Any] = self.system.evaluate(
            "spectrum", values.take(self.spectrum_places, axis=-1)
        )
        return result

    def expand(self, parameters: Any, spectrum: Any, reduced: Any) -> tuple[Any, Any]:
        """All unknowns (..., n) from the reduced ones, and determinants (..., d).

        Each determinant is that of a linear system solved on the way, relative to its bound.
        Everything is in floats: parameters (..., p), spectrum (..., k), reduced unknowns (..., r),
        which are not used if the orbit has none.
        """
        at = (parameters, spectrum, *([reduced] if self.reduced else []))
        if self.has("determinants"):
            found: tuple[Any, Any] = self.evaluate("unknowns", "determinants", at=at)
            return found
        values = self.evaluate("unknowns", at=at)
        return values, np.ones((*np.shape(values)[:-1], 0))

    @cached_property
    def solver(self) -> Callable[..., Any] | None:
        """The compiled solver of this orbit, if there is one."""
        return self._compiled("solve")

    @cached_property
    def admissible(self) -> Callable[..., Any] | None:
        """The compiled admissibility test of this orbit, if there is one."""
        return self._compiled("admissible")

    @cached_property
    def directions(self) -> Callable[..., Any] | None:
        """The compiled derivatives of this orbit by its parameters, if there are any."""
        return self._compiled("directions")

    def flow(
        self, configuration: str, parameters: Any, spectrum: Any, time: Any, state: Any
    ) -> Any:
        """State (..., N) after a time (...) in one configuration, in the orbit's coordinates.

        Where they are the system's the flow is its flow.
        """
        kernel = f"flow_{configuration}".replace("-", "_")
        own = f"{self.orbit}_{kernel}".replace("-", "_")
        if own in self.system.module.KERNELS:
            return self.system.evaluate(own, parameters, spectrum, time, state)
        given = np.asarray(parameters)
        # the orbit's parameters are all that its flows depend on
        known = dict(zip(self.parameter_names, np.moveaxis(given, -1, 0), strict=True))
        nothing = np.full(given.shape[:-1], np.nan)
        every = np.stack([known.get(p.name, nothing) for p in self.system.parameters], axis=-1)
        return self.system.evaluate(kernel, every, spectrum, time, state)

    def _compiled(self, name: str) -> Callable[..., Any] | None:
        prefix = f"{self.system.table['name']}_{self.orbit}".replace("-", "_")
        compiled = getattr(self.system.compiled, f"{prefix}_{name}", None)
        return None if compiled is None else _quiet(compiled)


def _total(terms: Iterator[Any]) -> Any:
    """Sum of numbers or arrays; the first one is not added to zero."""
    return sum(terms, next(terms, 0))
