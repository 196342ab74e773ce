"""The laws of result files: what is written is read again, and nothing else is."""

import copy
import json
import math
import random
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.result_files import checksum_of
from tests.certified import LOOP, kicked, loop, prove_basin, prove_doubling, prove_graph
from tests.horseshoes import folded_horseshoe
from tests.shared import shared_file
from tests.two_masses import CHAIN, RUBBING

STICK = "dry-friction/global-stick"
TWO_MASSES = CHAIN | {"r": 0.8}


def composed():
    phases = [("free", "first-reaches-stop")]
    return ns.solve(
        "rigid-stop", TWO_MASSES | {"r": 1}, [6.28], itinerary=phases, given={"period": "2*pi"}
    )


def found():
    from nonsmooth import find_orbits

    return find_orbits("dry-friction", RUBBING, 8, transitions=300)


def branch():
    return ns.continue_orbit(ns.solve(STICK), "V", (0.95, 1.05), step=0.1)


@cache
def looped():
    return ns.continue_orbit(loop(), "a", (1.5, 3.5))


def locus():
    of = looped()
    return ns.continue_orbit(of, "r", (0.45, 0.55), event=of.events[-1], step=0.1)


def designed():
    return ns.design(ns.solve(STICK), minimise="period", over={"V": (0.95, 1.05)})


def fitted():
    motion = ns.simulate("rigid-stop", TWO_MASSES, [0, 0, 1.5, 0], until=12)
    known = {name: value for name, value in TWO_MASSES.items() if name != "r"}
    return ns.fit(
        "rigid-stop", {"first-reaches-stop": motion.times[1:]}, parameters=known,
        bounds={"r": (0.5, 1)}, start={"x1": 0, "x2": 0, "v1": 1.5, "v2": 0}, sigma=1e-3,
    )  # fmt: skip


def event():
    of = looped()
    return ns.certify.event(of, of.events[-1])


def swept():
    given = {name: value for name, value in RUBBING.items() if name != "V"}
    start = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
    more = {"state": "x1", "configuration": "slip-stick", "transient": 50, "samples": 4}
    return ns.sweep("dry-friction", given, "V", [0.6, 0.65, 0.7], start, **more)


def census():
    bounds = {"tau1": "2.5", "tau2": "2"}
    return ns.certify.all(kicked(), {"k": 9, "r": "1/3", "a": 10}, bounds, itinerary=LOOP)


def certified():
    return ns.certify.branch(looped())


def proven_map():
    return ns.certify.box(loop(), {"r": ("2/5", "3/5")})


KINDS = {
    "nonsmooth orbit": lambda: ns.solve(STICK),
    "nonsmooth found orbits": found,
    "nonsmooth branch": branch,
    "nonsmooth locus": locus,
    "nonsmooth design": designed,
    "nonsmooth sweep": swept,
    "nonsmooth fit": fitted,
    "nonsmooth certificate": lambda: ns.certify(ns.solve(STICK)),
    "nonsmooth box certificate": proven_map,
    "nonsmooth event certificate": event,
    "nonsmooth certified branch": certified,
    "nonsmooth certified doubling": prove_doubling,
    "nonsmooth basin certificate": prove_basin,
    "nonsmooth chaos certificate": folded_horseshoe,
    "nonsmooth region certificate": prove_graph,
    "nonsmooth census": census,
}
FILES = {**KINDS, "orbit by tables": composed}
# what the file of a proof holds for the checker, and an answer that is shown
MOST = 110  # entries that are all tried: of larger files, those of proofs, some are
FREE = ("parameters", "given", "reasons", "enclosures", "unique", "bounds")  # of names that vary
OPEN = r".*(declaration|closing|margins|admissible)\b.*"


def file_of(kind):
    """A file of a kind, not to be changed."""
    return shared_file(kind, FILES[kind])


@cache
def text_of(kind):
    return file_of(kind).read_text()


def signed(content):
    """With the right checksums."""
    if isinstance(content, dict):
        content = {name: signed(entry) for name, entry in content.items()}
        return {**content, "sha256": checksum_of(content)} if "sha256" in content else content
    return [signed(entry) for entry in content] if isinstance(content, list) else content


@pytest.mark.parametrize("seed", range(5))
def test_numbers_come_back_as_they_were(seed, tmp_path):
    """Numbers of all sizes and both zeros, and what is none where that is let through."""
    rng, sweep = random.Random(seed), ns.load(file_of("nonsmooth sweep"))

    def number():
        return rng.choice([0.0, -0.0, 5e-324, math.nan, rng.gauss(0, 1), rng.gauss(0, 1) * 1e200])

    numbers = np.array([number() for _ in range(sweep.samples.size)]).reshape(sweep.samples.shape)
    replace(sweep, samples=numbers).save(tmp_path / "sweep.json")
    back = ns.load(tmp_path / "sweep.json").samples
    np.testing.assert_array_equal(back, numbers)
    np.testing.assert_array_equal(np.signbit(back), np.signbit(numbers))


SWEEP, PROOF, BRANCH = "nonsmooth sweep", "nonsmooth certificate", "nonsmooth branch"


@pytest.mark.parametrize(
    ("kind", "path", "entry", "told"),
    [
        (SWEEP, "done", 1.0, "'done' is of the wrong type"),
        (SWEEP, "values/1", "nan", "'values/2' is nan, not a finite number"),
        (SWEEP, "samples", [["1.0"], ["1.0", "2.0"]], "'samples' has rows of different lengths"),
        (SWEEP, "parameters/eta", "1/0", "'parameters/eta': '1/0'"),
        (
            SWEEP,
            "parameters/eta",
            "0" * 1001 + "1e99999999",
            "'parameters/eta' has an exponent beyond 10000",
        ),
        (SWEEP, "unheard", 0, "'unheard' is unknown"),
        (PROOF, "claims/existence", "third", "'claims/existence' is 'third', none of proved, re"),
        (PROOF, "itinerary/0", ["x"], "'itinerary/1' is no list of 2"),
        (PROOF, "box/0", {"name": ""}, "'box/1/mid' is missing"),
        (BRANCH, "multipliers/0/0", "1 2 3", "'multipliers/1/1' is '1 2 3', not a number"),
        (SWEEP, "follow", 1, "'follow' is of the wrong type"),
        (SWEEP, "outcomes/1", "1", "'outcomes/2' is of the wrong type"),
        (SWEEP, "start/1", "inf", "'start/2' is inf, not a finite number"),
        (SWEEP, "parameters/eta", 2, "'parameters/eta' is of the wrong type"),
        (PROOF, "bits", math.nan, "'bits' is of the wrong type"),
        (BRANCH, "admissible/0", 1, "'admissible/1' is of the wrong type"),
        (BRANCH, "period/0", "1.0 inf", "'period/1' is '1.0 inf', not a number"),
        (BRANCH, "stability/0", "sure", "'stability/1' is 'sure', none of stable, neutral"),
        (BRANCH, "orbit/digits", "1", "'orbit/digits' is of the wrong type"),
        ("nonsmooth basin certificate", "widest", math.inf, "'widest' is of the wrong type"),
        (BRANCH, "orbit/tables", 1, "'orbit/tables' is of the wrong type"),
    ],
)
def test_what_is_refused_is_named_by_its_path(kind, path, entry, told, tmp_path):
    *above, last = (int(step) if step.isdigit() else step for step in path.split("/"))
    content = parent = json.loads(text_of(kind))
    for step in above:
        parent = parent[step]
    parent[last] = entry
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(signed(content)))
    with pytest.raises(InputError, match=re.escape(f"{file}: {told}")):
        ns.load(file)


def paths_in(content, path=()):
    """Paths of all entries."""
    if path:
        yield path
    parts = content.items() if isinstance(content, dict) else ()
    parts = enumerate(content) if isinstance(content, list) else parts
    for step, entry in parts:
        yield from paths_in(entry, (*path, step))


def changes(content, path):
    """Content without an entry, with it of another type, not finite, or beside an unknown one."""
    *above, last = path

    def changed(change):
        other = copy.deepcopy(content)
        parent = other
        for step in above:
            parent = parent[step]
        change(parent)
        return other

    entry = content
    for step in path:
        entry = entry[step]
    yield changed(lambda parent: parent.__setitem__(last, [[entry]]))
    if isinstance(entry, str) and re.fullmatch(r"-?\d+\.\d+(e[-+]\d+)?", entry):
        yield changed(lambda parent: parent.__setitem__(last, "1.0.0"))
    if isinstance(last, str) and above[-1:] not in ([name] for name in FREE):
        yield changed(lambda parent: parent.__delitem__(last))


def is_proof(kind):
    """Whether files of a kind are proved again."""
    return "certif" in kind or "census" in kind


def refused_by_check(path):
    """Whether nothing of a file is proved again."""
    try:
        return ns.certify.check(path).difference is not None
    except InputError:
        return True


@pytest.mark.parametrize("kind", FILES)
def test_no_entry_is_missing_unknown_or_of_another_type(kind, tmp_path):
    path, content = tmp_path / "file.json", json.loads(text_of(kind))
    rng = random.Random(kind)
    every = [
        p for p in paths_in(content)
        if p[-1] != "sha256" and not re.fullmatch(OPEN, "/".join(map(str, p)))
    ]  # fmt: skip
    alike = {tuple("" if isinstance(step, int) else step for step in p): p for p in every}
    deep = [p for p in alike.values() if len(p) > 1]  # one for each annotation
    if len(deep) > MOST:
        deep = rng.sample(deep, 12)
    tried = [p for p in every if len(p) == 1] + deep
    wrong = [(where, other) for where in tried for other in changes(content, where)]
    wrong.append((("unheard",), {**content, "unheard": ""}))
    for where, other in wrong:
        path.write_text(json.dumps(signed(other)))
        try:
            found = ns.load(path)
            if hasattr(found, "equilibria"):  # one wrong entry leaves the others
                _ = [each.orbit for each in found.orbits]
                _ = [each.equilibrium for each in found.equilibria]
        except InputError as problem:
            told = str(problem)
        else:
            pytest.fail(f"{where} is accepted")
        assert told.startswith(f"{path}: ")
        assert "\n" not in told
        assert not is_proof(kind) or refused_by_check(path), where


@pytest.mark.parametrize("kind", FILES)
def test_no_cut_or_changed_byte_is_read(kind, tmp_path):
    path, text = tmp_path / "file.json", text_of(kind)
    rng = random.Random(13)
    for _ in range(40):
        place = rng.randrange(len(text) - 1)
        letter = chr(rng.randrange(33, 127))
        changed = rng.choice([text[:place], text[:place] + letter + text[place + 1 :]])
        path.write_text(changed)
        try:
            same = json.loads(changed) == json.loads(text)
        except ValueError:
            same = False
        if not same:
            with pytest.raises(InputError):
                ns.load(path)
            assert not is_proof(kind) or refused_by_check(path), changed


@pytest.mark.parametrize("cell", ["[]", "{}", "[[]]", '{"a":0}', "[[[[[0]]]]]"])
def test_text_of_little_but_brackets_is_refused_before_it_becomes_lists(
    cell, tmp_path, monkeypatch
):
    """A list takes some seventy bytes of memory, and two of text."""
    monkeypatch.setattr(json, "loads", lambda *_, **__: pytest.fail("it becomes lists"))
    path = tmp_path / "nested.json"
    path.write_text("[" + ",".join([cell] * 500_000) + "]")
    with pytest.raises(InputError, match=r"nested.json: its lists hold too little"):
        ns.load(path)
