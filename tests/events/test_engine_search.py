"""The compiled search for the first crossing, alone, on sums that are hard on it."""

import math

import numpy as np
import pytest
import stressing_search
from stressing import Sums
from stressing_search import FAMILIES, random_sums, search, verdicts

from nonsmooth.runtime.events.crossings_and_maxima import first_crossing
from nonsmooth.runtime.model.kernels import compiled_engine
from tests.sums import plain_sum
from tests.tables import slow

pytestmark = [
    pytest.mark.compiled,
    pytest.mark.skipif(compiled_engine() is None, reason="no compiled engine"),
]
WAVES = ((2, False), (1, True), (1, True))


def one(shape, exponents, values):
    return Sums(shape, np.array([exponents]), np.array([values], dtype=float))


def first(sums, until, reached=False):
    times, found = search(sums, np.array([until]), reached)
    return times[0] if found[0] else None


def in_python(sums, until, reached):
    """What the search of the other engine finds, one sum after the other."""
    times, found = until.copy(), np.zeros(len(until), dtype=bool)
    for i, exponents in enumerate(sums.exponents):
        values, polynomials = iter(sums.values[i].tolist()), []
        for length, oscillates in sums.shape:
            pairs = [(next(values), next(values) if oscillates else 0.0) for _ in range(length)]
            polynomials.append([complex(cosine, -sine) for cosine, sine in pairs])
        function = plain_sum([complex(*each) for each in exponents], polynomials)
        time = first_crossing(function, float(until[i]), reached=reached).time
        if time is not None:
            times[i], found[i] = time, True
    return times, found


@pytest.mark.parametrize("reached", [False, True], ids=["exceeded", "reached"])
@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("engine", ["c", slow("numpy")])
def test_no_zero_is_missed_and_none_invented(engine, family, reached, monkeypatch):
    rng = np.random.default_rng([*family.encode(), reached])
    if engine == "numpy":
        monkeypatch.setattr(stressing_search, "search", in_python)
    count = 100 if engine == "c" else 20
    for _ in range(4):
        sums, until = random_sums(rng, family, count)
        counts, told = verdicts(rng, sums, until, reached)
        assert not told
        assert counts["found"] + counts["none"] == count


def test_the_checks_see_a_missed_and_an_invented_zero(monkeypatch):
    sums = one(((1, False), (1, True)), [[0, 0], [0, 1]], [-0.65, 0.6, 0.3])
    rng, truth = np.random.default_rng(0), search(sums, np.array([9.0]), False)[0]
    for time, what in ((9.0, "wrong: missed"), (0.9 * truth[0], "wrong: no zero")):
        answer = np.array([time]), np.array([True])
        monkeypatch.setattr(stressing_search, "search", lambda *_, answer=answer: answer)
        counts, _ = verdicts(rng, sums, np.array([9.0]), False)
        assert counts[what] == 1


def test_a_start_left_by_its_third_derivative_does_not_hang():
    """A second derivative of 1e-54 keeps the third one from judging the start."""
    tiny = 6.842277657836021e-49
    exponents = [[0, 0], [0, 0.679871547194884], [0, 0.0011016937928567175]]
    values = [-tiny, -4.989247614795384e-06, 0, 0, tiny, 0.004528706294929873]
    for reached in (False, True):
        assert first(one(WAVES, exponents, values), 3.0, reached) is None


def test_a_start_left_over_many_cells_is_not_reached_again():
    """Behind the first cell the sum is still zero within the rounding of its terms."""
    slow = 3.5118422451879314e-06
    exponents = [[0, 0], [0, 1.0301018655807783], [0, slow]]
    level, rate = -1.4465519757866918e-06, 0.05341721470589871 * slow
    values = [level, -rate, 0, 0, -level, 0.05341721470589871]
    sums = one(WAVES, exponents, values)
    assert first(sums, 30.0, reached=True) is None


@pytest.mark.parametrize(
    ("depth", "reached", "expected"),
    [
        (1e-9, False, True),
        (1e-9, True, True),
        (0.0, True, True),
        (0.0, False, False),
        (-1e-9, True, False),
    ],
)
def test_a_double_zero_counts_by_its_depth(depth, reached, expected):
    """A maximum of sin t - 1 + depth."""
    sums = one(((1, False), (1, True)), [[0, 0], [0, 1]], [-1 + depth, 0, 1])
    time = first(sums, 4.0, reached)
    assert (time is not None) == expected
    if time is not None:
        assert time == pytest.approx(math.pi / 2 - math.sqrt(2 * depth), abs=1e-7)


def bump(frequencies, cell):
    """A sum that rises above zero inside one cell alone: below its cubic there, but for the ends.

    Frequencies of at most 1 make cells of length 1. About the cell's middle the sum is even, zero
    and flat at both ends, and 1 in the middle.
    """
    waves, middle = np.array(frequencies), cell + 0.5
    half = waves / 2
    conditions = [
        [1, *np.cos(half)],
        [0, *(waves * np.sin(half))],
        [1, *np.ones(len(waves))],
    ]
    even = np.linalg.lstsq(np.array(conditions), np.array([0.0, 0, 1]), rcond=None)[0]
    values = [even[0]]
    for amplitude, wave in zip(even[1:], waves, strict=True):
        values += [amplitude * math.cos(wave * middle), amplitude * math.sin(wave * middle)]
    exponents = [[0, 0], *([0, wave] for wave in waves)]
    return one(((1, False), *[(1, True)] * len(waves)), exponents, values)


def dense_first(sums, end):
    """The first zero by many samples, where the sum begins below zero."""
    times = np.linspace(0, end, 200_001)
    many = Sums(sums.shape, *(np.broadcast_to(a, (len(times), *a.shape[1:]))
                              for a in (sums.exponents, sums.values)))  # fmt: skip
    above = np.flatnonzero(many.at(times) > 0)
    return float(times[above[0]]) if len(above) else None


def test_a_rise_between_two_samples_is_found_by_the_bound_on_the_fourth_derivative():
    """Cubics between the samples stay below zero: only what they err by shows the crossing."""
    rng, inside = np.random.default_rng(5), 0
    for _ in range(40):
        others = rng.uniform(0.3, 0.95, int(rng.integers(1, 3)))
        cell = int(rng.integers(0, 3))
        sums = bump([1.0, *others], cell)
        sums.values[0, 0] -= 10.0 ** rng.uniform(-4, -1)
        if sums.at(np.zeros(1))[0] >= 0:
            continue
        expected = dense_first(sums, cell + 1.0)
        found = first(sums, cell + 1.0)
        assert (found is None) == (expected is None)
        if expected is not None:
            inside += cell < expected < cell + 1
            assert found == pytest.approx(expected, abs=1e-4)
    assert inside > 10


def test_a_rise_of_a_polynomial_within_one_cell_is_found():
    """As a^2 t^2 (1 - t)^2 less a little, whose first cell is from 0 to 1."""
    sums = one(((5, False),), [[0, 0]], [-1e-3, 0, 1, -2, 1])
    assert first(sums, 1.0) == pytest.approx((1 - math.sqrt(1 - 4 * math.sqrt(1e-3))) / 2)
