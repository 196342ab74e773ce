"""Functions as data: expressions in named numbers, in one small grammar, over any arithmetic.

A `Function` takes arrays of named numbers; its intermediate terms and results are expressions of
integers, quotients of them, names, ``+ - * / **``, parentheses, ``pi``, ``sqrt`` and the other
functions of the kernels' arithmetics; ``constant(...)`` holds a number as users give values.
Reading one executes nothing, and costs time in proportion to its length. `written` writes any
kernel down as such a function, operation for operation, so that both give the same digits.
"""

from __future__ import annotations

import operator
import re
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, islice
from math import prod
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import parse

_TOKEN = re.compile(r"\s*(?:(?P<number>\d+)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/(),]))")
_ROUND = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
    "**": operator.pow,
}  # fmt: skip
# functions of the arithmetics, and how many of their arguments in front are plain integers
_FUNCTIONS = {
    "sqrt": 0, "sin": 0, "cos": 0, "abs": 0, "angle": 0, "rational": 2, "constant": 1,
    "exponential_difference": 2,  # the order, how many factors; then the degree of each
}  # fmt: skip
_DEEPEST = 100  # parentheses in each other
_WRITTEN_DEEP = 30  # beyond, a term of its own is written
_LONGEST_NUMBER = 400  # digits
_HIGHEST_POWER = 1000
_LARGEST = 20_000  # bits of a number that is made of integers; rows, columns
# of an expression in what it is made of: beyond, exact arithmetic may never end
_HIGHEST_DEGREE, _MOST_TERMS = 1000, 1 << 64
_MOST_INDEX = 64
_MOST_ROOTS = 16  # of the factors of a difference of the exponential, as in C


@dataclass(frozen=True, kw_only=True)
class Function:
    """A function of arrays of named numbers, given by expressions."""

    takes: tuple[str, ...]  # names of the entries of each argument, row after row, between blanks
    inputs: tuple[tuple[int, ...], ...]  # shapes of the arguments; that of a number is empty
    outputs: tuple[tuple[int, ...], ...]  # shapes of the results; that of a number is empty
    names: tuple[str, ...]  # of the results
    since: tuple[int, ...]  # place of the first result that takes each argument
    terms: tuple[str, ...]  # what is computed on the way, in order: ``name = expression``
    gives: tuple[str, ...]  # rows of the results: expressions between commas; a vector is one row

    def __call__(self, *arguments: Any, lib: Any, outputs: int | None = None) -> Any:
        """The first results over an arithmetic, as nested lists; a tuple where there are several.

        Arguments at the end that these results do not take may be left out.
        """
        shapes = self.outputs[:outputs]
        left_out = [None] * (len(self.inputs) - len(arguments))
        numbers = [
            entry
            for argument, shape in zip((*arguments, *left_out), self.inputs, strict=True)
            for entry in ([None] * prod(shape) if argument is None else _flat(argument, len(shape)))
        ]
        found = iter(self._program.run(numbers, lib, len(shapes)))
        results = tuple(_shaped(found, shape) for shape in shapes)
        return results if len(results) > 1 else results[0]

    def check(self, *, exactly: bool) -> None:
        """Read all expressions, and raise an `InputError` of one line for what is refused.

        If `exactly` is True, expressions that are too large for the exact arithmetic of
        polynomials are refused too.
        """
        if exactly and not self._program.expands:
            raise InputError("an expression is too large")
        _ = self._program

    @cached_property
    def _program(self) -> _Program:
        places: dict[str, int] = {}
        for names, shape in zip(self.takes, self.inputs, strict=True):
            found = names.split()
            if len(found) != prod(shape) or len(shape) > 2 or min(shape, default=0) < 0:
                raise InputError(f"{names[:60]!r} are not {prod(shape)} names")
            for name in found:
                _check_name(name, places)
                places[name] = len(places)
        reader = _Reader(places)
        for term in self.terms:
            name, equals, text = term.partition("=")
            name = name.strip()
            if not equals:
                raise InputError(f"{term[:60]!r} is not of the form name = expression")
            _check_name(name, places)
            (places[name],) = reader.read(text, 1)
        results = []
        rows = iter(self.gives)
        for shape in self.outputs:
            count, width = (1, *shape)[-2:] if shape else (1, 1)
            if len(shape) > 2 or not 0 <= min(count, width) <= max(count, width) <= _LARGEST:
                raise InputError(f"results of the shape {list(shape)}")
            for _ in range(count):
                results += reader.read(next(rows, ""), width) if width else []
        if next(rows, None) is not None:
            raise InputError("a function gives more than its shapes tell")
        first = self._first_uses(reader, results)
        self._check_arguments(first)
        # what a step reads is used no later than the step, so each still comes behind what it reads
        steps = sorted(reader.steps, key=lambda step: first[step[0]])
        uses = [first[place] for place, _, _ in steps]
        ends = tuple(bisect_right(uses, count) for count in range(len(self.outputs)))
        entries = tuple(accumulate(prod(shape) for shape in self.outputs))
        return _Program(len(first), tuple(steps), tuple(results), ends, entries, reader.expands)

    def _first_uses(self, reader: _Reader, results: Sequence[int]) -> list[int]:
        """By place of a number: that of the first result that needs it; how many if none does."""
        first = [len(self.outputs)] * len(reader.sizes)
        entries = iter(results)
        for count, shape in enumerate(self.outputs):
            for place in islice(entries, prod(shape)):
                first[place] = min(first[place], count)
        for place, what, operands in reversed(reader.steps):
            for operand in _read(what, operands):
                first[operand] = min(first[operand], first[place])
        return first

    def _check_arguments(self, first: Sequence[int]) -> None:
        if len(self.names) != len(self.outputs) or len(self.since) != len(self.inputs):
            raise InputError("results or arguments that are more or fewer than their names")
        if not all(0 <= since < len(self.outputs) for since in self.since):
            raise InputError("an argument is of a result that the function does not have")
        if [*self.since] != sorted(self.since):
            raise InputError("an argument is taken later than one behind it")
        uses = iter(first)
        for since, shape in zip(self.since, self.inputs, strict=True):
            used = min(islice(uses, prod(shape)), default=since)
            if used < since:
                raise InputError(f"{self.names[used]!r} needs an argument that it does not take")

    @property
    def constants(self) -> tuple[str, ...]:
        """Texts of the irrational numbers in the expressions, once each."""
        steps = self._program.steps
        return tuple(
            dict.fromkeys(operands[0] for _, what, operands in steps if what == "constant")
        )


def _check_name(name: str, places: dict[str, int]) -> None:
    if not name.isidentifier() or name in _FUNCTIONS or name == "pi":
        raise InputError(f"{name[:60]!r} is no name")
    if name in places:
        raise InputError(f"{name[:60]!r} is named twice")


def _flat(array: Any, depth: int) -> Iterator[Any]:
    if not depth:
        yield array
        return
    for entry in array:
        yield from _flat(entry, depth - 1)


def _shaped(numbers: Iterator[Any], shape: Sequence[int]) -> Any:
    if not shape:
        return next(numbers)
    return [_shaped(numbers, shape[1:]) for _ in range(shape[0])]


@dataclass(frozen=True)
class _Program:
    """A list of steps, each of which makes a number from numbers before it.

    A step is a place, an operation and its operands. The operation is None for an integer,
    an operator, or the name of a function. `expands` says whether all numbers, expanded,
    are polynomials of a sensible size.
    """

    size: int  # number of all places, those of the inputs among them
    # in the order of the first results that need them; those that none needs come last
    steps: tuple[tuple[int, Any, tuple[Any, ...]], ...]
    results: tuple[int, ...]  # places of the entries of all results
    steps_until: tuple[int, ...]  # how many steps give the results up to each
    entries_until: tuple[int, ...]  # how many entries they have
    expands: bool

    def run(self, inputs: Sequence[Any], lib: Any, count: int) -> list[Any]:
        """Entries of the first `count` results for these inputs, over the arithmetic `lib`."""
        found = [*inputs, *[None] * (self.size - len(inputs))]
        for place, what, operands in self.steps[: self.steps_until[count - 1]]:
            if what is None:
                found[place] = operands[0]
            elif what is operator.pow:
                found[place] = found[operands[0]] ** operands[1]
            elif not isinstance(what, str):
                found[place] = what(*[found[operand] for operand in operands])
            elif what == "pi":
                found[place] = lib.pi
            elif what == "abs":
                found[place] = abs(found[operands[0]])
            else:
                found[place] = getattr(lib, what)(*_operands(what, operands, found))
        return [found[place] for place in self.results[: self.entries_until[count - 1]]]


def _read(what: Any, operands: Sequence[Any]) -> Sequence[int]:
    """Places of the numbers that a step reads."""
    if what is None or what == "pi":
        return ()
    if what is operator.pow:
        return operands[:1]
    if not isinstance(what, str):
        return operands
    plain = _FUNCTIONS[what]
    return operands[plain + operands[1] if what == "exponential_difference" else plain :]


def _operands(what: str, operands: Sequence[Any], found: Sequence[Any]) -> list[Any]:
    plain = _FUNCTIONS[what]
    if what == "exponential_difference":
        plain += operands[1]
        t, *numbers = (found[operand] for operand in operands[plain:])
        ends = [*accumulate(operands[2:plain])]
        begins = [0, *ends]
        return [operands[0], t, *(tuple(numbers[i:j]) for i, j in zip(begins, ends, strict=False))]
    numbers = [found[operand] for operand in operands[plain:]]
    return [*operands[:plain], *numbers]


class _Reader:
    """Reads expressions into steps; the same expression twice is one step."""

    def __init__(self, places: dict[str, int]) -> None:
        self.places = places
        self.steps: list[tuple[int, Any, tuple[Any, ...]]] = []
        self.expands = True
        # of each number, expanded: bits where it is made of integers (else 0), degree, terms
        self.sizes = [(0, 1, 1)] * len(places)
        self._known: dict[tuple[Any, tuple[Any, ...]], int] = {}
        self._tokens: list[str] = []
        self._place = 0

    def read(self, text: str, count: int) -> list[int]:
        """Places of the numbers that `count` expressions between commas stand for."""
        self._tokens, self._place = list(_tokens(text)), 0
        found = [self._sum(0)]
        while self._next(","):
            found.append(self._sum(0))
        if self._token or len(found) != count:
            raise InputError(f"{text.strip()[:60]!r} is not {count} expressions between commas")
        return found

    @property
    def _token(self) -> str:
        return self._tokens[self._place]

    def _next(self, *wanted: str) -> str:
        """The next token if it is one of those wanted, and move on; else an empty text."""
        token = self._token
        if token not in wanted:
            return ""
        self._place += 1
        return token

    def _need(self, wanted: str) -> None:
        if not self._next(wanted):
            raise InputError(f"{wanted!r} is missing before {self._token[:20]!r}")

    def _sum(self, depth: int) -> int:
        found = self._product(depth)
        while sign := self._next("+", "-"):
            found = self._step(_ROUND[sign], found, self._product(depth))
        return found

    def _product(self, depth: int) -> int:
        found = self._power(depth)
        while sign := self._next("*", "/"):
            right = self._power(depth)
            numbers = self._integer(found), self._integer(right)
            if sign == "/" and None not in numbers:  # a fraction of integers is exact
                if numbers[1] == 0:
                    raise InputError("division by zero")
                found = self._step("rational", *numbers)
            else:
                found = self._step(_ROUND[sign], found, right)
        return found

    def _power(self, depth: int) -> int:
        if self._next("-"):
            if depth >= _DEEPEST:
                raise InputError("nested too deeply")
            inner = self._power(depth + 1)
            number = self._integer(inner)
            return self._step(operator.neg, inner) if number is None else self._constant(-number)
        found = self._atom(depth)
        if self._next("**"):
            exponent = self._plain()
            if exponent > _HIGHEST_POWER:
                raise InputError(f"exponent beyond {_HIGHEST_POWER}")
            found = self._step(operator.pow, found, exponent)
        return found

    def _atom(self, depth: int) -> int:
        if depth >= _DEEPEST:
            raise InputError("nested too deeply")
        token = self._token
        if token.isdecimal():
            return self._constant(self._plain())
        if self._next("("):
            found = self._sum(depth + 1)
            self._need(")")
            return found
        if not token.isidentifier():
            raise InputError(f"{token[:20]!r} where a number or a name belongs")
        self._place += 1
        if token == "constant":
            return self._step(token, self._text())
        if token in _FUNCTIONS and token != "rational":
            return self._called(token, depth + 1)
        if token == "pi":
            return self._step("pi")
        if token not in self.places:
            raise InputError(f"unknown name {token[:60]!r}")
        return self.places[token]

    def _called(self, name: str, depth: int) -> int:
        self._need("(")
        operands: list[int] = []
        plain = _FUNCTIONS[name]
        while True:
            if len(operands) < plain:
                operands.append(self._plain())
                if operands[-1] > _MOST_INDEX:
                    raise InputError(f"{name} takes no {operands[-1]}")
                if name == "exponential_difference" and len(operands) == 2:
                    plain += operands[1]
            else:
                operands.append(self._sum(depth))
            if not self._next(","):
                break
        self._need(")")
        count = len(operands) - plain
        if name != "exponential_difference" and count != 1 + (name == "angle"):
            raise InputError(f"{name} of {count} numbers")
        if name == "exponential_difference":
            order, _, *degrees = operands[:plain]
            roots = sum(degrees)
            if not (order < roots <= _MOST_ROOTS and all(degrees) and count == roots + 1):
                raise InputError(f"{name} of {count} numbers, of order {order} and {roots} roots")
        return self._step(name, *operands)

    def _text(self) -> str:
        """A number in parentheses, as users give values; it need not be one of this grammar."""
        self._need("(")
        begin, deep = self._place, 1
        while deep:
            deep += {"(": 1, ")": -1}.get(self._token, 0)
            if not self._token:
                raise InputError("')' is missing at the end of a constant")
            self._place += 1
        text = "".join(self._tokens[begin : self._place - 1])
        parse(text)
        return text

    def _plain(self) -> int:
        """The next token as a plain integer."""
        token = self._token
        if not token.isdecimal():
            raise InputError(f"{token[:20]!r} where an integer belongs")
        if len(token) > _LONGEST_NUMBER:
            raise InputError(f"a number of more than {_LONGEST_NUMBER} digits")
        self._place += 1
        return int(token)

    def _integer(self, place: int) -> int | None:
        """The integer in a place; None if another number is there."""
        step = place - len(self.sizes) + len(self.steps)
        found = self.steps[step] if step >= 0 else None
        return int(found[2][0]) if found is not None and found[1] is None else None

    def _constant(self, number: int) -> int:
        return self._step(None, number)

    def _step(self, what: Any, *operands: Any) -> int:
        key = what, operands
        if key not in self._known:
            self._known[key] = len(self.sizes)
            self.steps.append((len(self.sizes), what, operands))
            self.sizes.append(self._size(what, operands))
        return self._known[key]

    def _size(self, what: Any, operands: tuple[Any, ...]) -> tuple[int, int, int]:
        """Bits, degree and terms of the number that a step makes, when it is expanded.

        An enormous number is refused. Where the degree or the terms are too many, `expands`
        becomes False.
        """
        if what is None or what == "rational":
            return max(1, *(number.bit_length() for number in operands)), 0, 1
        if isinstance(what, str):
            return 0, 1, 1
        power = operands[1] if what is operator.pow else 1
        bits, degrees, terms = zip(
            *(self.sizes[place] for place in operands[: 1 if what is operator.pow else 2]),
            strict=True,
        )
        together = what in (operator.mul, operator.truediv)
        bit = 0 if 0 in bits else (sum(bits) + 1) * max(1, power)
        degree = (sum(degrees) if together else max(degrees)) * power
        count = prod(terms) if together else sum(terms)
        if bit > _LARGEST:
            raise InputError("a number is too large")
        if degree > _HIGHEST_DEGREE or count.bit_length() * power > _MOST_TERMS.bit_length():
            self.expands, degree, count = False, 1, 1
        return bit, degree, count**power


def _tokens(text: str) -> Iterator[str]:
    """The numbers, names and signs of a text in order, and an empty text at the end."""
    place, text = 0, text.rstrip()
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise InputError(f"unexpected {text[place : place + 10].strip()!r}")
        yield token[token.lastgroup or 0]
        place = token.end()
    yield ""


def written(
    kernel: Callable[..., Any],
    takes: Sequence[Sequence[str]],
    inputs: Sequence[tuple[Sequence[int], int]],
    outputs: Sequence[tuple[str, Sequence[int]]],
) -> Function:
    """The `Function` that has the same operations as a kernel over any arithmetic.

    The kernel takes arrays as nested sequences, and ``lib``. `takes` holds the names of the
    entries of each argument; `inputs` has its shape and the place of the first result that takes
    it, `outputs` has name and shape of each result.
    """
    writer = _Writer()
    arguments = [
        _shaped(iter([writer.number("name", name) for name in names]), shape)
        for names, (shape, _) in zip(takes, inputs, strict=True)
    ]
    found = kernel(*arguments, lib=_Tracing(writer))
    results = []
    values = found if len(outputs) > 1 else (found,)
    for value, (_, shape) in zip(values, outputs, strict=True):
        rows = [[value]] if not shape else [value] if len(shape) == 1 else value
        results += [[writer.taken(entry) for entry in row] for row in rows]
    terms, gives = writer.texts(results)
    return Function(
        takes=tuple(" ".join(names) for names in takes),
        inputs=tuple(tuple(shape) for shape, _ in inputs),
        outputs=tuple(tuple(shape) for _, shape in outputs),
        names=tuple(name for name, _ in outputs),
        since=tuple(since for _, since in inputs),
        terms=terms,
        gives=tuple(row for row, entries in zip(gives, results, strict=True) if entries),
    )


def _noted(sign: str) -> tuple[Callable[..., _Traced], Callable[..., _Traced]]:
    """An operator of traced numbers, and the same with its operands the other way round."""

    def plain(self: _Traced, other: Any) -> _Traced:
        return self.writer.number(sign, self, other)

    def turned(self: _Traced, other: Any) -> _Traced:
        return self.writer.number(sign, other, self)

    return plain, turned


class _Traced:
    """A number of a kernel that is written down: its operations are noted."""

    __slots__ = ("place", "writer")
    __add__, __radd__ = _noted("+")
    __sub__, __rsub__ = _noted("-")
    __mul__, __rmul__ = _noted("*")
    __truediv__, __rtruediv__ = _noted("/")
    __pow__, _ = _noted("**")

    def __init__(self, writer: _Writer, place: int) -> None:
        self.writer, self.place = writer, place

    def __neg__(self) -> _Traced:
        return self.writer.number("negative", self)

    def __pos__(self) -> _Traced:
        return self

    def __abs__(self) -> _Traced:
        return self.writer.number("abs", self)


class _Tracing:
    """The arithmetic of traced numbers."""

    def __init__(self, writer: _Writer) -> None:
        self._writer = writer
        self.pi = writer.number("pi")

    def rational(self, numerator: int, denominator: int) -> _Traced:
        """A fraction."""
        return self._writer.number("rational", numerator, denominator)

    def constant(self, text: str) -> _Traced:
        """A number, as users give values."""
        return self._writer.number("constant", text)

    def exponential_difference(self, k: int, t: Any, *factors: Sequence[Any]) -> _Traced:
        """A divided difference of the exponential."""
        numbers = [k, len(factors), *map(len, factors), t, *(c for f in factors for c in f)]
        return self._writer.number("exponential_difference", *numbers)

    def __getattr__(self, name: str) -> Callable[..., _Traced]:
        if name not in _FUNCTIONS:
            raise AttributeError(name)
        return lambda *operands: self._writer.number(name, *operands)


_BINDING = {"+": 1, "-": 1, "*": 2, "/": 2, "negative": 3, "**": 4}


class _Writer:
    """Notes operations, and writes them down as texts."""

    def __init__(self) -> None:
        self._nodes: list[tuple[str, tuple[Any, ...]]] = []
        self._places: dict[tuple[str, tuple[Any, ...]], int] = {}
        self._texts: dict[int, tuple[str, int, int]] = {}  # text, how it binds, depth

    def number(self, what: str, *operands: Any) -> _Traced:
        """The result of an operation; the same one for the same operands."""
        plain = what in ("name", "rational", "constant")
        node = what, tuple(("integer", x) if plain else self.taken(x) for x in operands)
        if node not in self._places:
            self._places[node] = len(self._nodes)
            self._nodes.append(node)
        return _Traced(self, self._places[node])

    def taken(self, entry: Any) -> Any:
        """A number as an operand: its place, or the integer."""
        if isinstance(entry, _Traced):
            return entry.place
        above, below = entry.as_integer_ratio()  # a float is taken exactly
        return ("integer", above) if below == 1 else self.number("rational", above, below).place

    def texts(self, results: Sequence[Sequence[Any]]) -> tuple[tuple[str, ...], list[str]]:
        """Texts of the terms on the way, and of each row of the results."""
        uses = Counter(entry for row in results for entry in row if isinstance(entry, int))
        for place in range(len(self._nodes) - 1, -1, -1):
            if place in uses:
                uses.update(x for x in self._nodes[place][1] if isinstance(x, int))
        terms: list[str] = []
        for place in sorted(uses):
            text, binding, depth = self._text(place)
            what = self._nodes[place][0]
            again = uses[place] > 1 and what not in ("name", "pi", "rational", "constant")
            if again or depth > _WRITTEN_DEEP:
                name = f"_{len(terms) + 1}"
                terms.append(f"{name} = {text}")
                text, binding, depth = name, 9, 0
            self._texts[place] = text, binding, depth
        return tuple(terms), [", ".join(self._operand(x)[0] for x in row) for row in results]

    def _operand(self, operand: Any) -> tuple[str, int, int]:
        if isinstance(operand, int):
            return self._texts[operand]
        number = operand[1]
        return str(number), 9 if number >= 0 else 3, 0

    def _text(self, place: int) -> tuple[str, int, int]:
        what, operands = self._nodes[place]
        if what == "name":
            return str(operands[0][1]), 9, 0
        if what == "pi":
            return what, 9, 0
        if what == "constant":
            return f"constant({operands[0][1]})", 9, 0
        if what == "rational":
            (_, above), (_, below) = operands
            return f"{above}/{below}", 0, 0
        binding = _BINDING.get(what)
        parts = [self._operand(operand) for operand in operands]
        depth = 1 + max(part[2] for part in parts)
        if binding is None:
            return f"{what}({', '.join(part[0] for part in parts)})", 9, depth
        if what == "negative":
            return f"-{_wrapped(parts[0], 4)}", 3, depth
        left = _wrapped(parts[0], binding + (what == "**"))
        if what == "**":
            return f"{left}**{parts[1][0]}", binding, depth
        blank = " " if binding == 1 else ""
        return f"{left}{blank}{what}{blank}{_wrapped(parts[1], binding + 1)}", binding, depth


def _wrapped(part: tuple[str, int, int], least: int) -> str:
    """A text in parentheses unless it binds as strongly as is needed."""
    text, binding, _ = part
    return text if binding >= least else f"({text})"
