"""Modes of a field: their sum is its exponential, to the digits that rounding leaves.

Of fields of all kinds: one by one and in stacks, with few states and many, where eigenvalues are
equal, nearly equal, or apart.
"""

import math
import weakref
from itertools import product

import numpy as np
import pytest
from flint import arb, arb_mat, ctx
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError
from nonsmooth.runtime.model.modes.numeric_modes import grouped_modes, numeric_modes
from nonsmooth.runtime.model.modes.precise_modes import exponentials_at, precise_candidates
from nonsmooth.runtime.model.modes.subspace_modes import subspace_modes
from nonsmooth.runtime.model.time_functions import (
    derivative_matrix,
    function_bounds,
    functions_at,
)
from tests.large_systems import chain as long_chain
from tests.large_systems import masses_apart

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

NUMERIC = "nonsmooth.runtime.model.modes.numeric_modes"


def exponential(matrix, t):
    """Each entry is rounded once."""
    with ctx.workprec(300):
        rows = (arb_mat(matrix.tolist()) * arb(t)).exp().tolist()
        return np.array([[float(entry) for entry in row] for row in rows])


def whole(field):
    return np.vstack([field, np.zeros(field.shape[1])])


def summed(modes, t):
    """Flow (N, N + 1) after a time."""
    functions = np.array(functions_at(modes.shapes, modes.exponents, t))
    if hasattr(modes.flows, "at"):
        return modes.flows.at(functions)
    return np.tensordot(functions, modes.flows, axes=1)


def missed(field, modes, t, least=0.0):
    """The largest error of a flow, in units of its largest entry, but of no smaller ones."""
    wanted = exponential(whole(field), t)[:-1]
    return float(np.abs(summed(modes, t) - wanted).max() / max(least, np.abs(wanted).max()))


def keep_their_law(modes, t):
    """Functions of time solve their own linear system, and keep to their bounds."""
    shapes, exponents = modes.shapes, modes.exponents
    rates = derivative_matrix(shapes, exponents)
    begin = np.array(functions_at(shapes, exponents, 0.0))
    found = np.array(functions_at(shapes, exponents, t))
    bounds = np.array(function_bounds(shapes, exponents, t, t))
    errors = np.abs(found - exponential(rates, t) @ begin)
    assert (errors <= 1e-14 * (1 + t * np.abs(exponents).max()) * bounds).all()
    assert (np.abs(found) <= bounds * (1 + 1e-13)).all()
    earlier = np.array(function_bounds(shapes, exponents, t / 3, t))
    between = np.array([functions_at(shapes, exponents, s) for s in np.linspace(t / 3, t, 12)])
    assert (np.abs(between) <= earlier * (1 + 1e-13)).all()


# --- fields


def structure(mass, damping, stiffness, load, forced=None, frequency=1.0):
    """M x'' + C x' + K x = f, and c f_2, with c and s turning, if there is a second force."""
    mass, damping, stiffness = (np.atleast_2d(m) for m in (mass, damping, stiffness))
    size = len(mass)
    field = np.zeros((2 * size + 2, 2 * size + 3))
    field[:size, size : 2 * size] = np.eye(size)
    forces = np.zeros((3, size))
    forces[2], forces[0] = load, 0.0 if forced is None else forced
    parts = (-stiffness, -damping, forces.T)
    field[size:-2] = np.linalg.solve(mass, np.hstack(parts).astype(float))
    field[-2, -2], field[-1, -3] = -frequency, frequency
    return field if forced is not None else np.delete(field[:-2], (-3, -2), axis=1)


def links(count, ends=2):
    """Stiffness of a chain, between walls or of masses held by each other alone."""
    found = 2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    found[0, 0] = found[-1, -1] = ends
    return found


def chain(count, damping, frequency, held=None):
    """Masses between walls, the first one forced; one may be held, under a load on the others."""
    stiffness = links(count)
    loads = np.full(count, 0.0 if held is None else 0.3)
    field = structure(np.eye(count), damping * (stiffness + np.eye(count)), stiffness, loads,
                      np.eye(count)[0], frequency)  # fmt: skip
    if held is not None:
        field[count + held] = 0.0
    return field


def turned(field):
    """The same motion in other coordinates: no entry is zero any more."""
    basis = np.linalg.qr(np.random.default_rng(5).normal(size=(len(field), len(field))))[0]
    return np.hstack([basis @ field[:, :-1] @ basis.T, basis @ field[:, -1:]])


def free_masses(seed):
    """Full mass matrices, rigid-body modes, proportional damping, load.

    Of seeds 175 and 192 rounding takes the rigid body's eigenvalues apart, to a pair of 1e-8.
    """
    random = np.random.default_rng(seed)
    size = int(random.integers(2, 5))
    factor = random.normal(size=(size, size)) / 4
    mass = np.eye(size) + factor @ factor.T
    between = np.diff(np.eye(size), axis=0)
    stiffness = between.T @ np.diag(random.uniform(0.1, 30, size - 1)) @ between
    a, b = random.choice([0.0, 1 / 16, 0.3]), random.choice([0.0, 0.1])
    return structure(mass, a * stiffness + b * mass, stiffness, random.normal(size=size))


NATURAL = np.sqrt(2 - 2 * np.cos(np.pi / 4))  # of three masses between walls
JORDAN = np.array([[-1, 1, 0, 0.0], [0, -1, 1, 0], [0, 0, -1, 1]])
NEAR = np.array([[-1, 1, 0, 0.0], [0, -1.00001, 1, 0], [0, 0, -0.99999, 1]])
ONE, TWO = (1, False), (1, True)

# fields, and the lengths of their modes and which of them oscillate, where that is known
FIELDS = {
    "underdamped": (structure(1, 0.2, 1, 0.3), [ONE, TWO]),
    "overdamped": (structure(1, 3, 1, 0.3), [ONE, ONE, ONE]),
    "critical": (structure(1, 2.6, 1.69, 0.3), [ONE, (2, False)]),
    "negative damping": (structure(1, -0.1, 1, 0.3), [ONE, TWO]),
    "bouncing ball": (np.array([[0, 1, 0], [0, 0, -9.81]]), [(3, False)]),
    "drag without spring": (structure(1, 0.5, 0, 2), None),
    "at rest": (np.zeros((2, 3)), None),
    "chain": (structure(np.eye(3), 0.1 * links(3), links(3), [1, 0, 0]), None),
    "free chain": (structure(np.diag([1, 2, 3]), 0 * links(3), links(3, 1), [1, 0, 0]),
                   [(3, False), TWO, TWO]),
    "twice the same": (structure(np.eye(2), 0.1 * np.eye(2), np.eye(2), [1, 2]), [ONE, TWO]),
    "light and stiff": (structure(1e-3, 0, 100, -9.81e-3), [ONE, TWO]),
    "two speeds": (structure(np.eye(2), np.diag([1e4, 0.1]), [[2e3, -1], [-1, 2]], 1), None),
    "forced": (structure(1, 0.1, 1, 0, 1, 0.7), [ONE, TWO, TWO]),
    "resonance": (structure(1, 0, 1, 0, 1, 1.0), [ONE, (2, True)]),
    "resonance beside a held mass": (chain(4, 0.0, NATURAL, 3), None),
    "nearly in resonance": (chain(4, 0.0, NATURAL + 1e-9, 3), None),
    "three equal": (JORDAN, None),
    "three equal, turned": (turned(JORDAN), [ONE, (3, False)]),
    "three nearly equal": (turned(NEAR), None),
    **{f"free masses {k}": (free_masses(k), None) for k in (*range(6), 175, 192)},
    **{f"random {k}": (np.random.default_rng(k).normal(size=(k, k + 1)), None)
       for k in range(1, 9)},
    # many states
    "long": (long_chain(12).fields[0], None),
    "long, sticking": (long_chain(12, 5).fields[1], None),
    # on both sides of the mass some frequencies are equal
    "longer, sticking": (long_chain(20, 11).fields[1], None),
    "drifting": (structure(np.eye(12), 0 * links(12), links(12, 1), 0.0), None),
    "falling": (structure(np.eye(12), 0 * links(12), links(12, 1), 0.5), None),
    "equal": (masses_apart(12, np.ones(24)).fields[0], None),
}  # fmt: skip


@pytest.mark.parametrize("name", FIELDS)
def test_the_modes_sum_up_to_the_exponential(name):
    field, known = FIELDS[name]
    modes = numeric_modes(field)
    assert known is None or [(s.length, s.oscillates) for s in modes.shapes] == known
    if name.startswith("random"):
        assert sum(len(shape.places) for shape in modes.shapes) == len(field) + 1
    assert tuple(modes.exponents[0]) == (0, 0)
    assert not modes.shapes[0].oscillates
    if name in ("forced", "resonance", "free chain", "light and stiff"):  # nothing drifts
        assert (modes.exponents[modes.exponents[:, 1] != 0, 0] == 0).any()
    speed = np.abs(np.linalg.eigvals(field[:, :-1])).max() or 1.0
    for angle in (0.0, 0.01, 1.0, 12.0, 100.0):
        time = angle / speed
        allowed = 4e-15 * (10 + angle)
        if name.startswith("free masses"):  # whose modes may be larger than their sum
            terms, rates = np.abs(modes.flows).sum(axis=0).max(), np.abs(field).sum(axis=1).max()
            allowed = 20 * np.finfo(float).eps * (1 + time * rates) * terms
        elif len(field) > 12:  # where zero is threefold some processors' kernels miss by 1.1e-12
            allowed = (1e-11 if name == "falling" else 1e-12) * max(1.0, time / 20)
        assert missed(field, modes, time, 1.0) <= allowed
        keep_their_law(modes, time)


SMALL = (
    0.0,
    *10.0 ** -np.arange(16, -0.1, -8),
    *10.0 ** np.random.default_rng(3).uniform(-16, 0, 2),
)


def nearly_met(small):
    """Fields with eigenvalues that are near each other; allowed errors, and times up to which."""
    found = [(structure(1, 2 * (1 + sign * small), 1, 0.7), 3e-13, 100.0) for sign in (1, -1)]
    critical = 2 * math.sqrt(small)
    for damping in {0.0, small, critical / 6, critical}:
        late = 10.0 if damping in (small, critical) else 1000.0
        found.append((structure(1, damping, small, 1.0), 1e-12, late))
        for load in (0.0, 1.0):
            # Prescott's kernels miss a load beside the forcing by 1.8e-12
            allowed = 3e-12 if load else 1e-12
            found.append((structure(1, damping, small, load, 5, 1.7), allowed, late))
    one, near = np.random.default_rng(8).uniform(0.1, 1), max(small, 1e-9)
    for stiffness in ([small, one], [small, one * small], [1.0, 1 + near], [0.0, small]):
        field = structure(np.eye(2), np.zeros((2, 2)), np.diag(stiffness), [0.7, -0.4])
        found.append((field, 1e-12, 1000.0))
    for stiffness, load, damping in product((1.0, 0.3), (0.0, 0.7), (0.0, 0.3 * small)):
        field = structure(1, damping, stiffness, load, 5, math.sqrt(stiffness) * (1 + small))
        # in units of the forcing's response at rest three digits are lost
        found.append((field, 1e-12 * 5 / stiffness, 1000.0))
    return found


@pytest.mark.slow
@pytest.mark.parametrize("small", SMALL)
def test_where_modes_nearly_meet_no_digits_cancel(small):
    """In front of boundaries, which set the unit of time, and without a load without any."""
    joined = False
    for field, allowed, late in nearly_met(small):
        size = len(field)
        walls = np.hstack([np.eye(size), -np.ones((size, 1))])  # each state is 1
        for rows in (walls, *[None] * (not field[:, -1].any())):
            modes = numeric_modes(field, rows)
            joined |= any(shape.joined for shape in modes.shapes)
            for t in (0.01, 1.0, 10.0, late):
                assert missed(field, modes, t) < allowed
                keep_their_law(modes, t)
    assert joined or not 0 < small < 1e-3  # how near has to be depends on the processor


def test_a_forcing_that_hardly_turns_in_front_of_a_wall_that_is_near():
    """The unit of time is that of the fall to the wall, in which the forcing takes for ever."""
    stiffness, damping = np.array([[10, -10], [-5, 5]]), np.diag([0.1, 0.025])
    field = np.zeros((6, 7))
    field[:2, 2:4], field[2:4, :2], field[2:4, 2:4] = np.eye(2), -stiffness, -damping
    field[2, 5], field[2, 6], field[3, 6], field[4, 5], field[5, 4] = 1, 0.3, 5e-21, -1e-12, 1e-12
    wall = np.array([[1, 0, 0, 0, 0, 0, -1e-21]])
    assert missed(field, numeric_modes(field, wall), 1.0) < 1e-12


def test_eigenvalues_that_cannot_be_told_apart():
    """A Jordan block of eleven, moved by 1e-13: eigenvalues 0.07 from each other."""
    field = np.diag(np.full(11, 1.0), 1)[:11]
    field[-1, 0] = 1e-13
    with pytest.raises(InputError, match="neither equal nor apart"):
        numeric_modes(turned(field))


@pytest.mark.parametrize("seed", range(3))
def test_fields_of_any_numbers_have_modes_or_are_refused(seed, capfd):
    """Linear algebra is asked for nothing with which it does not end, or of which it complains."""
    rng = np.random.default_rng(seed)
    for size in rng.integers(1, 5, 12):
        shape = 4, size, size + 1
        wide = rng.normal(size=shape) * 10.0 ** rng.uniform(-250, 250, shape)
        chosen = rng.choice([0, 1, -1, 1e-8, 1e8, 1e-12, 1e300, -1e300, 1e-300], size=shape)
        resting = rng.choice([0, 1, -1, 1e-3, 2], size=shape) * 1e-310
        fields, rows = np.concatenate([wide, chosen, resting]), rng.normal(size=(12, 2, size + 1))
        groups = grouped_modes(fields, rows)
        assert sorted(place for group in groups for place in group.places) == [*range(12)]
    assert capfd.readouterr() == ("", "")


def test_conjugate_rates_are_one_mode_of_a_cluster():
    """Of x'''' = -4 x all four have one modulus and one frequency."""
    matrix = np.diag(np.ones(3), 1)
    matrix[-1, 0] = -4
    clusters = [c.poles for found in precise_candidates(matrix, math.sqrt(2)) for c in found]
    paired = [poles for poles in clusters if len(poles) > 1]
    assert paired
    for poles in paired:
        assert poles[1::2] == tuple(pole.conjugate() for pole in poles[::2])


@pytest.mark.parametrize("rate", [1e-10, 1e-11, 1e-12, 1e-13])
def test_what_decays_slowly_is_not_taken_for_a_constant(rate):
    """Over the longest search its motion changes by more than rounding."""
    matrix = np.array([[-rate, 1.0, 0.0], [0.0, -rate, 0.0], [0.0, 0.0, -1.0]])
    quick = subspace_modes(matrix, np.ones((3, 3), dtype=bool))
    assert quick is not None
    found = [quick[0].exponents[:, 0].tolist()]
    for clusters in precise_candidates(matrix, 1.0):
        found.append([cluster.poles[0].real for cluster in clusters])
    for centres in found:
        assert min(centres, key=abs) == pytest.approx(-rate, rel=1e-2)
    assert len(found) > 2


@pytest.mark.parametrize(("count", "which"), [(3, 2), (4, 1), (6, 0), (8, 7)])
def test_a_held_mass_and_a_forcing_drive_the_rest(count, which, monkeypatch):
    """They are no reason to search for clusters in many digits."""
    numeric_modes(chain(2, 0.02, 0.7, 1))  # whose held mass and forcing are those of the others
    monkeypatch.setattr(f"{NUMERIC}.best_modes", None)
    field = chain(count, 0.02, 0.7, which)
    modes = numeric_modes(field)
    assert modes.shapes[0].length == 2  # the held mass keeps its velocity
    fastest = np.abs(np.linalg.eigvals(field[:, :-1])).max()
    for angle in (1 / 64, 1.0, 16.0, 128.0):
        error = missed(field, modes, angle / fastest, 1.0)
        assert error < 1e-15 * (10 + angle) * (len(field) + 1)


@pytest.mark.parametrize("seed", [0, 2, 3, 4, 6])
def test_modes_in_a_stack_are_those_of_each_alone(seed):
    """Whatever else is in it: numbers that are not finite, or equal eigenvalues."""
    random = np.random.default_rng(seed)
    size = int(random.integers(2, 8))
    damping = random.choice([0.0, 0.02, 0.3])
    held = None, 0, 1, 1, None
    fields = [chain(size, damping, random.uniform(0.3, 2), which) for which in held]
    fields += [*random.normal(size=(3, 2 * size + 2, 2 * size + 3))]
    fields += [chain(size, 0.0, 2 * math.sin(math.pi / (2 * size + 2)) + x) for x in (0.0, 1e-6)]
    stack = np.array(fields)
    stack[4, 0, 0] = np.inf
    rows = np.zeros((len(stack), 0, stack.shape[2]))
    groups = grouped_modes(stack, rows)
    every = [(group, k, place) for group in groups for k, place in enumerate(group.places.tolist())]
    assert sorted(place for _, _, place in every) == [*range(len(stack))]
    for group, k, place in every:
        modes = group._replace(exponents=group.exponents[k], flows=group.flows[0][k])
        (alone,) = grouped_modes(stack[place : place + 1], rows[:1])
        assert alone.shapes == modes.shapes or place > 7
        if place <= 7:
            assert_array_equal(alone.exponents[0], modes.exponents)
            assert_array_equal(alone.flows[0][0], modes.flows)
        assert np.isfinite(modes.flows).all() == (place != 4)
        if place != 4:
            fastest = np.abs(np.linalg.eigvals(stack[place, :, :-1])).max()
            for angle in (1 / 64, 1.0, 16.0, 128.0):
                if modes.exponents[:, 0].max() * angle / fastest < 50:
                    error = missed(stack[place], modes, angle / fastest, 1.0)
                    allowed = 1e-15 if place <= 7 else 1e-14  # in resonance
                    assert error < allowed * (10 + angle) * (stack.shape[1] + 1)


# --- many states


def test_factors_are_the_matrices_they_stand_for():
    """And they are few: both sides of the eigenvectors, and a matrix."""
    rng = np.random.default_rng(1)
    for name in ("long", "long, sticking"):
        field = FIELDS[name][0]
        shapes, _, flows = numeric_modes(field)
        kept = sum(array.size for array in (flows.matrices, flows.left, flows.right))
        assert name != "long" or kept < 2.2 * field.shape[1] ** 2 + field.size
        functions = sum(len(shape.places) for shape in shapes)
        extended, values = rng.normal(size=(3, 27)), rng.normal(size=(3, functions))
        matrices = flows.all()
        assert matrices.shape == (functions, 26, 27)
        parts = np.einsum("fij,nj->nfi", matrices, extended)
        assert_allclose(flows.parts(extended), parts, atol=1e-13)
        assert_allclose(flows.at(values[0]), np.tensordot(values[0], matrices, 1), atol=1e-13)
        moved = np.einsum("nf,nfi->ni", values, parts)
        assert_allclose(flows.states(values, extended), moved, atol=1e-12)
        sizes = np.einsum("fij,nj->nfi", abs(matrices), abs(extended))
        bounds = flows.sizes(abs(extended))
        assert (bounds >= sizes * (1 - 1e-13)).all()
        assert bounds.sum() < 2 * sizes.sum()
        # the force goes on as if nothing happened, whatever the masses do
        flow = summed(numeric_modes(field), 3.0)
        assert not flow[-2:, :-3].any()


def test_of_many_fields_the_modes_are_remembered_that_fit_into_memory(
    monkeypatch,
):
    most = 1 << 20
    monkeypatch.setattr(f"{NUMERIC}._MOST", most)
    # no other test has fields of this size
    fields = [k / 64 * chain(13, 0.015, 0.6) for k in range(100, 200)]
    known = [numeric_modes(field).flows for field in fields]
    arrays = [weakref.ref(a) for flows in known for a in (flows.matrices, flows.left, flows.right)]
    del known
    kept = [array() for array in arrays if array() is not None]
    assert most / 4 < sum(array.nbytes for array in kept) < most


@pytest.mark.parametrize(("count", "bits"), [(2, None), (6, None), (3, 60)])
def test_exponentials_are_right_to_the_last_digit(count, bits, monkeypatch):
    """Also where the first precision is not enough: it is told, and more is taken."""
    if bits is not None:
        monkeypatch.setattr("nonsmooth.runtime.model.modes.precise_modes._FEW_BITS", bits)
    matrix = whole(long_chain(count).fields[0])
    found = exponentials_at(matrix, [4.0, 2.0**-11, 0.5])
    assert sorted(found) == [2.0**-11, 0.5, 4.0]
    for t, rounded in found.items():
        assert_array_equal(rounded, exponential(matrix, t))
