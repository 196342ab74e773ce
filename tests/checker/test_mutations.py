"""No change of a file is accepted that changes what the check shows.

Every entry of every kind of file is changed, removed, doubled, exchanged with its siblings or
joined by a new one, and the checksums are made right again. The check then refuses the file, or
says the very same as before: what it says nothing of are notes and hints, listed here by name.
"""

import copy
import json
import os
import random
import re
import tempfile
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.present.files.kept import save_result
from tests.certified import (
    LOOP,
    forced,
    kicked,
    loop,
    prove_branch,
    rooted,
    signed,
    struck_together,
)
from tests.horseshoes import folded_horseshoe
from tests.shared import shared_file
from tests.tables import slow

SAMPLE = int(os.environ.get("NONSMOOTH_MUTATIONS", "40"))  # of each file; 0 for all of them
STICK = "dry-friction/global-stick"


def _census(**bounds):
    return ns.certify.all(kicked(), {"k": 9, "r": "1/3", "a": 10}, bounds, itinerary=LOOP)


def _events(*branches):
    found = [ns.certify.event(branch, event) for branch in branches for event in branch.events]

    class Several:
        def save(self, path):
            save_result(found, path)

    return Several()


FILES = {
    "derived": lambda: ns.certify(ns.solve(STICK)),
    "unstable": lambda: ns.certify(ns.solve("dry-friction/symmetric")),
    "derivatives": lambda: ns.certify(ns.solve(STICK), derivatives=["eta", "e1"]),
    "derivatives-conservative": lambda: ns.certify(
        ns.solve("elastic-stop/one-contact"), derivatives=["m1", "T"]
    ),
    "derivatives-composed": lambda: ns.certify(loop(k="sqrt(2)"), derivatives=True),
    "conservative": lambda: ns.certify(ns.solve("elastic-stop/one-contact")),
    "irrational-period": lambda: ns.certify(
        ns.solve("rigid-stop/one-impact", {"T": "2*pi", "k1": "sqrt(2)"})
    ),
    "composed": lambda: ns.certify(loop()),
    "irrational": lambda: ns.certify(loop(k="sqrt(2)")),
    "not-admissible": lambda: ns.certify(loop(a="1")),
    "forced": lambda: ns.certify(forced("soft")),
    "struck-together": lambda: ns.certify(struck_together()),
    "twice-forced": lambda: ns.certify(forced("twice")),
    "rooted": lambda: ns.certify(
        ns.solve(rooted(), {"a": "9", "r": "1/2"}, [*[3.1, 1.5], *[0.0, 2.0]], itinerary=LOOP)
    ),
    "rooted-by-a-root": lambda: ns.certify(
        ns.solve(rooted(), {"a": "8", "r": "1/2"}, [*[3.1, 1.5], *[0.0, 2.0]], itinerary=LOOP)
    ),
    "uncertain": lambda: ns.certify(ns.solve("dry-friction/solution-ii")),
    "map": lambda: ns.certify.box(ns.solve(STICK), {"V": ("0.99", "1.01"), "e1": ("3", "3.04")}),
    "map-of-tiles": lambda: ns.certify.box(
        loop(a="11/5"), {"a": ("17/10", "23/10"), "r": ("9/20", "11/20")}, tiles=9
    ),
    "map-irrational": lambda: ns.certify.box(loop(k="sqrt(2)"), {"r": ("2/5", "3/5")}),
    "map-conservative": lambda: ns.certify.box(
        ns.solve("rigid-stop/one-impact", {"T": "6.3"}),
        {"T": ("6.2", "6.4"), "m1": ("0.99", "1.01")},
    ),
    "events": lambda: _events(
        ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3)),
        ns.continue_orbit(loop(k="sqrt(2)"), "a", (1.2, 3.5)),
    ),
    "branch": lambda: ns.load(shared_file("branch of friction", prove_branch)),
    "branch-vanishing": lambda: ns.certify.branch(
        ns.continue_orbit(ns.solve(STICK, {"V": "1.18"}), "V", (1.1, 1.3)), interval=("1.1", "1.3")
    ),
    "census": lambda: _census(tau1="2.5", tau2="2"),
    "census-conservative": lambda: ns.certify.all(
        "elastic-stop/one-contact", box={"tau": 10, "tau1": 10}
    ),
    "chaos": lambda: ns.load(shared_file("nonsmooth chaos certificate", folded_horseshoe)),
    "census-derived": lambda: ns.certify.all(
        STICK, box={"tau": ("1.9", "2.1"), "tau1": ("1.5", "1.6")}
    ),
}

# what the check says nothing of: notes for people, and hints where it looks
NOTES = (
    r".*package",
    r".*\breasons?\b.*",  # that there is one is checked
    r".*\bchosen\b.*",  # that the orbit leaves them open is checked
    r"events/\d+/text",
    r"tiles/\d+/looked_at",
    r"start",  # of a branch: from which of its tiles it was followed
    r"tried.*",  # of the search for chaos
    r"no_derivatives.*",
)
HINTS = (
    r".*\bbits",
    r".*box/\d+/(mid|rad)",  # of unknowns
    r"tiles/\d+/guess.*",
    r"tiles/\d+/(centre|radii)/.*",  # another tube around the same orbits
    r"tiles/\d+/event/window/.*",
    r".*closing/(dropped|form|constants).*",  # any energy serves
    r".*margins(/\d+|/\d+/least)?",
)
# what is changed into another truth, which is proved
TRUE = (
    r"(.*/)?(enclosures/[^/]+|derivatives/[^/]+/[^/]+)/rad",  # sharper, of what is exactly so
    r"derivatives/multiplier [12] (re|im)",  # of several proved ones some may be told
    r"derivatives/(x10|v10|v20)",  # zero by both parameters: exchanged
    r"box/[^/]+/[01]",  # a smaller box
    r"enclosures/trace",  # left out where nothing is claimed of stability
    r".*other_multipliers",  # a larger bound, or none
    r"parameters/a",  # where a wall stands that is only looked at
    r".*multipliers/\d+/(re|im)/rad",
)

# of one kind of file: chaos lasts in a neighbourhood of the parameters, and of the sets
LASTING = {"chaos": (r"h_sets.*", r"parameters/.*")}
REORDERED = "exchange coverings"  # who covers whom is told in the order of the file


class Mutation(NamedTuple):
    """A change of what is at a path."""

    path: tuple
    what: str

    def __str__(self):
        return f"{self.what} {'/'.join(map(str, self.path))}"


@cache
def written(name):
    """The file of a kind."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file.json"
        FILES[name]().save(path)
        return path.read_text()


def entries(content, path=()):
    """All entries of a file with their paths."""
    if path:
        yield path, content
    if isinstance(content, dict):
        for name, entry in content.items():
            if name != "sha256":
                yield from entries(entry, (*path, name))
    elif isinstance(content, list):
        for place, entry in enumerate(content):
            yield from entries(entry, (*path, place))


def mutations(content):
    """All changes that are tried."""
    for path, entry in entries(content):
        yield Mutation(path, "remove")
        yield Mutation(path, "duplicate")
        if isinstance(entry, dict | list):
            yield Mutation(path, "add")
            yield Mutation(path, "empty")
            if len(entry) > 1 and not (
                isinstance(entry, dict) and {*entry} == {"mid", "rad"}
            ):  # that is a wider ball
                yield Mutation(path, "exchange")
        else:
            yield Mutation(path, "change")
            yield Mutation(path, "retype")


def mutated(content, mutation, drawn):
    """A changed copy; None if nothing is changed."""
    changed = copy.deepcopy(content)
    *above, last = mutation.path
    parent = changed
    for step in above:
        parent = parent[step]
    entry = parent[last]
    match mutation.what:
        case "remove":
            del parent[last]
        case "duplicate" if isinstance(parent, list):
            parent.insert(last, copy.deepcopy(entry))
        case "duplicate":
            parent[f"{last}0"] = copy.deepcopy(entry)
        case "add" if isinstance(entry, dict):
            entry["unheard"] = "0"
        case "add":
            entry.append(copy.deepcopy(drawn.choice(entry)) if entry else "0")
        case "empty":
            parent[last] = type(entry)()
        case "exchange":
            keys = list(entry) if isinstance(entry, dict) else list(range(len(entry)))
            one, other = drawn.sample(keys, 2)
            entry[one], entry[other] = entry[other], entry[one]
        case "retype":
            parent[last] = {"a": 1} if entry is None else [entry]
        case "change":
            parent[last] = other_than(entry, parent, last)
    return None if changed == content else changed


def other_than(entry, parent, last):
    """Another value of the type of an entry, so far away that it cannot be meant."""
    if isinstance(entry, bool):
        return not entry
    if entry is None:
        return 0
    if isinstance(entry, int | float):
        return entry + 1
    if entry in ("proved", "refuted", "undecided"):
        return {"proved": "refuted", "refuted": "proved", "undecided": "proved"}[entry]
    if not re.fullmatch(r"[-+]?\d+(\.\d*)?(e[-+]?\d+)?(/\d+)?", entry):
        return entry + "x"
    number = Fraction(entry)
    if last == "rad":  # much too sharp
        return f"{Fraction(number, 10**6).numerator}/{Fraction(number, 10**6).denominator}"
    if last == "mid":
        number += 10 * Fraction(parent["rad"])
    elif last == "least":
        number = 10 * number + 1
    else:
        number += Fraction(1, 64)
    return str(number)


def renewed(content):
    """With the right checksums."""
    if isinstance(content, dict):
        content = {name: renewed(entry) for name, entry in content.items()}
        return signed(content) if "sha256" in content else content
    return [renewed(entry) for entry in content] if isinstance(content, list) else content


def said(content, path):
    """What is shown, the claims and the note; None if the file is refused."""
    path.write_text(json.dumps(renewed(content)))
    try:
        found = ns.certify.check(path)
    except InputError:
        return None
    if found.difference is not None:
        assert found.certificate is None
        return None
    return found._repr_html_(), found.claims, found.note


def sampled(content, drawn, count):
    """So many mutations, as many of each kind of path as there are of others."""
    found = list(mutations(content))
    if not count or len(found) <= count:
        return found
    groups = {}
    for mutation in found:
        shape = (mutation.what, *(x for x in mutation.path if isinstance(x, str)))
        groups.setdefault(shape, []).append(mutation)
    return [drawn.choice(group) for group in drawn.sample(list(groups.values()), count)]


DEAR = "branch", "branch-vanishing", "census-conservative", "census-derived", "map"
KINDS = [slow(name) if name in DEAR else name for name in FILES]


@pytest.mark.parametrize("name", KINDS)
def test_files_come_back_and_are_covered_by_their_checksum(name, tmp_path):
    first, again = tmp_path / "file.json", tmp_path / "again.json"
    first.write_text(written(name))
    loaded = ns.load(first)
    save_result(list(loaded) if isinstance(loaded, tuple) else loaded, again)
    assert again.read_text() == written(name)
    first.write_text(written(name).replace('"package": "', '"package": "1', 1))
    assert "checksum" in str(ns.certify.check(first).difference)


@pytest.mark.parametrize("name", KINDS)
def test_no_change_of_a_file_is_shown_as_proved(name, tmp_path):
    drawn = random.Random(name)
    content = json.loads(written(name))
    path = tmp_path / "file.json"
    answer = said(content, path)
    assert answer is not None
    true = "|".join((*TRUE, *LASTING.get(name, ())))
    allowed = re.compile("|".join((*NOTES, *HINTS, true)))
    tried = 0
    for mutation in sampled(content, drawn, SAMPLE):
        changed = mutated(content, mutation, drawn)
        if changed is None or str(mutation) == REORDERED:
            continue
        tried += 1
        told = said(changed, path)
        where = "/".join(map(str, mutation.path))
        if told is None:
            continue
        assert told == answer or re.fullmatch(true, where), f"{mutation} is shown"
        assert allowed.fullmatch(where) or name == "uncertain", f"{mutation} is accepted"
    assert tried > 3 * SAMPLE // 4 or name == "uncertain"
