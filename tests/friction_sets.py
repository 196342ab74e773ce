"""Motions of the paper's two masses on a belt to a section, and sets of states that go there.

On the section the first mass breaks loose from the belt while the second one sticks.
"""

import numpy as np

import nonsmooth as ns
from nonsmooth.runtime.checker.state_sets.many_sets import ManyMotions
from nonsmooth.runtime.checker.state_sets.switching import StatedSection
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.sets.sections import listed_declaration, transition_section
from nonsmooth.runtime.proof.statement import exact_system
from tests.two_masses import STICKING

# with the paper's orbit, which has a phase in which both masses stick
DATA = {name: str(value) for name, value in STICKING.items()}
SECTION = StatedSection("slip-stick", source="stick-stick", boundary="first-breaks-forward")


BOX = {"x1": (2, 5), "x2": (6, 8), "v1": (-0.5, 0.5), "v2": (-0.5, 0.5)}  # of starts
SIDE, TILES = 0.25, 60


def prove_basin():
    """Of some tiles, those at a corner of the box lead to the orbit; others slip long."""
    orbit = ns.solve("dry-friction/global-stick", DATA)
    return ns.certify.basin(orbit, box=BOX, side=SIDE, tiles=TILES)


def returns(start, configuration="slip-stick", transitions=60):
    """x2 each time that a motion comes to the section."""
    motion = ns.simulate("dry-friction", DATA, list(start), configuration, transitions=transitions)
    names = motion.configurations
    at = [k for k in range(1, len(names)) if names[k - 1 : k + 1] == ("stick-stick", "slip-stick")]
    return motion.states[at, 1]


def arrival(start, configuration="slip-stick"):
    """x2 where a motion first comes to the section; None if it does not."""
    return next(iter(returns(start, configuration)), None)


def section_of(system):
    """The section of an enclosed system."""
    structure = system.structure
    source, target = map(structure.configuration, ("stick-stick", "slip-stick"))
    boundary = structure.boundary(source, "first-breaks-forward")
    return transition_section(system, source, frozenset({boundary}), target)


def declared_system(name="dry-friction", data=None):
    """The declaration of a system with all of its transitions, as a file states it."""
    kernels = load_system(name)
    return listed_declaration(kernels, exact_system(kernels, data or DATA))


def motions_of(declared, most=400, widest=0.25):
    """The map of sets to the section, of a declaration."""
    return ManyMotions(declared, DATA, SECTION, np.ones(4), widest, most, 16)


def anywhere(low, high):
    """Boxes of states at the time 0."""
    boxes = ManySets.of_boxes(np.atleast_2d(low), np.atleast_2d(high))
    return ManySets(*(np.insert(x, -1, 0.0, axis=1) for x in vars(boxes).values()))


def sampled(random, sign, count):
    """Middles (n, 4) and half widths (n, 1) of boxes, by the sides from which masses move."""
    middles = random.uniform((-4, -8, 0.2, 0.2), (4, 8, 2, 2), (count, 4))
    middles[:, 2:] = 1 + middles[:, 2:] * sign
    return middles, random.choice([0.03, 0.06, 0.12], count)[:, None]


def corner(random, size):
    """Where in a box: corners and faces are where states first go another way."""
    share = random.uniform(-1, 1, size)
    return np.where(random.random(size) < 0.4, np.sign(share) * (1 - 1e-9), share)


def inside(leaves, number, point):
    """Which of the leaves of a set hold a point."""
    own = leaves.origin == number
    return ((leaves.low[own] - 1e-9 <= point) & (point <= leaves.high[own] + 1e-9)).all(axis=1)


def missed(leaves, boxes, name, each):
    """Of motions from states of boxes, how many end in no leaf; how many ran, and divided sets."""
    random, (middles, half) = np.random.default_rng(7), boxes
    away = ran = several = 0
    for k in np.flatnonzero(~leaves.lost):
        ways = set()
        for _ in range(each):
            state = middles[k] + half[k] * corner(random, 4)
            away += not inside(leaves, k, arrival(state, name)).any()
            ways.add(ns.simulate("dry-friction", DATA, state, name, transitions=12).configurations)
            ran += 1
        several += len(ways) > 1
    return away, ran, several
