"""Every public result tells in a few lines what it is, and shows a table in a notebook."""

from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.continuation.event import Event
from tests.certified import kicked, prove_basin, prove_branch, prove_doubling, prove_graph
from tests.horseshoes import folded_horseshoe
from tests.places import records
from tests.shared import shared_file

DATA = dict(chi="0.4", eta=4, V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2=1)
RIGID = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
START = {"x1": 1, "x2": 0, "v1": -1, "v2": 0}
REST = {"x1": 0, "x2": 0, "v1": 0, "v2": 0}
KINDS = {name for name, kind in records().items() if hasattr(kind, "_repr_html_")}
KINDS |= {"DifferentiableFunction", "Experiment"}


ORBIT, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"


@cache
def branch() -> Any:
    return ns.continue_orbit(ns.solve(SYMMETRIC), "V", (0.6, 1.3))


def flip() -> Any:
    return next(event for event in branch().events if event.kind == "flip")


@cache
def result(kind: str) -> Any:
    """One result of each kind."""
    match kind:
        case "Orbit":
            return ns.solve(ORBIT)
        case "Orbits":
            return ns.solve(ORBIT, {"V": np.linspace(0.9, 1.1, 4)})
        case "Motion":
            return ns.solve(ORBIT).motion()
        case "Trajectory":
            return ns.simulate("dry-friction", DATA, REST, transitions=60)
        case "Trajectories":
            return ns.simulate("rigid-stop", RIGID, np.full((5, 4), 0.5), transitions=3)
        case "Recurrence":
            return ns.itinerary_of(ns.solve(ORBIT, {"us1": 1, "us2": 1}).trajectory(8))
        case "PoincareMap":
            return ns.poincare_map("rigid-stop", RIGID, ("free", "first-reaches-stop", "free"))
        case "Found":
            return ns.find_orbits("dry-friction", DATA, 10)
        case "Sweep":
            names = {"state": "x1", "configuration": "slip-stick", "transient": 20}
            fixed = {name: value for name, value in DATA.items() if name != "V"}
            return ns.sweep("dry-friction", fixed, "V", [0.6, 0.7], REST, **names)
        case "Experiment":
            return ns.Experiment(data={"t": [1, 2], "x1": [0, 1]}, parameters={"r": 1}, offset=3)
        case "Fit":
            motion = ns.simulate("rigid-stop", RIGID, START, transitions=4)
            data = {"first-reaches-stop": motion.times[1:]}
            return ns.fit("rigid-stop", data, parameters=RIGID, free=["r"], start=START, sigma=1)
        case "Branch":
            return branch()
        case "Event":
            return flip()
        case "Locus":
            return ns.continue_orbit(branch(), "eta", (3.99, 4.01), event=flip())
        case "DifferentiableFunction":
            return ns.orbit_function(ns.solve(ORBIT), by=["V", "eta"], of=["period", "trace"])
        case "Design":
            return ns.design(ns.solve(SYMMETRIC), minimise="period", over={"V": (0.6, 0.7)})
        case "Certificate":
            return ns.certify(result("Orbit"))
        case "BoxCertificate":
            return ns.certify.box(result("Orbit"), {"V": ("0.999", "1.001")})
        case "CertifiedBranch":
            return ns.load(shared_file("branch of friction", prove_branch))
        case "CertifiedDoubling":
            return ns.load(shared_file("nonsmooth certified doubling", prove_doubling))
        case "BasinCertificate":
            return ns.load(shared_file("nonsmooth basin certificate", prove_basin))
        case "ChaosCertificate":
            return ns.load(shared_file("nonsmooth chaos certificate", folded_horseshoe))
        case "RegionCertificate":
            return ns.load(shared_file("nonsmooth region certificate", prove_graph))
        case "Census":
            return ns.certify.all(ORBIT, {"us1": 1, "us2": 1}, {"tau": (1.9, 2.1), "tau1": (3, 4)})
        case "EventCertificate":
            return ns.certify.event(branch(), flip())
        case "Proof":
            return ns.certify.motion("rigid-stop", RIGID, START, "free", 3)
        case "Check":
            with TemporaryDirectory() as folder:
                file = Path(folder, "proof.json")
                result("Certificate").save(file)
                return ns.certify.check(file)
    raise AssertionError(f"a new public result: tell here how one is made: {kind}")


class Tags(HTMLParser):
    """Open tags, and whether each is closed in its turn."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: Any) -> None:
        if tag != "br":
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_result_tells_what_it_is(kind: str) -> None:
    lines = repr(result(kind)).splitlines()
    assert 2 <= len(lines) < 5
    assert all(line.strip() and len(line) <= 100 for line in lines), lines
    assert "object at" not in repr(result(kind))
    assert "array(" not in repr(result(kind))
    html = result(kind)._repr_html_()
    assert html.startswith("<table>")
    assert Tags(html).open == []


def test_the_words_are_those_of_the_result() -> None:
    trace = result("Certificate").trace
    assert f"{float(trace.mid):.10g}"[:9] in repr(result("Certificate"))
    assert f"V = {flip().value:.8g}"[:10] in repr(flip())
    assert f"{len(branch())} orbits" in repr(branch())
    assert "60 transitions" in repr(result("Trajectory"))


def test_a_users_system_has_its_own_name() -> None:
    found = ns.simulate(kicked(), {"k": 1, "r": "0.5", "a": 9}, {"x": 0, "v": 1}, transitions=2)
    assert repr(found).splitlines()[0] == "motion of kicked, 2 transitions"


def test_what_a_result_says_of_names_is_no_markup() -> None:
    event = Event(
        kind="flip", parameter="a<b", value=1.0, unknowns={"<i>": 1.0}, phase=None,
        configuration="", boundary="", time=None, place=0.5, text="<script>",
    )  # fmt: skip
    assert "<script>" not in event._repr_html_()
    assert "<i>" not in event._repr_html_()
