"""Documents as LaTeX articles, and LaTeX as PDF."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

from nonsmooth.derive.document.blocks import Block, Document, Formula, Heading, Paragraph, Table
from nonsmooth.derive.document.layout import rows, width

__all__ = ["LatexMissing", "compile_pdf", "to_latex"]

_PREAMBLE = r"""\documentclass[10pt,a4paper]{article}
\usepackage{amsmath,amssymb}
\usepackage{array,booktabs,longtable}
\usepackage[margin=25mm]{geometry}
\allowdisplaybreaks[1]
\setcounter{MaxMatrixCols}{40}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip plus 2pt minus 1pt}
\setlength{\LTpre}{0.7\baselineskip}
\setlength{\LTpost}{0.4\baselineskip}
\setlength{\jot}{5pt}
\AtBeginDocument{%
  \setlength{\abovedisplayskip}{6pt plus 2pt minus 2pt}%
  \setlength{\belowdisplayskip}{3pt plus 2pt minus 1pt}}
\renewcommand{\arraystretch}{1.15}
\newcolumntype{L}[1]{>{\raggedright\arraybackslash}p{#1}}
"""
_SPECIAL = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "é": r"\'e",
    **{c: f"\\{c}" for c in "&%#_{}"},
}
_TEXT_WIDTH = 45.5
_MARKS = re.compile(r"(\$[^$]+\$|\*[^*]+\*)")


class LatexMissing(RuntimeError):
    """No LaTeX was found on the search path."""

    def __init__(self) -> None:
        super().__init__(
            "no LaTeX found (pdflatex, lualatex or tectonic): install texlive-latex-recommended"
            " (Debian, Ubuntu), MacTeX (macOS) or MiKTeX (Windows), or choose another format"
        )


def to_latex(document: Document) -> str:
    """Write a complete article."""
    title = _text(document.title)
    parts = [
        _PREAMBLE,
        r"\begin{document}",
        rf"\begin{{center}}\Large\bfseries {title}\end{{center}}",
    ]
    for numbered, group in groupby(document.blocks, _is_numbered):
        blocks = list(group)
        # equations in a row are aligned with each other
        parts += [_formulas(blocks)] if numbered else [_block(block) for block in blocks]
    parts.append(r"\end{document}")
    return "\n".join(parts) + "\n"


def _block(block: Block) -> str:
    if isinstance(block, Heading):
        return f"\n\\{'sub' * (block.level - 1)}section{{{_text(block.text)}}}\n"
    if isinstance(block, Paragraph):
        return f"\n{_text(block.text)}"
    if isinstance(block, Formula):
        return _formulas([block])
    return _table(block)


def _is_numbered(block: Block) -> bool:
    return isinstance(block, Formula) and block.label is not None


def _formulas(formulas: Sequence[Block]) -> str:
    found = []
    for formula in formulas:
        if not isinstance(formula, Formula):
            continue
        broken = [f"{left} &{right}" for left, right in rows(formula.lines)]
        broken[-1] += rf" && \text{{{_text(formula.note)}}}" if formula.note else ""
        broken[-1] += rf" \tag{{{formula.label}}}" if formula.label else ""
        found += broken
    body = " \\\\\n".join(found)
    return f"\\begin{{align*}}\n{body}\n\\end{{align*}}"


def _table(table: Table) -> str:
    columns = ["l"] * len(table.header)
    if table.wrapped is not None:
        widths = [
            max(_measure(r[i]) for r in (table.header, *table.rows)) for i in range(len(columns))
        ]
        taken = sum(w + 1.2 for i, w in enumerate(widths) if i != table.wrapped)
        room = min(_TEXT_WIDTH - taken - 1.2, widths[table.wrapped] + 1.0)
        columns[table.wrapped] = f"L{{{room:.1f}em}}"
    head = " & ".join(rf"\textbf{{{_text(h)}}}" for h in table.header)
    body = [
        rf"\begin{{longtable}}{{@{{}}{''.join(columns)}@{{}}}}",
        r"\toprule",
        rf"{head} \\",
        r"\midrule",
    ]
    body += [r"\endhead", r"\bottomrule", r"\endlastfoot"]
    body += [" & ".join(_text(cell) for cell in row) + r" \\" for row in table.rows]
    body.append(r"\end{longtable}")
    return "\n".join(body)


def _measure(text: str) -> float:
    """Approximate width of text in em."""
    total = 0.0
    for part in _MARKS.split(text):
        total += width(part[1:-1]) if part.startswith("$") else 0.52 * len(part.strip("*"))
    return total


def _text(text: str) -> str:
    """Text with its marks, special characters escaped outside formulas."""
    found = []
    for part in _MARKS.split(text):
        if part.startswith("$") and part.endswith("$") and len(part) > 1:
            found.append(part)
        elif part.startswith("*") and part.endswith("*") and len(part) > 1:
            found.append(rf"\emph{{{_escaped(part[1:-1])}}}")
        else:
            found.append(_escaped(part))
    return "".join(found)


def _escaped(text: str) -> str:
    return "".join(_SPECIAL.get(c, c) for c in text)


def compile_pdf(latex: str, target: Path) -> None:
    """Compile an article to a PDF file, in a temporary directory and without a shell.

    Raises
    ------
    LatexMissing
        If neither pdflatex nor lualatex nor tectonic is installed.
    RuntimeError
        If LaTeX reports an error; the message ends with the end of its log.
    """
    engines = (shutil.which(name) for name in ("pdflatex", "lualatex", "tectonic"))
    engine = next((e for e in engines if e), None)
    if engine is None:
        raise LatexMissing
    if Path(engine).stem == "tectonic":
        command, runs = [engine, "--untrusted", "document.tex"], 1
    else:
        options = ["-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape"]
        # the second run knows the widths of the tables
        command, runs = [engine, *options, "document.tex"], 2
    # no dates: the same article gives the same file
    environment = os.environ | {"SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "document.tex").write_text(latex, encoding="utf-8")
        for _ in range(runs):
            done = subprocess.run(
                command,
                cwd=folder,
                env=environment,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
            )
            if done.returncode != 0:
                report = "\n".join((done.stdout + done.stderr).splitlines()[-15:])
                raise RuntimeError(f"{Path(engine).name} failed:\n{report}")
        shutil.copyfile(Path(folder, "document.pdf"), target)
