"""Every public result tells in a few lines what it is, and shows a table in a notebook."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from tests.certified import kicked
from tests.core.test_result_files import file_of, looped
from tests.places import records
from tests.present.elements import Elements
from tests.present.test_load import TYPES
from tests.two_masses import CHAIN, RUBBING

RIGID = CHAIN | {"r": 1}
START = {"x1": 1, "x2": 0, "v1": -1, "v2": 0}
REST = {"x1": 0, "x2": 0, "v1": 0, "v2": 0}
KINDS = {name for name, kind in records().items() if hasattr(kind, "_repr_html_")}
KINDS |= {"DifferentiableFunction", "Experiment"}


ORBIT = "dry-friction/global-stick"
IN_FILES = {name: kind for kind, name in TYPES.items()}
IN_FILES["EventCertificate"] = IN_FILES.pop("tuple")


@cache
def result(kind):
    """One result of each kind: of those that are kept in files, from one."""
    if kind in IN_FILES:
        found = ns.load(file_of(IN_FILES[kind]))
        return found[0] if isinstance(found, tuple) else found
    match kind:
        case "Orbits":
            return ns.solve(ORBIT, {"V": np.linspace(0.9, 1.1, 4)})
        case "Motion":
            return ns.solve(ORBIT).motion()
        case "Trajectory":
            return ns.simulate("dry-friction", RUBBING, REST, transitions=60)
        case "Trajectories":
            return ns.simulate("rigid-stop", RIGID, np.full((5, 4), 0.5), transitions=3)
        case "Recurrence":
            return ns.itinerary_of(ns.solve(ORBIT, {"us1": 1, "us2": 1}).trajectory(8))
        case "PoincareMap":
            return ns.poincare_map("rigid-stop", RIGID, ("free", "first-reaches-stop", "free"))
        case "Experiment":
            return ns.Experiment(data={"t": [1, 2], "x1": [0, 1]}, parameters={"r": 1}, offset=3)
        case "Event":
            return looped().events[-1]
        case "DifferentiableFunction":
            return ns.orbit_function(ns.solve(ORBIT), by=["V", "eta"], of=["period", "trace"])
        case "Proof":
            return ns.certify.motion("rigid-stop", RIGID, START, "free", 3)
        case "Check":
            return ns.certify.check(file_of("nonsmooth certificate"))
    raise AssertionError(f"a new public result: tell here how one is made: {kind}")


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_result_tells_what_it_is(kind):
    lines = repr(result(kind)).splitlines()
    assert 2 <= len(lines) < 5
    assert all(line.strip() and len(line) <= 100 for line in lines), lines
    assert "object at" not in repr(result(kind))
    assert "array(" not in repr(result(kind))
    html = result(kind)._repr_html_()
    assert html.startswith("<table>")
    assert Elements(html).words


def test_the_words_are_those_of_the_result():
    trace = result("Certificate").trace
    assert f"{float(trace.mid):.10g}"[:9] in repr(result("Certificate"))
    assert f"{result('Event').value:.8g}"[:8] in repr(result("Event"))
    assert f"{len(result('Branch'))} orbits" in repr(result("Branch"))
    assert "60 transitions" in repr(result("Trajectory"))


def test_a_users_system_has_its_own_name():
    found = ns.simulate(kicked(), {"k": 1, "r": "0.5", "a": 9}, {"x": 0, "v": 1}, transitions=2)
    assert repr(found).splitlines()[0] == "motion of kicked, 2 transitions"


def test_what_a_result_says_of_names_is_no_markup():
    event = replace(result("Event"), parameter="a<b", unknowns={"<i>": 1.0}, text="<script>")
    assert "<script>" not in event._repr_html_()
    assert "<i>" not in event._repr_html_()
