"""The check of basins: true files pass, and false ones do not."""

import json
from math import prod

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Boundary, Configuration, FirstOrder, System, Transition
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.state_sets.basin import _motions
from nonsmooth.runtime.checker.state_sets.graph import stated_grid
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.present.compare_declarations import compare
from tests import friction_sets
from tests.certified import content_of, flat, prove_basin, refused_file, runs, saved
from tests.places import GALLERY
from tests.shared import shared_file


@pytest.fixture(scope="module")
def near(tmp_path_factory):
    """A basin of one mass on a belt, which is proved again in a second."""
    orbit = ns.solve(f"{GALLERY / 'mass_on_belt.py'}:stick-slip")
    path = tmp_path_factory.mktemp("belt") / "basin.json"
    found = ns.certify.basin(orbit, box={"x": (0, 2), "v": (-0.5, 0.5)}, side=0.25)
    assert 0 < found.attracted.sum() < found.attracted.size
    found.save(path)
    return path


@pytest.fixture
def belt(near):
    return content_of(near)


@pytest.fixture
def path():
    return shared_file("basin of friction", friction_sets.prove_basin)


@pytest.fixture
def content(path):
    return content_of(path)


@pytest.mark.slow
def test_a_true_file_of_a_declared_orbit_is_proved_again(near):
    check = ns.certify.check(near)
    assert check.difference is None
    assert check.claims == {"basin": "proved"}


@pytest.mark.slow
def test_a_true_file_of_an_orbit_with_a_name_is_compared(path):
    check = ns.certify.check(path)
    assert check.difference is None
    assert check.claims == {"basin": "proved"}
    assert check.compared


@pytest.mark.slow
@pytest.mark.parametrize(
    ("label", "told"),
    [
        ("dry-friction/symmetric", "the orbit through the core is not dry-friction/symmetric"),
        ("dry-friction/solution-ii", "a phase of dry-friction/solution-ii lasts no time"),
        ("dry-friction/another", "dry-friction/another is no orbit of dry-friction"),
        ("", " is no orbit of dry-friction"),
    ],
)
def test_a_basin_is_of_the_orbit_that_is_named(content, label, told):
    with pytest.raises(Failure, match=told):
        compare({**content, "orbit": label})


@pytest.mark.slow
def test_an_orbit_without_a_name_is_not_compared(content):
    assert compare(content)
    assert not compare({**content, "orbit": "dry-friction, 4 phases"})


@pytest.mark.slow
def test_several_processes_prove_a_file_again(near, belt, tmp_path):
    told = []
    check = ns.certify.check(near, workers=2, progress=lambda *done: told.append(done))
    assert check.difference is None
    assert told[-1] == (check.certificate.attracted.sum(),) * 2
    verdicts = runs([2] * len(flat(belt["verdicts"])))
    false = saved({**belt, "verdicts": verdicts}, tmp_path / "false.json")
    assert "elsewhere" in ns.certify.check(false, workers=2).difference


def edited_ranks(content, change):
    ranks = flat(content["ranks"])
    change(ranks)
    return {**content, "ranks": runs(ranks)}


@pytest.mark.slow
def test_ranks_are_those_of_boxes(belt, tmp_path):
    def below(ranks):
        ranks[ranks.index(-1) if -1 in ranks else 0] = -2

    def beyond(ranks):
        ranks[0] = len(ranks)

    for change in (below, beyond):
        refused_file(edited_ranks(belt, change), tmp_path, "no such ranks")


def test_a_box_beside_the_core_is_not_in_it(belt, tmp_path):
    def wider(ranks):
        last = max(k for k, rank in enumerate(ranks) if rank == 0)
        ranks[last + 1] = 0

    refused_file(edited_ranks(belt, wider), tmp_path, "not in the core")


def test_tiles_that_are_not_attracted_are_not_stated_to_be(belt, tmp_path):
    verdicts = flat(belt["verdicts"])
    last = max(k for k, verdict in enumerate(verdicts) if verdict == 1)
    verdicts[last] = 2
    refused_file({**belt, "verdicts": runs(verdicts)}, tmp_path, "a tile may lead elsewhere")


@pytest.mark.parametrize("ends", [(-0.5, 1e300), (-0.5, 0.75), (0.0, 0.5), (0.5, -0.5)])
def test_tiles_are_those_of_the_box_that_is_stated(belt, tmp_path, ends):
    box = {**belt["box"], "v": list(ends)}
    refused_file({**belt, "box": box}, tmp_path, "box")
    tiles = belt["tiles"]
    place = belt["states"].index("v")
    counts = [n - (k == place) for k, n in enumerate(tiles["counts"])]
    verdicts = runs(flat(belt["verdicts"])[: prod(counts)])
    edited = {**belt, "tiles": {**tiles, "counts": counts}, "verdicts": verdicts}
    refused_file(edited, tmp_path, "tiles of another box")


@pytest.mark.slow
def test_another_core_is_refused(content, tmp_path):
    core = content["core"]
    wide = {**core, "sides": [["3.5"]]}
    refused_file({**content, "core": wide}, tmp_path, "contracted")
    refused_file({**content, "contraction": "1/2"}, tmp_path, "contracted")
    refused_file({**content, "contraction": "1"}, tmp_path, "the core is not contracted")


def test_a_core_that_is_mapped_elsewhere_is_refused(belt, tmp_path):
    # all of it is mapped to one point, which is beside it
    core = belt["core"]
    (centre,), ((side,),) = core["centre"], core["sides"]
    far, less = float(centre) + 0.5 * abs(float(side)), float(side) / 4
    beside = {**core, "centre": [str(far)], "sides": [[str(less)]]}
    refused_file({**belt, "core": beside}, tmp_path, "contracted")


@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("iterates", 2, "a way does not lead back"),
        ("coordinates", ["x1"], "coordinates"),
        ("states", ["v", "x"], "tiles of other states"),
        ("widest", 0.0, "no limits of sets"),
        ("boundary", "belt-breaks-forward", "no such transition"),
        ("ranks", [[0, 3]], "another number of boxes"),
        ("claim", "undecided", "numbers of no claim"),
        ("reason", "a reason", "a reason why it is not proved"),
    ],
)
def test_other_entries_are_refused(belt, tmp_path, name, value, told):
    refused_file({**belt, name: value}, tmp_path, told)


def test_another_declaration_is_refused(belt, tmp_path):
    declared = json.loads(json.dumps(belt["declaration"]))
    rows = declared["configurations"]["slip"]["boundaries"]
    rows.pop(next(iter(rows)))
    refused_file({**belt, "declaration": declared}, tmp_path, "")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda rank: 2 * rank if rank > 0 else rank, None),  # ranks may be left out
        (lambda rank: min(rank, 1), "rank 1"),  # to a box of the same rank
        (lambda rank: 9 - rank if rank > 0 else rank, "may lead elsewhere"),  # to a larger one
        (lambda rank: -1 if rank == 1 else rank, "rank 2"),  # to a box without a rank
        (lambda rank: -1 if rank > 0 else rank, "a tile may lead elsewhere"),
    ],
)
def test_boxes_and_tiles_lead_to_boxes_of_smaller_ranks(tmp_path, change, told):
    kicked = content_of(shared_file("nonsmooth basin certificate", prove_basin))
    assert max(rank for rank, _ in kicked["ranks"]) > 2
    content = {**kicked, "ranks": [[change(rank), n] for rank, n in kicked["ranks"]]}
    if told:
        refused_file(content, tmp_path, told)
        return
    assert ns.certify.check(saved(content, tmp_path / "same.json")).difference is None


@pytest.mark.slow
def test_false_tiles_are_not_followed_for_ever(content):
    """On average a set has a quarter of the portions that it may have."""
    tiles, section = stated_grid(content["tiles"], 4), stated_grid(content["grid"], 1)
    sums = section.sums(np.repeat(*zip(*content["ranks"], strict=True)) >= 0)
    verdicts, followed = np.array(flat(content["verdicts"])), []
    for verdict in (2, 1):
        motions, chosen = _motions(content, 8), np.flatnonzero(verdicts == verdict)[:12]
        leaves, portions = motions.leaves, []

        def counted(*arguments, leaves=leaves, portions=portions):
            found = leaves(*arguments)
            portions.append(found.portions)
            return found

        motions.leaves = counted
        boxes = tiles.sets(chosen)
        states = (np.insert(x, x.shape[1] - 1, 0.0, axis=1) for x in vars(boxes).values())
        led = motions.lead(
            ManySets(*states), "slip-slip", (), lambda _, *box: section.covered(sums, *box)
        )
        assert led == (verdict == 2)
        followed.append(sum(portions))
        assert followed[-1] < motions.most * (len(chosen) / 4 + 2)
    assert followed[1] > followed[0]


X, Z = sp.symbols("x z", real=True)


def relay(side, beyond, rate, drift=0, parameters=()):
    """Where x turns at 0 and 1 while z decays; on one side it falls off beyond a boundary."""
    ends, decay = {"up": Boundary("top", X - 1), "down": Boundary("bottom", -X)}, [0, -rate]
    sides = [
        Configuration(
            name,
            FirstOrder([[0, 0], decay], [speed, drift]),
            (ends[name], *[Boundary("beyond", beyond)] * (name == side)),
        )
        for name, speed in (("up", 1), ("down", -1))
    ]
    ways = ("up", "top", "down"), ("down", "bottom", "up"), (side, "beyond", "off")
    return System(
        "relay",
        "x turns at 0 and 1, or falls off",
        (X, Z),
        parameters,
        (*sides, Configuration("off", FirstOrder([[1, 0], decay], [1, 0]), ())),
        tuple(Transition(source, {boundary}, target) for source, boundary, target in ways),
    )


def test_boxes_from_which_nothing_arrives_have_no_rank(tmp_path):
    """At the bottom with z > 0 a state is beyond already: it is in no motion."""
    itinerary = [("down", "bottom"), ("up", "top")]
    system = relay("up", Z - X, 1, sp.Rational(-1, 2))
    orbit = ns.solve(system, guess=[1, 1], itinerary=itinerary)
    box = {"x": (0.25, 0.75), "z": (-0.75, 0.75)}
    content = content_of(ns.certify.basin(orbit, box=box, side=0.25))
    first, exponent = (content["grid"][name][0] for name in ("first", "exponents"))
    ranks = np.array(flat(content["ranks"]))
    beyond = (first + np.arange(len(ranks))) * 2.0**exponent > 0
    assert beyond.sum() > 1
    assert (ranks[beyond] == -1).all()
    ranks[beyond] = 1
    refused_file(
        {**content, "ranks": runs(ranks.tolist())}, tmp_path, "a box of the rank 1 has no image"
    )
