"""Public names say what they take, give, refuse, and how they are used.

numpydoc sections are demanded of what `nonsmooth` and `nonsmooth.derive` export, and of the results
that the reference lists: of functions, of classes and of their public methods. What a function
returns is listed there. Ruff's pydocstyle cannot tell whether they are complete.
"""

import ast
import inspect
import re
import textwrap
from dataclasses import fields, is_dataclass
from functools import cache, cached_property

import pytest

import nonsmooth
import nonsmooth.derive
import nonsmooth.jax
import nonsmooth.torch
from tests.places import CHECKOUT, records

ERRORS = {"DeclarationError", "DerivationError", "InputError", "MissingExtra", "NoConvergence"}


def public():
    """Kind, name and object of each public class, function, method and property."""
    for package in (nonsmooth, nonsmooth.derive, nonsmooth.jax, nonsmooth.torch):
        for name in package.__all__:
            found = getattr(package, name)
            if inspect.isfunction(found):
                yield "function", name, found
            elif name == "certify":
                yield "function", name, type(found).__call__
                for target in (n for n in vars(type(found)) if not n.startswith("_")):
                    yield "function", f"{name}.{target}", getattr(found, target)
            elif inspect.isclass(found):
                yield from members(name, found)
    for name, found in records().items():
        if hasattr(found, "_repr_html_"):
            yield from members(name, found)


def members(name, found):
    """Kind, name and object of a class and of its public methods and properties."""
    yield "class", name, found
    for attribute, member in vars(found).items():
        if isinstance(member, property | cached_property):
            inner = member.fget if isinstance(member, property) else member.func
            kind = "property"
        else:
            inner, kind = getattr(member, "__func__", member), "method"
        if not attribute.startswith("_") and inspect.isfunction(inner):
            yield kind, f"{name}.{attribute}", inner


PUBLIC = list(public())
KNOWN = {name for kind, name, _ in PUBLIC if kind == "class"} | {*records()}
KNOWN |= {"Any", "Callable", "Dataset", "None"}


def sections(docstring):
    """Text of each section of a docstring, that of the summary under an empty name."""
    parts = re.split(r"^(\w+)\n-{3,}$", inspect.cleandoc(docstring), flags=re.MULTILINE)
    return {"": parts[0]} | dict(zip(parts[1::2], parts[2::2], strict=True))


def entries(section):
    """Names that a section of parameters or attributes describes."""
    heads = (line.partition(" : ")[0] for line in section.splitlines() if line[:1].strip())
    return {name.strip().lstrip("*") for head in heads for name in head.split(",")}


def raised(function):
    """Errors of the package that the body of a function raises by itself."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    calls = (n.exc for n in ast.walk(tree) if isinstance(n, ast.Raise))
    return {c.func.id for c in calls if isinstance(c, ast.Call) and isinstance(c.func, ast.Name)}


@pytest.mark.parametrize(("kind", "name", "found"), PUBLIC, ids=[name for _, name, _ in PUBLIC])
def test_docstrings_are_complete(kind, name, found):
    told = sections(found.__doc__ or "")
    summary = told[""].strip().partition("\n")[0]
    assert summary.endswith((".", ":")), f"no summary in one line: {summary!r}"
    if kind == "class":
        described = entries(told.get("Parameters", "") + told.get("Attributes", ""))
        own = fields(found) if is_dataclass(found) else ()
        wanted = {f.name for f in own if not f.name.startswith("_")}
        assert wanted <= described, f"not described: {sorted(wanted - described)}"
        return
    signature = inspect.signature(found)
    wanted = set(signature.parameters) - {"self", "cls"}
    described = entries(told.get("Parameters", ""))
    assert wanted == described, f"not described, or not there: {sorted(wanted ^ described)}"
    annotation = str(signature.return_annotation)
    unknown = set(re.findall(r"(?<![.\w])[A-Z]\w+", annotation)) - KNOWN
    assert kind != "function" or not unknown, f"not in the reference: {sorted(unknown)}"
    if kind != "property" and signature.return_annotation not in (None, "None"):
        assert "Returns" in told
    missing = {error for error in raised(found) & ERRORS if error not in told.get("Raises", "")}
    assert not missing, f"raised and not told: {sorted(missing)}"
    if kind == "function":
        assert "Examples" in told


QUOTED = re.compile(r'"""(.*?)"""', re.DOTALL)


@cache
def texts():
    """Sources of the package by their files."""
    files = [p for room in ("runtime", "derive") for p in (CHECKOUT / room).rglob("*.py")]
    return {file.relative_to(CHECKOUT): file.read_text(encoding="utf-8") for file in files}


@pytest.mark.slow
def test_docstrings_name_what_exists():
    known = {part for file in texts() for part in file.with_suffix("").parts}
    for text in texts().values():
        known.update(re.findall(r"\w+", re.sub("#.*", "", QUOTED.sub("", text))))
    stale = [
        f"{file}: `{quoted}`"
        for file, text in texts().items()
        for docstring in QUOTED.findall(text)
        for quoted in re.findall(r"(?<!`)`([^`\n]+)`(?!`)", docstring)
        if not known.issuperset(re.findall(r"\b[A-Za-z_]\w*", quoted))
    ]
    assert not stale


def test_a_class_name_has_one_meaning():
    places = {}
    for file, text in texts().items():
        if file.parts[0] == "runtime":
            for name in re.findall(r"^ *class (\w+)", QUOTED.sub("", text), re.MULTILINE):
                places.setdefault(name, []).append(str(file))
    assert {name: where for name, where in places.items() if len(where) > 1} == {}
