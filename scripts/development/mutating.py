"""Find the places of a source in which a bug can be planted, by its syntax alone."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

from mutating_c import changes_in_c


class Change(NamedTuple):
    """A piece of a text between two characters, its replacement, and what it is part of."""

    function: str
    operator: str
    begin: int
    end: int
    after: str


@dataclass(frozen=True)
class Place:
    """One bug of a file: a change with an address that is stable as long as its function stays."""

    file: str
    count: int
    line: int
    before: str
    change: Change

    @property
    def address(self) -> str:
        """File, qualified name, operator, and the number among these in the function."""
        return f"{self.file}::{self.change.function}::{self.change.operator}[{self.count}]"

    def __str__(self) -> str:
        """Say where it is and what it does."""
        before, after = (" ".join(text.split()) for text in (self.before, self.change.after))
        return f"{self.address}  line {self.line}: {before} -> {after}"


def places(file: str, text: str) -> list[Place]:
    """All bugs of a source, in its order."""
    source = _Source(text)
    changes = (
        [Change(*each) for each in changes_in_c(text)]
        if file.endswith(".c")
        else [*_changes(ast.parse(text), source, _Around())]
    )
    counts: Counter[tuple[str, str]] = Counter()
    ordered = []
    for change in sorted(changes, key=lambda each: each.begin):
        counts[change[:2]] += 1
        line = text.count("\n", 0, change.begin) + 1
        before = text[change.begin : change.end]
        ordered.append(Place(file, counts[change[:2]], line, before, change))
    return ordered


def planted(text: str, place: Place) -> str:
    """The text with the bug in it."""
    return text[: place.change.begin] + place.change.after + text[place.change.end :]


def functions(text: str) -> set[str]:
    """Qualified names of the functions of a module."""
    return {name for _, name in _beginnings(ast.parse(text), "")}


def probed(text: str, statement: str) -> str:
    """The text with a statement at the head of every function and at the end of the module.

    In the statement {} stands for the name of the function, or that of the module.
    """
    source = _Source(text)
    for first, name in sorted(
        _beginnings(ast.parse(text), ""), key=lambda each: source.span(each[0]), reverse=True
    ):
        at = source.span(first)[0]
        head = text[text.rfind("\n", 0, at) + 1 : at]
        between = "; " if head.strip() else f"\n{head}"
        text = text[:at] + statement.format(name) + between + text[at:]
    return f"{text}\n{statement.format('')}\n"


ALONE = (ast.Name, ast.Constant, ast.Attribute, ast.Call, ast.Subscript)


class _Source:
    """Pieces of a text by nodes, whose columns count bytes."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.lines = text.split("\n")
        self.begins = [0, *accumulate(len(line) + 1 for line in self.lines)]

    def _position(self, line: int, column: int) -> int:
        return self.begins[line - 1] + len(self.lines[line - 1].encode()[:column].decode())

    def span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        """First character of a node, and the one behind it; decorators are part of a function."""
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        first = next(iter(getattr(node, "decorator_list", ())), None)
        end = self._position(node.end_lineno, node.end_col_offset)
        if first is not None:
            return self.text.rindex("@", 0, self.span(first)[0]), end
        return self._position(node.lineno, node.col_offset), end

    def __getitem__(self, node: ast.expr) -> str:
        """The text of an expression, in the parentheses that it may need."""
        begin, end = self.span(node)
        text = self.text[begin:end]
        return text if isinstance(node, ALONE) else f"({text})"


class _Around(NamedTuple):
    """What encloses a node: qualified name, whether that is a function, its return type."""

    name: str = ""
    function: bool = False
    returns: str = ""


def _beginnings(node: ast.AST, outer: str) -> Iterator[tuple[ast.stmt, str]]:
    """First statements of functions behind their docstrings, with qualified names."""
    for child in ast.iter_child_nodes(node):
        name = outer
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            name = f"{outer}.{child.name}".lstrip(".")
            body = child.body[ast.get_docstring(child, clean=False) is not None :]
            if body and not isinstance(child, ast.ClassDef):
                yield body[0], name
        yield from _beginnings(child, name)


def _changes(node: ast.AST, source: _Source, around: _Around) -> Iterator[Change]:
    if _left_out(node):
        return
    for operator, place, after in _bugs(node, source, around):
        yield Change(around.name, operator, *source.span(place), after)
    if isinstance(node, ast.Call) and (name := _called(node)) in EXTREMES:
        end = source.span(node.func)[1]
        yield Change(around.name, "extreme", end - len(name), end, EXTREMES[name])
    for child, inside in _parts(node, around):
        yield from _changes(child, source, inside)


def _left_out(node: ast.AST) -> bool:
    """Whether a node gets no bugs.

    It is text for messages, serves types, has no text of its own, or a change makes no
    difference.
    """
    match node:
        case ast.Raise() | ast.Assert() | ast.JoinedStr() | ast.pattern():
            return True
        case ast.keyword(arg="strict"):
            return True
        case ast.If(test=test):
            return not {*_names(test)}.isdisjoint({"TYPE_CHECKING", "__name__"})
        case ast.Expr(value=ast.Call(func=func)):
            return not {*_names(func)}.isdisjoint(QUIET)
    return False


def _parts(node: ast.AST, around: _Around) -> Iterator[tuple[ast.AST, _Around]]:
    """Nodes inside a node that can have bugs, each with what encloses it."""
    match node:
        case ast.FunctionDef() | ast.AsyncFunctionDef():
            returns = ast.unparse(node.returns) if node.returns else ""
            inside = _Around(f"{around.name}.{node.name}".lstrip("."), True, returns)
            values = [*node.args.defaults, *filter(None, node.args.kw_defaults)]
            yield from ((each, inside) for each in (*values, *node.body))
        case ast.ClassDef():
            inside = _Around(f"{around.name}.{node.name}".lstrip("."))
            yield from ((each, inside) for each in node.body)
        case ast.Assign(targets=[ast.Name(id=name)], value=value) if not around.function:
            if not name.startswith("__"):
                yield value, around._replace(name=f"{around.name}.{name}".lstrip("."))
        case ast.AnnAssign(target=target, annotation=annotation, value=value):
            named = around
            if isinstance(target, ast.Name) and not around.function:
                named = around._replace(name=f"{around.name}.{target.id}".lstrip("."))
            if value is not None and "TypeAlias" not in _names(annotation):
                yield value, named
        case ast.match_case(guard=guard, body=body):
            yield from ((each, around) for each in (*filter(None, [guard]), *body))
        case _:
            yield from ((each, around) for each in ast.iter_child_nodes(node))


QUIET = {"logging", "logger", "warnings", "print", "super"}  # calls that only tell, or must be
BOUNDARIES: dict[type[ast.cmpop], str] = {
    ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">",
}  # fmt: skip
REVERSED: dict[type[ast.cmpop], str] = {
    ast.Lt: ">", ast.LtE: ">=", ast.Gt: "<", ast.GtE: "<=", ast.Eq: "!=", ast.NotEq: "==",
    ast.Is: "is not", ast.IsNot: "is", ast.In: "not in", ast.NotIn: "in",
}  # fmt: skip
COMPARED: dict[type[ast.cmpop], str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
    ast.Is: "is", ast.IsNot: "is not", ast.In: "in", ast.NotIn: "not in",
}  # fmt: skip
_PAIRS = [
    ("min", "max"), ("minimum", "maximum"), ("fmin", "fmax"), ("argmin", "argmax"),
    ("nanmin", "nanmax"), ("all", "any"), ("floor", "ceil"),
]  # fmt: skip
EXTREMES = dict([*_PAIRS, *(pair[::-1] for pair in _PAIRS)])
ANSWERS = {"bool": "not {}", "float": "-{}", "np.ndarray": "-{}", "int": "{} + 1"}
Bug = tuple[str, ast.expr | ast.stmt, str]


def _bugs(node: ast.AST, source: _Source, around: _Around) -> Iterator[Bug]:
    """Bugs of a node itself: operator, the node that is replaced, and the replacement."""
    match node:
        case ast.Compare(left=left, ops=ops, comparators=comparators):
            for k, op in enumerate(ops):
                for operator, exchanged in (("boundary", BOUNDARIES), ("comparison", REVERSED)):
                    if type(op) in exchanged:
                        signs = [COMPARED[type(each)] for each in ops]
                        signs[k] = exchanged[type(op)]
                        rest = zip(signs, map(source.__getitem__, comparators), strict=True)
                        after = " ".join([source[left], *map(" ".join, rest)])
                        yield operator, node, f"({after})"
        case ast.BinOp(left=left, op=op, right=right) if not _joined(left, right):
            sum_of = {ast.Add: "-", ast.Sub: "+"}.get(type(op))
            if sum_of:
                yield "term", node, f"({source[left]} {sum_of} {source[right]})"
            elif isinstance(op, ast.Mult | ast.Pow):
                yield "factor", node, source[left]
            elif isinstance(op, ast.Div):
                yield "factor", node, f"({source[left]} * {source[right]})"
            elif isinstance(op, ast.BitAnd | ast.BitOr) and around.function:
                yield "condition", node, source[right]
                yield "condition", node, source[left]
        case ast.AugAssign(target=target, op=ast.Add() | ast.Sub() as op, value=value):
            if not _joined(value):
                sign = "-" if isinstance(op, ast.Add) else "+"
                begin, end = source.span(target)
                yield "term", node, f"{source.text[begin:end]} {sign}= {source[value]}"
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            yield "sign", node, source[operand]
        case ast.UnaryOp(op=ast.Not() | ast.Invert(), operand=operand):
            yield "negation", node, source[operand]
        case ast.BoolOp(op=op, values=values):
            word = " and " if isinstance(op, ast.And) else " or "
            for left_out in values:
                others = [source[each] for each in values if each is not left_out]
                yield "condition", node, f"({word.join(others)})" if others[1:] else others[0]
        case ast.Attribute(attr="T", value=value):
            yield "transpose", node, source[value]
        case ast.Constant(value=bool() as value):
            yield "truth", node, f"{not value}"
        case ast.Constant(value=int()):
            yield "number", node, f"({source[node]} + 1)"
        case ast.Constant(value=float() as value):
            yield "number", node, f"({source[node]} * 1000)" if value else "1.0"
        case ast.Expr(value=ast.Call()):
            yield "call", node, "pass"
        case ast.If(
            test=test, body=[*_, ast.Raise() | ast.Return() | ast.Continue() | ast.Break()]
        ):
            yield "guard", test, "False"
        case ast.If(test=test) | ast.IfExp(test=test):
            yield from _chosen(test, source)
        case ast.comprehension(ifs=ifs):
            for test in ifs:
                yield from _chosen(test, source)
        case ast.Return(value=ast.Tuple(elts=[*_, last])) if not isinstance(last, ast.Starred):
            yield "answer", last, "None"
        case ast.Return(value=ast.expr() as value) if not isinstance(value, ast.Constant):
            if around.returns in ANSWERS:
                yield "answer", value, f"({ANSWERS[around.returns].format(source[value])})"
            elif around.returns.endswith("| None"):
                yield "answer", value, "None"


def _chosen(test: ast.expr, source: _Source) -> Iterator[Bug]:
    """The negation of a test that has no comparison or word of its own to be changed."""
    if isinstance(test, ast.Name | ast.Attribute | ast.Call | ast.Subscript):
        yield "choice", test, f"(not {source[test]})"


def _called(call: ast.Call) -> str:
    match call.func:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def _names(node: ast.AST) -> list[str]:
    return [
        each.id if isinstance(each, ast.Name) else each.attr
        for each in ast.walk(node)
        if isinstance(each, ast.Name | ast.Attribute)
    ]


def _joined(*operands: ast.expr) -> bool:
    """Whether some operand is a text, a list, a tuple or None, so that no other sum exists."""
    return any(
        isinstance(each, ast.JoinedStr | ast.List | ast.Tuple | ast.ListComp)
        or (isinstance(each, ast.Constant) and isinstance(each.value, str | None))
        for each in operands
    )
