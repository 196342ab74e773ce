"""Periodic orbits that live in a system: the known ones are found, and what is found is one."""

import json
from functools import cache

import numpy as np
import pytest
import sympy as sp

from nonsmooth import InputError, chart, find_orbits, load, simulate, solve
from nonsmooth.derive import RigidStop
from tests.certified import edited as content_edited
from tests.certified import placing, stating
from tests.explore.listed import check_listed
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.two_masses import CHAIN, RUBBING, STICKING

# the engine in Python takes minutes for these starts; test_cli_motions has a short one
pytestmark = pytest.mark.compiled


@cache
def found(name):
    data, starts = {"A": (STICKING, 800), "B": (RUBBING, 50)}[name]
    return find_orbits("dry-friction", data, starts, transitions=1500, rng=1)


def by_period(name, period):
    (orbit,) = (o for o in found(name).orbits if abs(o.period - period) < 1e-3)
    return orbit


# --- what is known to live there


# the kernels of one of the orbits, and of each its period, verdict and share of the starts
KNOWN = {
    "A": (
        "dry-friction/global-stick",
        [(7.868625596740777, "stable", 0.98, 1), (15.100643125310262, "stable", 1e-9, 0.015)],
    ),
    "B": (
        "dry-friction/symmetric",
        [
            *((4.8960, "unstable", 0, 0), (12.5353, "unstable", 0, 0)),
            *((9.5987, "stable", 0.09, 1), (19.4095, "stable", 0.09, 1)),
        ],
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", KNOWN)
def test_what_is_known_to_live_there_is_found(name):
    kernels, known = KNOWN[name]
    for period, verdict, least, most in known:
        entry = by_period(name, period)
        assert entry.verdict == verdict
        assert least <= entry.share <= most
    every = {round(o.period, 4) for o in found(name).orbits if o.verdict == "stable"}
    assert name == "A" or every == {period for period, verdict, *_ in known if verdict == "stable"}
    wanted, mine = solve(kernels), by_period(name, known[0][0]).orbit
    # kernels hold half of a symmetric orbit's phases, or all of them: the period decides
    assert mine.period == pytest.approx(sum(wanted.dwell_times), abs=1e-11)
    assert mine.trace == pytest.approx(wanted.trace, abs=1e-9)


@pytest.mark.slow
def test_a_second_attractor_of_less_than_one_percent_has_known_multipliers():
    multipliers = by_period("A", 15.1006).orbit.multipliers
    np.testing.assert_allclose(multipliers.real, -0.711, atol=5e-4)
    np.testing.assert_allclose(np.abs(multipliers.imag), 0.565, atol=5e-4)


@pytest.mark.slow
def test_a_planted_attractor_is_found_from_a_box():
    target = by_period("A", 15.1006).orbit.states[0]
    box = {n: (x - 1e-3, x + 1e-3) for n, x in zip(("x1", "x2", "v1", "v2"), target, strict=True)}
    near = find_orbits("dry-friction", STICKING, 20, transitions=800, box=box)
    (orbit,) = (o for o in near.orbits if o.starts)
    assert orbit.period == pytest.approx(15.100643125310262, abs=1e-10)
    assert orbit.share == 1
    assert (np.abs(near.starts - target) <= 1e-3).all()
    np.testing.assert_allclose(near.box.mean(axis=1), target, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", KNOWN)
def test_what_is_listed_is_there_once(name):
    check_listed("dry-friction", found(name))


def test_names_tell_orbits_of_one_period_apart(tmp_path):
    """Those of a chart of basins: beyond their numbers."""
    data, file = {"d": "0.5", "r": "0.8", "w": "1.5"}, tmp_path / "found.json"
    result = find_orbits(str(GALLERY / "two_stops.py"), data, 12, transitions=400)
    result.save(file)
    names = chart(str(file), x=[0.0]).attractor.attrs["meanings"]
    places = [str(k) for k, entry in enumerate(result.orbits, 1) if entry.starts]
    told = [names[place].split(", ", 1)[1] for place in places]
    assert len(told) > 1
    assert len({name.split(", ")[0] for name in told}) == 1
    assert len(set(told)) == len(told)
    assert any("mirror image of 1" in name for name in told)


def test_labels_are_where_the_starts_lead():
    result = found("B")
    for place in range(0, len(result.starts), 11):
        orbit = result.orbits[result.labels[place]].orbit
        motion = simulate("dry-friction", RUBBING, result.starts[place], transitions=1500)
        lasted = motion.times[-1] - motion.times[-1 - len(orbit.itinerary)]
        assert lasted == pytest.approx(orbit.period, rel=1e-6)


# --- seeds, boxes, engines


@pytest.mark.slow
def test_equal_seeds_give_equal_results():
    """As do generators of random numbers, whatever the threads."""
    sources = (4, np.random.SeedSequence(4), np.random.default_rng(4), 5)
    one, *same, other = (
        find_orbits("dry-friction", RUBBING, 10, transitions=600, rng=rng, threads=threads)
        for rng, threads in zip(sources, (1, 2, 1, 1), strict=True)
    )
    for again in same:
        np.testing.assert_array_equal(one.starts, again.starts)
        np.testing.assert_array_equal(one.labels, again.labels)
        assert [o.period for o in one.orbits] == [o.period for o in again.orbits]
    assert (one.starts != other.starts).all()
    assert {round(o.period, 8) for o in one.orbits if o.verdict == "stable"} == {
        round(o.period, 8) for o in other.orbits if o.verdict == "stable"
    }


@pytest.mark.slow
def test_both_engines_find_the_same(monkeypatch):
    results = []
    for backend in ("c", "numpy"):
        monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
        results.append(find_orbits("dry-friction", RUBBING, 1, transitions=130, rng=2))
    for result in results:
        assert {round(o.period, 6) for o in result.orbits if o.starts} <= {9.598694, 19.409498}
    np.testing.assert_array_equal(results[0].starts, results[1].starts)
    np.testing.assert_array_equal(results[0].labels, results[1].labels)


def drawn_from(system, data, box=None):
    """The box in which starts are drawn."""
    return find_orbits(system, data, 1, transitions=2, box=box).box


def test_a_box_reaches_twice_as_far_as_any_boundary():
    limits = drawn_from("rigid-stop", CHAIN | {"r": 1}, {"v2": (-0.5, 0.25)})
    assert limits[0].tolist() == [-2, 2]  # the stop is at 1
    assert limits[3].tolist() == [-0.5, 0.25]
    assert (limits[:, 0] < limits[:, 1]).all()
    friction = drawn_from("dry-friction", STICKING)
    assert friction[2].tolist() == [-2, 2]  # the belt's velocity is 1
    # f1 = x1 - chi x2 reaches ur1 at x1 = ur1, x2 = ur1/chi
    assert friction[1, 1] == pytest.approx(2 * 4.0195 / 0.5)


def test_a_load_says_how_fast_starts_fall_where_nothing_returns():
    gravity, height = sp.symbols("gravity height")
    ground = RigidStop("x", at=-height, restitution=1, side="lower", name="ground")
    ball = one_mass("fallen", ground, stiffness=0, load=[-gravity])
    for g, h in ((9.81, 0.25), (9.81e9, 2.5e-10)):
        limits = drawn_from(ball, {"gravity": g, "height": h})
        assert limits[:, 1].tolist() == pytest.approx([2 * h, 2 * np.sqrt(g * h)], rel=1e-12)
    without_length = drawn_from(str(GALLERY / "bouncing_ball.py"), {"gravity": 9.81, "r": 0.5})
    assert without_length[:, 1].tolist() == [2, 2]


def test_progress_is_told_in_words():
    told = []
    find_orbits("dry-friction", STICKING, 5, transitions=200, progress=told.append)
    assert told[0] == "following 5 starts"
    assert len(told) == 3


def test_starts_inside_the_stop_are_drawn_again():
    result = find_orbits("elastic-stop", CHAIN | {"k3": 1}, 10, transitions=20, box={"x1": (0, 3)})
    assert len(result.starts) == 10
    assert np.unique(result.labels).tolist() != []
    rigid = find_orbits("rigid-stop", CHAIN | {"r": 1}, 10, transitions=20, box={"x1": (-0.5, 2)})
    assert len(rigid.starts) == 10
    assert (rigid.starts[:, 0] <= 1).all()


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"system": "dry-frictoin"}, "did you mean"),
        ({"parameters": {}}, "needs a value"),
        ({"parameters": STICKING | {"us1": 9}}, "does not hold"),
        ({"n": 0}, "n = 0"),
        ({"transitions": 1}, "transitions = 1"),
        ({"threads": 0}, "threads = 0"),
        ({"rng": -1}, "-1 is no seed"),
        ({"box": {"z1": (0, 1)}}, "unknown state 'z1'"),
        ({"box": {"x1": (1, 0)}}, "no interval"),
        ({"box": {"x1": (0, np.inf)}}, "no interval"),
        (
            {"system": "rigid-stop", "parameters": CHAIN | {"r": 1}, "box": {"x1": (2, 3)}},
            "give another box",
        ),
    ],
)
def test_bad_input(changes, match):
    arguments = {"system": "dry-friction", "parameters": STICKING, "n": 5, "transitions": 20}
    with pytest.raises(InputError, match=match):
        find_orbits(**(arguments | changes))


# --- files


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    path = tmp_path_factory.mktemp("found") / "found.json"
    found("B").save(path)
    return path


def test_what_is_saved_comes_back(saved):
    wanted, loaded = found("B"), load(saved)
    assert json.loads(json.dumps(loaded.to_json())) == wanted.to_json()
    for number, entry in enumerate(wanted.orbits, 1):
        for one in (loaded.orbits[number - 1].orbit, load(f"{saved}:{number}")):
            assert (one.unknowns, one.itinerary) == (entry.orbit.unknowns, entry.itinerary)
    with pytest.raises(InputError, match="holds no orbit 99"):
        load(f"{saved}:99")


def edited(path, edit, other):
    """Another file of changed content, with its checksum made right again."""
    other.write_text(json.dumps(content_edited(path, edit)))
    return other


@pytest.mark.parametrize(
    "edit",
    [
        lambda c: c.update(labels=c["labels"][:-1]),
        lambda c: c.update(labels=[99] * len(c["labels"])),
        stating(starts=[["0", "0"]]),
        lambda c: c["box"].pop("x1"),
        stating(system="none"),
    ],
)
def test_signed_nonsense_is_refused_too(saved, tmp_path, edit):
    with pytest.raises(InputError, match=r"nonsense\.json"):
        load(edited(saved, edit, tmp_path / "nonsense.json"))


def of_first(kind, **entries):
    return lambda content: content[kind][0].update(entries)


def moved(content):
    state = content["equilibria"][0]["state"]
    content["equilibria"][0]["state"] = {n: repr(float(x) + 0.5) for n, x in state.items()}


def renamed(content):
    state = content["equilibria"][0]["state"]
    content["equilibria"][0]["state"] = {f"{n}0": x for n, x in state.items()}


NOT_OF_IT = [
    ("orbits", placing("orbits", 0, "dwell_times", 0, "1.5"), "not a solution"),
    ("orbits", lambda c: c["orbits"][0]["dwell_times"].pop(), "do not belong together"),
    ("orbits", lambda c: c["orbits"][0]["states"].pop(), "none of the states"),
    ("orbits", lambda c: [row.pop() for row in c["orbits"][0]["states"]], "none of the states"),
    ("orbits", placing("orbits", 0, "itinerary", 0, 1, "none"), "none"),
    ("orbits", of_first("orbits", itinerary=[]), "none of the states"),
    ("orbits", of_first("orbits", mirror=2), ""),
    ("equilibria", of_first("equilibria", configuration="none"), ""),
    ("equilibria", of_first("equilibria", configuration="stick-stick"), ""),
    ("equilibria", moved, ""),
    ("equilibria", lambda c: c["equilibria"][0]["state"].popitem(), ""),
    ("equilibria", renamed, ""),
    ("equilibria", of_first("equilibria", mirror=2), ""),
    ("orbits equilibria", stating("parameters", chi="0.41"), ""),
]


@pytest.mark.parametrize(("kinds", "edit", "reason"), NOT_OF_IT)
def test_what_is_none_of_its_system_is_refused_and_leaves_the_rest(
    saved, tmp_path, kinds, edit, reason
):
    wanted, path = found("B"), edited(saved, edit, tmp_path / "other.json")
    loaded, first = load(path), len(wanted.orbits) + 1  # number of the first equilibrium
    numbers = {
        "orbits": lambda entry: [*entry.orbit.unknowns.values()],
        "equilibria": lambda entry: entry.equilibrium.state.tolist(),
    }
    for kind, words in (
        ("orbits", "orbit 1, of period "),
        ("equilibria", f"equilibrium {first}, in "),
    ):
        entries, known = getattr(loaded, kind), getattr(wanted, kind)
        if kind not in kinds:
            assert [*map(numbers[kind], entries)] == [*map(numbers[kind], known)]
            continue
        asked = [lambda kind=kind, entry=entries[0]: numbers[kind](entry)]
        asked += [lambda: solve(f"{path}:1")] * (kind == "orbits")
        for ask in asked:
            with pytest.raises(InputError, match=rf"other\.json: {words}.*{reason}"):
                ask()
        assert (entries[0].starts, entries[0].share) == (known[0].starts, known[0].share)
        assert words in loaded._repr_html_()
    assert "refused" in str(loaded)
    with pytest.raises(InputError, match=r"other\.json: "):
        loaded.save(tmp_path / "again.json")
    if "orbits" not in kinds:
        assert solve(f"{path}:1").period == pytest.approx(wanted.orbits[0].period, rel=1e-12)
