"""An orbit keeps what it was solved with, whatever becomes of the file that declared it."""

import shutil

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive.codegen.emit import emit_package, emit_system
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.two_masses import STICKING
from tests.user_systems import DAMPED, KICKED, declare


def told(orbit):
    """What is asked of a live record: anew, for nothing of it is kept between two calls."""
    again = type(orbit)(**{name: getattr(orbit, name) for name in orbit.__dataclass_fields__})
    motion = again.motion()
    branch = ns.continue_orbit(again, "r", (0.2, 0.6), points=4)
    return {
        "states": again.states.tolist(),
        "trace": again.trace,
        "admissible": again.admissibility.verdict,
        "monodromy": again.monodromy.tolist(),
        "motion": motion(np.linspace(0, again.period, 7)).tolist(),
        "refined": str(ns.refine(again, 30).unknowns),
        "moved": branch.orbit_at(0).to_json(),
        "claims": ns.certify(again).claims,
        "json": again.to_json(),
    }


def declared(folder, text, *, derived):
    """Declare the orbit in a file, or as a folder of generated kernels; its name."""
    path = declare(folder, text)
    if not derived:
        return f"{path}:loop"
    found = declaration_in(path)
    emitted = emit_system(found.system, found.orbits, path.name)
    (folder / "own").mkdir(exist_ok=True)
    for name, content in emit_package([emitted], "nonsmooth generate").items():
        (folder / "own" / name).write_text(content, encoding="utf-8")
    return f"{folder / 'own'}:loop"


@pytest.mark.slow
@pytest.mark.parametrize(("text", "derived"), [(KICKED, True), (DAMPED, False)])
@pytest.mark.parametrize("change", ["edited", "deleted"])
def test_a_live_record_does_not_read_its_file_again(tmp_path, text, derived, change):
    name = declared(tmp_path, text, derived=derived)
    orbit, many = ns.solve(name, {"r": "0.4"}), ns.solve(name, {"r": [0.3, 0.5]})
    assert (orbit.problem.kernels is not None) == derived
    before, times = told(orbit), many.dwell_times.tolist()
    if change == "edited":
        declared(tmp_path, text.replace("[[4]]", "[[5]]"), derived=derived)
        assert ns.solve(name, {"r": "0.4"}).period != orbit.period
    else:
        shutil.rmtree(tmp_path)
        with pytest.raises(ns.InputError):
            ns.solve(name)
    assert told(orbit) == before
    assert many.dwell_times.tolist() == times


def test_a_record_by_kernels_and_one_by_tables_are_asked_alike():
    kernels = ns.solve("dry-friction/global-stick")
    tables = ns.solve("dry-friction", STICKING, kernels.dwell_times, itinerary=kernels.itinerary)
    assert type(kernels) is type(tables)
    assert kernels.dwell_time_names == ("ta", "tau", "tau1", "tau2")
    assert_allclose(kernels.dwell_times, tables.dwell_times, atol=1e-12)
    assert kernels.states.shape == tables.states.shape == (4, 4)
    assert_allclose(np.diff(kernels.states, axis=0), np.diff(tables.states, axis=0))
    assert_allclose(kernels.multipliers, tables.multipliers, atol=1e-12)
    assert_allclose(kernels.saltations, tables.saltations, atol=1e-9)
    assert_allclose(kernels.monodromy, tables.monodromy, atol=1e-9)
    times = np.linspace(-1, 1.99 * kernels.period, 50)  # no transition lies among them
    first, second = kernels.motion(), tables.motion()
    apart = second(times) - first(times)  # positions are from another origin
    assert_allclose(apart, np.broadcast_to(apart[0], apart.shape), atol=1e-10)
    assert second.configuration(times).tolist() == first.configuration(times).tolist()
    assert set(kernels.to_json()) == {*tables.to_json()} | {"requires"}
    assert_allclose(tables.trajectory(2)(times[20:-1]), second(times[20:-1]), atol=1e-9)
    with pytest.raises(ns.InputError, match="motion"):
        kernels.trajectory()
    with pytest.raises(ns.InputError, match="no kernels"):
        tables.evaluate("jacobian")


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ((), "no quantity is named; .*residual"),
        (("residual", "jacobean"), "unknown quantity .*residual, jacobian, "),
        (("residual", "spectrum"), "unknown quantity .*residual, jacobian, "),
        (("reduced_residual",), "is of the reduced equations.* at tau, tau1;.*residual, jacobian"),
        (("residual", "trace"), "gives residual and trace; .*trace"),
    ],
)
def test_what_is_no_quantity_of_the_equations_is_refused_with_those_that_are(asked, told):
    with pytest.raises(ns.InputError, match=told):
        ns.solve("dry-friction/global-stick").evaluate(*asked)
