"""The formulas of a document, and those that stand on its pages in each format."""

import re
from collections import Counter
from xml.etree import ElementTree

from nonsmooth.derive.document.blocks import Document, Formula, Heading, Paragraph
from nonsmooth.derive.document.hypertext import to_html, to_markdown
from nonsmooth.derive.document.latex import to_latex
from tests.formulas.latex import read_latex
from tests.formulas.mathml import read_element

_INLINE = re.compile(r"\$([^$]+)\$")
_MATRIX = re.compile(r"\\begin\{matrix\}.*?\\end\{matrix\}", re.DOTALL)
_BREAK = re.compile(r" \\\\\*?\n")
_ENDS = re.compile(r"\s*(?:\\tag\{[\d.]+\})?\s*$", re.DOTALL)


def inline(text):
    """LaTeX of the formulas in running text."""
    return _INLINE.findall(text)


def texts_of(block):
    """The texts of a block."""
    if isinstance(block, Heading | Paragraph):
        return [block.text]
    if isinstance(block, Formula):
        return [block.note or ""]
    return [cell for row in (block.header, *block.rows) for cell in row]


def _own(document):
    found = Counter()
    for block in document.blocks:
        found.update(read_latex(f) for text in texts_of(block) for f in inline(text))
        if isinstance(block, Formula):
            found.update(read_latex(side) for row in block.rows for side in row)
    return found


def _markdown(document):
    text = to_markdown(document).replace("&#124;", "|")
    found = Counter()
    for body in re.findall(r"\\begin\{aligned\}\n(.*?)\n\\end\{aligned\}", text, re.DOTALL):
        found.update(_sides(body))
    text = re.sub(r"\$\$\n.*?\n\$\$", "", text, flags=re.DOTALL)
    found.update(map(read_latex, inline(text)))
    return found


def _latex(document):
    text = to_latex(document).replace(r"\\[3pt]", r"\\")
    found = Counter()
    displays = re.findall(r"\\begin\{align\*\}\n(.*?)\n\\end\{align\*\}", text, re.DOTALL)
    for body in displays:
        found.update(_sides(body))
    text = re.sub(r"\\begin\{align\*\}\n.*?\n\\end\{align\*\}", "", text, flags=re.DOTALL)
    found.update(map(read_latex, inline(text.partition(r"\begin{document}")[2])))
    return found


def page_of(document):
    """The HTML page, which has to be well formed."""
    return ElementTree.fromstring(re.sub("<!DOCTYPE html>|<meta [^>]*>", "", to_html(document)))


def read_page(latex):
    """Items of a formula on an HTML page."""
    (element,) = page_of(Document("", (Paragraph(f"${latex}$"),))).iter("math")
    return read_element(element)


def _html(document):
    found = Counter()
    for element in page_of(document).iter("math"):
        if element.get("display") == "block":
            found.update(read_element(side) for row in element[0] for side in row)
        else:
            found[read_element(element)] += 1
    return found


def _sides(body):
    for row in _BREAK.split(body):
        whole = _MATRIX.sub(lambda m: m[0].replace("&", "\0"), _ENDS.sub("", row))
        left, _, right = whole.partition(" &")
        yield read_latex(left.replace("\0", "&"))
        yield read_latex(right.replace("\0", "&"))


def on_pages(document):
    """All formulas: of the document itself, and read from the page in each format."""
    return {
        "document": _own(document),
        "markdown": _markdown(document),
        "latex": _latex(document),
        "html": _html(document),
    }
