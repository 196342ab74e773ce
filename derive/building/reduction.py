"""Large linear structures reduced to the coordinates that elements act on, and a few modes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from nonsmooth.derive.building.structure_matrices import (
    Factor,
    Structure,
    checked_structure,
    lowest_modes,
)
from nonsmooth.derive.declaration.fields import made, shown
from nonsmooth.derive.declaration.soundness import check_unique
from nonsmooth.derive.errors import DeclarationError

Array = npt.NDArray[np.float64]
Method = Literal["craig-bampton", "free-interface"]
Direction = int | str | Mapping[Any, float] | Sequence[float] | Array


@dataclass(frozen=True, eq=False)
class ReducedStructure:
    """A structure in few coordinates: those kept, then modal ones.

    Attributes
    ----------
    coordinates : tuple of str
        Names of the r reduced coordinates: those kept, then q1, q2, ... of the modes.
    mass, stiffness, damping : arrays (r, r)
        Symmetric matrices as `oscillator` takes them; without damping zeros.
    transformation : array (n, r)
        Coordinates of the whole structure from the reduced ones.
    kept : tuple of int
        Places of the kept coordinates in the whole structure.
    names : tuple of str
        Names of the n coordinates of the whole structure.
    cutoff : float
        Angular frequency of the first mode that is left out. Above it the reduction is wrong; at
        half of it frequencies by Craig-Bampton are wrong by some percent, those of free-interface
        modes are exact up to it. Infinite where no mode is left out.
    method : {"craig-bampton", "free-interface"}
    """

    coordinates: tuple[str, ...]
    mass: Array
    stiffness: Array
    damping: Array
    transformation: Array
    kept: tuple[int, ...]
    names: tuple[str, ...]
    cutoff: float
    method: Method

    @property
    def frequencies(self) -> Array:
        """Angular frequencies of the reduced structure without damping, in rising order."""
        from scipy.linalg import eigh

        squares = eigh(self.stiffness, self.mass, eigvals_only=True)
        return np.asarray(np.sqrt(np.maximum(squares, 0)))

    def direction(self, direction: Direction) -> dict[str, float]:
        """Give a direction of the whole structure in the reduced coordinates.

        Parameters
        ----------
        direction : int or str, mapping, or n weights
            A coordinate by its place or name, weights of some, or of all.

        Returns
        -------
        dict of str to float
            What an element takes as its direction, and `Harmonic` or `load` as a force there.

        Raises
        ------
        DeclarationError
            For an unknown coordinate, another number of weights, or weights not finite.

        Examples
        --------
        >>> from nonsmooth.derive import reduce_structure
        >>> reduced = reduce_structure([[1, 0], [0, 1]], [[2, -1], [-1, 1]], keep=[1], modes=1)
        >>> reduced.direction(1)
        {'x1': 1.0}
        """
        weights = np.zeros(len(self.names))
        if isinstance(direction, int | str):
            direction = {direction: 1.0}
        if isinstance(direction, Mapping):
            for which, weight in direction.items():
                weights[_place(which, self.names, "direction")] += weight
        else:
            given = np.asarray(direction, dtype=float)
            if given.shape != weights.shape:
                raise DeclarationError(
                    f"direction has shape {given.shape} where the structure has"
                    f" {len(self.names)} coordinates"
                )
            weights = given
        if not np.isfinite(weights).all():
            raise DeclarationError("direction holds a weight that is not finite")
        reduced = weights @ self.transformation
        return {
            name: float(weight)
            for name, weight in zip(self.coordinates, reduced, strict=True)
            if weight != 0
        }


def reduce_structure(
    mass: Any,
    stiffness: Any,
    damping: Any = None,
    *,
    keep: Sequence[int | str],
    modes: int,
    coordinates: Sequence[str] | None = None,
    method: Method = "craig-bampton",
) -> ReducedStructure:
    """Reduce ``mass x'' + damping x' + stiffness x`` to kept coordinates and a few modes.

    Craig-Bampton (Craig and Bampton 1968): the static shape of each kept coordinate, the
    others following without load, and the lowest modes with the kept coordinates held.
    Free-interface modes (Rubin 1975; Craig and Chang 1977): the lowest modes of the whole
    structure, motions as a rigid body among them, and for each kept coordinate the static
    answer of the modes that are left out. Either is exact for static forces at kept
    coordinates. Large sparse matrices are solved by SciPy's `eigsh` about a shift, small ones
    densely. Damping is carried over by the transformation.

    Parameters
    ----------
    mass, stiffness, damping : n x n matrices of numbers
        NumPy arrays, SciPy sparse matrices or lists; symmetric, mass positive definite.
    keep : sequence of int or str
        Coordinates that stay as they are, by place (from 0) or name: those that elements and
        forces act on. May be empty where modes are kept.
    modes : int
        How many modes are kept beside them.
    coordinates : n names, optional
        x0, x1, ... when omitted.
    method : {"craig-bampton", "free-interface"}

    Returns
    -------
    ReducedStructure

    Raises
    ------
    DeclarationError
        For a matrix that is not square, not finite, not symmetric or of another size, a mass
        that is not positive definite, a stiffness that leaves the others free to move where
        all kept are held, a coordinate that does not exist or is kept twice, more modes than
        there are, or a reduction that keeps nothing.

    Examples
    --------
    >>> import numpy as np
    >>> from nonsmooth.derive import reduce_structure
    >>> stiffness = 2 * np.eye(50) - np.eye(50, k=1) - np.eye(50, k=-1)
    >>> reduced = reduce_structure(np.eye(50), stiffness, keep=[49], modes=3)
    >>> reduced.coordinates, reduced.mass.shape
    (('x49', 'q1', 'q2', 'q3'), (4, 4))
    >>> print(f"wrong above {reduced.cutoff:.4f}")
    wrong above 0.2507
    """
    made(Method, method, "method")
    structure = checked_structure(mass, stiffness, damping)
    size = structure.mass.shape[0]
    names = tuple(f"x{i}" for i in range(size)) if coordinates is None else coordinates
    names = made(tuple[str, ...], names, "coordinates")
    if len(names) != size:
        raise DeclarationError(f"there are {len(names)} names for {size} coordinates")
    check_unique(names, "coordinate")
    if isinstance(keep, str) or not np.iterable(keep):
        raise DeclarationError(
            f"keep is {shown(keep)}, not a row of places or names of coordinates"
        )
    kept = [_place(which, names, "keep") for which in keep]
    check_unique([names[i] for i in kept], "kept coordinate")
    if isinstance(modes, bool) or not isinstance(modes, int | np.integer) or modes < 0:
        raise DeclarationError(f"modes is {shown(modes)}, not a number of modes")
    if not kept and modes == 0:
        raise DeclarationError("the reduction keeps nothing: no coordinate and no mode")
    if modes > size - len(kept):
        raise DeclarationError(
            f"modes is {modes}, but beside {len(kept)} kept of {size} coordinates there are"
            f" {size - len(kept)}"
        )
    reduced_names = (*(names[i] for i in kept), *(f"q{k}" for k in range(1, modes + 1)))
    check_unique(reduced_names, "reduced coordinate")
    reduced = _BASES[method](structure, kept, int(modes))
    return ReducedStructure(
        reduced_names,
        reduced.mass,
        reduced.stiffness,
        _carried(structure.damping, reduced.transformation),
        reduced.transformation,
        tuple(kept),
        names,
        reduced.cutoff,
        method,
    )


class _Reduced(NamedTuple):
    transformation: Array
    mass: Array
    stiffness: Array
    cutoff: float


def _craig_bampton(structure: Structure, kept: list[int], count: int) -> _Reduced:
    mass, stiffness, _ = structure
    size, held = mass.shape[0], len(kept)
    others = np.setdiff1d(np.arange(size), kept)
    transformation = np.zeros((size, held + count))
    transformation[kept, range(held)] = 1
    inner = stiffness[others][:, others]
    if held and len(others):
        factor = Factor(inner)
        if not factor.positive_definite:
            raise DeclarationError(
                "stiffness is not positive definite where all kept coordinates are held: keep"
                " coordinates that hold the structure, or take free-interface modes"
            )
        transformation[others, :held] = -factor(stiffness[others][:, kept].toarray())
    squares, shapes, cutoff = _modes(inner, mass[others][:, others], count)
    transformation[others, held:] = shapes
    # by theory, to the last bit: modes have unit mass, and no stiffness in common with the rest
    reduced_mass = _carried(mass, transformation)
    reduced_mass[held:, held:] = np.eye(count)
    reduced_stiffness = np.zeros_like(reduced_mass)
    reduced_stiffness[:held, :held] = _carried(stiffness, transformation[:, :held])
    reduced_stiffness[held:, held:] = np.diag(squares)
    return _Reduced(transformation, reduced_mass, reduced_stiffness, cutoff)


def _free_interface(structure: Structure, kept: list[int], count: int) -> _Reduced:
    mass, stiffness, _ = structure
    held = len(kept)
    squares, shapes, cutoff = _modes(stiffness, mass, count)
    if not held:
        return _Reduced(shapes, np.eye(count), np.diag(squares), cutoff)
    residual = _residual(structure, kept, squares, shapes)
    flexibility = (residual[kept] + residual[kept].T) / 2
    values = np.linalg.eigvalsh(flexibility)
    if values[0] <= 1e-10 * values[-1]:
        raise DeclarationError(
            "the modes that are left out do not move all kept coordinates: keep fewer modes"
        )
    inverse = np.linalg.inv(flexibility)
    inverse = (inverse + inverse.T) / 2
    followed = residual @ inverse  # unit displacement of one kept coordinate
    at_kept = shapes[kept]
    transformation = np.hstack([followed, shapes - followed @ at_kept])
    transformation[kept] = np.eye(held, held + count)
    crossed = -inverse @ at_kept
    stiffness_of_modes = np.diag(squares) - at_kept.T @ crossed
    reduced = np.block([[inverse, crossed], [crossed.T, stiffness_of_modes]])
    return _Reduced(
        transformation, _carried(mass, transformation), (reduced + reduced.T) / 2, cutoff
    )


def _residual(structure: Structure, kept: list[int], squares: Array, shapes: Array) -> Array:
    """Static answers (n, held) of the neglected modes to unit forces at the kept coordinates.

    Where the structure moves as a rigid body the forces are balanced by its inertia.
    """
    from scipy.sparse import bmat, csc_array
    from scipy.sparse.linalg import splu

    mass, stiffness, _ = structure
    size = mass.shape[0]
    forces = np.zeros((size, len(kept)))
    forces[kept, range(len(kept))] = 1
    rounding = 1e3 * np.finfo(float).eps * (stiffness.diagonal() / mass.diagonal()).max()
    rigid = shapes[:, squares <= rounding]
    weighted = mass @ rigid
    balanced = forces - weighted @ (rigid.T @ forces)
    if rigid.shape[1]:
        bordered = csc_array(bmat([[stiffness, weighted], [weighted.T, None]]))
        padded = np.vstack([balanced, np.zeros((rigid.shape[1], len(kept)))])
        answers = splu(bordered).solve(padded)[:size]
    else:
        factor = Factor(stiffness)
        if not factor.positive_definite:
            raise DeclarationError(
                "stiffness is not positive definite, and motions as a rigid body are not among"
                " the modes: keep more modes"
            )
        answers = factor(balanced)
    return np.asarray(answers - shapes @ (shapes.T @ (mass @ answers)))


def _modes(stiffness: Any, mass: Any, count: int) -> tuple[Array, Array, float]:
    """Squared frequencies and shapes of the lowest modes, and the frequency of the next one."""
    size = mass.shape[0]
    squares, shapes = lowest_modes(stiffness, mass, min(count + 1, size))
    cutoff = float(np.sqrt(max(squares[count], 0.0))) if count < size else float("inf")
    return squares[:count], shapes[:, :count], cutoff


def _carried(matrix: Any, transformation: Array) -> Array:
    """The matrix in reduced coordinates, symmetric; entries of rounding alone become zero."""
    carried = transformation.T @ (matrix @ transformation)
    sizes = abs(transformation)
    rounding = 4 * np.finfo(float).eps * (sizes.T @ (abs(matrix) @ sizes))
    carried = (carried + carried.T) / 2
    return np.asarray(np.where(abs(carried) <= rounding, 0.0, carried))


def _place(which: int | str, names: Sequence[str], what: str) -> int:
    """Index of a coordinate that is given by its index or its name."""
    if isinstance(which, str):
        if which not in names:
            raise DeclarationError(f"{what}: unknown coordinate {which!r}")
        return names.index(which)
    if isinstance(which, bool) or not isinstance(which, int | np.integer):
        raise DeclarationError(
            f"{what}: {shown(which)} is neither a place nor a name of a coordinate"
        )
    if not 0 <= which < len(names):
        raise DeclarationError(f"{what}: there is no coordinate {which} of {len(names)}")
    return int(which)


_BASES = {"craig-bampton": _craig_bampton, "free-interface": _free_interface}
