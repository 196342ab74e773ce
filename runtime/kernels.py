"""The one door to generated/: tables and kernels of systems and orbits, compiled or not."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from importlib.resources import files
from types import ModuleType
from typing import Any

import numpy as np

from nonsmooth.runtime.arithmetic import FLOATS
from nonsmooth.runtime.errors import InputError, unknown_name

__all__ = [
    "Boundary",
    "OrbitKernels",
    "ParameterTable",
    "SystemKernels",
    "backend",
    "load_orbit",
    "load_system",
    "orbit_names",
    "system_names",
]

_PACKAGE = "nonsmooth.generated"
_PROVENANCE = "PROVENANCE.json"
_REMEDY = "run `nonsmooth regenerate`, or install the package again"


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


@dataclass(frozen=True)
class Boundary:
    """A boundary watched along one phase: one row of the boundary functions.

    Attributes
    ----------
    phase : int
    name : str
    open_parameter : str or None
        Parameter that the orbit's equations leave open; it enters the function as
        ``open_coefficient * value``.
    open_coefficient : float
    begins : bool
        Whether the phase begins on the boundary.
    """

    phase: int
    name: str
    open_parameter: str | None
    open_coefficient: float
    begins: bool


@dataclass(frozen=True)
class SystemKernels:
    """Tables and kernels of one system."""

    name: str
    module: ModuleType
    compiled: ModuleType | None

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

    def source(self, kernel: str) -> Callable[..., Any]:
        """A kernel over any arithmetic: takes its arrays as sequences, and ``lib``."""
        function: Callable[..., Any] = getattr(self.module, kernel)
        return function

    def evaluate(self, kernel: str, *arrays: Any) -> Any:
        """A kernel in double precision, broadcast over leading axes."""
        return self._callable(kernel)(*arrays)

    def flow(self, configuration: str, parameters: Any, time: Any, state: Any) -> Any:
        """State after a time in one configuration; physical coordinates, nondimensional.

        Parameters
        ----------
        configuration : str
        parameters : array (..., p)
            In the order of `parameters`.
        time : array (...)
        state : array (..., N)

        Raises
        ------
        InputError
            For an unknown configuration.
        """
        if configuration not in self.configurations:
            raise unknown_name("configuration", configuration, self.configurations)
        parameters = np.asarray(parameters, dtype=float)
        names = [p.name for p in self.parameters]
        places = [names.index(name) for name in self.table["spectrum_parameters"]]
        spectrum, _ = self.evaluate("spectrum", parameters[..., places])
        kernel = f"flow_{configuration.replace('-', '_')}"
        return self.evaluate(kernel, parameters, spectrum, time, state)

    @cache  # noqa: B019 - systems live as long as the process
    def _callable(self, kernel: str) -> Callable[..., Any]:
        if self.compiled is not None:
            function: Callable[..., Any] = getattr(
                self.compiled, f"{self.name.replace('-', '_')}_{kernel}"
            )
            return function
        inputs, outputs = self.module.KERNELS[kernel]
        return _vectorised(self.source(kernel), inputs, outputs)


def _vectorised(
    function: Callable[..., Any], inputs: list[tuple[int, ...]], outputs: list[tuple[int, ...]]
) -> Callable[..., Any]:
    """The generalized ufunc of an any-arithmetic kernel, on NumPy."""

    def call(*arrays: Any) -> Any:
        unpacked = []
        for array, shape in zip(arrays, inputs, strict=True):
            array = np.asarray(array, dtype=float)
            if array.shape[array.ndim - len(shape) :] != tuple(shape):
                raise ValueError(f"an argument of shape {array.shape} does not end in {shape}")
            unpacked.append(np.moveaxis(array, range(-len(shape), 0), range(len(shape))))
        lead = np.broadcast_shapes(
            *(a.shape[len(shape) :] for a, shape in zip(unpacked, inputs, strict=True))
        )
        found = function(*unpacked, lib=FLOATS)
        results = []
        for value, shape in zip(found if len(outputs) > 1 else (found,), outputs, strict=True):
            flat = [value] if not shape else list(value)
            if len(shape) == 2:
                flat = [entry for row in flat for entry in row]
            stacked = np.stack([np.broadcast_to(entry, lead) for entry in flat], axis=-1)
            results.append(stacked.reshape((*lead, *shape)).astype(float, copy=False))
        return tuple(results) if len(results) > 1 else results[0][()]

    return call


@dataclass(frozen=True)
class OrbitKernels:
    """Tables and kernels of one orbit of a system."""

    system: SystemKernels
    orbit: str

    @property
    def name(self) -> str:
        """``system/orbit``."""
        return f"{self.system.name}/{self.orbit}"

    @property
    def table(self) -> dict[str, Any]:
        """The generated table of the orbit."""
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
    def required(self) -> dict[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""
        return dict(self.table["required"])

    @cached_property
    def solved_for(self) -> tuple[str, ...]:
        """Parameters among the unknowns."""
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
        """Dwell times among the unknowns."""
        return tuple(name for name in self.unknowns if name in self.dwell_times)

    def durations(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Dwell time of each phase, from parameters and unknowns.

        One that is no unknown is the period, what the others leave of it, or zero.
        """
        return {
            name: sum(factor * values[term] for term, factor in terms.items())
            for name, terms in zip(self.dwell_times, self.table["durations"], strict=True)
        }

    @cached_property
    def reduced(self) -> tuple[str, ...]:
        """Names of the reduced unknowns."""
        return tuple(self.table["reduced"])

    @cached_property
    def boundaries(self) -> tuple[Boundary, ...]:
        """Rows of the boundary functions."""
        return tuple(Boundary(*row) for row in self.table["boundaries"])

    @cached_property
    def combined(self) -> dict[str, dict[str, int]]:
        """Parameters that are sums of multiples of physical ones, e = ur - us."""
        return dict(self.table["combined"])

    @cached_property
    def spectrum_places(self) -> list[int]:
        """Where among the parameters those of the spectrum stand."""
        return [self.parameter_names.index(n) for n in self.system.table["spectrum_parameters"]]

    def source(self, kernel: str) -> Callable[..., Any]:
        """A kernel of this orbit over any arithmetic."""
        return self.system.source(f"{self.orbit.replace('-', '_')}_{kernel}")

    def evaluate(self, kernel: str, *arrays: Any) -> Any:
        """A kernel of this orbit in double precision, broadcast over leading axes."""
        return self.system.evaluate(f"{self.orbit.replace('-', '_')}_{kernel}", *arrays)

    def spectrum(self, parameters: Any, lib: Any = None) -> tuple[Any, Any]:
        """Spectrum and its derivatives at the equations' parameters.

        Without ``lib`` for arrays (..., p) of floats; with it for one point in that
        arithmetic.
        """
        if lib is not None:
            found: tuple[Any, Any] = self.system.source("spectrum")(
                [parameters[i] for i in self.spectrum_places], lib=lib
            )
            return found
        values = np.asarray(parameters, dtype=float)
        result: tuple[Any, Any] = self.system.evaluate(
            "spectrum", values[..., self.spectrum_places]
        )
        return result

    def expand(self, parameters: Any, spectrum: Any, reduced: Any) -> tuple[Any, Any]:
        """All unknowns from the reduced ones, and determinants in units of their bounds.

        Floats, arrays (..., n) and (..., d); d is the number of linear systems that were
        solved on the way.
        """
        arrays = (parameters, spectrum, *([reduced] if self.reduced else []))
        found = self.evaluate("expand", *arrays)
        if isinstance(found, tuple):
            return found
        return found, np.ones((*np.shape(found)[:-1], 0))

    @property
    def solver(self) -> Callable[..., Any] | None:
        """The compiled solver of this orbit, if there is one."""
        return self._compiled("solve")

    @property
    def admissible(self) -> Callable[..., Any] | None:
        """The compiled admissibility test of this orbit, if there is one."""
        return self._compiled("admissible")

    def _compiled(self, name: str) -> Callable[..., Any] | None:
        if self.system.compiled is None:
            return None
        prefix = f"{self.system.name}_{self.orbit}".replace("-", "_")
        return getattr(self.system.compiled, f"{prefix}_{name}", None)


def system_names() -> tuple[str, ...]:
    """Names of the generated systems."""
    return tuple(_provenance()["systems"])


def orbit_names() -> tuple[str, ...]:
    """Names ``system/orbit`` of all generated orbits."""
    return tuple(
        f"{system}/{orbit}"
        for system in system_names()
        for orbit in load_system(system).module.ORBITS
    )


def backend() -> str:
    """Which kernels are used: "c" when they are built, else "numpy".

    The environment variable NONSMOOTH_BACKEND chooses; asking for C that is not there is an
    InputError.
    """
    return "numpy" if _compiled_module() is None else "c"


def load_orbit(name: str) -> OrbitKernels:
    """Tables and kernels of ``system/orbit``.

    Raises
    ------
    InputError
        For an unknown name, or generated files that are cut, edited or foreign.
    """
    system, _, orbit = name.partition("/")
    if system in system_names():
        loaded = load_system(system)
        if orbit in loaded.module.ORBITS:
            return _orbit(loaded.name, orbit, backend())
    raise unknown_name("orbit", name, orbit_names())


def load_system(name: str) -> SystemKernels:
    """Tables and kernels of a system; errors as for `load_orbit`."""
    if name not in system_names():
        raise unknown_name("system", name, system_names())
    return _system(name, backend())


@cache
def _orbit(system: str, orbit: str, chosen: str) -> OrbitKernels:
    return OrbitKernels(_system(system, chosen), orbit)


@cache
def _system(name: str, chosen: str) -> SystemKernels:
    stem = name.replace("-", "_")
    file = f"{stem}.py"
    try:
        expected = _provenance()["files"][file]["sha256"]
        found = hashlib.sha256(files(_PACKAGE).joinpath(file).read_bytes()).hexdigest()
    except (OSError, KeyError, TypeError):
        raise InputError(f"generated/{file} is missing or unrecorded: {_REMEDY}") from None
    if found != expected:
        raise InputError(f"generated/{file} is not the file that {_PROVENANCE} records: {_REMEDY}")
    module = import_module(f"{_PACKAGE}.{stem}")
    compiled = _compiled_module() if chosen == "c" else None
    if compiled is not None:
        derivation = getattr(compiled, f"derivation_{stem}", None)
        if derivation != module.DERIVATION:
            raise InputError(
                f"the compiled kernels of {name} are of another derivation than generated/{file}:"
                " install the package again, or set NONSMOOTH_BACKEND=numpy"
            )
    return SystemKernels(name, module, compiled)


@cache
def _provenance() -> dict[str, Any]:
    try:
        record = json.loads(files(_PACKAGE).joinpath(_PROVENANCE).read_text(encoding="utf-8"))
        named = isinstance(record["systems"], list) and isinstance(record["files"], dict)
        if not named or not all(isinstance(name, str) for name in record["systems"]):
            raise TypeError
    except (OSError, ValueError, KeyError, TypeError):
        raise InputError(f"generated/{_PROVENANCE} is missing, cut or foreign: {_REMEDY}") from None
    return dict(record)


def _compiled_module() -> ModuleType | None:
    chosen = os.environ.get("NONSMOOTH_BACKEND", "")
    if chosen not in ("", "c", "numpy"):
        raise InputError(f"NONSMOOTH_BACKEND is {chosen!r}, neither 'c' nor 'numpy'")
    if chosen == "numpy":
        return None
    try:
        return import_module(f"{_PACKAGE}._kernels")
    except ImportError:
        if chosen == "c":
            raise InputError(
                "NONSMOOTH_BACKEND is 'c', but the compiled kernels are not built:"
                " install the package again with a C compiler at hand"
            ) from None
        return None
