"""Basins that are proved: exact motions go where the proof says, and nothing false is said."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import SoftStop
from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.sets.certify_basin import Undecided, attracting_core, next_tiles
from nonsmooth.runtime.proof.sets.section_choice import FloatSection
from nonsmooth.runtime.proof.sets.section_choice import section_of as basin_section
from nonsmooth.runtime.proof.statement import exact_system
from tests.certified import accepted
from tests.friction_sets import BOX, DATA, SIDE, TILES, arrival, prove_basin, section_of
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.shared import shared_file


@pytest.fixture(scope="module")
def orbit():
    return ns.solve("dry-friction/global-stick", DATA)


@pytest.fixture(scope="module")
def found():
    return ns.load(shared_file("basin of friction", prove_basin))


@pytest.fixture(scope="module")
def impact():
    orbit = ns.solve(
        f"{GALLERY / 'impact_oscillator.py'}:one-period", {"r": "0.3", "sigma": "-0.2", "w": "2.4"}
    )
    assert orbit.stability.verdict == "stable"
    return orbit


def on_section(x2):
    return [4.0195 + x2 / 2, x2, 1.0, 1.0]


@pytest.mark.slow
def test_the_core_is_around_the_orbit_and_contracted(orbit, found):
    assert found.proved
    assert found.coordinates == ("x2",)
    centre, side = float(found.core.centre[0]), abs(float(found.core.sides[0][0]))
    exact = orbit.trajectory().states[1, 1]
    assert abs(centre - exact) < 1e-5
    ends = np.array([centre - 0.99 * side, exact, centre + 0.99 * side])
    images = np.array([arrival(on_section(x)) for x in ends])
    rates = np.abs(np.diff(images) / np.diff(ends))
    assert (rates < float(Fraction(found.contraction))).all()
    assert ((centre - side < images) & (images < centre + side)).all()


@pytest.mark.slow
def test_motions_from_boxes_come_to_smaller_ranks(found):
    random = np.random.default_rng(1)
    good = np.flatnonzero(found.ranks > 0)
    for number in random.choice(good, 40, replace=False):
        low, high = found.grid.bounds(np.array([number]))
        place = random.uniform(low[0, 0], high[0, 0])
        try:
            image = arrival(on_section(place))
        except ns.InputError:
            continue  # no state of the section: beyond a boundary
        (place_of,) = np.floor(image / found.grid.sides).astype(int) - found.grid.first
        assert 0 <= found.ranks[place_of] < found.ranks[number]


@pytest.mark.slow
def test_motions_from_tiles_come_to_the_orbit(orbit, found):
    random = np.random.default_rng(2)
    good = np.flatnonzero(found.attracted)
    assert len(good) > 20
    x2 = orbit.trajectory().states[1, 1]
    for number in random.choice(good, 8, replace=False):
        low, high = found.tiles.bounds(np.array([number]))
        start = random.uniform(low[0], high[0])
        motion = ns.simulate("dry-friction", DATA, start, transitions=2500)
        names = motion.configurations
        at = [k for k, n in enumerate(names) if n == "slip-stick" and names[k - 1] == "stick-stick"]
        # it contracts by 0.98 in each period
        assert abs(motion.states[at[-1], 1] - x2) < 0.02


@pytest.mark.slow
def test_more_tiles_are_added_to_those_that_were_looked_at(orbit, found):
    tiles = int(found.looked.sum()) + 20
    more = ns.certify.basin(orbit, box=BOX, side=SIDE, tiles=tiles, resume=found)
    assert more.looked.sum() == found.looked.sum() + 20
    assert more.attracted[found.attracted].all()
    again = ns.certify.basin(orbit, box=BOX, side=SIDE, tiles=tiles, resume=found)
    assert np.array_equal(again.attracted, more.attracted)
    with pytest.raises(ns.InputError, match="another tiles"):
        ns.certify.basin(orbit, box=BOX, side=2 * SIDE, tiles=20, resume=more)
    name, (low, high) = next(iter(BOX.items()))
    shorter = {**BOX, name: (low, high - 0.01)}
    with pytest.raises(ns.InputError, match="another box"):
        ns.certify.basin(orbit, box=shorter, side=SIDE, tiles=20, resume=more)


@pytest.mark.slow
def test_a_share_is_that_of_the_box_which_was_asked_for(found):
    random = np.random.default_rng(8)
    some = replace(
        found,
        tiles=BoxGrid((-1, 0, 1, -2), (3, -2, 0, 5), (4, 3, 2, 2)),
        attracted=random.random(48) < 0.7,
        box=dict(zip(found.states, [(1.7, 3.1), (-1.25, 0.5), (0.5, 4), (1.3, 1.4)], strict=True)),
    )
    low, high = (np.array(x) for x in zip(*some.box.values(), strict=True))
    points = random.uniform(low, high, (200_000, 4))
    _, number, inside = some.tiles.numbers_met(points, points)
    assert inside.all()
    assert some.share == pytest.approx(some.attracted[number].mean(), abs=0.005)
    assert replace(some, attracted=np.ones(48, dtype=bool)).share == 1


@pytest.mark.slow
def test_several_processes_find_what_one_finds(orbit, found):
    none = np.zeros_like(found.looked)
    begun = replace(found, looked=none, attracted=none)
    shared = ns.certify.basin(orbit, box=BOX, side=SIDE, tiles=TILES, workers=2, resume=begun)
    both = shared.looked & found.looked
    assert both.any()
    assert np.array_equal(shared.attracted[both], found.attracted[both])
    with pytest.raises(ns.InputError, match="workers = 0"):
        ns.certify.basin(orbit, workers=0)


@pytest.mark.slow
def test_an_interrupt_keeps_what_several_processes_found(orbit, found):
    def interrupted(share, count):
        if share:
            raise KeyboardInterrupt

    with pytest.raises(ns.Interrupted) as ended:
        ns.certify.basin(
            orbit, box=BOX, side=SIDE, tiles=9000, resume=found, workers=2, progress=interrupted
        )
    partial = ended.value.partial
    assert found.looked.sum() < partial.looked.sum() < partial.looked.size
    assert partial.attracted[found.attracted].all()


def test_tiles_are_looked_at_where_most_are_attracted():
    tiles = BoxGrid((0, 0), (0, 0), (64, 64))
    place = np.stack(np.unravel_index(np.arange(len(tiles)), tiles.counts))
    truth = (place[0] < 24) & (place[1] >= 40)  # a corner of 14 %
    looked, attracted = np.zeros((2, len(tiles)), dtype=bool)
    shares = []
    while not looked.all():
        numbers = next_tiles(tiles, looked, attracted, 128)
        assert not looked[numbers].any()
        assert 0 < len(np.unique(numbers)) == len(numbers) <= 128
        looked[numbers], attracted[numbers] = True, truth[numbers]
        shares.append(attracted.sum() / truth.sum())
    assert shares[0] < 0.1  # anywhere
    assert shares[9] > 0.9  # of all 32 batches
    assert shares[-1] == 1


@pytest.mark.slow
@pytest.mark.compiled
def test_with_a_forcing_the_section_holds_all_states(impact, tmp_path):
    found = ns.certify.basin(impact, box={"x": (-0.8, -0.55), "v": (-0.2, 0)})
    assert found.proved, found.reason
    assert found.phase
    assert found.tiles is None
    assert found.coordinates == ("x", "v")
    accepted(found, tmp_path)
    good = np.flatnonzero(found.ranks >= 0)
    assert len(good) > 50
    random = np.random.default_rng(3)
    cosine, sine = (float(Fraction(x)) for x in found.phase)
    centre = np.array([float(x) for x in found.core.centre])
    period = 2 * np.pi / 2.4
    values = {name: str(value) for name, value in impact.parameters.items()}
    for number in random.choice(good, 12, replace=False):
        low, high = found.grid.bounds(np.array([number]))
        x, v = random.uniform(low[0], high[0])
        motion = ns.simulate(
            impact.system, values, [x, v, cosine, sine], found.configuration, until=80 * period
        )
        end = motion(np.array([80 * period]))[0, :2]
        assert np.abs(end - centre).max() < 1e-2


@pytest.mark.slow
def test_no_basin_is_claimed_where_no_box_is_attracted(impact):
    found = ns.certify.basin(impact, box={"x": (-90, -80), "v": (0.045, 0.085)})
    assert found.claim == "undecided"
    assert "no box of the section" in found.reason


def test_an_orbit_that_is_not_stable_has_no_basin():
    orbit = ns.solve(
        f"{GALLERY / 'impact_oscillator.py'}:one-period", {"r": "0.8", "sigma": "0.2", "w": "2.4"}
    )
    assert orbit.stability.verdict == "unstable"
    found = ns.certify.basin(orbit)
    assert found.claim == "undecided"
    assert found.reason
    assert found.statement.startswith("nothing is proved")
    with pytest.raises(ns.InputError, match="nothing to draw"):
        found.plot()


@pytest.mark.slow
def test_an_attractor_beside_an_orbit_is_not_taken_for_it(orbit, found):
    met = orbit.trajectory().states[1, 1]
    assert abs(float(found.core.centre[0]) - met) < 1e-5
    system = exact_system("dry-friction", DATA)
    floats = FloatSection(orbit.system, system, section_of(system))
    with pytest.raises(Undecided, match="another orbit is there"):
        attracting_core(floats, 1, np.array([met + 2]), 16.0, pytest.fail)


def test_an_orbit_beside_an_attractor_has_no_basin():
    # the motions beside it come to another orbit
    orbit = ns.solve("dry-friction/symmetric", dict(V="0.8", us1=1, us2=1, ur1=4, ur2=2))
    found = ns.certify.basin(orbit, tiles=0)
    assert (found.claim, found.reason) == ("undecided", "the orbit is no motion of the system")


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"tiles": -1}, "tiles = -1"),
        ({"most": 0}, "most = 0"),
        ({"bits": 10}, "bits = 10"),
        ({"side": 0}, "side = 0"),
        ({"widest": float("nan")}, "widest = nan"),
        ({"box": {"x9": (0, 1)}}, "x9"),
        ({"box": {"x1": (1, 0)}}, "no interval"),
        ({"side": 1e-300}, "sides 1e-300"),
        ({"side": 1e-12}, "sides 1e-12"),
        ({"side": 1e-3}, "sides 0.001"),
        ({"side": 0.125, "box": {"v1": (-0.125, 1e300)}}, "take longer"),
        ({"box": {"v1": (-1e308, 1e308)}}, "a side of a box"),
    ],
)
def test_wrong_numbers_are_refused_before_anything_is_proved(orbit, wrong, told):
    def begun(*done):
        pytest.fail("it is begun")

    with pytest.raises(ns.InputError, match=told):
        ns.certify.basin(orbit, progress=begun, **wrong)


def test_parameters_that_an_orbit_leaves_open_are_asked_for():
    with pytest.raises(ns.InputError, match="open"):
        ns.certify.basin(ns.solve("dry-friction/global-stick"))


def test_a_linear_response_has_a_section_at_every_frequency():
    """A turn of the forcing and the motion over one are the same, but for rounding."""
    stop = SoftStop("x", at=10, stiffness=10, name="stop")
    far = one_mass("far", stop, damping="1/5", forces={sp.Symbol("w"): 1})
    for w in np.arange(20, 31) / 10:
        orbit = ns.solve(far, {"w": w}, [2 * np.pi / w], itinerary=[("free", "forcing-phase")])
        with flint_precision(128):
            system = exact_system(orbit.system, {"w": orbit.parameters["w"]})
            met = basin_section(system, orbit.trajectory(), float(orbit.period))
        x, v = met.point
        assert np.hypot(x, v / w) == pytest.approx(1 / abs(1 - w**2 + 0.2j * w))
