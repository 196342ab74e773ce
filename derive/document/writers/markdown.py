"""Documents as Markdown with formulas, as GitHub shows it."""

from __future__ import annotations

from nonsmooth.derive.document.blocks import Block, Document, Formula, Heading, Paragraph

__all__ = ["to_markdown"]


def to_markdown(document: Document) -> str:
    """A document as a Markdown page; displayed formulas stand between ``$$``."""
    parts = [f"# {document.title}", *(_block(block) for block in document.blocks)]
    return "\n\n".join(parts) + "\n"


def _block(block: Block) -> str:
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
