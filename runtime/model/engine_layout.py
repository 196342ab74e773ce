"""The integers and numbers that the compiled engine reads, packed from the Python records.

`runtime/engine/tables.h` says what they mean; both files change together.
"""

from __future__ import annotations

from functools import cache
from itertools import chain

import numpy as np

from nonsmooth.runtime.model.boundary_sets import mask_of, words_of
from nonsmooth.runtime.model.factored_flows import arrays_of, factored_functions
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure


@cache
def layout_of(structure: Structure) -> np.ndarray:
    """Everything about a structure with modes that no parameter changes, as int32 (size,).

    The array is read-only.
    """
    modes = list(chain(*structure.shapes))
    boundaries = list(chain(*structure.boundaries))
    # what may act in several orders is left to the decider
    ordered = [{t.boundaries for t in found if t.order} for found in structure.transitions]
    listed = tuple(
        tuple(t for t in found if t.boundaries not in several)
        for found, several in zip(structure.transitions, ordered, strict=True)
    )
    transitions = list(chain(*listed))
    conditions = [condition for t in transitions for condition in t.conditions]
    pairs = list(dict.fromkeys((row, along) for row, along, _ in conditions))
    place_of = {pair: place for place, pair in enumerate(pairs)}
    header = [
        len(structure.states),
        len(structure.configurations),
        structure.rows,
        structure.resets,
        len(modes),
        sum(structure.functions),
        len(boundaries),
        len(transitions),
        len(pairs),
        len(conditions),
        sum(map(factored_functions, structure.shapes)),
    ]
    parts = [
        header,
        _starts(structure.shapes),
        [mode.length for mode in modes],
        [int(mode.oscillates) for mode in modes],
        [int(mode.joined) for mode in modes],
        [int(mode.paired) for mode in modes],
        [int(mode.factored) for mode in modes],
        np.cumsum([0, *structure.functions]).tolist(),
        np.cumsum([0, *map(factored_functions, structure.shapes)]).tolist(),
        _starts(structure.boundaries),
        [b.row for b in boundaries],
        [int(b.reached) for b in boundaries],
        _starts(listed),
        words_of(structure, [mask_of(t.boundaries) for t in transitions]).ravel().tolist(),
        [t.target for t in transitions],
        [t.reset for t in transitions],
        np.cumsum([0, *(len(t.conditions) for t in transitions)]).tolist(),
        [place_of[row, along] for row, along, _ in conditions],
        [int(holds) for _, _, holds in conditions],
        [row for row, _ in pairs],
        [along for _, along in pairs],
    ]
    packed = np.array(list(chain(*parts)), dtype=np.int32)
    packed.flags.writeable = False
    return packed


def numbers_of(system: PiecewiseLinear) -> np.ndarray:
    """Fields, rows, resets, exponents and flows of one point in one array (size,) of floats."""
    flows = [array for flow in system.flows for array in arrays_of(flow)]
    parts = (system.fields, system.rows, system.resets, *system.exponents, *flows)
    return np.concatenate([np.asarray(part, dtype=float).ravel() for part in parts])


def _starts(groups: tuple[tuple[object, ...], ...]) -> list[int]:
    return [int(x) for x in np.cumsum([0, *map(len, groups)])]
