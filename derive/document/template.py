r"""Templates of a document's sections: whole sentences and formulas, with what differs inserted.

Blank lines separate the blocks of a template. Between two lines ``$$`` stands a formula, each line
of it one relation, ``left &= right``; an indented line continues the one above, where it may
break. ``\tag{1.1}`` below the relations numbers them, with their meaning behind it. A line that
begins with ``##`` is a heading. A line ``| Header | of | a table |`` stands above the rows of a
table, without which the table drops out; the column in ``<angles>`` takes the remaining width.

``@name`` inserts a value: text, an expression as LaTeX, a list, lines of a formula, or blocks; of a
mapping there is a relation for each of its items. Where it stands in ``$...$`` or ``*...*`` and has
several elements, the formula or the word is repeated for each. A relation shows, in the sense of
`Line.shows`, the expression that is inserted on its right-hand side. ``#name`` is a number or the
length of a list in words, ``#Name`` as the first of a sentence, ``#name phase(s)`` with a noun.
``@cited(key)`` cites the source, ``@label(Stability 1)`` is the number of the first equation of a
section. ``[name: this | that]`` is the first text if the value is true, and otherwise the second;
``[many name: this | that]`` the first if it is more than one, or has more than one element. Names
are those of the values that a section gives, or else attributes of what it describes, of its
notation or its letters; ``@name.attribute`` goes on from there.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from inspect import cleandoc
from typing import Any

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Heading, Line, Paragraph, Table, marked
from nonsmooth.derive.document.notation import Notation, enumeration, number

_NAME = r"[a-z]+(?:[_.][a-z]+)*"
_VALUE = re.compile(f"@({_NAME})")
_INSERTION = re.compile(
    rf"@(?P<method>cited|label)\((?P<key>.*?)\)|@(?P<value>{_NAME})"
    rf"|#(?P<number>(?i:{_NAME}))(?:(?P<noun> [a-z ]+)\(s\))?"
)
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
    def notation(self) -> Notation:
        """The notation of the document."""
        notation: Notation = getattr(self.owner, "notation", self.owner)
        return notation

    def value(self, path: str) -> Any:
        """The value of a name, or an attribute of it."""
        if path in self.values:
            return self.values[path]
        first, *others = path.split(".")
        if first in self.values:
            value = self.values[first]
        else:
            owners = (self.owner, self.notation, self.notation.letters)
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
        return str((this if (_size(value) > 1 if many else value) else that) or "")

    def inserted(self, text: str) -> str:
        """Text with the values in it; what is inserted is not read again."""
        return "".join(self.repeated(mark, part) for mark, part in marked(text))

    def insertion(self, match: re.Match[str]) -> str:
        """What one name in a template stands for."""
        if match["method"]:
            return str(self.value(match["method"])(self.inserted(match["key"])))
        if match["value"]:
            return self.notation.text(self.value(match["value"]))
        name, noun = match["number"], match["noun"]
        size = _size(self.value(name.lower()))
        words = number(size) if name.islower() else number(size).capitalize()
        return f"{words}{noun or ''}{'s' if noun and size != 1 else ''}"

    def repeated(self, mark: str, part: str) -> str:
        """A part of a text with the values in it, once for each element of a list."""
        for name in _VALUE.findall(part) if mark else ():
            value = self.value(name)
            if isinstance(value, Mapping):
                value = [self.notation.relation(*item).latex for item in value.items()]
            if isinstance(value, (list, tuple)):
                each = (replace(self, values={**self.values, name: v}) for v in value)
                return enumeration([filling.repeated(mark, part) for filling in each])
        return f"{mark}{_INSERTION.sub(self.insertion, part)}{mark}"

    def listed(self, text: str) -> list[Any] | None:
        """The blocks or lines for which a name stands; None if it stands for something else."""
        alone = _VALUE.fullmatch(text)
        value = self.value(alone[1]) if alone else ""
        if isinstance(value, Mapping):
            return [line for item in value.items() for line in self.notation.entries(*item)]
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
                elif words.startswith("| "):
                    blocks += self.table(words)
                elif text := self.inserted(words).strip():
                    blocks.append(Paragraph(text))
        return blocks

    def table(self, text: str) -> list[Block]:
        """The table of a header and the name of its rows; nothing without rows."""
        *header, rows = text.strip("| ").split(" | ")
        wrapped = next((i for i, cell in enumerate(header) if cell.startswith("<")), None)
        cells = tuple(cell.strip("<>") for cell in header)
        found = tuple(self.value(rows.removeprefix("@")))
        return [Table(cells, found, wrapped)] if found else []

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
        values = [self.value(m[1]) for m in _VALUE.finditer(right)]
        shown = next((v for v in values if isinstance(v, (sp.Expr, sp.MatrixBase))), None)
        alone = re.fullmatch(rf"{_VALUE.pattern}([,.]?)", right)
        value, mark = (values[0], alone[2]) if alone else (self.inserted(right), "")
        subject = self.value(left[1:]) if _VALUE.fullmatch(left) else None
        head = subject if isinstance(subject, sp.Symbol) else self.inserted(left)
        return replace(self.notation.relation(head, value, mark, shows=shown), relation=sign)


def _size(value: Any) -> int:
    """A number itself, the length of a list."""
    return value if isinstance(value, int) else len(value)


def _words(text: str) -> str:
    """Text on one line, with one space between words."""
    return re.sub(r"\s+([.,;:])", r"\1", " ".join(text.split()))
