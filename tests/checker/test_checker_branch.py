"""The check of a branch: it proves what is so, and refuses a file that was edited."""

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from flint import ctx

import nonsmooth as ns
from nonsmooth.derive import Harmonic, SoftStop, oscillator
from nonsmooth.runtime.checker import Failure, check_branch
from nonsmooth.runtime.checker.ranges.branch import checked_tiles, curve_of
from nonsmooth.runtime.checker.ranges.branch_tile import SHARP, CheckedTile
from nonsmooth.runtime.core.taylor_models import range_of
from tests.certified import certified_over, prove_branch, signed
from tests.shared import shared_file

Content = dict[str, Any]


@pytest.fixture(scope="module")
def content() -> Content:
    path = shared_file("branch of friction", prove_branch)
    assert ns.certify.check(path).claims == {"branch": "proved"}
    found: Content = json.loads(path.read_text())
    return found


@pytest.fixture(scope="module")
def preloaded(tmp_path_factory: pytest.TempPathFactory) -> Content:
    """A tile of which only narrow parts are proved to be stable: a multiplier is near 1."""
    rate = sp.symbols("Omega")
    system = oscillator(
        "preloaded", ["x"], mass=[[1]], damping=[["3/10"]], stiffness=[[1]],
        forcing=[Harmonic(rate, cosine=["11/50"])],
        elements=[SoftStop("x", at="-1/50", stiffness="71/25", damping="2/25", name="pad")],
    )  # fmt: skip
    orbit = ns.find_orbits(system, {"Omega": "0.7"}, 2, transitions=100).orbits[0].orbit
    found = certified_over(orbit, "Omega", "0.7", "0.7185", tiles=1)
    assert [tile.before for tile in found.tiles] == ["stable"]
    path = tmp_path_factory.mktemp("preloaded") / "branch.json"
    found.save(path)
    content: Content = json.loads(path.read_text())
    return content


def with_event(content: Content, kind: str) -> Any:
    return next(tile for tile in content["tiles"] if (tile["event"] or {}).get("kind") == kind)


def drop_a_tile(content: Content) -> None:
    del content["tiles"][3]


def drop_an_event(content: Content) -> None:
    tile = with_event(content, "flip")
    tile["event"] = None
    tile["after"] = tile["before"]
    for other in content["tiles"][content["tiles"].index(tile) + 1 :]:
        other["before"] = other["after"] = tile["before"]


def hide_both_sides(content: Content) -> None:
    tile = with_event(content, "flip")
    tile["event"], tile["before"] = None, tile["after"]


def exchange_the_sides(content: Content) -> None:
    tile = with_event(content, "grazing")
    tile["before"], tile["after"] = tile["after"], tile["before"]


def another_kind(content: Content) -> None:
    with_event(content, "flip")["event"]["kind"] = "neimark-sacker"


def a_fold(content: Content) -> None:
    with_event(content, "flip")["event"]["kind"] = "fold"


def move_the_event(content: Content) -> None:
    event = with_event(content, "flip")["event"]
    event["lower"], event["upper"] = "107/100", "108/100"


def sharpen_the_event(content: Content) -> None:
    ball = with_event(content, "flip")["event"]["enclosures"]["V"]
    ball["rad"] = "1e-60"


def move_the_window(content: Content) -> None:
    with_event(content, "grazing")["event"]["window"] = ["1/10", "1/5"]


def widen_the_window(content: Content) -> None:
    """The function has its one maximum in this window too, but is convex where it begins."""
    with_event(content, "grazing")["event"]["window"] = ["1/10", "2"]


def move_the_tube(content: Content) -> None:
    content["tiles"][4]["centre"][0][0] += 1e-3


def widen_the_tube(content: Content) -> None:
    content["tiles"][4]["radii"] = [10.0 for _ in content["tiles"][4]["radii"]]


def reverse_a_tile(content: Content) -> None:
    content["tiles"][4]["forwards"] = False


def shorten_a_tile(content: Content) -> None:
    content["tiles"][0]["lower"] = "61/100"


def widen_the_interval(content: Content) -> None:
    content["interval"] = ["1/2", "13/10"]


def call_it_stable(content: Content) -> None:
    for tile in content["tiles"]:
        tile["event"] = None
        tile["before"] = tile["after"] = "stable"


def call_a_tile_undecided(content: Content) -> None:
    tile = content["tiles"][4]
    tile["before"] = tile["after"] = "undecided"
    tile["reason"] = "planted"


def forget_an_end(content: Content) -> None:
    content["ends"][1] = ""


def another_parameter(content: Content) -> None:
    content["parameters"]["eta"] = "4.1"


def another_phase(content: Content) -> None:
    with_event(content, "grazing")["event"]["phase"] = 2


def an_event_of_its_own(content: Content) -> None:
    tile = content["tiles"][4]
    tile["event"] = {**copy.deepcopy(with_event(content, "flip")["event"])}


def a_flip_beside_a_grazing(content: Content) -> None:
    with_event(content, "grazing")["event"]["also"] = [["flip", 1, "", ""]]


def divide_a_phase(content: Content) -> None:
    """No phase of this orbit begins where it ends."""
    content["tiles"][4]["divided"] = 1


def end_where_nothing_vanishes(content: Content) -> None:
    content["ends"][0] = "a phase vanishes"


ATTACKS: list[Callable[[Content], None]] = [
    drop_a_tile, drop_an_event, hide_both_sides, exchange_the_sides, another_kind, a_fold,
    move_the_event, sharpen_the_event, move_the_window, widen_the_window, move_the_tube,
    widen_the_tube, reverse_a_tile, shorten_a_tile, widen_the_interval,
    call_it_stable, call_a_tile_undecided,
    forget_an_end, another_phase, an_event_of_its_own, a_flip_beside_a_grazing,
    divide_a_phase, end_where_nothing_vanishes,
]  # fmt: skip


@pytest.mark.slow
def test_a_branch_is_proved_again(content: Content) -> None:
    check_branch(content)


@pytest.mark.parametrize("attack", ATTACKS, ids=lambda attack: attack.__name__)
def test_an_edited_branch_is_refused(content: Content, attack: Callable[[Content], None]) -> None:
    edited = copy.deepcopy(content)
    attack(edited)
    with pytest.raises(Failure):
        check_branch(signed(edited))
    with pytest.raises(Failure, match="checksum"):
        check_branch({**edited, "sha256": content["sha256"]})


def test_other_parameters_are_another_branch(content: Content, tmp_path: Path) -> None:
    edited = copy.deepcopy(content)
    another_parameter(edited)
    path = tmp_path / "edited.json"
    path.write_text(json.dumps(signed(edited)))
    assert ns.certify.check(path).difference is not None


def width(number: Any) -> float:
    return float(abs(range_of(number - number.mid())).upper())


@pytest.mark.slow
def test_a_tile_is_proved_on_parts(content: Content, preloaded: Content) -> None:
    """On each half of a tile the orbits are at least as narrowly enclosed, and are there."""
    for tile in [*checked_tiles(content), *checked_tiles(preloaded)]:
        seen: list[Any] = []

        def prove(point: Any, seen: list[Any] = seen) -> None:
            seen.append(point)
            if len(seen) == 1:
                raise Failure("halve it")

        tile.parts(prove)
        whole, *halves = seen
        for side, half in zip((-1, 1), halves, strict=True):
            with ctx.workprec(192):
                orbit = tile.at(half[tile.place].at([0]).mid())
            e = tile.space.variable(0, side / 2, 1 / 2)
            for before, after, exact in zip(whole, half, orbit, strict=True):
                assert width(after) <= width(before.at([e]))
                assert abs(after.at([0]) - exact) <= width(after) + 2**-40


def test_a_map_that_is_multiplied_by_a_speed_is_the_map_times_it(preloaded: Content) -> None:
    """Also where the equations are divided by a dwell time, and the map needs no speed."""
    curve, seen = curve_of(preloaded), set()
    for divided in (None, 1, 2):
        try:
            tile = CheckedTile(curve, {**preloaded["tiles"][0], "divided": divided})
        except Failure:
            continue
        with ctx.workprec(SHARP):
            orbit = tile.curve.orbit(tile.at_end(tile.low))
            whole, section = orbit.section, orbit.declared.section
            for place in range(2):
                slow, speed = orbit.map_on(*section, slow=place), orbit.speed(place)
                assert abs(speed) > 0
                entries = zip(slow.entries(), whole.entries(), strict=True)
                assert all(x.overlaps(speed * y) and x.rad() < 1e-20 for x, y in entries)
        seen.add(divided)
    assert len(seen) > 1
