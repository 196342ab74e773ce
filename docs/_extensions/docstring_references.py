"""Docstrings as pages: public names are links, formulas as written, enumerations listed."""

from enum import Enum
from inspect import cleandoc, isroutine

from docutils.nodes import Element, literal
from numpydoc.xref import DEFAULT_LINKS
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment


def show_as_code(
    app: Sphinx, environment: BuildEnvironment, node: pending_xref, shown: Element
) -> Element | None:
    """Show a name that has no page of its own, such as a parameter's, as code.

    References with a role of their own, ``:py:func:`` and the like, stay strict.
    """
    if node.get("refdomain") == "py" and node["reftype"] == "obj":
        return literal("", shown.astext())
    return None


def skip_tuple_fields(
    app: Sphinx, what: str, name: str, member: object, skip: bool, options: object
) -> bool | None:
    """Leave out the fields of named tuples, which their class describes."""
    return True if type(member).__name__ == "_tuplegetter" else None


def show_as_written(
    app: Sphinx, what: str, name: str, member: object, options: object, lines: list[str]
) -> None:
    """Keep the lines of an indented formula, and list the members of an enumeration.

    Of an object that is called, as `nonsmooth.certify` is, what its call does is told too.
    """
    if what == "function" and not isroutine(member):
        lines += cleandoc(type(member).__call__.__doc__).splitlines()
    for i in range(len(lines) - 2):
        head, blank, formula = lines[i : i + 3]
        indented = len(formula) - len(formula.lstrip()) > len(head) - len(head.lstrip())
        if head.endswith(":") and not blank and indented and formula.lstrip()[0] not in "*->=":
            lines[i] = f"{head.removesuffix(':').removesuffix(':')}::"
    if isinstance(member, type) and issubclass(member, Enum):
        told = {one: getattr(one, "message", None) or getattr(one, "text", "") for one in member}
        lines += [f"* ``{one.name}``: {text}" for one, text in told.items()] + [""]


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to references that lead nowhere, to docstrings and to the members of classes."""
    DEFAULT_LINKS.clear()  # to Python's own pages, which are not here
    app.connect("missing-reference", show_as_code)
    app.connect("autodoc-process-docstring", show_as_written, priority=400)  # before numpydoc
    app.connect("autodoc-skip-member", skip_tuple_fields)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
