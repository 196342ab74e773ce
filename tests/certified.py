"""Orbits to be certified: of users' systems whose numbers are known in closed form, and forced."""

import copy
import json
import math
import random
import re
import sys
import tempfile
from dataclasses import fields
from fractions import Fraction
from functools import cache, reduce
from itertools import groupby
from operator import getitem, setitem
from pathlib import Path
from traceback import walk_stack
from typing import get_type_hints

import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    Harmonic,
    Parameter,
    RigidStop,
    SecondOrder,
    Slider,
    SoftStop,
    System,
    Transition,
    oscillator,
)
from nonsmooth.runtime.checker import CHECKS, Failure
from nonsmooth.runtime.core.json_codec import by
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.model.kernels import load_system
from tests.one_mass import one_mass

x, v = sp.symbols("x v", real=True)
PARAMETERS = (
    Parameter("k", "stiffness on the right"),
    Parameter("r", "what is left of the velocity", lower=-3, upper=3),
    Parameter("a", "place of the wall"),
)
k, r, a = (parameter.symbol for parameter in PARAMETERS)
LOOP = (("right", "falls"), ("left", "rises"))
SPRING_OF_FOUR = SecondOrder([[1]], [[4]])
WALL_AND_KICK = (
    Transition("right", {"wall"}, "right", (), {v: -v}),
    Transition("left", {"rises"}, "right", (), {v: r * v + 1}),
)


def of_files(*names):
    """A test of the content of each of the files of these names."""
    return pytest.mark.parametrize("content", names, indirect=True)


def between_springs(name, sides, more, parameters=(), watched=(), place=0):
    """A mass with one field right of a place, where more may be watched, and another left of it.

    The first transition leads from the right to the left; `more` are those behind it.
    """
    right, left = sides
    return System(
        name,
        "a mass between two springs",
        (x, v),
        tuple(parameters),
        (
            Configuration("right", right, (Boundary("falls", place - x), *watched)),
            Configuration("left", left, (Boundary("rises", x - place),)),
        ),
        (Transition("right", {"falls"}, "left"), *more),
    )


def ticking(matrix, load, *parameters):
    """States at rest, mapped by a matrix and a load each time that a clock comes to 1."""
    *states, clock = sp.symbols(f"y1:{matrix.rows + 1} clock", real=True)
    moved = matrix * sp.Matrix(states) + load * sp.ones(matrix.rows, 1)
    rest = FirstOrder(sp.zeros(matrix.rows + 1), [*[0] * matrix.rows, 1])
    reset = {**dict(zip(states, moved, strict=True)), clock: 0}
    return System(
        "ticking",
        "states that a clock maps",
        (*states, clock),
        parameters,
        (Configuration("rest", rest, (Boundary("tick", clock - 1),)),),
        (Transition("rest", {"tick"}, "rest", (), reset),),
    )


@cache
def kicked():
    """A mass between springs k and 4, kicked where it rises: v -> r v + 1.

    Its orbit begins with v0 = 1/(1 - r), lasts pi/sqrt(k) + pi/2, goes as far as
    v0/sqrt(k), and has the multiplier r. A wall that is only looked at stands at a.
    """
    sides = SecondOrder([[1]], [[k]]), SPRING_OF_FOUR
    return load_system(
        between_springs("kicked", sides, WALL_AND_KICK, PARAMETERS, [Boundary("wall", x - a)])
    )


def loop(**given):
    """Its orbit, at k = 1, r = 1/2, a = 3 unless others are given."""
    values = {"k": "1", "r": "1/2", "a": "3", **given}
    size = 1 / (1 - float(sp.sympify(values["r"])))
    stiffness = float(sp.sympify(values["k"]))
    guess = [math.pi / math.sqrt(stiffness), math.pi / 2]
    return ns.solve(kicked(), values, [*guess, *[0.0, size]], itinerary=LOOP)


@cache
def rooted():
    """As `kicked`, at k = 1, with the wall at the root of a: no rational function of it."""
    sides = SecondOrder([[1]], [[1]]), SPRING_OF_FOUR
    wall = Boundary("wall", x - sp.sqrt(a))
    return load_system(between_springs("rooted", sides, WALL_AND_KICK, PARAMETERS[1:], [wall]))


FORCED = {
    "soft": one_mass(
        "soft", SoftStop("x", "1/2", stiffness=20, damping="4/5"),
        damping="1/10", forces={"13/10": "7/10"},
    ),
    "rigid": one_mass(
        "rigid", RigidStop("x", 0, "4/5"), damping="1/10", forces={"13/5": "7/10"}
    ),
    "slider": one_mass(
        "slider", Slider("x", 3, "1/5"), damping="1/10", stiffness="1/2", forces={"9/10": "3/5"}
    ),
    "twice": oscillator(
        "twice", ["x"], [[1]], [[1]], [["3/10"]],
        forcing=[Harmonic(1, ("7/10",)), Harmonic(2, sine=("3/10",))],
        elements=[SoftStop("x", "1/2", stiffness=20, damping="4/5")],
    ),
}  # fmt: skip


# what reaches nothing touches the pad where the amplitude 2/5 / |1 - Omega^2 + i Omega / 5| is 1
PAD = one_mass(
    "pad", SoftStop("x", at=1, stiffness="1/2", damping="1/20", name="pad"),
    damping="1/5", forces={sp.Symbol("Omega"): "2/5"},
)  # fmt: skip


@cache
def forced(name):
    """What a motion of a forced system comes to, as a periodic orbit."""
    kernels = load_system(FORCED[name])
    size = len(kernels.table["states"])
    cosines = [kernels.table["states"].index(c) for c, _ in kernels.table["forcing"]]
    start = [float(i in cosines) for i in range(size)]
    motion = ns.simulate(kernels, {}, start, until=600.0)
    found = ns.itinerary_of(motion)
    return ns.solve(kernels, {}, itinerary=found)


@cache
def struck(law=None):
    """Two masses, each with a stop, which the mass matrix couples by c."""
    c = Parameter("c", "coupling through the mass matrix", lower="-1/2", upper="1/2")
    system = oscillator(
        f"struck-{law}" if law else "struck", ["x1", "x2"], [[1, c.symbol], [c.symbol, 1]],
        sp.eye(2), sp.eye(2) / 10, forcing=[Harmonic("4/5", {"x1": 3, "x2": 3})],
        elements=[RigidStop("x1", 1, "1/2", name="a"), RigidStop("x2", 1, "1/2", name="b")],
        parameters=(c,), simultaneous_impacts=law,
    )  # fmt: skip
    return load_system(system)


@cache
def struck_together(law=None, coupling="0"):
    """Its symmetric orbit, in which both masses are struck at one instant."""
    kernels, given = struck(law), {"c": coupling}
    motion = ns.simulate(kernels, given, [0, 0, 0.1, 0.1, 1, 0], transitions=200)
    found = ns.itinerary_of(motion)
    return ns.solve(kernels, given, itinerary=found)


def prove_basin():
    """Of a box of starts of the kicked mass, from which motions rise at once, or fall first."""
    box = {"x": (0, 2), "v": (-2, 2)}
    return ns.certify.basin(loop(a="9/4"), box=box, side=0.5)


def prove_branch():
    """Of an orbit with dry friction, from a grazing beyond a flip."""
    return ns.certify.branch(ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3)))


def prove_vanishing():
    """Up to where a contact with a soft stop vanishes, and what is beyond."""
    orbit = ns.find_orbits(PAD, {"Omega": "0.8"}, 2, transitions=300).orbits[0].orbit
    return certified_over(orbit, "Omega", "0.79", "0.805", beyond=True)


def prove_doubling():
    """What branches off at that flip, in one tile."""
    orbit = ns.solve("dry-friction/symmetric", {"V": "1.08"})
    return ns.certify.doubling(ns.continue_orbit(orbit, "V", (1.07, 1.09)), tiles=1)


def prove_graph():
    """Of speeds of the kicked mass, which tend to one."""
    data = {"k": 1, "r": "1/2", "a": 10}
    return ns.certify.region(kicked(), data, [0, 1.5], region={"v": (0.5, 4)}, boxes=16, levels=1)


def certified_over(orbit, parameter, low, high, **asked):
    """What is proved of an orbit's branch between two rational values of a parameter."""
    ends = str(low), str(high)
    lower, upper = (float(Fraction(end)) for end in ends)
    branch = ns.continue_orbit(orbit, parameter, (lower, upper))
    return ns.certify.branch(branch, interval=ends, **asked)


def accepted(found, folder):
    """The check of the file of what was found: it holds."""
    found.save(folder / "found.json")
    check = ns.certify.check(folder / "found.json")
    assert check.difference is None
    return check


def content_of(found):
    """What a file holds, or that of what was found."""
    if isinstance(found, Path):
        return json.loads(found.read_text())
    with tempfile.TemporaryDirectory() as folder:
        found.save(Path(folder) / "found.json")
        return json.loads((Path(folder) / "found.json").read_text())


def interrupted(ask, files, within, last=math.inf):
    """How many lines of some files run while functions of these names do, and what is found.

    Behind the `last` of them comes Ctrl-C, and what is found is the state that it leaves.
    """
    lines, before = 0, sys.gettrace()

    def trace(frame, event, argument):
        nonlocal lines
        if not frame.f_code.co_filename.endswith(files):
            return None
        if event == "line" and within & {each.f_code.co_name for each, _ in walk_stack(frame)}:
            lines += 1
            if lines > last:
                sys.settrace(before)
                raise KeyboardInterrupt
        return trace

    sys.settrace(trace)
    try:
        found = ask()
        return lines, found
    except ns.Interrupted as stopped:
        return lines, stopped.partial
    finally:
        sys.settrace(before)


def told_at(found, point):
    """The verdict that a map tells of a point; none in the band about a curve of events."""
    tile = found.tile_at(point)
    if tile.event is None:
        return str(tile.verdict)
    place = [
        (2 * Fraction(point[name]) - low - high) / (high - low)
        for name, (low, high) in found.where(tile).items()
    ]
    side = tile.event.band.side_of(place)
    return "" if side is None else str(getattr(tile.event, side))


def random_points(found, seed, count):
    """So many points of each tile of a map."""
    drawn = random.Random(seed)
    for tile in found.tiles:
        for _ in range(count):
            yield {
                name: low + Fraction(drawn.random()) * (high - low)
                for name, (low, high) in found.where(tile).items()
            }


def signed(content):
    """A file's content with the checksum made right."""
    return {**content, "sha256": checksum_of(content)}


def edited(found, change):
    """Content, or that of a file or of what was found, changed, the checksum made right."""
    content = copy.deepcopy(found) if isinstance(found, dict) else content_of(found)
    change(content)
    return signed(content)


def stating(*path, **entries):
    """A change of a file: what is at a path has other entries."""
    return lambda content: reduce(getitem, path, content).update(entries)


def placing(*path):
    """A change of a file: where a path leads, which the last of these stands behind, is that."""
    *above, last, entry = path
    return lambda content: setitem(reduce(getitem, above, content), last, entry)


def believed(content):
    """See the checker prove all that a file states."""
    CHECKS[content["format"]](content)


def refused(content, match=None):
    """Make the checksum right again, and see the mathematics refuse it."""
    with pytest.raises(Failure, match=match):
        believed(signed(content))


def saved(content, path):
    """A file of this content, with the checksum made right again."""
    path.write_text(json.dumps(signed(content)))
    return path


def moved(entry, by=3):
    """Move a ball's middle by so many radii."""
    middle = Fraction(entry["mid"]) + Fraction(str(by)) * Fraction(entry["rad"])
    entry["mid"] = f"{round(middle * 10**400)}e-400"


def refused_file(content, folder, told):
    """See a file of this content, its checksum made right, be refused for that reason."""
    path = saved(content, folder / "false.json")
    try:
        difference = ns.certify.check(path).difference
    except ns.InputError as problem:
        difference = str(problem)
    assert told in difference, difference


def flat(counted):
    """Values of which a file tells how often each follows itself."""
    return [value for value, count in counted for _ in range(count)]


def runs(values):
    """Values as a file tells them, each with how often it follows itself."""
    return [[value, len([*group])] for value, group in groupby(values)]


def claimed(kind, content):
    """The record that entries describe, whatever they say of what follows from them."""
    hints = get_type_hints(kind, include_extras=True)
    own = [field.name for field in fields(kind) if field.name in content]
    return kind(**{name: by(hints[name], lambda value: value).read(content[name]) for name in own})


def unhashed(told):
    """An answer without the hashes in names, of declarations here and of data in a file."""
    return re.sub("@[0-9a-f]{16}", "", json.dumps(told, sort_keys=True))
