"""Documents as one self-contained HTML page with MathML."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape

from nonsmooth.derive.document.blocks import (
    Block,
    Document,
    Formula,
    Heading,
    Paragraph,
    Table,
    notes_beside,
)
from nonsmooth.derive.document.layout import marked
from nonsmooth.derive.document.writers.mathml import mathml

__all__ = ["to_html"]

_STYLE = """
:root { color-scheme: light dark; }
body { font: 1.05rem/1.55 Georgia, "Times New Roman", serif; margin: 0 auto; max-width: 56rem;
  padding: 1rem; overflow-wrap: break-word; }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.25rem; margin-top: 2.2rem; }
h3 { font-size: 1.05rem; margin-top: 1.6rem; }
.formula, .table { overflow-x: auto; margin: 0.8rem 0; padding: 0.2rem 0; }
.formula { display: flex; align-items: center; gap: 1.5rem; }
.formula math { margin: 0 auto; }
.formula .number { white-space: nowrap; }
.noted { display: grid; grid-template-columns: 45% 1fr auto; }
.noted > math { justify-self: start; margin: 0 0 0 20%; }
@media (max-width: 44rem) { .noted { display: flex; flex-wrap: wrap; } }
math { font-size: 1.05em; }
mtd { padding: 0.25em 0.35em; }
.rows > mtr > mtd:first-child { text-align: right; text-align: -webkit-right; padding-right: 0; }
.rows > mtr > mtd:last-child { text-align: left; }
table { border-collapse: collapse; font-size: 0.95rem; }
th, td { border-bottom: 1px solid #8886; padding: 0.3rem 0.8rem 0.3rem 0; text-align: left;
  vertical-align: baseline; }
"""


def to_html(document: Document) -> str:
    """A document as an HTML page that needs no network: style and MathML are inside.

    ImportError says that latex2mathml is not installed.
    """
    try:
        from latex2mathml.converter import convert
    except ImportError as error:
        raise ImportError(
            'HTML needs the latex2mathml package: pip install "nonsmooth[html]"'
        ) from error
    page = _Page(convert)
    body = "\n".join(page.group(group) for group in document.groups)
    title = escape(document.title)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{title}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"<h1>{title}</h1>\n{body}\n</body>\n</html>\n"
    )


class _Page:
    """A writer of blocks as HTML, with one converter of LaTeX to MathML."""

    def __init__(self, convert: Callable[[str], str]) -> None:
        self.convert = convert

    def group(self, group: Sequence[Block]) -> str:
        """HTML of one block, or of consecutive numbered formulas."""
        beside = notes_beside([b for b in group if isinstance(b, Formula)])
        return "\n".join(self.block(b, beside=beside) for b in group)

    def block(self, block: Block, *, beside: bool) -> str:
        """HTML of one block; the note of a formula stands `beside` it, or else above."""
        if isinstance(block, Heading):
            return f"<h{block.level + 1}>{self.text(block.numbered)}</h{block.level + 1}>"
        if isinstance(block, Paragraph):
            return f"<p>{self.text(block.text)}</p>"
        return self.formula(block, beside) if isinstance(block, Formula) else self.table(block)

    def formula(self, formula: Formula, beside: bool) -> str:
        """HTML of a formula's rows, aligned at their signs, in a box that scrolls by itself."""
        cells = "".join(
            f"<mtr><mtd>{self.math(left)}</mtd><mtd>{self.math(right)}</mtd></mtr>"
            for left, right in formula.rows
        )
        above = note = ""
        if formula.note and beside:
            note = f'<span class="note">{self.text(formula.note)}</span>'
        elif formula.note:
            above = f"<p>{self.text(formula.lead)}</p>\n"
        label = f'<span class="number">({escape(formula.label)})</span>' if formula.label else ""
        kind = "formula noted" if note else "formula"
        return (
            f'{above}<div class="{kind}"><math display="block" displaystyle="true">'
            f'<mtable class="rows" displaystyle="true">{cells}</mtable></math>{note}{label}</div>'
        )

    def table(self, table: Table) -> str:
        """HTML of a table, in a box that scrolls by itself."""
        head = "".join(f"<th>{self.text(cell)}</th>" for cell in table.header)
        body = "\n".join(
            f"<tr>{''.join(f'<td>{self.text(cell)}</td>' for cell in row)}</tr>"
            for row in table.rows
        )
        return f'<div class="table"><table>\n<tr>{head}</tr>\n{body}\n</table></div>'

    def text(self, text: str) -> str:
        """HTML of text with formulas and emphasis."""
        found = []
        for mark, part in marked(text):
            if mark == "$":
                found.append(f"<math>{self.math(part)}</math>")
            else:
                found.append(f"<em>{escape(part)}</em>" if mark else escape(part))
        return "".join(found)

    def math(self, latex: str) -> str:
        """MathML of one piece of LaTeX, without its outer element."""
        if not latex.strip():
            return "<mrow></mrow>"
        return mathml(latex, self.convert)
