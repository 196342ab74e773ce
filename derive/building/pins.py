"""Resets by which parts that begin to hold are put exactly in their place."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import StopPart

__all__ = ["pins"]


def pins(
    assembly: Assembly, begun: Sequence[int], target: Regimes, *, impact: bool
) -> dict[sp.Symbol, sp.Expr]:
    """Reset of the velocities, and at stops the positions, of parts that begin to hold.

    A held coordinate is set to its value. Where a combination of coordinates is held, the
    state is projected orthogonally on all active directions together; at an impact it is
    left as it is.
    """
    frame = assembly.frame
    weights = {i: assembly.holder(i).direction.todok() for i in begun}
    if all(len(found) == 1 for found in weights.values()):
        pinned: dict[sp.Symbol, sp.Expr] = {}
        for i in begun:
            part = assembly.holder(i)
            (((_, place), weight),) = weights[i].items()
            position = frame.positions[place]
            if isinstance(part, StopPart):
                pinned[position] = sp.cancel((weight * position - part.gap) / weight)
            pinned[frame.velocities[place]] = part.speed / weight
        return pinned
    if impact:
        return {}
    active = assembly.active(target)
    stops = [i for i in active if isinstance(assembly.parts[i], StopPart)]
    gaps = sp.Matrix([assembly.stop(i).gap for i in stops])
    drifts = sp.Matrix(
        [frame.velocity(assembly.holder(i).direction) - assembly.holder(i).speed for i in active]
    )
    return _projected(frame.velocities, assembly.rows(active), drifts) | _projected(
        frame.positions, assembly.rows(stops), gaps
    )


def _projected(
    symbols: Sequence[sp.Symbol], rows: sp.Matrix, excess: sp.Matrix
) -> dict[sp.Symbol, sp.Expr]:
    """Values of the symbols nearest to the present ones for which the excess vanishes.

    `excess` (k x 1) has the gradients `rows` (k, n) by the symbols.
    """
    if rows.rows == 0:
        return {}
    shift = rows.T * (rows * rows.T).inv() * excess
    return {s: sp.expand(s - e) for s, e in zip(symbols, shift, strict=True) if e != 0}
