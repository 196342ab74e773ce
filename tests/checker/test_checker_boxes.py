"""The check of maps: true ones pass, and no change that makes a claim false does."""

import copy
import json
import random
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from types import SimpleNamespace

import pytest
from flint import arb, ctx, fmpq

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.ranges.folded import beyond_folds, neighbours
from nonsmooth.runtime.checker.ranges.tiles import CheckedBox, MapTile
from nonsmooth.runtime.checker.stated.parameters import independent
from nonsmooth.runtime.core.rational_functions import symbols
from nonsmooth.runtime.core.result_files import checksum_of
from tests.certified import (
    PAD,
    believed,
    claimed,
    content_of,
    edited,
    loop,
    moved,
    of_files,
    refused,
    saved,
    stating,
)
from tests.checker.test_checker import other_systems
from tests.proof import test_fold_curves

RIGID = "rigid-stop/one-impact"
MAPS = {
    "stick": (
        lambda: ns.solve("dry-friction/global-stick"),
        {"V": ("0.99", "1.01"), "eta": ("0.99", "1.01")},
        9,
    ),
    "flip": (lambda: loop(r="-9/10"), {"r": ("-11/10", "-4/5")}, 17),
    "wall": (lambda: loop(a="11/5"), {"a": ("1/2", "3"), "r": ("1/5", "3/5")}, 11),
    "rigid": (
        lambda: ns.solve(RIGID, {"T": "6.3"}),
        {"T": ("6.2", "6.4"), "m1": ("0.99", "1.01")},
        9,
    ),
    "unstable": (lambda: ns.solve(RIGID, {"T": "6.1", "k2": "1.456"}), {"T": ("6", "6.2")}, 9),
    "forced": (
        lambda: ns.find_orbits(PAD, {"Omega": "0.8"}, 2, transitions=300).orbits[0].orbit,
        {"Omega": ("0.7999", "0.8001")},
        3,
    ),
    "irrational": (lambda: loop(k="sqrt(2)"), {"r": ("2/5", "3/5")}, 3),
    "coarse": (lambda: loop(a="11/5"), {"a": ("17/10", "23/10")}, 1),
}


@cache
def mapped(name):
    orbit, box, tiles = MAPS[name]
    return ns.certify.box(orbit(), box, tiles=tiles)


@cache
def written(name):
    """The file of a map."""
    return json.dumps(content_of(mapped(name)))


@pytest.fixture
def content(request):
    """The entries of the map that a test is about."""
    return json.loads(written(request.param))


def totalled(content):
    """With totals that follow from the tiles, and the checksum made right again."""
    told = claimed(type(mapped("stick")), content).to_json()
    content |= {name: told[name] for name in ("claims", "shares", "enclosures")}
    content["sha256"] = checksum_of(content)
    return content


def proved(content):
    return [tile for tile in content["tiles"] if tile["claims"]["existence"] == "proved"]


@of_files(*MAPS)
def test_true_maps_pass(content):
    believed(content)


def test_the_maps_are_of_all_kinds():
    verdicts = {name: mapped(name).shares for name in MAPS}
    assert verdicts["stick"]["proved"] == verdicts["rigid"]["proved"] == 1
    assert verdicts["forced"]["proved"] == verdicts["irrational"]["proved"] == 1
    assert min(verdicts["flip"][name] for name in ("proved", "unstable")) > 0
    kinds = ("proved", "not admissible", "divided", "undecided")
    assert min(verdicts["wall"][name] for name in kinds) > 0
    assert verdicts["unstable"]["unstable"] > verdicts["coarse"]["proved"] == 0


@of_files("stick", "rigid", "forced", "flip")
def test_centres_outside_their_enclosures_are_refused(content):
    for name in content["tiles"][0]["enclosures"]:
        changed = copy.deepcopy(content)
        moved(proved(changed)[-1]["enclosures"][name], Fraction(21, 10))
        refused(totalled(changed), f"{name} is not in its enclosure")


@pytest.mark.slow
@of_files("stick", "rigid", "forced", "irrational")
def test_another_system_has_another_orbit(content):
    for _ in other_systems(content["declaration"], "11/10", 6):
        refused(content)


@of_files("stick", "flip", "rigid", "unstable", "wall", "coarse")
def test_claims_of_another_verdict_are_refused(content, request):
    seen = set()
    if "wall" in request.node.name:  # what was not tried may be true
        seen = {("proved", "undecided", "proved")}
    for place, tile in enumerate(content["tiles"]):
        kind = tuple(tile["claims"].values())
        if kind in seen:
            continue
        seen.add(kind)
        for name in tile["claims"]:
            for verdict in {"proved", "refuted"} - {tile["claims"][name]}:
                changed = copy.deepcopy(content)
                other = changed["tiles"][place]
                claims = other["claims"]
                claims[name] = verdict
                if name == "existence":
                    claims |= dict.fromkeys(("admissibility", "stability"), "undecided")
                other["reasons"] = {n: "so" for n, told in claims.items() if told != "proved"}
                refused(changed)
                refused(totalled(changed), name)


@of_files("flip", "wall")
def test_tiles_of_other_places_are_refused(content):
    for change in (
        lambda tiles: tiles.pop(),
        lambda tiles: tiles.append(tiles[0]),
        lambda tiles: tiles.__setitem__(0, tiles[1]),
        lambda tiles: tiles[0]["place"][0].__setitem__(0, tiles[0]["place"][0][0] + 1),
        lambda tiles: tiles[0]["place"][0].__setitem__(1, tiles[0]["place"][0][1] + 1),
    ):
        changed = copy.deepcopy(content)
        change(changed["tiles"])
        refused(changed, "fill|no place")
    changed["tiles"] = [{**content["tiles"][0], "place": [[0, 61]] * len(content["box"])}]
    refused(changed, "tiny tiles")
    verdicts = [tuple(tile["claims"].values()) for tile in content["tiles"]]
    first, second = next(
        (i, j)
        for i, a in enumerate(verdicts)
        for j, b in enumerate(verdicts)
        if a != b and "undecided" not in (*a, *b)
    )
    tiles = content["tiles"]
    tiles[first]["place"], tiles[second]["place"] = tiles[second]["place"], tiles[first]["place"]
    refused(totalled(content), "in the tile")


@of_files("stick", "rigid", "forced")
def test_guesses_in_other_places_are_refused(content):
    size = len(content["tiles"][0]["guess"])
    for guess in ([0.0] * size, [3.0] * size, [0.5] * (size - 1)):
        content["tiles"][0]["guess"] = guess
        refused(content, "in the tile")


@pytest.mark.slow
@of_files("stick", "rigid", "forced", "flip", "wall", "irrational")
def test_wider_boxes_are_refused(content):
    for name in content["box"]:
        changed = copy.deepcopy(content)
        low, high = map(Fraction, changed["box"][name])
        changed["box"][name][1] = str(high + (high - low) / 2)
        if name != "a":  # more of the wall's places are as harmless
            refused(changed, "in the tile")
        changed["box"][name] = [str(high), str(low)]
        refused(changed, "the box is empty")


def undecided(tile):
    tile["claims"] = dict.fromkeys(tile["claims"], "undecided")
    tile["reasons"] = dict.fromkeys(tile["claims"], "so")


def nothing():
    """The file of a map that has no declaration."""
    orbit = ns.solve("dry-friction/solution-ii")
    return content_of(ns.certify.box(orbit, {"V": ("0.9", "1.1")}))


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda _, tile: tile.update(looked_at=False), "was not looked at"),
        (lambda _, tile: undecided(tile), "enclosures of no orbit"),
        (lambda content, _: content.update(stability="neutral"), "stability of another kind"),
        (
            lambda _, tile: tile.update(guess=[1.15 * x for x in tile["guess"]]),
            "not near the numbers",
        ),
        (lambda _, tile: tile["enclosures"].pop("trace"), "not those of the unknowns"),
        (
            lambda _, tile: tile["enclosures"].update(more=tile["enclosures"]["trace"]),
            "not those of the unknowns",
        ),
        (lambda content, _: content["box"].update(V=["1", "1"]), "the box is empty"),
    ],
)
def test_what_a_tile_states_is_whole(change, told):
    content = json.loads(written("stick"))
    change(content, content["tiles"][0])
    refused(totalled(content), told)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda content: None, None),
        (stating(stability="neutral"), "stability of another kind"),
        (stating(closing={"kind": "state"}), "about no declaration"),
        (
            stating("tiles", 0, enclosures={"period": {"mid": "1", "rad": "1"}}),
            "enclosures of no orbit",
        ),
    ],
)
def test_of_no_declaration_nothing_is_stated(change, told):
    content = nothing()
    assert not content["declaration"]
    change(content)
    if told is None:
        believed(content)
    else:
        refused(content, told)


@pytest.mark.parametrize("beside", [True, False])
def test_tiles_that_meet_are_of_one_orbit(beside):
    """Of two orbits next to a fold the one in a tile is not the other one in the next tile."""
    ends = ("-613/500", "-49/40", "-153/125")
    halves = [
        content_of(
            ns.certify.box(
                test_fold_curves.orbit(stable),
                {"sigma": ends[k : k + 2], "r": ("0.7999", "0.8001")},
            )
        )
        for k, stable in enumerate((True, beside))
    ]
    content, (tile,) = halves[0], halves[1]["tiles"]
    content["box"]["sigma"] = [ends[0], ends[2]]
    content["tiles"].append(tile)
    for k, own in enumerate(content["tiles"]):
        own["place"][[*content["box"]].index("sigma")] = [k, 1]
    if beside:
        believed(totalled(content))
    else:
        refused(totalled(content), "not that of a tile beside it")


def test_constants_may_not_depend_on_each_other():
    parameter, constant = symbols(["p", "c"])
    box = [(fmpq(0), fmpq(1))]
    for divisor, alright in (
        (constant, True), (parameter * constant - 1, True), (constant * constant - 2, False),
    ):  # fmt: skip
        declared = SimpleNamespace(exactly=SimpleNamespace(divisors=[fmpq(3), divisor]))
        if alright:
            independent(declared, [arb(2).sqrt()], box)
            continue
        independent(declared, [], box)  # there it may stand for a parameter
        with pytest.raises(Failure, match="depend"):
            independent(declared, [arb(2).sqrt()], box)


@of_files("rigid", "unstable")
def test_what_is_kept_is_not_taken_for_granted(content):
    for change in (
        {"kind": "state", "dropped": -1},
        {"kind": "state"},
        {"dropped": 7},
        {"form": [["0"] * 4] * 4},
        {"period": "6"},
        {"form": [["0", "1", "0", "0"], *content["closing"]["form"][1:]]},
    ):
        refused({**content, "closing": {**content["closing"], **change}})
    reset = content["declaration"]["transitions"][0]["reset"]
    assert reset[2][2] == "-1"
    reset[2][2] = "-9/10"
    refused(content, "a reset keeps neither energy nor form")


@of_files("flip")
def test_totals_follow_from_the_tiles(content):
    refused(edited(content, stating("claims", stability="proved")), "stability of the box")
    more = content["shares"]["proved"] + 1e-9
    refused(edited(content, stating("shares", proved=more)), "shares")
    for name, ball in content["enclosures"].items():
        half = f"{round(Fraction(ball['rad']) * 10**30 / 2)}e-30"
        refused(edited(content, stating("enclosures", name, rad=half)), f"{name} of the box")
    del content["tiles"][0]["enclosures"]["trace"]
    refused(content, "enclosures of the box")


@pytest.mark.parametrize("seed", range(12))
def test_no_false_enclosure_passes(seed):
    """Of the kicked mass all is known: it begins with v0 = 1/(1 - r), and r is its trace."""
    drawn = random.Random(seed)
    content = json.loads(written("flip"))
    tile = drawn.choice(proved(content))
    (step, level), (low, high) = tile["place"][0], map(Fraction, content["box"]["r"])
    width = (high - low) / 2**level
    ends = low + step * width, low + (step + 1) * width
    name, true = drawn.choice([("trace", ends), ("v0", (1 / (1 - ends[0]), 1 / (1 - ends[1])))])
    middle, radius = sum(true) / 2, (true[1] - true[0]) / 2
    middle += radius * Fraction(drawn.uniform(-0.3, 0.3))
    size = radius * Fraction(drawn.uniform(0.5, 1.6))
    stated = {
        "mid": f"{round(middle * 10**30)}e-30", "rad": f"{round(size * 10**30)}e-30",
    }  # fmt: skip
    tile["enclosures"][name] = stated
    totalled(content)
    if middle - size > true[0] or middle + size < true[1]:
        refused(content, f"{name} is not in its enclosure")
    elif middle - size < true[0] - radius / 50 and middle + size > true[1] + radius / 50:
        believed(content)  # smaller tiles tell


def test_the_orbit_is_the_same_on_all_of_a_tile(monkeypatch):
    """With halves exchanged all enclosures hold, of orbits that are not those of the tile."""
    content = json.loads(written("flip"))
    tile = proved(content)[0]
    (step, level), (low, high) = tile["place"][0], map(Fraction, content["box"]["r"])
    first, last = (low + (step + k) * (high - low) / 2**level for k in (0, 1))
    ends = 1 / (1 - first), 1 / (1 - last)
    middle, radius = sum(ends) / 2, abs(ends[1] - ends[0]) / 2
    entry = tile["enclosures"]["v0"]  # so narrow that halves tell
    entry["mid"], entry["rad"] = (f"{round(x * 10**30)}e-30" for x in (middle, radius * 101 / 100))
    totalled(content)
    believed(content)
    whole = tuple(fmpq(*x.as_integer_ratio()) for x in (first, last))
    orbit, seen = MapTile._orbit, []

    def exchanged(self, where, guess):
        (here,) = where
        if self.tile is tile and here != whole:
            seen.append(here)
            where = [tuple(sum(whole) - x for x in reversed(here))]
            guess = [arb(x) for x in tile["guess"]]
        return orbit(self, where, guess)

    monkeypatch.setattr(MapTile, "_orbit", exchanged)
    refused(content, "another orbit is found on a part of it")
    assert seen


@of_files("stick", "rigid")
def test_a_map_is_compared_with_its_system(content, tmp_path):
    path = saved(content, tmp_path / "map.json")
    found = ns.certify.check(path)
    assert (found.difference, found.note) == (None, None)
    assert found.certificate.to_json() == ns.load(path).to_json()
    fixed = next(name for name in content["parameters"] if name not in content["box"])
    changed = copy.deepcopy(content)
    changed["parameters"][fixed] = f"{content['parameters'][fixed]}+1/1000"
    assert ns.certify.check(saved(changed, tmp_path / "other.json")).difference is not None
    # a boundary that is never near may stand elsewhere: only the system tells
    name, entry = next(iter(changed["declaration"]["configurations"].items()))
    entry["boundaries"]["new"] = [*["0"] * len(changed["declaration"]["states"]), "-1"]
    changed["parameters"] = content["parameters"]
    told = ns.certify.check(saved(changed, tmp_path / "other.json")).difference
    assert "declaration is not that of" in str(told), name


OWN = """
import sympy as sp
from nonsmooth.derive import Itinerary, Parameter, Reference, RigidStop, oscillator, Harmonic

r = Parameter("r", "restitution", lower=0, upper=1)
F = Parameter("F", "amplitude")
k = Parameter("k", "stiffness", lower=0)
system = oscillator(
    "own", ["x"], [[1]], [[k.symbol]], [["1/10"]], forcing=[Harmonic("13/5", (F.symbol,))],
    elements=[RigidStop("x", 0, r.symbol, name="stop")], parameters=[r, F, k],
)
data = Reference({"r": "4/5", "F": "7/10", "k": "sqrt(1.01)"}, {"T": "2.4"})
orbits = [Itinerary("loop", system, [("free", "stop-reaches-stop", "T")], reference=data)]
"""


def test_a_map_of_a_users_file(tmp_path):
    source, path = tmp_path / "own.py", tmp_path / "map.json"
    source.write_text(OWN)
    orbit = ns.solve(f"{source}:loop")
    ns.certify.box(orbit, {"r": ("0.78", "0.82")}, tiles=5).save(path)
    source.unlink()
    found = ns.certify.check(path)
    assert found.difference is None
    assert "no declaration was run" in str(found.note)
    source.write_text(OWN)
    found = ns.certify.check(path, f"{source}:loop")
    assert (found.difference, found.note) == (None, None)
    source.write_text(OWN.replace('"1/10"', '"1/11"'))
    assert ns.certify.check(path).difference is None
    told = str(ns.certify.check(path, f"{source}:loop").difference)
    assert "is not that of the file, or has changed" in told


def test_a_state_of_another_system_is_not_resumed(tmp_path):
    source = tmp_path / "own.py"
    source.write_text(OWN)
    box = {"r": ("0.78", "0.82")}
    state = ns.certify.box(ns.solve(f"{source}:loop"), box, tiles=1)
    source.write_text(OWN.replace('"1/10"', '"3/10"'))
    with pytest.raises(InputError, match="another declaration"):
        ns.certify.box(ns.solve(f"{source}:loop"), box, resume=state)


def test_a_map_with_tiles_of_no_orbit_passes():
    orbit = ns.solve("dry-friction/symmetric")
    found = ns.certify.box(orbit, {"V": ("0.6", "1.3"), "eta": ("3.8", "4.2")}, tiles=2)
    assert {"existence"} in [set(tile.reasons) for tile in found.tiles]
    content = content_of(found)
    believed(content)
    tile = next(t for t in content["tiles"] if t["claims"]["existence"] == "undecided")
    tile["reasons"] = {"stability": "so"}
    refused(content, "reasons for other claims")


def ends(place):
    """Where a tile is in the box, which is 0 to 1 along each axis."""
    return [(Fraction(step, 2**level), Fraction(step + 1, 2**level)) for step, level in place]


def beyond(event, place, edge):
    """Whether points of an edge of the tile of a fold are beyond the fold, as far as is seen."""
    axis, sign = event["axis"] - 1, 1 if event["above"] == "beyond a fold" else -1
    units = [
        [(2 * x - low - high) / (high - low) for x in part]
        for part, (low, high) in zip(edge, ends(place), strict=True)
    ]
    low, high = units[1 - axis]
    along = [low + (high - low) * Fraction(k, 16) for k in range(17)]
    curve = [sum(Fraction(c) * t**k for k, c in enumerate(event["centre"])) for t in along]
    return all((x - c) * sign > event["radius"] for x in units[axis] for c in curve)


@pytest.mark.parametrize("steep", [True, False])
@pytest.mark.parametrize("seed", range(30))
def test_open_tiles_are_beyond_folds_where_nothing_else_is_beside_them(seed, steep):
    """And always there, if the curve only rises or falls."""
    drawn, places = random.Random(seed), [[(0, 0), (0, 0)]]
    for _ in range(drawn.choice((3, 12, 60))):
        place = places.pop(drawn.randrange(len(places)))
        axis = drawn.randrange(2)
        step, level = place[axis]
        for half in (0, 1):
            places.append([*place[:axis], (2 * step + half, level + 1), *place[axis + 1 :]])
    verdicts = [drawn.choice(("undecided", "divided")) for _ in places]
    events = []
    for _ in places:
        centre = [drawn.randint(-16, 16) / 8, 0.0, *(drawn.randint(-4, 4) / 8 for _ in "ab")]
        bends = 2 * abs(centre[2]) + 3 * abs(centre[3])
        centre[1] = drawn.choice((-1, 1)) * (bends + 1 / 8 if steep else bends / 2)
        above, axis = drawn.choice(("beyond a fold", "stable")), drawn.choice((1, 2))
        event = {"kind": "fold", "centre": centre, "radius": 5 / 16, "above": above, "axis": axis}
        events.append(drawn.choice((event, event, event, None)))
    beside = [set() for _ in places]
    true = [set() for _ in places]  # of what is beside open tiles, but open ones
    for k, other in permutations(range(len(places)), 2):
        pairs = zip(ends(places[k]), ends(places[other]), strict=True)
        edge = [(max(low, least), min(high, most)) for (low, high), (least, most) in pairs]
        shortest, longest = sorted(high - low for low, high in edge)
        if shortest == 0 < longest:
            beside[k].add(other)
            if verdicts[other] != "undecided":
                event = events[other]
                true[k].add(bool(event) and beyond(event, places[other], edge))
    found = neighbours(places)
    assert [sorted(others) for others in found] == [sorted(others) for others in beside]
    tiles = [{"event": e, "place": place} for e, place in zip(events, places, strict=True)]
    answers = beyond_folds(tiles, verdicts, found)
    for k, verdict in enumerate(verdicts):
        group, before = {k}, set()
        while group != before:
            before, group = (
                group,
                group.union(
                    other for one in group for other in beside[one] if verdicts[other] == verdict
                ),
            )
        own = verdict == "undecided" and set().union(*(true[one] for one in group)) == {True}
        assert answers[k] == own if steep else answers[k] <= own


@pytest.mark.parametrize("bend", [-1.5, 0.0])
def test_an_edge_that_a_curve_passes_twice_is_not_beyond_it(bend):
    event = {"kind": "fold", "centre": [0.0, 0.0, bend], "radius": 0, "above": "", "axis": 1}
    tiles = [{"event": own, "place": [(k, 1), (0, 0)]} for k, own in enumerate((None, event))]
    assert beyond_folds(tiles, ("undecided", ""), [[1], [0]]) == [not bend, False]


@pytest.mark.slow
def test_a_fold_is_where_orbits_meet_and_not_amid_their_tube():
    """The tube is moved along the two orbits, and the curve to where the parameter then is."""
    content = content_of(test_fold_curves.small())
    (event,) = (tile["event"] for tile in content["tiles"])
    believed(content)
    fold = CheckedBox(content).proved(content["tiles"][0]).fold
    point = next(p for p in product((fmpq(-1), fmpq(1)), repeat=2) if fold.claims_at(p))
    with ctx.workprec(64):
        own = fold.at(point)
        other = "above" if fold.sheets.sheet == "below" else "below"
        fold.sheets = fold.sheets._replace(sheet=other)
        assert fold.holds(point, fold.at(point))
        assert not fold.holds(point, own)
    event["fold"]["centre"][0] += event["fold"]["half"] / 250
    event["centre"][0] += 3.1536e-5
    event["radius"] = 1.5e-5
    refused(content, "they may meet beside the band")
