"""What the documents say is what was declared: each formula, evaluated at random numbers."""

import random

import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Friction,
    Harmonic,
    Itinerary,
    Regions,
    RigidStop,
    Slider,
    SoftStop,
    System,
    Terms,
    chain_matrices,
    oscillator,
)
from nonsmooth.derive.document.blocks import Table
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from tests.declared_documents import one_mass
from tests.documents import GALLERY, distinct, document_of, marked, names
from tests.documents import declarations as all_declarations
from tests.formulas.cycle_law import CycleLaw, Orbit
from tests.formulas.law import Facts, SystemLaw, drawn
from tests.tables import slow

SECTIONS = ("The system", "Configurations", "Modal analysis", "Transitions", "Contacts")
SYSTEMS = list(names(System))


def random_system(seed):
    """Coordinates, elements of every kind, and expressions with every sign."""
    draw = random.Random(seed)
    letters = sp.symbols("A b k2 mu_c e m nu", positive=True)

    def positive():
        one, two = draw.sample(letters, 2)
        return draw.choice([one, one + two, one * two, one / two, 2 * one / 3, (one + 1) / two])

    def signed():
        one, two, three = draw.sample(letters, 3)
        choices = [-one, -one - two, one - two, -(one + two) / three, -2 * one, (two - 3) * one]
        return draw.choice(choices)

    size = draw.choice([1, 1, 1, 2, 2])
    coordinates = [f"x{i + 1}" for i in range(size)] if size > 1 else [draw.choice(["x", "phi"])]
    mass, stiffness, _ = chain_matrices(
        [positive() for _ in range(size)], [positive() for _ in range(size)]
    )
    damping = draw.choice([None, sp.diag(*(positive() for _ in range(size)))])
    side, other = (draw.choice(["upper", "lower"]) for _ in range(2))
    u, s = letters[:2]
    last, first = coordinates[-1], coordinates[0]
    kinds = [
        RigidStop(last, at=signed(), restitution=sp.Symbol("r"), side=side, name="wall"),
        SoftStop(first, at=signed(), stiffness=positive(), damping=s, side=other, name="pad"),
        Friction(first, kinetic=u, static=u + s, velocity=signed(), name="belt"),
        Slider(last, stiffness=positive(), limit=positive(), name="joint"),
        Regions(sp.Symbol(first) + signed(), above=Terms(load={first: signed()}), name="step"),
    ]
    forcing = [Harmonic(sp.Symbol("w"), cosine={first: signed()})] if draw.random() < 0.4 else []
    return oscillator(
        f"random-{seed}", coordinates, mass, stiffness, damping,
        load={last: signed()}, forcing=forcing, elements=draw.sample(kinds, draw.choice([1, 1, 2])),
    )  # fmt: skip


def check(document, system, seed):
    found = SystemLaw(Facts(system, document, drawn(system, seed))).check(SECTIONS)
    tables = {block.header[:2]: block for block in document.blocks if isinstance(block, Table)}
    named = {row[0].strip("*") for row in tables["Configuration", "Boundary"].rows} - {""}
    assert named == {c.name for c in system.configurations if c.boundaries}
    declared = {"Parameter": system.parameters, "From": system.transitions}
    assert {first for first, entries in declared.items() if entries} <= {
        first for first, _ in tables
    }
    return found


@pytest.mark.parametrize("name", marked(distinct(SYSTEMS, "three_masses")))
def test_what_the_document_of_a_system_says_is_true(name):
    system = all_declarations()[name]
    assert check(document_of(name), system, 3) >= 9


@pytest.mark.parametrize(
    "seed",  # stops and sliders, which systems of the gallery have too, take long
    [2, 3, 4, 11, slow(5)],
)
def test_what_the_document_of_a_random_system_says_is_true(seed):
    system = random_system(seed)
    assert check(describe_system(system), system, seed) >= 8


@pytest.mark.parametrize(("zeta", "square"), [("3/10", 1), (1, 1), (2, 1), ("-1/10", 4), (1, -1)])
def test_what_the_document_of_one_damped_mass_says_is_true(zeta, square):
    system = one_mass(zeta, square)
    assert check(describe_system(system), system, 3) >= 9


def unanchored_system(seed):
    """One or two masses that nothing holds, with ratios, roots and forcings of every kind."""
    draw = random.Random(seed)
    gamma, k, w = sp.symbols("gamma k w", positive=True)
    size = draw.choice([1, 2, 2])
    coordinates = [f"x{i + 1}" for i in range(size)]
    mass = sp.diag(*draw.sample([1, gamma, 1 + gamma, (1 + gamma) / gamma, sp.sqrt(gamma)], size))
    link = draw.choice([1, k, (1 + k) / k, sp.sqrt(k)]) if size == 2 else 0
    stiffness = link * sp.Matrix([[1, -1], [-1, 1]])[:size, :size]
    drag = draw.choice([None, sp.diag(draw.choice([k, sp.sqrt(k)]))]) if size == 1 else None
    forcing = [
        Harmonic(
            draw.choice([2, w, w + k, sp.sqrt(2)]), cosine={"x1": 1}, sine={coordinates[-1]: k}
        )
        for _ in range(draw.choice([0, 1, 1, 2]))
    ]
    stop = RigidStop("x1", at=k, restitution=0, name="wall")
    return oscillator(
        f"unanchored-{seed}", coordinates, mass, stiffness, drag,
        load={"x1": draw.choice([0, k])}, forcing=forcing, elements=[stop] if size == 1 else [],
    )  # fmt: skip


@pytest.mark.parametrize("seed", [1, 3, 18, 180])
def test_what_the_document_of_masses_that_nothing_holds_says_is_true(seed):
    system = unanchored_system(seed)
    assert check(describe_system(system), system, seed) >= 4


def law_of(name):
    """The document of an itinerary of the gallery, and its orbit at the reference."""
    solved = ns.solve(f"{GALLERY}/{name.replace('/', '.py:')}")
    document = describe_orbit(all_declarations()[name])
    system = document.shown.system
    known = {p.name: p.symbol for p in system.parameters}
    given = drawn(system, 1)
    given |= {known[n]: float(v) for n, v in solved.parameters.items()}
    facts = Facts(system, document, given)
    return CycleLaw(facts, Orbit(facts, solved))


ITINERARIES = [n for n in names(Itinerary) if (GALLERY / f"{n.partition('/')[0]}.py").exists()]


ALIKE = "backlash_gear/rattle", "impact_damper/struck-twice", "two_belts/second-sticks"


@pytest.mark.parametrize("name", marked(distinct(ITINERARIES, *ALIKE)))
def test_what_the_document_of_an_itinerary_says_is_true_on_an_orbit(name):
    assert law_of(name).whole() > 40
