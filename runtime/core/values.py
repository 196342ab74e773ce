"""Exact parameter values: what the user wrote, evaluated at whatever precision is asked.

A value is a decimal (``0.4831`` is the rational 4831/10000) or an expression such as ``1/3``
or ``2*pi/sqrt(3)``. Rational arithmetic stays rational, the rest is done with balls, so
every number that leaves this module carries the digits it was asked for.
"""

import ast
import math
import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from decimal import MAX_EMAX, MIN_EMIN, Decimal, localcontext
from fractions import Fraction
from functools import lru_cache
from numbers import Rational, Real
from threading import RLock
from typing import TYPE_CHECKING, Any, TypeAlias

from nonsmooth.runtime.core.errors import InputError, one_line, unknown_name

if TYPE_CHECKING:
    import numpy as np
    from flint import arb

    Number: TypeAlias = "str | float | Fraction | Decimal | Value | np.number[Any]"
    Numbers: TypeAlias = "Sequence[Any] | np.ndarray"

LONGEST_TEXT = 1000
LARGEST_EXPONENT = 10_000
_DEEPEST_NESTING = 100
_LARGEST_RATIONAL = 200_000  # bits
_HIGHEST_PRECISION = 8192  # bits at which an undecided rounding is given up
_CALLED = ("sqrt", "sin", "cos", "exp", "log", "asin", "acos", "atan")  # as arb calls them
_NAMES = ("pi", *_CALLED, "root")
_HIGHEST_DEGREE = 100  # of a polynomial whose root is taken
_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}
_TOKEN = re.compile(
    r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE](?P<exponent>[+-]?\d+))?|[^\W\d]\w*|\*\*|[-+*/(),])\s*",
    re.ASCII,
)


_FLINT_LOCK = RLock()


@contextmanager
def flint_precision(bits: int) -> Iterator[None]:
    """Compute with python-flint at that many bits inside the block.

    Its precision is one for the whole process: other threads wait.
    """
    from flint import ctx

    with _FLINT_LOCK, ctx.workprec(bits):
        yield


@dataclass(frozen=True)
class Value:
    """A real number known exactly, made by `parse` or `as_value`."""

    text: str  # as the user wrote it; values with the same text are equal
    # the number as a fraction; None where irrational functions enter
    exact: Fraction | None = field(compare=False, repr=False)
    _double: float = field(compare=False, repr=False)

    def __float__(self) -> float:
        """Give the double nearest to the number."""
        return self._double + 0.0  # never -0.0

    def __str__(self) -> str:
        """Give the text as the user wrote it."""
        return self.text

    def ball(self, precision_bits: int) -> "arb":
        """Enclose the number in a ball, computed with a working precision of so many bits."""
        return _ball(self.text if self.exact is None else self.exact, precision_bits)

    def mpf(self, digits: int) -> Any:
        """The number as an `mpmath.mpf` with relative error below ``10**-digits``.

        A number that 8000 bits cannot tell from zero has that absolute error instead.
        """
        import mpmath

        wanted = math.ceil(max(digits, 1) * math.log2(10)) + 8
        bits, limit = wanted + 24, 2 * wanted + _HIGHEST_PRECISION
        while (ball := self.ball(bits)).rel_accuracy_bits() < wanted and bits < limit:
            bits *= 2
        mantissa, exponent = ball.mid().man_exp()
        return mpmath.mpf((int(mantissa), int(exponent)), prec=wanted)


@lru_cache(maxsize=1024)
def parse(text: str) -> Value:
    """Read a decimal or an expression of ``+ - * / **``, pi, sqrt, sin, cos, exp, log, ...

    Nothing is ever executed, and literals are exact: ``0.1`` is 1/10. Known are asin, acos
    and atan too, and ``root(k, a, b, ..., c)``, the real root of number k, from 0 and counted
    from the lowest, of the polynomial with the integer coefficients a, b, ..., c, the highest
    first. An `InputError` refuses a text that is no such expression, has no finite real
    value, or is too large.

    Examples
    --------
    >>> parse("1/3").exact
    Fraction(1, 3)
    >>> float(parse("2*pi"))
    6.283185307179586
    """
    try:
        number = _evaluate(*_tree(text), 0)
        return _value(text.strip(), number if isinstance(number, Fraction) else None)
    except (InputError, ZeroDivisionError) as problem:
        reason = problem if isinstance(problem, InputError) else "division by zero"
        shown = repr(text if len(text) <= 60 else text[:57] + "...")
        raise InputError(f"{shown} is not a number or expression: {reason}") from None


def as_value(number: object) -> Value:
    """A number of any usual type, its text, or a `Value`, as an exact value.

    A Python or NumPy float means its shortest decimal (0.1 is 1/10); integers, fractions,
    `decimal.Decimal` and `mpmath.mpf` are taken exactly as they are, as are real numbers of SymPy
    whose text `parse` reads. An `InputError` refuses what is not finite, a bool, complex, an
    array, or no number at all.

    Examples
    --------
    >>> as_value(0.1).exact
    Fraction(1, 10)
    """
    match number:
        case Value():
            return number
        case bool():
            raise InputError(f"{number} is a truth value, not a number")
        case str():
            return parse(number)
        case float() if math.isfinite(number):
            text = float.__repr__(number)  # numpy.float64, a subclass, prints its type too
            return Value(text, Fraction(Decimal(text)), float(number))
        case Rational():
            exact = Fraction(int(number.numerator), int(number.denominator))
        case Real() if hasattr(number, "_mpf_") and (parts := _parts_of_mpf(number)):
            exact = parts[0] * Fraction(2) ** parts[1]
        case Real() | Decimal():
            return parse(str(number))  # NumPy's other floats print their shortest decimal
        case _ if getattr(number, "shape", None) == () and hasattr(number, "__len__"):
            inner: Any = _plain_array(number)[()]
            if isinstance(inner, bytes):
                raise InputError(f"{inner!r} is not a real number")
            return as_value(inner)
        case _ if getattr(number, "is_number", False) and getattr(number, "is_real", False):
            symbolic: Any = number  # of SymPy, such as pi/3
            if any(hasattr(part, "_mpf_") for part in symbolic.atoms()):  # it prints 15 digits
                return as_value(float(symbolic))
            return parse(str(symbolic))
        case _:
            raise InputError(f"{' '.join(repr(number).split())[:60]} is not a real number")
    try:
        return _value(str(exact), exact)
    except ValueError:  # Python refuses to print integers of more than 4300 digits
        raise InputError("the number has too many digits or is too large") from None


def by_name(label: str, given: Any) -> dict[str, Any]:
    """What is given by names, nothing for None; an `InputError` refuses what is no mapping.

    Examples
    --------
    >>> by_name("parameters", {"eta": 1}), by_name("parameters", None)
    ({'eta': 1}, {})
    """
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError(f"{label}: {one_line(repr(given), 60)} does not give values by names")
    return dict(given)


def axes(given: Any) -> int:
    """How many axes an array or a list of lists has; 0 for a number, a text, or what is neither.

    Examples
    --------
    >>> axes([[0, 1], [2, 3]]), axes("1/3")
    (2, 0)
    """
    if isinstance(given, list | tuple | range):
        return 1 + axes(given[0]) if given else 1
    return int(getattr(given, "ndim", 0))


def real_array(label: str, given: Any) -> "np.ndarray":
    """The array of the real numbers that are given, as numbers of any type or as texts.

    An `InputError` refuses anything else, and masked values.

    Examples
    --------
    >>> real_array("times", [0, "1/4"])
    array([0.  , 0.25])
    """
    import numpy as np

    try:
        array = _plain_array(given)
        if array.dtype.kind in "iuf":
            return array.astype(float)
        if array.dtype.kind in "OUT":
            numbers = [
                number if isinstance(number, float) else float(as_value(number))
                for number in array.ravel().tolist()
            ]
            return np.array(numbers).reshape(array.shape)
        raise InputError(f"{array.dtype} is no type of real numbers")
    except (TypeError, ValueError) as problem:
        if isinstance(problem, InputError):
            raise InputError(f"{label}: {problem}") from None
    raise InputError(f"{label}: no array of real numbers")


def _plain_array(given: Any) -> "np.ndarray":
    """What NumPy makes of something; an `InputError` refuses values that a mask leaves out."""
    import numpy as np

    if np.ma.is_masked(given):
        raise InputError("masked values are no numbers")
    return np.asarray(given)


def random_generator(rng: Any) -> "np.random.Generator":
    """The generator of a seed, a seed sequence or a generator; an `InputError` refuses others.

    Examples
    --------
    >>> random_generator(1).integers(10) == random_generator(1).integers(10)
    np.True_
    """
    import numpy as np

    try:
        if not isinstance(rng, bool):
            return np.random.default_rng(rng)
    except (TypeError, ValueError):
        pass
    raise InputError(f"{one_line(repr(rng), 60)} is no seed and no generator of random numbers")


def real_number(label: str, given: Any) -> float:
    """The real number that is given; an `InputError` refuses anything else."""
    array = real_array(label, given)
    if array.ndim:
        raise InputError(f"{label}: {one_line(repr(given), 60)} is no real number")
    return float(array)


def parse_assignment(text: str) -> tuple[str, Value]:
    """Name and value of a text ``name=value``, without blanks around the name.

    An `InputError` refuses a text of another form, and a value that is no number.

    Examples
    --------
    >>> parse_assignment("eta=0.98")[1].exact
    Fraction(49, 50)
    """
    name, equals, value = (part.strip() for part in text.partition("="))
    if not (equals and value and name.isidentifier()):
        raise InputError(f"{text[:60]!r} is not of the form name=value, such as eta=0.98")
    low, dots, high = value.partition("..")
    if dots:
        raise InputError(
            f"{name}: {value[:60]!r} is no number; a range, where one is taken, is"
            f" {low[:20]}:{high[:20].lstrip('.')}"
        )
    try:
        return name, parse(value)
    except InputError as problem:
        raise InputError(f"{name}: {problem}") from None


def decimal_string(number: Any, digits: int) -> str:
    """Decimal text of a number with ``digits + 3`` significant digits, trailing zeros kept.

    It differs from the number x by at most ``10**-digits * max(1, abs(x))``. The notation is
    positional for ``1e-7 <= abs(x) < 1e21``, otherwise it has an exponent. The number is a
    ball, which must be narrow enough to determine the digits, or an mpf or float, which are
    exact. An `InputError` refuses what is not finite, and a ball that is too wide.
    """
    with localcontext(prec=digits + 20, Emax=MAX_EMAX, Emin=MIN_EMIN):
        middle, radius = _decimals(number)
        if not (middle.is_finite() and radius.is_finite()):
            raise InputError(f"{number} is not a finite number")
        if 2 * radius > Decimal(10) ** -digits * max(Decimal(1), abs(middle)):
            raise InputError(f"the ball {number.str(5)} does not determine {digits} digits")
        size = middle.adjusted() if middle else 0
        if -7 <= size <= 20:
            return f"{middle:.{max(0, digits + 2 - size)}f}"
        return f"{middle:.{digits + 2}e}"


def _tree(text: str) -> tuple[ast.expr, str]:
    """Give the syntax tree of a text, and the source to which its columns refer."""
    if len(text) > LONGEST_TEXT:
        raise InputError(f"longer than {LONGEST_TEXT} characters")
    # Only these tokens ever reach Python's parser, so it has nothing to warn of.
    text, tokens, place = text.strip(), [], 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None or (token[1] == "," and "root" not in tokens):
            hint = "; powers are written **" if text[place] == "^" else ""
            raise InputError(f"unexpected {text[place]!r}{hint}")
        if abs(int(token["exponent"] or 0)) > LARGEST_EXPONENT:
            raise InputError(f"exponent beyond {LARGEST_EXPONENT}")
        tokens.append(token[1])
        place = token.end()
    source = " ".join(tokens)
    try:
        return ast.parse(source, mode="eval").body, source
    except (SyntaxError, RecursionError, MemoryError) as problem:
        raise InputError(getattr(problem, "msg", "nested too deeply").partition(";")[0]) from None


def _evaluate(node: ast.AST, source: str, depth: int) -> "Fraction | arb":
    """Evaluate an allowed syntax node, exactly as long as it is rational; refuse the others."""
    if depth > _DEEPEST_NESTING:
        raise InputError("nested too deeply")
    match node:
        case ast.Constant(value=int() | float()) if not isinstance(node.value, bool):
            # The literal's own text: its value is rounded to a double already.
            return Fraction(ast.get_source_segment(source, node) or "")
        case ast.Name(id="pi"):
            from flint import arb

            return arb.pi()
        case ast.Name(id=name) if name.lower() in ("nan", "snan", "inf", "infinity"):
            raise InputError("not finite")
        case ast.Name(id=name) | ast.Call(func=ast.Name(id=name)) if name not in _NAMES:
            raise unknown_name("name", name, _NAMES)
        case ast.Call(func=ast.Name(id="root"), args=[_, _, _, *_] as numbers, keywords=[]):
            return _root([_evaluate(number, source, depth + 1) for number in numbers])
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in _CALLED:
            result: arb = getattr(_lift(_evaluate(inner, source, depth + 1)), name)()
            return result
        case ast.UnaryOp(op=ast.UAdd() | ast.USub() as sign, operand=inner):
            operand = _evaluate(inner, source, depth + 1)
            return -operand if isinstance(sign, ast.USub) else operand
        case ast.BinOp(left=left, op=symbol, right=right) if type(symbol) in _OPERATORS:
            operands = (_evaluate(side, source, depth + 1) for side in (left, right))
            return _combine(_OPERATORS[type(symbol)], *operands)
    raise InputError(f"{ast.get_source_segment(source, node)!r} is not allowed")


def _root(numbers: "list[Fraction | arb]") -> "arb":
    """Enclose a real root of a polynomial: its number, then the coefficients."""
    from flint import fmpz_poly

    found = [int(n) for n in numbers if isinstance(n, Fraction) and n.denominator == 1]
    place, *coefficients = found or [-1]
    if len(found) != len(numbers) or place < 0 or not coefficients[0]:
        raise InputError("root takes a place and integers, the first coefficient not zero")
    if len(coefficients) - 1 > _HIGHEST_DEGREE or max(map(_bits, found)) > _HIGHEST_PRECISION:
        raise InputError("a polynomial too large")
    roots: Any = fmpz_poly(coefficients[::-1]).complex_roots()
    real = sorted((root.real for root, _ in roots if root.imag == 0), key=lambda x: x.mid())
    if place >= len(real):
        raise InputError(f"a polynomial of {len(real)} real roots has none of number {place}")
    root: arb = real[place]
    return root


def _combine(
    apply: Callable[[Any, Any], Any], left: "Fraction | arb", right: "Fraction | arb"
) -> "Fraction | arb":
    """Apply an operator, exactly where the result is rational and not enormous."""
    rational, growth = isinstance(left, Fraction) and isinstance(right, Fraction), 2
    if apply is operator.pow and isinstance(right, Fraction):
        if abs(right) > LARGEST_EXPONENT:
            raise InputError(f"exponent beyond {LARGEST_EXPONENT}")
        rational, growth = rational and right.denominator == 1, abs(right.numerator)
    if not rational:
        left, right = _lift(left), _lift(right)
    elif _bits(left) * growth > _LARGEST_RATIONAL or _bits(right) > _LARGEST_RATIONAL:
        raise InputError("an intermediate result is too large")
    result: Fraction | arb = apply(left, right)
    return result


def _bits(number: Any) -> int:
    return max(int(number.numerator).bit_length(), int(number.denominator).bit_length())


def _lift(number: "Fraction | arb") -> "arb":
    """Make a ball of a fraction at the current precision."""
    from flint import arb, fmpq

    if isinstance(number, Fraction):
        return arb(fmpq(number.numerator, number.denominator))
    return number


def _ball(number: str | Fraction, precision_bits: int) -> "arb":
    """Enclose a fraction, or the value of a text."""
    with flint_precision(precision_bits):
        return _lift(number if isinstance(number, Fraction) else _evaluate(*_tree(number), 0))


def _value(text: str, exact: Fraction | None) -> Value:
    """Make a value; refuse one that is undefined or beyond the range of a double."""
    try:
        double = _nearest_double(text) if exact is None else float(exact)
    except OverflowError:
        double = math.inf
    if math.isinf(double):
        raise InputError("too large for a double")
    if math.isnan(double):
        raise InputError("no finite real value")
    return Value(text, exact, double)


def _nearest_double(text: str) -> float:
    """Round the value of a text to the nearest double; NaN where it is undefined."""
    bits = 128
    while True:
        ball = _ball(text, bits)
        low, high = float(ball.lower()), float(ball.upper())
        if low == high or bits >= _HIGHEST_PRECISION:
            return float(ball) if ball.is_finite() else math.nan
        bits *= 2


def _parts_of_mpf(number: Any) -> tuple[int, int] | None:
    """Give signed mantissa and exponent of an `mpmath.mpf`; None if it is not finite."""
    sign, mantissa, exponent, _ = number._mpf_
    return (int((-1) ** sign * mantissa), int(exponent)) if mantissa or not exponent else None


def _decimals(number: Any) -> tuple[Decimal, Decimal]:
    """Give middle and radius of a ball, mpf or float in the current decimal context."""
    zero, undefined = Decimal(0), Decimal("nan")
    if isinstance(number, float | int):
        return Decimal(number), zero
    if not hasattr(number, "rad"):
        parts = _parts_of_mpf(number)
        return (parts[0] * Decimal(2) ** parts[1] if parts else undefined), zero
    if not number.is_finite():
        return undefined, undefined
    middle, radius = (
        int(mantissa) * Decimal(2) ** int(exponent)
        for mantissa, exponent in (number.mid().man_exp(), number.rad().man_exp())
    )
    return middle, radius
