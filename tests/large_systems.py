"""Systems of any size made from matrices alone: no declaration, no derivation, no package modes.

Masses in a chain between walls, x'' + C x' + x K = F e_1 cos(Omega t), C = 0.02 K + 0.02 I, with a
rigid stop at the last one and, if wanted, dry friction at another one; and equal masses by
themselves, each between two stops.
"""

import math

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import (
    BoundaryShape,
    Structure,
    TransitionShape,
    mode_shapes,
)

GAP, RESTITUTION, LIMIT, OMEGA = 0.3, 0.8, 0.5, 0.7


def by_tables(
    name,
    fields,
    rows,
    resets,
    boundaries,
    transitions,
    modes,
    forcing=(),
):
    """A system of given tables; boundaries are names, rows and whether reaching is enough."""
    size, count = fields.shape[1], len(fields)
    structure = Structure(
        name,
        tuple(f"y{i}" for i in range(size)),
        tuple(f"c{i}" for i in range(count)),
        tuple(shapes for shapes, _, _ in modes),
        ((),) * count,
        ((),) * count,
        tuple(tuple(BoundaryShape(*b) for b in found) for found in boundaries),
        tuple(map(tuple, transitions)),
        (),
        len(rows),
        len(resets),
        forcing,
    )
    exponents, flows = (tuple(m[k] for m in modes) for k in (1, 2))
    return PiecewiseLinear(structure, {}, fields, rows, resets, exponents, flows)


def _modes(field, factored):
    """Pairs of complex eigenvalues from eigenvectors; what is left belongs to zero."""
    if factored:
        return tuple(numeric_modes(field))
    size = len(field)
    whole = np.vstack([field, np.zeros(size + 1)])
    values, right = np.linalg.eig(whole)
    left = np.linalg.inv(right)
    places = np.flatnonzero(values.imag > 1e-6)
    assert 2 * len(places) + np.count_nonzero(abs(values) < 1e-9) == size + 1
    terms = []
    for k in places:
        projector = np.outer(right[:, k], left[k])
        terms += [2 * projector.real, -2 * projector.imag]
    terms.insert(0, np.eye(size + 1) - sum(terms[::2]))
    exponents = np.array([(0.0, 0.0), *((values[k].real, values[k].imag) for k in places)])
    exponents[np.abs(exponents) < 1e-13] = 0.0
    shapes = mode_shapes([(1, False), *[(1, True)] * len(places)])
    return shapes, exponents, np.array(terms)[:, :size]


def chain(count, rubbing=None, factored=False):
    """A chain; configurations without friction: 0, with it: 0 forwards, 1 sticking, 2 backwards.

    Parameters
    ----------
    count : int
        Masses; the states are positions, velocities, cosine and sine of the force.
    rubbing : int, optional
        The mass with friction, from 0.
    factored : bool
        Whether modes have factors instead of matrices: those that the package finds.

    Returns
    -------
    PiecewiseLinear
    """
    size, last = 2 * count + 2, 2 * count - 1
    stiffness = 2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    free = np.zeros((size, size + 1))
    free[:count, count : 2 * count] = np.eye(count)
    free[count : 2 * count, :count] = -stiffness
    free[count : 2 * count, count : 2 * count] = -0.02 * (stiffness + np.eye(count))
    free[count, 2 * count] = 1.0
    free[2 * count, 2 * count + 1], free[2 * count + 1, 2 * count] = -OMEGA, OMEGA
    stop = np.zeros(size + 1)
    stop[count - 1], stop[-1] = 1.0, -GAP
    unit = np.eye(size, size + 1)
    bounce = unit.copy()
    bounce[last, last] = -RESTITUTION
    strike = TransitionShape(frozenset({0}), (), 1, 0)
    if rubbing is None:
        fields, rows, resets = free[None], stop[None], np.stack([unit, bounce])
        return by_tables(
            f"chain-{count}", fields, rows, resets, [[("stop", 0, True)]], [[strike]],
            [_modes(free, factored)], ((2 * count, 2 * count + 1),),
        )  # fmt: skip
    mass = count + rubbing
    held, forwards, backwards = free.copy(), free.copy(), free.copy()
    held[[rubbing, mass]] = 0.0
    forwards[mass, -1], backwards[mass, -1] = -LIMIT, LIMIT
    force, velocity = free[mass].copy(), np.zeros(size + 1)
    velocity[mass] = 1.0
    pushed, pulled = force.copy(), -force
    pushed[-1] -= LIMIT
    pulled[-1] -= LIMIT
    rest = unit.copy()
    rest[mass, mass] = 0.0
    names = [
        [("stop", 0, True), ("stops", 1, True)],
        [("stop", 0, True), ("pushed", 3, False), ("pulled", 4, False)],
        [("stop", 0, True), ("stops", 2, True)],
    ]
    slides = [
        TransitionShape(frozenset({1}), ((3, 1, True),), 2, 0),
        TransitionShape(frozenset({1}), ((4, 1, True),), 2, 2),
        TransitionShape(frozenset({1}), (), 2, 1),
    ]
    strikes = [TransitionShape(frozenset({0}), (), 1, c) for c in range(3)]
    starts = [TransitionShape(frozenset({b}), (), 0, c) for b, c in ((1, 0), (2, 2))]
    fields = np.stack([forwards, held, backwards])
    rows = np.stack([stop, -velocity, velocity, pushed, pulled])
    return by_tables(
        f"rubbing-chain-{count}", fields, rows, np.stack([unit, bounce, rest]), names,
        [[strikes[0], *slides], [strikes[1], *starts], [strikes[2], *slides]],
        [_modes(field, factored) for field in fields],
    )  # fmt: skip


def masses_apart(count, gaps):
    """Masses x'' + x = 0, each between stops at its gap to the right, then to the left.

    Parameters
    ----------
    count : int
    gaps : array (2 count,)
        To the right of each mass, then to the left of each. All that are reached together
        bounce together.

    Returns
    -------
    PiecewiseLinear
    """
    size = 2 * count
    field = np.zeros((size, size + 1))
    field[:count, count:size], field[count:, :count] = np.eye(count), -np.eye(count)
    rows = np.zeros((size, size + 1))
    rows[:count, :count], rows[count:, :count] = np.eye(count), -np.eye(count)
    rows[:, -1] = -gaps
    unit = np.eye(size, size + 1)
    single = [frozenset({b}) for b in range(size)]
    sets = [*single, frozenset(range(count)), frozenset(range(count, size))]
    resets = [unit]
    for reached in sets:
        bounce = unit.copy()
        for b in reached:
            bounce[count + b % count, count + b % count] = -RESTITUTION
        resets.append(bounce)
    transitions = [TransitionShape(s, (), k + 1, 0) for k, s in enumerate(sets)]
    cosine, sine = np.eye(size, size + 1), field.copy()
    shapes = mode_shapes([(1, False), (1, True)])
    flows = np.stack([np.zeros((size, size + 1)), cosine, sine])
    names = [(f"right{b}" if b < count else f"left{b - count}", b, True) for b in range(size)]
    return by_tables(
        f"apart-{count}", field[None], rows, np.stack(resets), [names], [transitions],
        [(shapes, np.array([(0.0, 0.0), (0.0, 1.0)]), flows)],
    )  # fmt: skip


def integrated(system, state, configuration, transitions):
    """Times, configurations and states by matrix exponentials, samples and root finding.

    What follows an event is decided by the values of the conditions' functions alone.

    Parameters
    ----------
    system : PiecewiseLinear
        Of which neither exponents nor flows are used.
    state : array (N,)
    configuration : int
    transitions : int

    Returns
    -------
    times : array (n,)
    configurations : list of int
    states : array (n, N)
    """
    step, size = 1 / 32, len(state)
    wholes = [np.vstack([field, np.zeros(size + 1)]) for field in system.fields]
    steps = [expm(step * whole) for whole in wholes]
    now, here, time = np.append(state, 1.0), configuration, 0.0
    times, places, states = [0.0], [here], [state]
    while len(times) <= transitions:
        shapes = system.structure.boundaries[here]
        rows = system.rows[[shape.row for shape in shapes]]
        after = steps[here] @ now
        # a start on a boundary leaves it
        found = math.inf, -1
        for b in np.flatnonzero(rows @ after > 0).tolist():
            inside = 1e-9 if (rows[b] @ now) > -1e-12 else 0.0
            when = brentq(_value, inside, step, args=(rows[b], wholes[here], now), xtol=1e-15)
            found = min(found, (when, b))
        if found[1] < 0:
            now, time = after, time + step
            continue
        now, time = expm(found[0] * wholes[here]) @ now, time + found[0]
        taken = next(
            t
            for t in system.structure.transitions[here]
            if t.boundaries == {found[1]}
            and all((system.rows[r] @ now > 0) == holds for r, _, holds in t.conditions)
        )
        now = np.append(system.resets[taken.reset] @ now, 1.0)
        here = taken.target
        times.append(time)
        places.append(here)
        states.append(now[:-1])
    return np.array(times), places, np.array(states)


def _value(t, row, whole, start):
    return float(row @ expm(t * whole) @ start)
