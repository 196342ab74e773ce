"""How a motion's fields and rows change with parameters."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nonsmooth.runtime.model.table_derivatives import TableDerivatives, table_derivatives
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["table_changes"]


def table_changes(motion: Trajectory, by: Sequence[str]) -> TableDerivatives:
    """Derivatives of the system's tables by q names, zero by those that are no parameters."""
    kernels = motion.structure.kernels
    assert kernels is not None
    names = [table.name for table in kernels.parameters]
    tables = table_derivatives(kernels, np.array([float(motion.parameters[n]) for n in names]))
    places = [names.index(name) if name in names else len(names) for name in by]
    return TableDerivatives(
        *(np.concatenate([part, np.zeros((1, *part.shape[1:]))])[places] for part in tables)
    )
