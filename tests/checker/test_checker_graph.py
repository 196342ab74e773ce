"""The check of graphs of boxes: true files pass, and false ones do not."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.derive import Parameter
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.state_sets.many_sets import ManyMotions
from nonsmooth.runtime.model.kernels import load_system
from tests.certified import (
    accepted,
    believed,
    claimed,
    content_of,
    flat,
    refused_file,
    runs,
    signed,
)
from tests.checker.test_checker_basin import X, Z, relay
from tests.friction_sets import DATA
from tests.horseshoes import FRICTION_DATA
from tests.places import GALLERY


@pytest.fixture(scope="module")
def found():
    return ns.certify.region(
        "dry-friction", DATA, [5, 4, 0.5, 0.25], region={"x2": (3.5, 5.5)}, boxes=16, levels=2
    )


@pytest.fixture(scope="module")
def path(found, tmp_path_factory):
    path = tmp_path_factory.mktemp("graph") / "graph.json"
    found.save(path)
    return path


@pytest.fixture
def content(path):
    return content_of(path)


@pytest.mark.slow
def test_a_true_file_is_proved_again_and_loaded(found, path):
    check = ns.certify.check(path)
    assert check.difference is None
    assert check.claims == {"region": "proved"}
    again = ns.load(path)
    assert again.to_json() == found.to_json()
    assert again.graph.grid == found.graph.grid
    for box in range(0, len(found.graph.grid), 7):
        assert set(again.targets(box)) == set(found.targets(box))


def test_a_region_without_an_attractor_is_compared_with_its_system_too(tmp_path):
    system, data = str(GALLERY / "impact_oscillator.py"), {"r": "0.65", "sigma": "0", "w": "2.3"}
    region = {"x": (-0.8, -0.6), "v": (0, 0.2)}
    found = ns.certify.region(system, data, {"x": -0.7, "v": 0.1}, region=region, boxes=4)
    assert found.claim == "undecided"
    assert accepted(found, tmp_path).compared


@pytest.mark.slow
def test_a_true_file_of_two_coordinates_is_proved_again(tmp_path):
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    data, region = {"r": "0.65", "sigma": "0", "w": "2.3"}, {"x": (-2, 0), "v": (-2, 2)}
    found = ns.certify.region(
        system, data, {"x": -0.7, "v": 0.1}, boxes=12, region=region, levels=1
    )
    assert found.proved
    assert found.graph.unknown.any()
    found.save(tmp_path / "graph.json")
    check = ns.certify.check(tmp_path / "graph.json")
    assert check.difference is None
    assert check.claims == {"region": "proved"}
    # a box of unknown image is not called known
    content = json.loads((tmp_path / "graph.json").read_text())
    unknown = found.graph.unknown.astype(int)
    unknown[unknown.argmax()] = 0
    content["unknown"] = [[int(told), 1] for told in unknown]
    refused_file(content, tmp_path, "the image of a box")


def rewritten(content, change):
    """A file of a graph that follows from other edges, with all that is said of them."""
    from nonsmooth.runtime.core.json_codec import encode
    from nonsmooth.runtime.proof.sets.graph_certificate import (
        GraphEntries,
        entries_of,
        stated_graph,
    )

    content = json.loads(json.dumps(content))
    change(content)
    graph = stated_graph(claimed(GraphEntries, content))
    stays = any(graph.stays(own) for own in graph.components)
    content["claim"] = "proved" if stays else "undecided"
    return {**content, **encode(entries_of(graph))}


def without_edges(content, dropped):
    edges = [
        [source, first + k, 1]
        for source, first, count in content["edges"]
        for k in range(count)
        if not dropped(source, first + k)
    ]
    content["edges"] = edges


def test_the_rewritten_file_of_the_same_graph_passes(content, tmp_path):
    same = rewritten(content, lambda content: None)
    assert signed(same) == content


def test_flows_may_be_rounded_otherwise(content):
    believed(signed({**content, "bits": content["bits"] + 33}))


@pytest.mark.slow
def test_a_component_is_not_split(found, content, tmp_path):
    own = found.components[0].boxes
    half = {*own[: len(own) // 2].tolist()}

    def split(content):
        without_edges(content, lambda s, t: (s in half) != (t in half) and {s, t} <= {*own})

    refused_file(rewritten(content, split), tmp_path, "the image of a box")


def test_edges_are_stated_once_and_in_order(content, tmp_path):
    edges = content["edges"]
    refused_file({**content, "edges": [*edges, edges[-1]]}, tmp_path, "edges are not in order")
    refused_file({**content, "edges": edges[::-1]}, tmp_path, "edges are not in order")


def test_boxes_that_hold_no_state_are_no_component():
    start, region = {"x": 0.5, "z": -0.5}, {"z": (-0.9, -0.1)}
    rate = Parameter("k", "rate")
    system = relay("down", X - 1 + Z, rate.symbol, parameters=[rate])
    found = ns.certify.region(system, {"k": 1}, start, "up", region=region, boxes=2)
    content = content_of(found)
    # behind the top with z > 0 a state is beyond already: nothing leads from there
    content |= {"source": "up", "boundary": "top", "configuration": "down"}
    content |= {"grid": {"exponents": [-2], "first": [2], "counts": [2]}, "divided": [[[0, 2]]]}
    none = {"outside": [[0, 2]], "unknown": [[0, 2]], "components": [[0, 2]], "ranks": [[0, 2]]}
    content |= {**none, "trapping": [[1, 2]], "claim": "proved"}
    empty = signed({**content, "edges": [[0, 0, 2], [1, 0, 2]]})
    with pytest.raises(Failure, match="from a box that has no image"):
        believed(empty)


@pytest.mark.slow
def test_what_is_not_trapping_is_not_added(found, content, tmp_path):
    outer = next(k for k in range(len(found.graph.grid)) if k not in found.trapping)

    def alone(content):
        without_edges(content, lambda s, t: s == outer)
        for name in ("outside", "unknown"):
            told = flat(content[name])
            told[outer] = 0
            content[name] = runs(told)

    refused_file(rewritten(content, alone), tmp_path, "the image of a box")
    told = flat(content["trapping"])
    told[outer] = 1
    refused_file({**content, "trapping": runs(told)}, tmp_path, "a trapping region is left")


@pytest.mark.slow
def test_every_edge_counts_where_images_are_sharp(found, content, tmp_path):
    wide = [box for box in range(len(found.graph.grid)) if len(found.targets(box)) > 2]
    for box in wide[:: max(len(wide) // 2, 1)]:
        targets = found.targets(box)
        low, _ = found.graph.grid.bounds(targets)
        inner = int(targets[np.argsort(low[:, 0])[len(targets) // 2]])

        def cut(content, box=box, inner=inner):
            without_edges(content, lambda s, t: (s, t) == (box, inner))

        refused_file(rewritten(content, cut), tmp_path, "the image of a box")
    assert wide


@pytest.mark.slow
def test_an_image_that_leaves_the_region_is_said_to(content, tmp_path):
    def narrower(content):
        # the same boxes, moved by one: their images are others
        content["grid"]["first"][0] += 1

    refused_file(rewritten(content, narrower), tmp_path, "the image of a box")


@pytest.mark.parametrize(
    ("name", "change", "told"),
    [
        ("ranks", lambda told: [max(told)] * len(told), "an edge ascends"),
        ("ranks", lambda told: [x + 1 for x in told], "is not what the other entries give"),
        ("components", lambda told: [-1] * len(told), "an edge ascends"),
        ("components", lambda told: [0] * len(told), "a box is not of its component"),
        ("trapping", lambda told: [0] * len(told), "is not what the other entries give"),
        ("unknown", lambda told: [1] * len(told), "an edge of an unknown image"),
        ("outside", lambda told: [2] * len(told), "a box is so or not"),
        ("outside", lambda told: told[1:], "another number of boxes"),
    ],
)
def test_other_numbers_of_boxes_are_refused(content, tmp_path, name, change, told):
    other = {**content, name: runs(change(flat(content[name])))}
    refused_file(other, tmp_path, told)


@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("coordinates", ["x1"], "coordinates"),
        ("widest", [0.0] * 4, "no limits of sets"),
        ("widest", [1.0] * 3, "no limits of sets"),
        ("longest", 2, "the image of a box"),
        ("boundary", "second-breaks-forward", "no such transition"),
        ("claim", "undecided", "the verdict is another one"),
        ("divided", [[[0, 3]]], "another number of boxes"),
        ("edges", [[0, 0, 10**6]], "an edge leads to no box"),
        ("edges", [], ""),
    ],
)
def test_other_entries_are_refused(content, tmp_path, name, value, told):
    refused_file({**content, name: value}, tmp_path, told)


def test_a_box_is_divided_or_not(content, tmp_path):
    """Other numbers are no way to say that it is not, though they add up to the same."""
    first, *others = content["divided"]
    told = flat(first)
    told[:2] = told[0] + 2, told[1] - 2
    edited = {**content, "divided": [runs(told), *others]}
    refused_file(edited, tmp_path, "a box is divided or not")


@pytest.mark.slow
def test_other_parameters_and_declarations_are_refused(content, tmp_path):
    refused_file({**content, "parameters": {**content["parameters"], "ur1": "4.1"}}, tmp_path, "")
    declared = json.loads(json.dumps(content["declaration"]))
    rows = declared["configurations"]["slip-stick"]["boundaries"]
    rows.pop(next(iter(rows)))
    refused_file({**content, "declaration": declared}, tmp_path, "")


@pytest.mark.slow
@pytest.mark.parametrize("region", [(11.23, 11.25), (5.51, 5.53)])
def test_the_check_follows_sets_at_corners(region, tmp_path):
    """One mass breaks away, or reaches the belt, just as the other one breaks away."""
    found = ns.certify.region(
        "dry-friction", FRICTION_DATA, [1.93, 7.18, 1.18, 1.18], region={"x2": region}, boxes=4
    )
    assert not found.graph.unknown.any()
    assert found.graph.outside.any()
    accepted(found, tmp_path)


def test_values_outside_of_their_domains_are_refused_before_anything_is_followed(
    content, tmp_path, monkeypatch
):
    monkeypatch.setattr(ManyMotions, "leaves", None)
    for name, value in (("V", "-1.0"), ("us1", "-1/2"), ("eta", "0")):
        other = {**content, "parameters": {**content["parameters"], name: value}}
        refused_file(other, tmp_path, "outside its domain")
