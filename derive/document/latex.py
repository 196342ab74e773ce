"""Documents as LaTeX articles, and LaTeX as PDF."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from nonsmooth.derive.document.blocks import (
    Block,
    Document,
    Formula,
    Heading,
    Paragraph,
    Table,
    rendered,
    text_width,
)

_PREAMBLE = r"""\documentclass[10pt,a4paper]{article}
\usepackage{amsmath,amssymb}
\usepackage{array,booktabs,longtable}
\usepackage[margin=25mm]{geometry}
\allowdisplaybreaks[4]
\setcounter{MaxMatrixCols}{40}
\setlength{\parindent}{0pt}
% a row vector in running text is not broken: the spaces before it give way
\setlength{\emergencystretch}{8em}
\setlength{\parskip}{0.5\baselineskip plus 2pt minus 1pt}
\setlength{\LTpre}{0.7\baselineskip}
\setlength{\LTpost}{0.4\baselineskip}
\setlength{\jot}{5pt}
\AtBeginDocument{%
  \setlength{\abovedisplayskip}{6pt plus 2pt minus 2pt}%
  \setlength{\belowdisplayskip}{3pt plus 2pt minus 1pt}}
\renewcommand{\arraystretch}{1.15}
% a heading, and a little of what follows it, on one page
\newcommand{\needroom}[1]{\par\penalty-100\begingroup
  \dimen0=\pagegoal\advance\dimen0-\pagetotal
  \ifdim\dimen0<#1\ifdim\dimen0>0pt\newpage\fi\fi\endgroup}
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
_ROOM = 6
# a table of more rows may go over the end of a page
_LONG = 14
# rows of one relation that stay on one page
_TOGETHER = 18


class LatexMissing(RuntimeError):
    """No LaTeX is on the search path."""

    def __init__(self) -> None:
        super().__init__(
            "no LaTeX found (pdflatex, lualatex or tectonic): install texlive-latex-recommended"
            " (Debian, Ubuntu), MacTeX (macOS) or MiKTeX (Windows), or choose another format"
        )


def to_latex(document: Document) -> str:
    """A document as a complete LaTeX article."""
    title = _text(document.title)
    parts = [
        _PREAMBLE,
        r"\begin{document}",
        rf"\begin{{center}}\Large\bfseries {title}\end{{center}}",
    ]
    first = next((b.number for b in document.blocks if isinstance(b, Heading)), None) or 1
    if first > 1:  # a part of the whole
        parts.append(rf"\setcounter{{section}}{{{first - 1}}}")
    around = (None, *document.blocks, None)
    for before, block, after in zip(around, document.blocks, around[2:], strict=False):
        if isinstance(block, Heading):
            parts.append(_heading(block, before, after))
        else:
            parts.append(_block(block))
    parts.append(r"\end{document}")
    return "\n".join(parts) + "\n"


def _heading(heading: Heading, before: Block | None, after: Block | None) -> str:
    """LaTeX of a heading, on one page with the heading that follows it at once."""
    title = f"\\{'sub' * (heading.level - 1)}section{{{_text(heading.text)}}}"
    if isinstance(before, Heading):
        return f"\n{title}\n"
    room = 2 * _ROOM if isinstance(after, Heading) else _ROOM
    return f"\n\\needroom{{{room}\\baselineskip}}\n{title}\n"


def _block(block: Paragraph | Formula | Table) -> str:
    """LaTeX of a block that is no heading; the note of a formula stands above it."""
    if isinstance(block, Formula):
        return (f"\n{_text(block.lead)}\n" if block.note else "") + _aligned(block)
    return _table(block) if isinstance(block, Table) else f"\n{_text(block.text)}"


def _aligned(formula: Formula) -> str:
    found = [f"{left} &{right}" for left, right in formula.rows]
    found[-1] += rf" \tag{{{formula.label}}}" if formula.label else ""
    body, together = found[0], 1
    for place, row in enumerate(found[1:], start=1):
        # a page may break where a relation begins, or inside one that is as long as half a page,
        # but not beside the first or the last row
        inside = row.startswith(" &") and together < _TOGETHER
        free = 1 < place < len(found) - 1 and not inside
        body += (r" \\" if free else r" \\*") + f"\n{row}"
        together = 1 if free else together + 1
    return f"\\begin{{align*}}\n{_spread(body)}\n\\end{{align*}}"


def _spread(text: str) -> str:
    """LaTeX with more room between the rows of matrices that have fractions as entries."""

    def rows_apart(match: re.Match[str]) -> str:
        found = match[0]
        return found.replace(r"\\", r"\\[3pt]") if r"\frac" in found else found

    return re.sub(r"\\begin\{matrix\}.*?\\end\{matrix\}", rows_apart, text)


def _table(table: Table) -> str:
    columns = ["l"] * len(table.header)
    if table.wrapped is not None:
        widths = [
            max(text_width(r[i]) for r in (table.header, *table.rows)) for i in range(len(columns))
        ]
        taken = sum(w + 1.2 for i, w in enumerate(widths) if i != table.wrapped)
        room = min(_TEXT_WIDTH - taken - 1.2, widths[table.wrapped] + 1.0)
        columns[table.wrapped] = f"L{{{room:.1f}em}}"
    head = " & ".join(rf"\textbf{{{_text(h)}}}" for h in table.header)
    body = [" & ".join(_text(cell) for cell in row) + r" \\" for row in table.rows]
    columns_of = f"{{@{{}}{''.join(columns)}@{{}}}}"
    top = [r"\toprule", rf"{head} \\", r"\midrule"]
    if len(table.rows) <= _LONG:
        begin = [r"\begin{center}", rf"\begin{{tabular}}{columns_of}"]
        end = [r"\bottomrule", r"\end{tabular}", r"\end{center}"]
        return "\n".join([*begin, *top, *body, *end])
    top += [r"\endhead", r"\bottomrule", r"\endlastfoot"]
    return "\n".join([rf"\begin{{longtable}}{columns_of}", *top, *body, r"\end{longtable}"])


def _text(text: str) -> str:
    """LaTeX of text with formulas and emphasis, special characters escaped outside formulas."""
    special = str.maketrans(_SPECIAL)
    return rendered(text, lambda words: words.translate(special), "${}$".format, r"\emph{{{}}}")


def compile_pdf(latex: str) -> bytes:
    """Bytes of an article's PDF, compiled in a temporary directory, without a shell.

    LatexMissing says that neither pdflatex nor lualatex nor tectonic is installed,
    RuntimeError that LaTeX reports an error; its message ends with the end of the log.
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
        return Path(folder, "document.pdf").read_bytes()
