r"""Templates of a document's sections: whole sentences and formulas, with what differs inserted.

Blank lines separate the blocks of a template. Between two lines ``$$`` stands a formula, each line
of it one relation, ``left &= right``; an indented line continues the one above, where it may
break. ``\tag{1.1}`` below the relations numbers them, with their meaning behind it. A line that
begins with ``##`` is a heading.

``@name`` inserts a value: text, an expression as LaTeX, a list, lines of a formula, or blocks. A
relation shows, in the sense of `Line.shows`, the expression that is inserted on its right-hand
side. ``[name: this | that]`` is the first text if the value is true, and otherwise the second;
``[many name: this | that]`` the first if the value has more than one element. Names are those of
the values that a section gives, or else attributes of what it describes, of its notation or its
letters; ``@name.attribute`` goes on from there.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from inspect import cleandoc
from typing import Any

import sympy as sp

from nonsmooth.derive.document.blocks import (
    LINE_WIDTH,
    Block,
    Formula,
    Heading,
    Line,
    Paragraph,
    width,
)
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.wording import Naming, enumeration

_NAME = r"[a-z]+(?:[_.][a-z]+)*"
_VALUE = re.compile(f"@({_NAME})")
_CHOICE = re.compile(rf"\[(many\s+)?({_NAME}):\s?([^\[\]]*?)(?:\s?(?<!\S)\|\s([^\[\]]*))?\]")
_RELATION = re.compile(r"(?:(.*?)\s*&(=|\\to)\s+)?(.*)")
_TAG = re.compile(r"\\tag\{(.*?)\}\s*(.*)")


def compose(owner: object, template: str, **values: object) -> list[Block]:
    """Blocks of a template on what a section describes; what is empty drops out."""
    return _Filling(owner, values).blocks(template)


def sentence(owner: object, template: str, **values: object) -> str:
    """Text of a template without formulas of its own."""
    filling = _Filling(owner, values)
    return filling.inserted(_words(filling.chosen(template)))


@dataclass(frozen=True)
class _Filling:
    """What is inserted in a template."""

    owner: Any
    values: dict[str, Any]

    @property
    def naming(self) -> Naming:
        """The notation of the document."""
        naming: Naming = getattr(self.owner, "naming", self.owner)
        return naming

    def value(self, path: str) -> Any:
        """The value of a name, or an attribute of it."""
        first, *others = path.split(".")
        owners = (self.owner, self.naming, getattr(self.owner, "letters", None))
        if first in self.values:
            value = self.values[first]
        else:
            value = getattr(next((o for o in owners if hasattr(o, first)), self.owner), first)
        for name in others:
            value = getattr(value, name)
        return value

    def chosen(self, template: str) -> str:
        """The template with one text of each choice, inner ones first."""
        text, before = cleandoc(template), ""
        while text != before:
            before = text
            text = _CHOICE.sub(self.choice, text)
        return text

    def choice(self, match: re.Match[str]) -> str:
        """The text that applies."""
        many, name, this, that = match.groups()
        value = self.value(name)
        return str((this if (len(value) > 1 if many else value) else that) or "")

    def inserted(self, text: str) -> str:
        """Text with the values in it."""
        return _VALUE.sub(lambda match: _text(self.naming, self.value(match[1])), text)

    def listed(self, text: str) -> list[Any] | None:
        """The blocks or lines for which a name stands; None if it stands for something else."""
        alone = _VALUE.fullmatch(text)
        value = self.value(alone[1]) if alone else ""
        several = value if isinstance(value, (list, tuple)) else [value]
        return list(several) if all(isinstance(v, (Block, Line)) for v in several) else None

    def blocks(self, template: str) -> list[Block]:
        """Blocks of the template."""
        blocks: list[Block] = []
        for place, part in enumerate(re.split(r"(?m)^\$\$$", self.chosen(template))):
            if place % 2:
                blocks += self.formula(part)
                continue
            for words in map(_words, re.split(r"\n\s*\n", part)):
                found = self.listed(words)
                if found is not None:
                    blocks += found
                elif words.startswith("##"):
                    blocks.append(Heading(words.strip("# "), 2))
                elif text := self.inserted(words).strip():
                    blocks.append(Paragraph(text))
        return blocks

    def formula(self, text: str) -> list[Block]:
        """The formula of the relations in a text; nothing without relations."""
        lines: list[Line] = []
        label = note = None
        for row in filter(str.strip, text.splitlines()):
            found, tag = self.listed(row), _TAG.fullmatch(row)
            if found is not None:
                lines += found
            elif tag:
                label, note = map(self.inserted, tag.groups())
            elif row.startswith(" "):
                before, more = lines[-1], self.relation(row.strip())
                pieces = (*before.pieces, *more.pieces)
                lines[-1] = replace(before, pieces=pieces, shows=before.shows or more.shows)
            else:
                lines.append(self.relation(row))
        return [Formula(tuple(lines), label, note or None)] if lines else []

    def relation(self, row: str) -> Line:
        """One relation, with the expression that it shows."""
        match = _RELATION.fullmatch(row)
        assert match
        left, sign, right = (part or "" for part in match.groups())
        alone = re.fullmatch(rf"{_VALUE.pattern}([,.]?)", right)
        if alone:
            line = relation(self.naming, "", self.value(alone[1]), alone[2])
        else:
            inserted = [self.value(m[1]) for m in _VALUE.finditer(right)]
            shown = [v for v in inserted if isinstance(v, (sp.Expr, sp.MatrixBase))]
            line = relation(self.naming, "", self.inserted(right))
            line = replace(line, shows=_shown(shown[0]) if shown else None)
        subject = self.value(left[1:]) if _VALUE.fullmatch(left) else None
        named = subject if isinstance(subject, sp.Symbol) else None
        return replace(line, left=self.inserted(left), relation=sign, subject=named)


def _words(text: str) -> str:
    """Text on one line, with one space between words."""
    return re.sub(r"\s+([.,;:])", r"\1", " ".join(text.split()))


def relation(naming: Naming, left: str, value: Any, mark: str = "") -> Line:
    """The line ``left = value`` with a mark at its end; it shows the value of an expression."""
    if isinstance(value, tuple):
        pieces = value
    elif isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixBase):
        pieces = naming.notation.pieces(naming.notation.tidy(value))
    else:
        pieces = (_text(naming, value),)
    return ended(Line(left, "=", pieces, None, _shown(value)), mark)


def _shown(value: Any) -> sp.Basic | None:
    """The expression or matrix that a line shows."""
    if isinstance(value, sp.MatrixBase):
        return sp.ImmutableMatrix(value)
    return value if isinstance(value, sp.Basic) else None


def ended(line: Line, mark: str) -> Line:
    """The line with a mark at its end, in place of a comma there."""
    *others, last = line.pieces
    return replace(line, pieces=(*others, f"{last.removesuffix(',') if mark else last}{mark}"))


def _text(naming: Naming, value: Any) -> str:
    """A value as text: expressions and matrices as LaTeX, lists with an "and"."""
    if isinstance(value, (list, tuple)):
        symbols = all(isinstance(v, sp.Symbol) for v in value)
        return naming.list(value) if symbols else enumeration(value)
    if isinstance(value, sp.Symbol):
        return naming.notation.symbol(value)
    if isinstance(value, sp.MatrixBase):
        if value.cols == 1:
            return transposed(naming, value)
        if value.is_square and value.is_diagonal():
            entries = ", ".join(map(naming.notation.latex, value.diagonal()))
            unit = value == sp.eye(value.rows)
            return "I" if unit else rf"\operatorname{{diag}}\left({entries}\right)"
        return naming.notation.latex(value)
    if isinstance(value, sp.Basic):
        return naming.notation.latex(naming.notation.tidy(value))
    return "" if value is None else str(value)


def math(naming: Naming, value: object, after: str = "") -> str:
    """A formula in running text: a value, and what follows it."""
    return f"${_text(naming, value)}{after}$"


def zeros(naming: Naming, values: Iterable[sp.Expr], relation: str = " = 0") -> str:
    """Text ``x = 0 and y = 0`` on values, with another relation if one is given."""
    return enumeration([math(naming, value, relation) for value in values])


def transposed(naming: Naming, column: sp.Matrix) -> str:
    """LaTeX of a column, written as a transposed row; a single entry is written alone."""
    notation = naming.notation
    if column.rows == 1:
        return notation.latex(notation.tidy(column[0]))
    return rf"{notation.latex(column.T.applyfunc(notation.tidy))}^{{\mathsf{{T}}}}"


def by_entries(naming: Naming, name: str, matrix: sp.Matrix) -> list[Line]:
    """The line ``name = matrix``, or one for each entry that is not zero if that is too wide."""
    whole = relation(naming, name, matrix)
    if width(whole.latex) <= LINE_WIDTH:
        return [whole]
    comma = "," if max(matrix.shape) > 9 else ""
    return [
        relation(naming, rf"\left({name}\right)_{{{i + 1}{column}}}", matrix[i, j])
        for i in range(matrix.rows)
        for j in range(matrix.cols)
        for column in ["" if matrix.cols == 1 else f"{comma}{j + 1}"]
        if matrix[i, j] != 0
    ]


def summed(notation: Notation, terms: Iterable[sp.Expr]) -> tuple[str, ...]:
    """Pieces of a sum of expressions in their order; zeros drop out."""
    pieces: list[str] = []
    for term in terms:
        if term != 0:
            first, *rest = notation.pieces(term)
            pieces += [f"+ {first}" if pieces and not first.startswith("-") else first, *rest]
    return tuple(pieces) or ("0",)
