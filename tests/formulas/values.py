"""What a formula is worth, given the values of the names that stand in it."""

import math
import operator
import re
from collections import ChainMap
from dataclasses import dataclass, field, replace
from functools import reduce

import numpy as np
from scipy.linalg import expm

from tests.formulas.latex import read_latex
from tests.formulas.layout import (
    CLOSING,
    OPENING,
    Accent,
    Atom,
    Fraction,
    Root,
    Script,
    Table,
    Unreadable,
    core_of,
    is_number,
    plain,
)

_FUNCTIONS = {
    "cos": np.cos,
    "sin": np.sin,
    "tan": np.tan,
    "cosh": np.cosh,
    "sinh": np.sinh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
    "det": lambda matrix: _scalar(np.linalg.det(np.atleast_2d(matrix))),
    "tr": lambda matrix: _scalar(np.trace(np.atleast_2d(matrix))),
    "arg": lambda z: np.angle(z) % (2 * math.pi),
    "diag": lambda *entries: np.diag(entries),
}
# terms of a series that are not written with an end
_MANY = 60
_INDEX = re.compile(r"([ijk])(?:\(([ijk])\))?((?:[-+]\d+)?)(?![A-Za-z])")


def name_of(latex):
    """A name as the readers know it."""
    return plain(read_latex(latex))


@dataclass(frozen=True)
class Reading:
    """Evaluate rows.

    Attributes
    ----------
    names : mapping of name to value
        Numbers, matrices (columns are N x 1) and functions.
    indices : mapping of letter to int
        In ``f_{j(k)}`` at ``k = 3`` the name is ``f_{j(3)}``.
    ranges : mapping of letter to numbers
        Of sums that do not say from where to where.
    """

    names: dict
    indices: dict = field(default_factory=dict)
    ranges: dict = field(default_factory=dict)

    def at(self, **indices):
        """The same names at other indices."""
        # only the first mapping is ever written to
        names = ChainMap(indices, self.names)
        return replace(self, names=names, indices={**self.indices, **indices})

    def latex(self, text):
        """Value of LaTeX."""
        return self(read_latex(text))

    def __call__(self, row):
        """Value of one expression, term by term."""
        terms, signs = divided(without_spaces(row), "+-±")
        if signs and not terms[0]:
            terms = terms[1:]
        else:
            signs = ["+", *signs]
        factors = [-1 if sign == "-" else 1 for sign in signs]
        values = [_Walk(self, term).product() for term in terms]
        return _scalar(reduce(_added, map(operator.mul, factors, values)))

    def label(self, row):
        """Text of an index, its letters replaced by their numbers."""

        def number(match):
            letter = match[2] or match[1]
            value = self.indices.get(letter)
            if value is None:
                return match[0]
            found = str(value + int(match[3] or 0))
            return f"{match[1]}({found})" if match[2] else found

        return _INDEX.sub(number, plain(row)) if self.indices else plain(row)

    def name(self, item, *, above=True):
        """An item as it is called."""
        if not isinstance(item, Script):
            return plain((item,))
        below = f"_{{{self.label(item.below)}}}" if item.below else ""
        raised = f"^{{{self.label(item.above)}}}" if item.above and above else ""
        return f"{plain((item.base,))}{below}{raised}"


@dataclass(frozen=True)
class Unit:
    """A multiple of the unit matrix, of whatever size is needed."""

    scale: object = 1.0

    def __mul__(self, other):
        return self.scale * other if _is_array(other) else Unit(self.scale * _scalar(other))

    __rmul__ = __mul__
    # or NumPy would take it for an entry
    __array_ufunc__ = None

    def of(self, size):
        """The matrix."""
        return np.asarray(self.scale * np.eye(size))


UNIT = Unit()


class _Walk:
    """One pass over a term."""

    def __init__(self, reading, row):
        self.reading, self.row, self.place = reading, list(row), 0

    # -- looking ahead

    def item(self):
        return self.row[self.place] if self.place < len(self.row) else None

    def sign(self):
        return _sign(self.item())

    def spaces(self):
        while (item := self.item()) and isinstance(item, Atom) and item.kind == "space":
            self.place += 1

    # -- grammar

    def product(self):
        value = self.factor()
        self.spaces()
        while (item := self.item()) is not None:
            sign = self.sign()
            if sign == "/":
                self.place += 1
                value = _scalar(value) / _scalar(self.factor())
                self.spaces()
                if self.item() is not None:
                    raise Unreadable(f"what does the stroke divide by? {plain(self.row)}")
                return value
            if sign == "·":
                self.place += 1
            elif is_number(core_of(item)):
                raise Unreadable(f"a number behind a factor: {plain(self.row)}")
            value = _times(value, self.factor())
            self.spaces()
        return value

    def factor(self):
        value = self.plain_factor()
        while self.sign() == "!":
            self.place += 1
            value = math.factorial(int(value))
        return value

    def plain_factor(self):
        self.spaces()
        item = self.item()
        if item is None:
            raise Unreadable(f"nothing where a factor should be: {plain(self.row)}")
        reading, start = self.reading, self.place
        self.place += 1
        if plain((item,)) in reading.names:
            return self.applied(reading.names[plain((item,))])
        core, sign = core_of(item), _sign(item)
        if sign in OPENING:
            self.place = start
            return self.bracket()
        if sign == "|":
            end = next(i for i in range(self.place, len(self.row)) if _sign(self.row[i]) == "|")
            inside, self.place = self.row[self.place : end], end + 1
            return abs(reading(tuple(inside)))
        if isinstance(core, Atom) and core.text in "∑∏" and core.kind == "sign":
            return self.repeated(core.text, item)
        if isinstance(core, Atom) and core.text == "∂":
            return self.derivative(item)
        if isinstance(core, Atom) and core.kind == "word":
            return self.function(core.text, item.above if isinstance(item, Script) else ())
        if isinstance(item, Script):
            return self.applied(self.scripted(item))
        if isinstance(item, Fraction):
            return reading(item.above) / reading(item.below)
        if isinstance(item, Root):
            degree = reading(item.degree) if item.degree else 2
            inside = reading(item.inside)
            return np.emath.sqrt(inside) if degree == 2 else inside ** (1 / degree)
        if isinstance(item, Table):
            return self.matrix(item)
        if is_number(item):
            return float(item.text)
        raise Unreadable(f"unknown: {plain((item,))} in {plain(self.row)}")

    def scripted(self, item):
        """A name with an index, a label above, or a power."""
        reading = self.reading
        name = reading.name(item)
        if name in reading.names:
            return reading.names[name]
        short = reading.name(item, above=False)
        if item.above and short in reading.names:
            return _power(reading.names[short], item.above, reading)
        if isinstance(item.base, Atom) and item.base.kind == "number" and not item.below:
            return _power(float(item.base.text), item.above, reading)
        if not isinstance(item.base, Atom | Accent):
            return _power(reading((item.base,)), item.above, reading)
        raise Unreadable(f"unknown: {name} in {plain(self.row)}")

    def applied(self, value):
        """A function takes the brackets behind it; a number must not look like one."""
        sign = self.sign()
        if callable(value):
            while callable(value):
                if self.sign() not in OPENING:
                    if isinstance(value, np.ndarray | float):
                        return np.asarray(value) if isinstance(value, np.ndarray) else float(value)
                    raise Unreadable(f"a function of nothing: {plain(self.row)}")
                value = value(*self.arguments())
            return value
        if sign in OPENING:
            inside, end = self.enclosed(self.place)
            raised = isinstance(self.row[end - 1], Script)
            if len(inside) == 1 and not raised and not isinstance(inside[0], Table | Fraction):
                raise Unreadable(f"a number applied: {plain(self.row)}")
        return value

    def arguments(self):
        inside, self.place = self.enclosed(self.place)
        return [self.reading(part) for part in split(inside, ",;")]

    def enclosed(self, place):
        """What stands in the brackets that open at a place, and where they end."""
        depth = 0
        for end in range(place, len(self.row)):
            sign = _sign(self.row[end])
            depth += (sign in OPENING) - (sign in CLOSING)
            if depth == 0:
                return tuple(self.row[place + 1 : end]), end + 1
        raise Unreadable(f"an open bracket: {plain(self.row)}")

    def bracket(self):
        inside, end = self.enclosed(self.place)
        closing, self.place = self.row[end - 1], end
        parts = [self.reading(part) for part in split(inside, ",")]
        value = parts[0] if len(parts) == 1 else np.array([parts])
        if isinstance(closing, Script):
            if closing.below:
                places = [int(d) - 1 for d in re.findall(r"\d", self.reading.label(closing.below))]
                value = value[places[0], places[1] if len(places) > 1 else 0]
            if closing.above:
                value = _power(value, closing.above, self.reading)
        return value

    def matrix(self, table):
        entries = [[self.reading(entry) for entry in row] for row in table.rows]
        if not any(_is_array(entry) for row in entries for entry in row):
            return np.array(entries)
        sizes = [[np.shape(np.atleast_2d(entry)) for entry in row] for row in entries]
        heights = [max(height for height, _ in row) for row in sizes]
        widths = [max(width for _, width in column) for column in zip(*sizes, strict=True)]
        for row, height in zip(entries, heights, strict=True):
            wide = zip(row, widths, strict=True)
            row[:] = [e if _is_array(e) else np.full((height, w), e) for e, w in wide]
        return np.block(entries)

    def derivative(self, item):
        """The derivative of a name, which is a name of its own."""
        text = self.reading.name(item)
        for end in range(len(self.row), self.place, -1):  # what is restricted has a longer name
            behind = [self.reading.name(i) for i in self.row[self.place : end]]
            name = text + "".join(behind)
            if name in self.reading.names:
                self.place = end
                return self.reading.names[name]
        last = self.row[self.place] if self.place < len(self.row) else None
        if isinstance(last, Script) and last.above:
            name = text + self.reading.name(last, above=False)
            if name in self.reading.names:
                raise Unreadable(f"is the derivative raised, or what is derived? {plain(self.row)}")
        raise Unreadable(f"unknown: {text} of {plain(self.row)}")

    def function(self, name, power):
        """A function by its name, of brackets or of the symbols that follow."""
        reading = self.reading
        known = _FUNCTIONS.get(name)
        if known is None:
            raise Unreadable(f"unknown function {name}")
        self.spaces()
        sign = self.sign()
        if sign in OPENING and not isinstance(self.item(), Script):
            inside, end = self.enclosed(self.place)
            value = known(*(reading(part) for part in split(inside, ",")))
            closing, self.place = self.row[end - 1], end
            if isinstance(closing, Script):
                raise Unreadable(f"power of what? {plain(self.row)}")
        else:
            start = self.place
            while (item := self.item()) is not None and _in_argument(item):
                self.place += 1
            value = known(reading(tuple(self.row[start : self.place])))
        return _power(value, power, reading) if power else value

    def repeated(self, text, item):
        """A sum or a product; factors of later numbers stand on the left."""
        body, self.place = tuple(self.row[self.place :]), len(self.row)
        letter, numbers = self.numbers(item, text)
        values = [self.reading.at(**{letter: n})(body) for n in numbers]
        if not values:
            return float(text == "∏")
        return reduce(_added if text == "∑" else _times, values)

    def numbers(self, item, text):
        """The letter that a sum counts with, and its values."""
        if len(item.below) == 1:
            letter = plain(item.below)
            return letter, self.reading.ranges[letter]
        letter, sign = plain(item.below[:1]), plain(item.below[1:2])
        first = int(self.reading.label(item.below[2:]))
        if sign == "≥":
            return letter, range(first, first + _MANY)
        last = self.reading.label(item.above)
        found = re.fullmatch(r"(\d+)(?:([+-])(\d+))?", last)
        if sign != "=" or found is None:
            raise Unreadable(f"from where to where? {plain((item,))}")
        end = int(found[1]) + int(f"{found[2]}{found[3]}" if found[2] else 0)
        return letter, range(first, end + 1) if text == "∑" else range(first, end - 1, -1)


def divided(row, signs):
    """Parts of a row between signs outside all brackets and bars, and those signs."""
    parts = [[]]
    found, depth, within = [], 0, False
    for item in row:
        sign = _sign(item)
        depth += (sign in OPENING) - (sign in CLOSING)
        within ^= item == Atom("|", "sign")
        if depth == 0 and not within and sign in [*signs]:
            parts.append([])
            found.append(sign)
        else:
            parts[-1].append(item)
    return [tuple(part) for part in parts], found


def split(row, signs):
    """Those parts alone."""
    return divided(row, signs)[0]


def without_spaces(row):
    """A row without spaces at its ends."""
    items = list(row)
    for place in (0, -1):
        # the one that is an Atom is the one whose kind is asked for
        while items and isinstance(items[place], Atom) and items[place].kind == "space":
            items.pop(place)
    return tuple(items)


def _sign(item):
    core = core_of(item)
    return core.text if isinstance(core, Atom) and core.kind == "sign" else ""


def _in_argument(item):
    """Whether an item behind a function without brackets belongs to what it is of."""
    core = core_of(item)
    if isinstance(core, Atom):
        return core.kind in ("letter", "upright", "number")
    return isinstance(core, Accent)


def _is_array(value):
    return isinstance(value, np.ndarray) and value.size > 1


def _scalar(value):
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.ravel()[0]
    if isinstance(value, complex | np.complexfloating) and value.imag == 0:
        value = value.real
    return value


def _times(left, right):
    if isinstance(left, Unit) or isinstance(right, Unit):
        return left * right
    left, right = _one(left, right)
    if isinstance(left, np.ndarray) and isinstance(right, np.ndarray):
        return left @ right
    return left * right


def _one(left, right):
    """A matrix of one entry that does not fit is a number."""
    if isinstance(left, np.ndarray) and isinstance(right, np.ndarray):
        if left.shape[1] == right.shape[0]:
            return left, right
        return _scalar(left), _scalar(right)
    return left, right


def _added(left, right):
    left, right = _scalar(left), _scalar(right)
    for one, other in ((left, right), (right, left)):
        if isinstance(one, Unit) and isinstance(other, Unit):
            return Unit(one.scale + other.scale)
        if isinstance(one, Unit):
            return one.of(len(np.atleast_2d(other))) + other
    if _is_array(left) != _is_array(right):
        raise Unreadable("a matrix and a number are added")
    return left + right


def _power(value, above, reading):
    if plain(above) == "𝖳":
        return np.atleast_2d(value).T
    exponent = reading(above)
    if _is_array(exponent):
        if value != math.e:
            raise Unreadable("a power with a matrix above")
        return expm(exponent)
    if _is_array(value):
        return np.linalg.matrix_power(value, int(exponent))
    value = _scalar(value)
    return np.emath.power(value, exponent) if exponent != int(exponent) else value ** int(exponent)
