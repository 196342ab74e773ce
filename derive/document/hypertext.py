"""Documents as Markdown, as GitHub shows it, and as one self-contained HTML page with MathML."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from itertools import pairwise
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from nonsmooth.derive.document.blocks import (
    Block,
    Document,
    Formula,
    Heading,
    Paragraph,
    Table,
    rendered,
)

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
math { font-size: 1.05em; }
mtd { padding: 0.25em 0.35em; }
.rows > mtr > mtd:first-child { text-align: right; text-align: -webkit-right; padding-right: 0; }
.rows > mtr > mtd:last-child { text-align: left; }
table { border-collapse: collapse; font-size: 0.95rem; }
th, td { border-bottom: 1px solid #8886; padding: 0.3rem 0.8rem 0.3rem 0; text-align: left;
  vertical-align: baseline; }
"""
_TIGHT = {"lspace": "0", "rspace": "0"}
_TALL = {"mfrac", "mtable", "msqrt"}
_OPENING, _CLOSING = ("(", "["), (")", "]")
_SIGNS = ("+", "−", "±")
_BEFORE_SIGN = (*_OPENING, "=", ",", "↦", "|", "<", ">")


def to_markdown(document: Document) -> str:
    """A document as a Markdown page; displayed formulas stand between ``$$``."""
    parts = [f"# {document.title}", *(_markdown(block) for block in document.blocks)]
    return "\n\n".join(parts) + "\n"


def _markdown(block: Block) -> str:
    if isinstance(block, Heading):
        return f"{'#' * (block.level + 1)} {block.numbered}"
    if isinstance(block, Paragraph):
        return block.text
    if isinstance(block, Formula):
        tag = f" \\tag{{{block.label}}}" if block.label else ""
        lead = f"{block.lead}\n\n" if block.note else ""
        return f"{lead}$$\n{block.latex}{tag}\n$$"
    lines = [block.header, tuple("---" for _ in block.header), *block.rows]
    return "\n".join(
        f"| {' | '.join(cell.replace('|', '&#124;') for cell in row)} |" for row in lines
    )


def to_html(document: Document) -> str:
    """A document as an HTML page that needs no network: style and MathML are inside.

    ImportError says that latex2mathml is not installed.
    """
    page = _Page()
    body = "\n".join(page.block(block) for block in document.blocks)
    title = escape(document.title)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{title}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"<h1>{title}</h1>\n{body}\n</body>\n</html>\n"
    )


class _Page:
    """A writer of blocks as HTML, with a converter of LaTeX to MathML."""

    def __init__(self) -> None:
        try:
            from latex2mathml.converter import convert
        except ImportError as error:
            raise ImportError(
                'HTML needs the latex2mathml package: pip install "nonsmooth[html]"'
            ) from error
        self.convert = convert

    def block(self, block: Block) -> str:
        """HTML of one block; the note of a formula stands above it."""
        if isinstance(block, Heading):
            return f"<h{block.level + 1}>{self.text(block.numbered)}</h{block.level + 1}>"
        if isinstance(block, Paragraph):
            return f"<p>{self.text(block.text)}</p>"
        return self.formula(block) if isinstance(block, Formula) else self.table(block)

    def formula(self, formula: Formula) -> str:
        """HTML of a formula's rows, aligned at their signs, in a box that scrolls by itself."""
        cells = "".join(
            f"<mtr><mtd>{self.math(left)}</mtd><mtd>{self.math(right)}</mtd></mtr>"
            for left, right in formula.rows
        )
        above = f"<p>{self.text(formula.lead)}</p>\n" if formula.note else ""
        label = f'<span class="number">({escape(formula.label)})</span>' if formula.label else ""
        return (
            f'{above}<div class="formula"><math display="block" displaystyle="true">'
            f'<mtable class="rows" displaystyle="true">{cells}</mtable></math>{label}</div>'
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
        return rendered(
            text, escape, lambda latex: f"<math>{self.math(latex)}</math>", "<em>{}</em>"
        )

    def math(self, latex: str) -> str:
        """MathML of one piece of LaTeX, without its outer element, mended."""
        if not latex.strip():
            return "<mrow></mrow>"
        # the converter forgets that one letter alone is upright, but not that a name is
        return _mended(self.convert(re.sub(r"\\mathrm\{(\w)\}", r"\\operatorname{\1}", latex)))


def equation_html(lines: Sequence[tuple[str, str]], name: str) -> str | None:
    """HTML table of numbered equations in MathML; None if no converter is installed."""
    try:
        page = _Page()
    except ImportError:
        return None  # a notebook then takes the LaTeX
    rows = "".join(
        f"<tr><td>({k})</td><td>{page.text(f'${latex}$')}</td><td>{page.text(note)}</td></tr>"
        for k, (latex, note) in enumerate(lines, start=1)
    )
    caption = f"{escape(name)}; (k) marks the state behind phase k"
    return f"<table><caption>{caption}</caption>{rows}</table>"


def _mended(mathml: str) -> str:
    """What is inside the outer element of a formula in MathML, mended for browsers.

    Names of functions get the spaces of TeX, signs in front of a term stand close to it,
    strokes and parentheses take no room of their own, and only around something tall do
    parentheses grow.
    """
    root = ElementTree.fromstring(re.sub(r' xmlns="[^"]*"', "", mathml, count=1))
    for row in list(root.iter()):
        _set_upright(row)
        _space_names(row)
        _space_signs(row)
        _settle_fences(row)
        _pair_bars(row)
    return "".join(ElementTree.tostring(child, encoding="unicode") for child in root)


def _set_upright(name: Element) -> None:
    """Make an operator of one letter an upright identifier."""
    if name.tag == "mo" and re.fullmatch("[A-Za-z]", name.text or ""):
        name.tag = "mi"
        name.set("mathvariant", "normal")


def _space_names(row: Element) -> None:
    if row.tag not in ("mrow", "math"):
        return
    neighbours = [None, *row, None]
    for before, element, after in zip(neighbours, neighbours[1:], neighbours[2:], strict=False):
        if element is None:
            continue
        name = element[0] if element.tag in ("msub", "msup", "msubsup") else element
        if name.tag not in ("mi", "mo") or not re.fullmatch("[a-z]{2,}", name.text or ""):
            continue
        name.tag = "mo"
        close_before = before is None or (before.tag == "mo" and before.text not in _CLOSING)
        close_after = after is None or (after.text or "") in _OPENING or _opens(after)
        name.set("lspace", "0" if close_before else "0.167em")
        name.set("rspace", "0" if close_after else "0.167em")


def _opens(element: Element) -> bool:
    """Whether an element is a row that begins with a parenthesis."""
    return element.tag == "mrow" and len(element) > 0 and element[0].text in _OPENING


def _space_signs(row: Element) -> None:
    for element in row:
        if element.tag == "mi" and element.text in _SIGNS:
            element.tag = "mo"
        if element.tag == "mo" and element.text in ("/", "."):
            element.attrib |= _TIGHT
    for before, sign in pairwise(row):
        if sign.tag == "mo" and before.text in _BEFORE_SIGN and sign.text in _SIGNS:
            sign.attrib |= {"form": "prefix", **_TIGHT}


def _settle_fences(row: Element) -> None:
    """Keep the parentheses of a row from growing if nothing tall is inside."""
    if len(row) < 2 or row[0].get("fence") != "true" or row[-1].get("fence") != "true":
        return
    inner = {element.tag for part in row for element in part.iter()}
    for fence in (row[0], row[-1]):
        fence.attrib |= _TIGHT
        if not inner & _TALL:
            fence.set("stretchy", "false")


def _pair_bars(row: Element) -> None:
    """Make bars in a row fences, of which every other one closes."""
    bars = [bar for bar in row if bar.text == "|"]
    for number, bar in enumerate(bars if len(bars) % 2 == 0 else ()):
        bar.tag = "mo"
        form = "postfix" if number % 2 else "prefix"
        bar.attrib |= {"form": form, "stretchy": "false", **_TIGHT}
