"""Functions as data: the digits of the kernels that they were written from, and nothing else."""

import json
from dataclasses import replace

import numpy as np
import pytest
from flint import fmpq

from nonsmooth import InputError
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.core.json_codec import decode, encode
from nonsmooth.runtime.core.rational_functions import symbols
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.expressions import Function, written
from nonsmooth.runtime.model.kernels import load_system
from tests.counting import calls_of
from tests.two_masses import SYSTEMS


def of(*texts, terms=(), names="a b"):
    """A function of two numbers that gives one row."""
    return Function(
        takes=(names,),
        inputs=((len(names.split()),),),
        outputs=((len(texts),),),
        names=("given",),
        since=(0,),
        terms=terms,
        gives=(", ".join(texts),),
    )


def flat(numbers):
    if isinstance(numbers, list | tuple):
        for entry in numbers:
            yield from flat(entry)
    else:
        yield numbers


@pytest.mark.parametrize("name", SYSTEMS)
def test_every_kernel_comes_back_to_the_last_bit(name):
    module = load_system(name).module
    drawn = np.random.default_rng(1)
    for kernel, (taken, given) in module.KERNELS.items():
        if kernel.startswith("flow_"):
            continue
        inputs = [shape for shape, _ in taken]
        takes = [[f"{'abcde'[i]}{k}" for k in range(int(np.prod(s)))] for i, s in enumerate(inputs)]
        function = written(getattr(module, kernel), takes, taken, given)
        read = decode(Function, json.loads(json.dumps(encode(function))))
        read.check(exactly=kernel in ("fields", "rows", "resets"))
        arrays = [drawn.uniform(0.5, 1.5, shape) for shape in inputs]
        with np.errstate(all="ignore"):
            wanted = [*flat(getattr(module, kernel)(*arrays, lib=FLOATS))]
            found = [*flat(read(*arrays, lib=FLOATS))]
            assert np.array_equal(wanted, found, equal_nan=True), kernel
            for count in range(1, len(given)):
                needed = [a for a, (_, since) in zip(arrays, taken, strict=True) if since < count]
                found = [*flat(read(*needed, lib=FLOATS, outputs=count))]
                assert np.array_equal(wanted[: len(found)], found, equal_nan=True), kernel


def test_one_text_serves_every_arithmetic():
    function = of("sqrt(_1)*pi/3", "(a - 1/3)**2/b", "-a**2", terms=("_1 = a*b",))
    assert function([2.0, 8.0], lib=FLOATS) == [4 * np.pi / 3, (2 - 1 / 3) ** 2 / 8, -4]
    sharp = Mpmath(50)
    found = function([sharp.mp.mpf(2), sharp.mp.mpf(8)], lib=sharp)
    assert abs(found[0] - 4 * sharp.mp.pi / 3) < sharp.mp.mpf(10) ** -48
    with flint_precision(200):
        from flint import arb

        assert function([arb(2), arb(8)], lib=Balls())[0].contains(4 * arb.pi() / 3)

    class Rational:
        rational = staticmethod(fmpq)

    a, b = symbols(("a", "b"))
    third = fmpq(1, 3)
    assert of("(a - 1/3)**2/b")([a, b], lib=Rational)[0] == (a - third) ** 2 / b


HOSTILE = {
    "10**10**10": "missing|commas",
    "10^10^10": "unexpected '\\^",
    "a**99999999999": "exponent beyond",
    "a**1001": "exponent beyond",
    "a**-2": "an integer belongs",
    "a**b": "an integer belongs",
    "(10**1000)**1000": "number is too large",
    "9" * 401: "more than 400 digits",
    "1e999": "commas",
    "1.5": "unexpected '.5'",
    "nan": "unknown name 'nan'",
    "inf": "unknown name 'inf'",
    "c": "unknown name 'c'",
    "rational(1, 0)": "unknown name 'rational'",
    "1/0": "division by zero",
    "a.real": "unexpected '.real'",
    "a['x']": "unexpected",
    "__import__('os').system('id')": "unexpected",
    "__import__(a)": "unknown name '__import__'",
    "exec(a)": "unknown name 'exec'",
    "lib.sqrt(a)": "unexpected '.sqrt",
    "sqrt": "'\\(' is missing",
    "sqrt(a, b)": "sqrt of 2 numbers",
    "exponential_difference(2, 1, 2, a, a, b)": "order 2 and 2 roots",
    "exponential_difference(0, 1, 2, a, a)": "of 2 numbers, of order 0",
    "exponential_difference(0, 2, 2, 0, a, a, b)": "of order 0",
    "exponential_difference(0, 1, 40, a, a, b)": "40 roots",
    "exponential_difference(0, 9, a, b)": "an integer belongs",
    "lambda: a": "unexpected ':",
    "a if b else a": "commas",
    "(" * 100_000 + "a" + ")" * 100_000: "nested too deeply",
    "-" * 100_000 + "a": "nested too deeply",
    "sqrt(" * 100_000: "nested too deeply",
    "": "belongs",
    "a +": "belongs",
    "a, b": "commas",
    "a; b": "unexpected ';",
    "a\x00": "unexpected",
}


@pytest.mark.parametrize("text", HOSTILE)
def test_what_is_no_expression_is_refused_in_one_line(text):
    def read():
        with pytest.raises(InputError, match=HOSTILE[text]) as refused:
            of(text).check(exactly=True)
        assert "\n" not in str(refused.value)
        assert len(str(refused.value)) < 200

    assert calls_of(read) < 10_000 + 10 * len(text)


@pytest.mark.parametrize(
    "terms",
    [
        ("x = (a + b)**1000", "y = (x + a)**1000"),
        tuple(f"x{k + 1} = x{k}*x{k}" for k in range(60)),
        tuple(f"x{k + 1} = x{k}**1000" for k in range(10)),
        ("x = (a + b + 1)**90",),
    ],
)
def test_what_would_expand_without_end_is_refused(terms):
    function = of("a", terms=("x0 = a + b", *terms))
    with pytest.raises(InputError, match="too large"):
        function.check(exactly=True)
    function.check(exactly=False)  # in floating-point numbers it costs nothing
    doubled = ("x0 = 10**9", *(f"x{k + 1} = x{k}*x{k}" for k in range(40)))
    with pytest.raises(InputError, match="number is too large"):
        of("a", terms=doubled).check(exactly=False)


@pytest.mark.parametrize(
    ("terms", "match"),
    [
        (("x",), "name = expression"),
        (("a = b",), "named twice"),
        (("pi = b",), "no name"),
        (("sqrt = b",), "no name"),
        (("x y = b",), "no name"),
        (("x = y", "y = a"), "unknown name 'y'"),
    ],
)
def test_terms_are_named_once_and_in_order(terms, match):
    with pytest.raises(InputError, match=match):
        of("a", terms=terms).check(exactly=False)


@pytest.mark.parametrize("shape", [(-1,), (1 << 40,), (2, 1 << 40), (1, 1, 1), (3,), (2, 2)])
def test_shapes_are_those_of_the_texts(shape):
    one = {"takes": ("a",), "names": ("given",), "since": (0,), "terms": ()}
    wrong = Function(**one, inputs=((1,),), outputs=(shape,), gives=("a, a",))
    with pytest.raises(InputError):
        wrong.check(exactly=False)
    wrong = Function(**one, inputs=(shape,), outputs=((1,),), gives=("a1",))
    with pytest.raises(InputError):
        wrong.check(exactly=False)


def test_the_first_results_do_without_later_arguments():
    def two(since, first="a1"):
        return Function(
            takes=("a1", "b1"),
            inputs=((1,), (1,)),
            outputs=((), ()),
            names=("one", "both"),
            since=since,
            terms=("sum = a1 + b1",),
            gives=(first, "sum"),
        )

    assert two((0, 1))([2.0], lib=FLOATS, outputs=1) == 2
    assert two((0, 1))([2.0], [3.0], lib=FLOATS) == (2, 5)
    with pytest.raises(InputError, match="'one' needs an argument that it does not take"):
        two((0, 1), "sum").check(exactly=False)
    with pytest.raises(InputError, match="taken later"):
        two((1, 0)).check(exactly=False)
    for since in ((0, 2), (-1, 0)):
        with pytest.raises(InputError, match="of a result that the function does not have"):
            two(since).check(exactly=False)
    with pytest.raises(InputError, match="more or fewer"):
        replace(two((0, 1)), names=("one",)).check(exactly=False)


def test_many_results_are_read_by_work_in_proportion_to_their_number():
    def read(count):
        function = Function(
            takes=("a b",),
            inputs=((2,),),
            outputs=((),) * count,
            names=tuple(f"result{k}" for k in range(count)),
            since=(0,),
            terms=tuple(f"x{k} = a*b + {k}" for k in range(count)),
            gives=tuple(f"x{k}" for k in range(count)),
        )
        function.check(exactly=False)
        found = function([2.0, 3.0], lib=FLOATS, outputs=count)
        assert found == tuple(6.0 + k for k in range(count))

    assert calls_of(lambda: read(2000)) < 11 * calls_of(lambda: read(200))


def test_the_first_results_need_no_work_for_later_ones():
    done = []

    class Counted:
        """A number that notes with what it is multiplied."""

        def __mul__(self, other):
            done.append(other)
            return self

    function = Function(
        takes=("a",),
        inputs=((1,),),
        outputs=((), (), ()),
        names=("last", "first", "again"),
        since=(0,),
        terms=("x1 = a*5", "x2 = a*6", "x3 = a*7"),
        gives=("x3", "x1", "x1*8"),
    )
    for count, factors in ((1, [7]), (2, [7, 5]), (3, [7, 5, 8])):
        done.clear()
        function([Counted()], lib=FLOATS, outputs=count)
        assert sorted(done) == sorted(factors)
