"""What is charted of an orbit: existence, admissibility and its limits, stability."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.admissible import first_violations
from nonsmooth.runtime.batch import Orbits, solve_many
from nonsmooth.runtime.charting.problem import MISSING, Variable, fixed_values, table_hash
from nonsmooth.runtime.composition.named import unknowns_of
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.newton import CONVERGED
from nonsmooth.runtime.orbit import STATUS

__all__ = ["NEITHER", "NO_ORBIT", "UNTOLD", "OrbitProblem", "orbit_problem"]

NEITHER, NO_ORBIT, UNTOLD = -1, -2, -3  # limits: none fails, there is no orbit, it is not told
_DERIVED, _COMPOSED = 1 << 16, 1 << 11  # points of a chunk: tenths of a second, seconds


@dataclass(frozen=True)
class OrbitProblem:
    """An orbit over a grid of parameters.

    Attributes
    ----------
    orbit : str
        As `solve_many` takes it.
    fixed : tuple of (name, value)
        All parameters that are not swept.
    """

    orbit: str
    fixed: tuple[tuple[str, float], ...]

    @property
    def kernels(self) -> OrbitKernels:
        """Tables and kernels of the orbit."""
        return load_orbit(self.orbit)

    @property
    def points(self) -> int:
        """Points of a chunk, unless a user says otherwise."""
        return _DERIVED if self.kernels.derived else _COMPOSED

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on but the grid."""
        kernels = self.kernels
        return {
            "kind": "orbit",
            "orbit": f"{kernels.system.table['name']}/{kernels.orbit}",
            "derivation": str(kernels.system.module.DERIVATION),
            "table": table_hash(kernels.table),
            "kernels": "numpy" if kernels.system.compiled is None else "c",
            "parameters": {name: repr(value) for name, value in self.fixed},
        }

    def variables(self) -> tuple[Variable, ...]:
        """What is computed."""
        kernels = self.kernels
        names = kernels.unknowns if kernels.derived else unknowns_of(kernels)
        opened = [p.name for p in kernels.open_parameters] if kernels.derived else []
        limits = limit_names(kernels)
        return (
            _flags("status", MISSING, {MISSING: "not computed", **STATUS}),
            Variable(
                "admissible",
                "|b1",
                False,
                {"long_name": "a motion of the real system, for large enough open parameters"},
            ),
            _flags(
                "limit",
                NO_ORBIT,
                {
                    NEITHER: "none fails",
                    NO_ORBIT: "no orbit",
                    UNTOLD: "not told",
                    **dict(enumerate(limits)),
                },
                "<i2",
            ),
            _number("trace", "trace of the Poincare map"),
            _number("margin", "1 - the largest nontrivial multiplier's size; 0 where neutral"),
            _number("period", "period", units="nondimensional"),
            *(_number(name, f"unknown {name}", units="nondimensional") for name in names),
            *(_number(f"least_{name}", f"what {name} has to exceed") for name in opened),
        )

    def compute(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """All variables at points whose parameters broadcast against each other."""
        parameters: dict[str, Any] = {**dict(self.fixed), **values}
        found = solve_many(self.orbit, threads=1, **parameters)
        kernels, shape = self.kernels, found.status.shape
        if found.admissible is None or found.bounds is None:
            raise InputError(f"{self.orbit}: admissibility is not decided")
        limit = np.where(found.converged, UNTOLD, NO_ORBIT)
        limit[found.admissible] = NEITHER
        margin = np.full(shape, np.nan)
        if kernels.derived:
            every = np.broadcast_arrays(*(parameters[n] for n in kernels.parameter_names))
            points = np.stack([np.broadcast_to(a, shape) for a in every], axis=-1)
            unknowns = np.stack([found.unknowns[n] for n in kernels.unknowns], axis=-1)
            lost = found.converged & ~found.admissible
            limit[lost] = first_violations(kernels, points[lost], unknowns[lost])
            here = found.converged
            margin[here] = _margins(kernels, points[here], unknowns[here], found.trace[here])
        return _named(found, limit, margin)


def orbit_problem(orbit: str, given: Mapping[str, object], swept: Sequence[str]) -> OrbitProblem:
    """Check names and values; parameters that are not given take the reference point's.

    Raises
    ------
    InputError
        For an unknown orbit, names or values that are wrong, or an orbit that many points
        at once cannot be found of.
    """
    kernels = load_orbit(orbit)
    tables = kernels.parameters if kernels.derived else kernels.system.parameters
    reference = kernels.table["reference"]
    defaults = reference["parameters"] if reference else {}
    fixed = fixed_values(tables, given, swept, defaults, kernels.name)
    return OrbitProblem(kernels.name, fixed)


def limit_names(kernels: OrbitKernels) -> list[str]:
    """What the numbers of `limit` stand for: phase, configuration and boundary."""
    if not kernels.derived:
        return []
    phases = kernels.table["phases"]
    return [f"phase {b.phase + 1} {phases[b.phase][0]}: {b.name}" for b in kernels.boundaries]


def _margins(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, trace: np.ndarray
) -> np.ndarray:
    """1 - the largest nontrivial |multiplier| of orbits (n,): as `Orbit.stability` has it."""
    table = kernels.table
    if table["rank"] == 1:
        return np.asarray(1 - np.abs(trace))
    if table["conservative"] and len(table["section"]) == 3:
        half = np.abs(trace - 1) / 2
        root = np.sqrt(np.maximum((half - 1) * (half + 1), 0))
        return np.where(half <= 1, 0.0, 1 - (half + root))
    spectrum, _ = kernels.spectrum(points)
    matrices = kernels.evaluate("poincare_jacobian", points, spectrum, unknowns)
    found = np.full(len(points), np.nan)
    sound = np.isfinite(matrices).all(axis=(-2, -1))
    sizes = np.abs(np.linalg.eigvals(matrices[sound]))
    found[sound] = 1 - sizes.max(axis=-1, initial=0.0)
    return found


def _named(found: Orbits, limit: np.ndarray, margin: np.ndarray) -> dict[str, np.ndarray]:
    bounds = found.bounds or {}
    return {
        "status": found.status.astype("i1"),
        "admissible": np.asarray(found.admissible),
        "limit": limit.astype("<i2"),
        "trace": np.where(found.status == CONVERGED, found.trace, np.nan),
        "margin": margin,
        "period": np.asarray(found.period),
        **found.unknowns,
        **{f"least_{name}": bound for name, bound in bounds.items()},
    }


def _number(name: str, meaning: str, **attributes: str) -> Variable:
    return Variable(name, "<f8", float("nan"), {"long_name": meaning, **attributes})


def _flags(name: str, fill: int, meanings: Mapping[int, str], dtype: str = "|i1") -> Variable:
    return Variable(
        name,
        dtype,
        fill,
        {
            "flag_values": list(meanings),
            "flag_meanings": " ".join(
                text.partition(":")[0].replace(" ", "_") for text in meanings.values()
            ),
            "meanings": {str(value): text for value, text in meanings.items()},
        },
    )
