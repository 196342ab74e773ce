"""The equations of an orbit in a notebook: a table in HTML, or aligned LaTeX."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import Any

from nonsmooth.derive.document.blocks import Formula
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.views.view import view_of
from nonsmooth.derive.equations.equation_system import EquationSystem

__all__ = ["equation_html", "equation_latex", "equation_lines", "expression_latex"]


def equation_lines(orbit: EquationSystem) -> list[tuple[str, str]]:
    """LaTeX and meaning of each equation, as the orbit's document has them."""
    blocks = describe_orbit(orbit).section("The equations")
    return [(b.lines[0].latex, b.note or "") for b in blocks if isinstance(b, Formula)]


def equation_latex(lines: Sequence[tuple[str, str]]) -> str:
    """LaTeX of equations, aligned at their signs, each with its meaning beside it."""
    rows = [f"& {latex} && \\text{{{note.replace('*', '')}}}" for latex, note in lines]
    body = " \\\\\n".join(rows)
    return f"$$\\begin{{aligned}}\n{body}\n\\end{{aligned}}$$"


def expression_latex(orbit: EquationSystem, expression: Any) -> str:
    """LaTeX of an expression or a matrix in the orbit's symbols, as its document writes it."""
    naming, _ = view_of(orbit)
    return naming.notation.latex(expression)


def equation_html(lines: Sequence[tuple[str, str]], name: str) -> str | None:
    """HTML table of numbered equations in MathML; None if no converter is installed."""
    try:
        from latex2mathml.converter import convert
    except ImportError:
        return None  # a notebook then takes the LaTeX
    rows = ""
    for number, (latex, note) in enumerate(lines, start=1):
        parts = re.split(r"\$([^$]+)\$", note.replace("*", ""))
        text = "".join(convert(p) if i % 2 else escape(p) for i, p in enumerate(parts))
        rows += f"<tr><td>({number})</td><td>{convert(latex)}</td><td>{text}</td></tr>"
    caption = f"{escape(name)}; (k) marks the state behind phase k"
    return f"<table><caption>{caption}</caption>{rows}</table>"
