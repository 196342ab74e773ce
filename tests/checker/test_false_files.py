"""Files that say what is not so, in all places at once: none of them is proved again."""

import copy
import json
from functools import cache

import pytest

import nonsmooth as ns
from nonsmooth import InputError
from tests.certified import content_of, stating
from tests.checker.test_mutations import renewed, written
from tests.file_shapes import KEPT, file_shapes
from tests.proof.test_parameter_derivatives import damped_at_zero
from tests.tables import slow

STICK = "dry-friction/global-stick"


@cache
def text_of(name):
    """A file of a kind."""
    if name != "derivatives-family":
        return written(name)
    return json.dumps(content_of(ns.certify(damped_at_zero(), derivatives=True)))


def content_named(name):
    """The content of a file; of several branches' events those of the first one."""
    content = json.loads(text_of(name))
    if name == "events":
        content["events"] = content["events"][:2]
    return content


def exchanging(one, other):
    """A change of a file: all names and texts with two words exchanged."""

    def exchanged(content):
        text = json.dumps(content)
        for old, new in ((one, "\0"), (other, one), ("\0", other)):
            text = text.replace(json.dumps(old), json.dumps(new))
        return json.loads(text)

    return exchanged


def refusal(content, path):
    """What the check says of content with the right checksums."""
    path.write_text(json.dumps(renewed(content)))
    try:
        return ns.certify.check(path).difference
    except InputError as problem:
        return str(problem)


def census_at(content):
    content["parameters"]["chi"] = "0.6"
    content["statement"] = content["statement"].replace("chi = 0.5", "chi = 0.6")


def smaller_box(content):
    content["box"] = [side.replace("tau <= 2.1", "tau <= 1.95") for side in content["box"]]
    content["statement"] = content["statement"].replace("tau <= 2.1", "tau <= 1.95")


def one_more(content):
    orbit = {"unique": content["orbits"][0]["unique"], "certificate": None, "reason": ""}
    content["orbits"].append(orbit)
    content["count"] = 2
    content["statement"] = content["statement"].replace("exactly 1 orbit", "exactly 2 orbits")


def no_orbit(content):
    content |= {"orbits": [], "count": 0, "admissible": 0}
    told = content["statement"].replace("exactly 1 orbit", "exactly 0 orbits")
    content["statement"] = told.replace("1 admissible", "0 admissible")


def turned(content, quantity, name):
    """A derivative with its sign turned."""
    found = content["derivatives"][quantity][name]
    middle = found["mid"]
    found["mid"] = middle[1:] if middle.startswith("-") else f"-{middle}"


def renamed(content, old, new):
    """Derivatives that are said to be by another parameter, along the same direction."""
    for entry in (*content["derivatives"].values(), content["directions"]):
        entry[new] = entry.pop(old)


def no_family(content):
    """Derivatives by a damping, with which there is no such orbit: as of the equations alone."""
    content["directions"]["c"] = {"c": "1"}
    for rates in content["derivatives"].values():
        rates["c"] = {"mid": "0", "rad": "1000"}


FALSE = {
    "census-derived": {
        "census at another parameter": census_at,
        "census in a smaller box": smaller_box,
        "census with an orbit without certificate": one_more,
        "label of the census": exchanging(STICK, "dry-friction/symmetric"),
    },
    "derived": {
        "names of the point": exchanging("x10", "x20"),
        "velocities of the point": exchanging("v10", "v20"),
        "dwell times of the point": exchanging("tau", "tau1"),
        "parameters of the point": exchanging("chi", "eta"),
        "label of the point": exchanging(STICK, "dry-friction/symmetric"),
        "a parameter of the point": stating("parameters", eta="1.01"),
        "chosen": stating(chosen=["chi"]),
        "a period": stating(given_period="7.87"),
        "multipliers twice": lambda c: c["multipliers"].append(c["multipliers"][0]),
    },
    "map": {
        "names of the map": exchanging("x10", "x20"),
        "dwell times of the map": exchanging("tau", "tau2"),
        "parameters of the map": exchanging("V", "eta"),
        "label of the map": exchanging(STICK, "rigid-stop/one-impact"),
        "chosen in the map": stating(chosen=["chi"]),
        "V of a map": stating("parameters", V="9"),
    },
    "events": {
        "names of the events": exchanging("x10", "x20"),
        "dwell times of the events": exchanging("tau", "tau1"),
        "V of an event": stating("events", 0, "parameters", V="9"),
        "another kind of event": stating("events", 0, kind="fold"),
    },
    "composed": {
        "a period that is true": stating(given_period="3*pi/2"),
    },
    "unstable": {
        "reasons": stating(reasons={}),
    },
    "derivatives": {
        "a derivative of another sign": lambda c: turned(c, "tau", "eta"),
        "a derivative of the trace": lambda c: turned(c, "trace", "e1"),
        "a derivative of a multiplier": lambda c: turned(c, "multiplier 1 re", "eta"),
        "a derivative of the start": lambda c: turned(c, "x20", "e1"),
        "derivatives by others": lambda c: renamed(c, "eta", "chi"),
        "derivatives by the same": lambda c: renamed(c, "e1", "ur1"),
        "a direction that is longer": stating("directions", e1={"ur1": "2"}),
        "another direction": stating("directions", e1={"us1": "-1"}),
        "a direction of nothing": stating("directions", e1={}),
        "a direction of a period": stating("directions", e1={"period": "1"}),
        "no directions": lambda c: c.pop("directions") and c,
        "derivatives of fewer": lambda c: c["derivatives"].pop("tau") and c,
    },
    "derivatives-family": {
        "derivatives of no family": no_family,
    },
}  # fmt: skip


@pytest.mark.parametrize(
    ("kind", "name"),
    [slow(kind, name, when=kind == "census-derived") for kind in FALSE for name in FALSE[kind]],
)
def test_false_files_are_refused(kind, name, tmp_path):
    change = FALSE[kind][name]
    content = content_named(kind)
    assert refusal(content, tmp_path / "same.json") is None
    changed = copy.deepcopy(content)
    changed = change(changed) or changed
    assert changed != content
    assert refusal(changed, tmp_path / "changed.json") is not None


@pytest.mark.parametrize(
    ("name", "change", "told"),
    [
        ("census-derived", no_orbit, "an orbit of the box is not listed"),
        ("derived", exchanging("dry-friction", "nowhere.py"), "unknown system 'nowher"),
        ("derived", stating(bits=128_000), "128000 bits are more than the"),
        ("events", stating("events", 0, bits=128_000), "128000 bits are more than the"),
    ],
)
def test_why_a_file_is_refused(name, change, told, tmp_path):
    content = content_named(name)
    assert told in str(refusal(change(content) or content, tmp_path / "false.json"))


def test_names_that_are_there_twice_are_refused(tmp_path):
    path = tmp_path / "twice.json"
    path.write_text(text_of("derived").replace('"chi": "0.5"', '"chi": "0.6", "chi": "0.5"', 1))
    with pytest.raises(InputError, match="'chi' is there twice"):
        ns.certify.check(path)


@pytest.mark.parametrize(
    ("name", "told"),
    [("value", "undecided and has no value"), ("trace", "existence is undecided")],
)
def test_what_is_undecided_has_no_numbers(name, told):
    found = ns.certify(ns.solve("dry-friction/solution-ii"))
    if name == "value":
        branch = ns.continue_orbit(ns.solve("rigid-stop/one-impact"), "T", (5.5, 7.5))
        proofs = (ns.certify.event(branch, event) for event in branch.events)
        found = next(proof for proof in proofs if not proof.proved)
    with pytest.raises(InputError, match=told):
        getattr(found, name)


def test_the_shapes_of_files_are_those_of_their_records():
    """Else `python -m tests.file_shapes` writes them anew."""
    assert json.loads(KEPT.read_text()) == file_shapes()
