"""Matrices that are too wide for a line: their widest entries stand below them."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from nonsmooth.derive.document.blocks import Line
from nonsmooth.derive.document.layout import width
from nonsmooth.derive.document.notation.wording import Naming

__all__ = ["with_entries"]

Place = tuple[int, int]


def with_entries(
    naming: Naming, name: str, matrix: sp.Matrix, room: float
) -> tuple[str, tuple[Line, ...]]:
    """LaTeX of a matrix that is no wider than `room` in em, and lines for its named entries.

    The widest entries are written as ``(name)_{ij}``, those of a row or a column with one
    index, until the matrix has room; `name` is the LaTeX of the matrix. An entry that
    equals another one up to its sign is written by that.
    """
    notation = naming.notation
    texts = {
        (i, j): notation.latex(matrix[i, j]) for i in range(matrix.rows) for j in range(matrix.cols)
    }
    named: dict[Place, str] = {}
    for place in sorted(texts, key=lambda each: -width(texts[each])):
        if width(_written(matrix, texts | named)) <= room:
            break
        label = _label(name, matrix, place)
        if place in named or width(texts[place]) <= width(label):
            continue
        named |= {other: f"{sign}{label}" for other, sign in _alike(matrix, place)}
    first = {text: place for place, text in sorted(named.items()) if not text.startswith("-")}
    lines = [
        Line(label, "=", notation.pieces(matrix[place]), None, matrix[place])
        for label, place in sorted(first.items(), key=lambda item: item[1])
    ]
    return _written(matrix, texts | named), tuple(lines)


def _label(name: str, matrix: sp.Matrix, place: Place) -> str:
    """LaTeX of an entry's name, with one index if the matrix is a row or a column."""
    long = max(matrix.shape) > 9
    indices = [str(i + 1) for i, many in zip(place, matrix.shape, strict=True) if many > 1]
    return rf"\left({name}\right)_{{{(',' if long else '').join(indices)}}}"


def _alike(matrix: sp.Matrix, place: Place) -> list[tuple[Place, str]]:
    """Places of all entries equal to the given one up to their sign, each with its sign."""
    entry, found = matrix[place], []
    for i in range(matrix.rows):
        for j in range(matrix.cols):
            other = matrix[i, j]
            if (i, j) == place or other == entry:
                found.append(((i, j), ""))
            elif other != 0 and sp.expand(other + entry) == 0:
                found.append(((i, j), "- "))
    return found


def _written(matrix: sp.Matrix, texts: Mapping[Place, str]) -> str:
    rows = [" & ".join(texts[i, j] for j in range(matrix.cols)) for i in range(matrix.rows)]
    body = r"\\".join(rows)
    return rf"\left(\begin{{matrix}}{body}\end{{matrix}}\right)"
