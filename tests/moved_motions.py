"""Motions of random oscillators, differenced centrally in fifty digits.

The sequence of configurations is that of the motion in doubles; the dwell times are solved anew
by Newton's method with exponentials of the fields in balls, of which the middles are taken.
"""

from fractions import Fraction

import numpy as np
from flint import arb, arb_mat

import nonsmooth as ns
from nonsmooth.derive import (
    Friction,
    Harmonic,
    Parameter,
    RigidStop,
    Slider,
    SoftStop,
    oscillator,
)
from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.model.piecewise import piecewise_in
from nonsmooth.runtime.simulation.motion_linearisation import MotionLinearisation

BITS = 220
STEP = Fraction(1, 10**20)


def random_oscillator(rng, name, masses=None):
    """A forced chain of one to three masses with a stop, friction or a slider, or two of them.

    Parameters
    ----------
    rng : Generator
    name : str
    masses : int, optional

    Returns
    -------
    System, its parameters, a start
    """
    count = masses or int(rng.integers(1, 4))
    names = [f"x{i}" for i in range(1, count + 1)]
    data = {f"m{i}": rng.uniform(0.5, 2) for i in range(1, count + 1)}
    data |= {f"k{i}": rng.uniform(0.5, 3) for i in range(1, count + 1)}
    data |= {"d": rng.uniform(0.01, 0.05), "F": rng.uniform(1.0, 2), "w": rng.uniform(0.5, 1.5)}
    kinds = rng.choice(["rigid", "soft", "friction", "slider"], 2, replace=False).tolist()
    data |= {"gap": rng.uniform(0.1, 0.4)} if {"rigid", "soft"} & {*kinds} else {}
    data |= {"r": rng.uniform(0.7, 0.95)} if "rigid" in kinds else {}
    data |= {"ks": rng.uniform(5, 20), "ds": rng.uniform(0, 0.3)} if "soft" in kinds else {}
    friction = {"mu": rng.uniform(0.1, 0.3), "mus": rng.uniform(0.3, 0.5), "V": 0.3}
    data |= friction if "friction" in kinds else {}
    data |= {"kj": rng.uniform(1, 3), "lim": rng.uniform(0.1, 0.4)} if "slider" in kinds else {}
    found = [Parameter(key, key) for key in data]
    p = {parameter.name: parameter.symbol for parameter in found}
    stiffness = [[0] * count for _ in names]
    for i in range(count):
        spring = p[f"k{i + 1}"]
        stiffness[i][i] += spring
        if i:
            stiffness[i - 1][i - 1] += spring
            stiffness[i][i - 1] -= spring
            stiffness[i - 1][i] -= spring
    last = names[-1]
    makers = {
        "rigid": lambda: RigidStop(last, p["gap"], p["r"], name="hard"),
        "soft": lambda: SoftStop(last, -p["gap"], p["ks"], p["ds"], side="lower", name="soft"),
        "friction": lambda: Friction("x1", p["mu"], p["mus"], velocity=p["V"], name="belt"),
        "slider": lambda: Slider("x1", p["kj"], p["lim"], name="jenkins"),
    }
    system = oscillator(
        name,
        names,
        [[p[f"m{i + 1}"] if i == j else 0 for j in range(count)] for i in range(count)],
        stiffness,
        damping=[[p["d"] * entry for entry in row] for row in stiffness],
        forcing=[Harmonic(p["w"], cosine={"x1": p["F"]})],
        elements=[makers[kind]() for kind in kinds],
        parameters=found,
    )
    start = [0.0] * (2 * count) + [0.0] * ("slider" in kinds) + [1.0, 0.0]
    start[count : 2 * count] = rng.uniform(-0.2, 0.2, count).tolist()
    return system, data, start


class MovedMotion:
    """A motion's sequence of configurations, followed in fifty digits from moved numbers."""

    def __init__(self, system, motion, apart=None):
        self.system, self.motion = system, motion
        own = np.zeros(motion.transitions, dtype=bool) if apart is None else apart
        linearisation = MotionLinearisation(motion, (), np.empty((0, 0)), np.empty(0), own)
        self.transitions, self.instants = linearisation.transitions, linearisation.instants

    def difference(self, parameters, start, times):
        """Derivatives of event times (n - 1,) and of states (m, N) at fixed times.

        Parameters
        ----------
        parameters : dict of str to float
            Direction; of what is left out nothing changes.
        start : array (N,)
            Direction.
        times : array (m,)

        Returns
        -------
        event_times, states : array
        """
        with Balls.working(BITS):
            above, below = (
                self._followed(parameters, start, times, sign * STEP) for sign in (1, -1)
            )
            width = arb(2 * STEP.numerator) / STEP.denominator
            return tuple(
                np.array([float(((a - b) / width).mid()) for a, b in zip(up, down, strict=True)])
                for up, down in zip(above, below, strict=True)
            )

    def one_sided(self, parameters, start, times, sign):
        """Derivatives of states (m, N) at fixed times on one side, where the motion is exact.

        Parameters
        ----------
        parameters : dict of str to float
            Direction; of what is left out nothing changes.
        start : array (N,)
            Direction.
        times : array (m,)
        sign : int
            1, or -1 for numbers that fall.

        Returns
        -------
        array (m, N)
        """
        with Balls.working(BITS):
            moved, here = (
                self._followed(parameters, start, times, step) for step in (sign * STEP, Fraction())
            )
            dwell = [float(b - a) for a, b in zip([arb(0), *moved[0]], moved[0], strict=False)]
            assert min(dwell) > -1e-35, "the sequence is not that of the moved motion"
            width = arb(sign * STEP.numerator) / STEP.denominator
            found = [float(((a - b) / width).mid()) for a, b in zip(moved[1], here[1], strict=True)]
        return np.reshape(found, (len(times), -1))

    def _followed(self, parameters, start, times, step):
        motion, run = self.motion, self.motion.run
        data = {
            name: as_value(Fraction(float(value)) + step * Fraction(parameters.get(name, 0.0)))
            for name, value in motion.parameters.items()
        }
        tables = piecewise_in(self.system, data, Balls())
        moved = [
            _exact(Fraction(x) + step * Fraction(dx))
            for x, dx in zip(run.states[0].tolist(), start.tolist(), strict=True)
        ]
        state, now, events, states = arb_mat([[x] for x in [*moved, arb(1)]]), arb(0), [], []
        size = len(moved)
        generators = [arb_mat([*field.tolist(), [0] * (size + 1)]) for field in tables.fields]
        dwell = np.diff(run.times).tolist()
        for k in range(len(run.times)):
            field = generators[int(run.configurations[k])]
            last = run.times[k + 1] if k < len(dwell) else np.inf
            for time in times[(times >= run.times[k]) & (times < last)].tolist():
                states += (field * (arb(time) - now)).exp().__mul__(state).entries()[:-1]
            if k == len(dwell):
                return events, states
            row = arb_mat([tables.rows[self.transitions.rows[k]].tolist()])
            time = arb(dwell[k])
            end = ((field * time).exp() * state).mid()
            for _ in range(20):
                if self.instants[k]:
                    break
                change = ((row * end)[0, 0] / (row * (field * end))[0, 0]).mid()
                time = (time - change).mid()
                end = ((field * time).exp() * state).mid()
                if abs(change) < arb(10) ** -45:
                    break
            else:
                raise RuntimeError(f"no event near entry {k + 1}")
            now = (now + time).mid()
            events.append(now)
            reset = arb_mat(tables.resets[self.transitions.resets[k]].tolist())
            state = arb_mat([[x] for x in [*(reset * end).mid().entries(), arb(1)]])
        raise AssertionError


def compared_with_digits(system, motion, rng, count):
    """Largest error of a motion's derivatives, in units of its condition and of the largest.

    States at random times and times of events are compared along a random direction, and the
    reverse pass with the forward one.

    Parameters
    ----------
    system : System
    motion : Trajectory
    rng : Generator
    count : int
        Of times.

    Returns
    -------
    float or None
        None where the motion has no derivative.
    """
    times = np.sort(rng.uniform(0, motion.end, count))
    try:
        found = motion.derivatives(times=times)
    except ns.InputError:
        return None
    along = dict(zip(found.by, rng.normal(size=len(found.by)).tolist(), strict=True))
    forward = found.jvp(along)
    # a start that its configuration holds moves as its constraints let it
    parameters = {name: along[name] for name in motion.parameters}
    events, states = MovedMotion(system, motion).difference(parameters, forward["before"][0], times)
    factors = rng.normal(size=forward["states"].shape)
    pulled = found.vjp(states=factors) @ list(along.values())
    errors = (
        forward["event_times"] - events,
        forward["states"].ravel() - states,
        pulled - (factors * forward["states"]).sum(),
    )
    largest = max(float(np.abs(part).max()) for part in (events, states))
    missed = max(float(np.nanmax(np.abs(error))) for error in errors)
    return missed / max(largest, 1.0) / found.condition


def compared_at_random(rng, name, transitions):
    """What `compared_with_digits` gives for a motion of a random oscillator of some name."""
    system, data, start = random_oscillator(rng, name)
    motion = ns.simulate(system, data, start, transitions=transitions)
    return compared_with_digits(system, motion, rng, 3)


def check_reverse(found, draw):
    """See derivatives of a motion by the reverse mode be products with those of the forward one."""
    names = ("states", "event_times", "before", "behind")
    factors = {name: draw.normal(size=getattr(found, name).shape[:-1]) for name in names}
    expected = sum(
        np.tensordot(part, getattr(found, name), axes=part.ndim) for name, part in factors.items()
    )
    np.testing.assert_allclose(found.vjp(**factors), expected, rtol=1e-12, atol=1e-12)


def _exact(value):
    return arb(value.numerator) / value.denominator
