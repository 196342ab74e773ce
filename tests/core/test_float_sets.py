"""Sets in double precision: they contain what they should, by exact arithmetic and by points."""

import os
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq, fmpq_mat

from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import ManySets, Rounded, within
from nonsmooth.runtime.core.values import flint_precision

COUNT, SIZE, SIDES = 40, 4, 5
DIGEST = """
import hashlib
import numpy as np
from flint import arb_mat
from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import Rounded
from tests.core.test_float_sets import COUNT, drawn
random, sets = drawn(3)
flow = FloatFlow(arb_mat(np.vstack([random.normal(size=(3, 4)), np.zeros(4)]).tolist()), 2.0**-4)
begin = random.uniform(0, 0.1, COUNT)
found = [sets, *flow.between(sets, begin, begin + 0.01)]
lift = np.vstack([np.eye(3, 4), [0.3, -0.2, 0.7, 0.1], [0, 0, 0, 1]])[[0, 1, 2, 4]]
found += [x.fewer_sides([0, 1, 2], Rounded(lift, np.zeros_like(lift))) for x in found]
row = random.normal(size=(1, 4))
found += [x.cut(Rounded(row, np.zeros_like(row)), zero=True)[0] for x in found]
arrays = [a for x in found for a in (x.centre, x.sides, x.box)]
print(hashlib.sha256(b"".join(a.tobytes() for a in arrays)).hexdigest())
"""


def drawn(seed, sides=SIDES):
    random = np.random.default_rng(seed)
    centre = random.normal(size=(COUNT, SIZE))
    centre[:, -1] = 1
    columns = random.normal(size=(COUNT, SIZE, sides))
    columns[:, -1] = 0
    box = random.uniform(0, 0.01, (COUNT, SIZE)) * (random.random((COUNT, 1)) < 0.5)
    box[:, -1] = 0
    return random, ManySets(centre, columns, box)


def points_of(random, sets, count=300):
    """States (B, count, n) of sets, also on their faces."""
    share = random.uniform(-1, 1, (len(sets), count, sets.sides.shape[2]))
    share = np.where(random.random(share.shape) < 0.3, np.sign(share), share)
    off = random.uniform(-1, 1, (len(sets), count, sets.centre.shape[1])) * sets.box[:, None]
    return sets.centre[:, None] + np.einsum("bnm,bkm->bkn", sets.sides, share) + off


def holds(random, sets, number, points):
    """Whether a set reaches as far as points in every direction that is tried."""
    rows = np.vstack([random.normal(size=(12, points.shape[-1])), np.eye(points.shape[-1])])
    low, high = sets[[number]].ranges(Rounded(rows, np.zeros_like(rows)))
    values = points @ rows.T
    return ((low[0] - 1e-12 <= values) & (values <= high[0] + 1e-12)).all()


def reach(sets, number, row):
    """How far a set reaches along a row, exactly."""
    row, centre, box = ([*map(Fraction, x)] for x in (row, sets.centre[number], sets.box[number]))
    sides = [[*map(Fraction, side)] for side in sets.sides[number].T]
    across = sum(abs(sum(x * y for x, y in zip(row, side, strict=True))) for side in sides)
    pairs = zip(row, centre, box, strict=True)
    return sum(x * c + abs(x) * b for x, c, b in pairs) + across


def test_an_image_holds_the_exact_one():
    random, sets = drawn(1)
    matrix = random.normal(size=(3, SIZE)) * 10.0 ** random.integers(-9, 9, (3, 1))
    given = Rounded(matrix, 2.0**-36 * np.abs(matrix))
    image, (low, high) = sets.mapped(given), sets.ranges(given)
    meant = matrix + 0.999 * random.choice([-1, 1], matrix.shape) * given.radius
    exact = fmpq_mat([[fmpq(*x.as_integer_ratio()) for x in row] for row in meant])
    for k in range(COUNT):
        sides = np.hstack([sets.centre[k][:, None], sets.sides[k]])
        columns = fmpq_mat([[fmpq(*x.as_integer_ratio()) for x in row] for row in sides])
        moved = exact * columns
        for i in range(3):
            assert -reach(sets, k, -meant[i]) >= low[k, i]
            assert reach(sets, k, meant[i]) <= high[k, i]
            told = np.hstack([image.centre[k, i], image.sides[k, i]])
            off = sum(
                abs(moved[i, j] - fmpq(*float(x).as_integer_ratio())) for j, x in enumerate(told)
            )
            carried = sum(
                abs(exact[i, j]) * fmpq(*float(b).as_integer_ratio())
                for j, b in enumerate(sets.box[k])
            )
            bound = fmpq(*float(image.box[k, i]).as_integer_ratio())
            assert off + carried <= bound
            assert bound <= carried * fmpq(11, 10) + fmpq(1, 2**30) * sum(
                abs(exact[i, j]) * 20 for j in range(SIZE)
            )


@pytest.mark.parametrize("zero", [False, True])
def test_a_cut_holds_every_state_that_meets_the_condition(zero):
    random, sets = drawn(2)
    row = random.normal(size=(COUNT, 1, SIZE))
    row[:, 0, -1] += random.uniform(-4, 4, COUNT)
    left, alive = sets.cut(Rounded(row, np.zeros_like(row)), zero=zero)
    points = points_of(random, sets)
    narrower = 0
    for k in range(COUNT):
        values = points[k] @ row[k, 0]
        good = points[k][values >= 0]
        if zero:  # two points on both sides, and where the function is zero between them
            above, below = points[k][values > 0], points[k][values < 0]
            count = min(len(above), len(below))
            above, below = above[:count], below[:count]
            part = (above @ row[k, 0] / ((above - below) @ row[k, 0]))[:, None]
            good = above + part * (below - above)
        if not alive[k]:
            assert not len(good)
            continue
        assert holds(random, left, k, good)
        narrower += left.spread[k].sum() < 0.9 * sets.spread[k].sum()
    assert narrower > 10


def test_a_condition_that_is_far_from_met_leaves_nothing_and_one_that_is_met_everything():
    _, sets = drawn(3)
    for sign in (-1.0, 1.0):
        row = np.zeros((1, SIZE))
        row[0, -1] = sign
        left, alive = sets.cut(Rounded(row, np.zeros_like(row)))
        assert (alive == (sign > 0)).all()
    assert np.array_equal(left.sides, sets.sides)
    assert np.array_equal(left.centre, sets.centre)


def test_a_thin_oblique_part_is_thin():
    square = ManySets.of_boxes(np.array([[-1.0, -1.0]]), np.array([[1.0, 1.0]]))
    row = Rounded(np.array([[1.0, 1.0, 0.0]]), np.zeros((1, 3)))
    left, _ = square.cut(row, zero=True)
    low, high = left.ranges(row)
    assert (high - low).max() < 1e-11


def test_fewer_sides_hold_the_set_and_what_is_exactly_true():
    random, sets = drawn(5, 7)
    # the first coordinate is half of the second, and 3
    for part in (sets.sides, sets.box[:, :, None]):
        part[:, 0] = part[:, 1] / 2
    sets.centre[:, 0] = sets.centre[:, 1] / 2 + 3
    sets = ManySets(sets.centre, sets.sides, np.zeros_like(sets.box))
    lift = np.array([[0.5, 0, 3], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    less = sets.fewer_sides([1, 2], Rounded(lift, np.zeros_like(lift)))
    assert less.sides.shape == (COUNT, SIZE, 2)
    points = points_of(random, sets)
    for k in range(COUNT):
        assert holds(random, less, k, points[k])
        for row in np.insert(random.normal(size=(6, SIZE - 2)), [0, 2], 0.0, axis=1):
            assert reach(less, k, row) >= reach(sets, k, row)
    fact = Rounded(np.array([[1.0, -0.5, 0.0, -3.0]]), np.zeros((1, SIZE)))
    low, high = less.ranges(fact)
    assert (high - low).max() < 1e-9
    none = sets.fewer_sides([], Rounded(np.array([[1.0], [2.0]]), np.zeros((2, 1))))
    assert none.sides.shape == (COUNT, 2, 0)
    assert (none.centre == [1.0, 2.0]).all()


def test_halves_are_the_set():
    random, sets = drawn(6)
    side = random.integers(0, SIDES, COUNT)
    both = sets.halves(side)
    assert len(both) == 2 * COUNT
    points = points_of(random, sets, 200)
    for k in range(COUNT):
        low, high = both[[k, k + COUNT]].hull
        assert ((points[k] >= low.min(axis=0)) & (points[k] <= high.max(axis=0))).all()
        assert np.abs(both.sides[k]).sum() < np.abs(sets.sides[k]).sum()
        for row in random.normal(size=(6, SIZE)):
            assert max(reach(both, k + n, row) for n in (0, COUNT)) >= reach(sets, k, row)


def test_a_box_keeps_all_states_where_a_function_is_not_positive():
    """The least sum of the other terms tells, exactly, how far each coordinate may go."""
    random = np.random.default_rng(11)
    low = random.normal(size=(COUNT, SIZE))
    high = low + random.uniform(0, 2, (COUNT, SIZE))
    low[:, -1] = high[:, -1] = 1
    row = random.normal(size=SIZE)
    least, most = within((low, high), Rounded(row[None], np.full((1, SIZE), 0.01)))
    narrower = 0
    for k in range(COUNT):
        ends = [[*map(Fraction, side[k])] for side in (low, high)]
        weights = [*map(Fraction, row - 0.00999 * np.sign(low[k] + high[k]))]
        terms = [min(w * a, w * b) for w, a, b in zip(weights, *ends, strict=True)]
        if sum(terms) > 0:  # there is none
            continue
        for i, (weight, first, last) in enumerate(zip(weights, *ends, strict=True)):
            farthest = (terms[i] - sum(terms)) / weight
            assert most[k, i] >= (min(last, farthest) if weight > 0 else last)
            assert least[k, i] <= (first if weight > 0 else max(first, farthest))
            narrower += least[k, i] > first or most[k, i] < last
    assert narrower > 10


# flows


FIELD = [[0, 1, 0, 0], [-4, fmpq(-1, 5), 1, 0], [0, 0, 0, 1], [0, 0, 0, 0]]


@pytest.fixture
def flow():
    with flint_precision(80):
        yield FloatFlow(arb_mat(fmpq_mat(FIELD)), 0.125)


def test_the_flow_holds_the_exponential(flow):
    """Whether its steps are short or, where much of a series is left out, long."""
    times = np.array([0.0, 1e-9, 0.0624, 0.0626, 1.0, 3.7, 40.3])
    long = FloatFlow(arb_mat(fmpq_mat(FIELD)), 4.0)
    for found in (flow.at(times), long.at(times)):
        with flint_precision(200):
            for k, time in enumerate(times.tolist()):
                exact = (arb_mat(fmpq_mat(FIELD)) * arb(time)).exp().tolist()
                for i in range(4):
                    for j in range(4):
                        ball = arb(float(found.middle[k, i, j]), float(found.radius[k, i, j]))
                        assert ball.contains(exact[i][j])
    assert flow.at(times).radius.max() < 1e-9


@pytest.mark.parametrize(("far", "size", "sides"), [(1, 0.125, SIDES), (1, 0, 1), (0, 1, 1)])
def test_a_pipe_holds_all_states_between_two_times(flow, far, size, sides):
    """Of sets, of points, and of lines through a state that rests."""
    random, sets = drawn(9, sides)
    sets = ManySets(sets.centre * [far, far, far, 1], sets.sides * size, sets.box * (sides > 1))
    begin = random.uniform(0, 3, COUNT)
    end = begin + random.uniform(0, 0.4, COUNT)
    moved, pipe = flow.between(sets, begin, end)
    starts = points_of(random, sets, 60)
    for k in range(COUNT):
        share = np.concatenate([[0, 1], random.random(18)])
        states = []
        for s in share:
            time = begin[k] + s * (end[k] - begin[k])
            exact = flow.at(np.array([time])).middle[0]
            states.append(starts[k] @ exact.T)
        assert holds(random, pipe, k, np.concatenate(states))
        middle = flow.at(np.array([(begin[k] + end[k]) / 2])).middle[0]
        assert holds(random, moved, k, starts[k] @ middle.T)


def test_windows_bound_functions_rates_and_values_at_their_ends(flow):
    random, sets = drawn(10)
    rows = random.normal(size=(3, SIZE))
    with flint_precision(80):
        windows = flow.windows(arb_mat(rows.tolist()), range(4, 7))
    top, slow, fast, first, last = windows.bounds(sets)
    starts = points_of(random, sets, 40)
    field = np.array([[float(fmpq(x).p) / float(fmpq(x).q) for x in row] for row in FIELD])
    for number in range(3):
        for share in (0.0, 0.3, 0.8, 1.0):
            exact = flow.at(np.array([(4 + number + share) * flow.step])).middle[0]
            states = starts @ exact.T
            values, rates = states @ rows.T, states @ field.T @ rows.T
            own = slice(3 * number, 3 * number + 3)
            assert (values.max(axis=1) <= top[:, own] + 1e-12).all()
            assert (rates.min(axis=1) >= slow[:, own] - 1e-12).all()
            assert (rates.max(axis=1) <= fast[:, own] + 1e-12).all()
            if share == 1.0:
                assert (values.min(axis=1) >= first[:, own] - 1e-12).all()
                assert (values.max(axis=1) <= last[:, own] + 1e-12).all()


def test_no_sets_at_no_times_have_no_states():
    # all pieces of a way may be seen not to reach a boundary
    flow = FloatFlow(arb_mat([[0, 1], [-1, 0]]), 0.25)
    none = ManySets(np.zeros((0, 2)), np.zeros((0, 2, 3)), np.zeros((0, 2)))
    moved, way = flow.between(none, np.zeros(0), np.zeros(0))
    assert len(moved) == len(way) == 0
    assert way.sides.shape == (0, 2, 4)


def test_each_processor_finds_the_same_sets():
    """By whatever kernels of linear algebra and instructions it has: a verdict rests on them."""
    instructions = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
    found = set()
    for another in (
        {},
        {"OPENBLAS_CORETYPE": "Prescott"},
        {"OPENBLAS_CORETYPE": "Haswell"},
        {"NPY_DISABLE_CPU_FEATURES": " ".join(instructions)},
    ):
        done = subprocess.run(
            [sys.executable, "-c", DIGEST], env=os.environ | another, capture_output=True, text=True
        )
        assert not done.returncode, done.stderr
        found.add(done.stdout)
    assert len(found) == 1
