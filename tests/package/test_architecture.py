"""docs/architecture.md tells the truth: what it names is there, and new things go where it says."""

import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

import nonsmooth as ns
import nonsmooth.derive
from nonsmooth.derive import Boundary
from nonsmooth.derive.building.element_parts import part_of
from nonsmooth.derive.building.elements import Element
from nonsmooth.derive.building.frame import Frame
from nonsmooth.derive.building.parts import Exit, SwitchPart
from nonsmooth.runtime.cli.application import app
from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.explore.continuation.event import KINDS, EventKind
from nonsmooth.runtime.present.pictures.kinds import KINDS as PICTURES
from nonsmooth.runtime.present.pictures.kinds import Kind
from tests.places import CHECKOUT

PAGE = (CHECKOUT / "docs" / "architecture.md").read_text(encoding="utf-8")
NAMED = sorted(set(re.findall(r"`([^`]+)`", PAGE)))
WORDS = {"System", "name", ".register"}  # of the text, not of a place
COMMANDS = [name for name in NAMED if name.startswith("nonsmooth ")]
NAMES = [name for name in NAMED if name not in WORDS and name not in COMMANDS]


def found(name: str) -> object:
    """What a dotted name stands for: a module, or what is in one."""
    whole = name if name.startswith("nonsmooth") else f"nonsmooth.runtime.{name}"
    whole = f"nonsmooth.{name}" if name.startswith("derive") else whole
    parts = whole.split(".")
    for count in range(len(parts), 0, -1):
        try:
            place: object = import_module(".".join(parts[:count]))
        except ModuleNotFoundError:
            continue
        for part in parts[count:]:
            place: object = getattr(place, part)
        return place
    raise AssertionError(name)


@pytest.mark.parametrize("name", NAMES)
def test_what_the_page_names_is_there(name: str) -> None:
    if "/" in name:
        place = CHECKOUT / name
        assert place.exists() or (CHECKOUT / "runtime" / name).exists()
    elif "." in name and (CHECKOUT / name).exists():
        assert name == "pyproject.toml"
    elif hasattr(ns, name):
        assert name in ns.__all__ or isinstance(found(name), ModuleType)
    else:
        assert found(name) is not None


@pytest.mark.parametrize("command", COMMANDS)
def test_the_commands_of_the_page_are_answered(command: str) -> None:
    result = CliRunner().invoke(app, [*command.split()[1:], "--json"])
    assert result.exit_code == 0, result.output


@dataclass(frozen=True)
class PiecewiseSpring:
    """A spring that is `stiffness` stiffer where the coordinate is positive."""

    coordinate: str
    stiffness: Any
    name: str = "spring"


@part_of.register
def _piecewise_spring(
    element: PiecewiseSpring, frame: Frame, elements: Sequence[Element]
) -> SwitchPart:
    row = frame.row(element.coordinate, f"element {element.name!r}")
    position = frame.position(row)
    return SwitchPart(
        element.name,
        {"tight": -frame.expression(element.stiffness) * position * row.T},
        {
            "slack": (Exit(Boundary(f"{element.name}-tightens", position), "tight"),),
            "tight": (Exit(Boundary(f"{element.name}-slackens", -position), "slack"),),
        },
        needed={"stiffness": frame.expression(element.stiffness)},
    )


def test_a_new_element_is_a_class_and_its_part() -> None:
    spring = PiecewiseSpring("x", stiffness=3)
    system = nonsmooth.derive.oscillator("bilinear", ["x"], [[1]], [[1]], elements=[spring])
    assert [c.name for c in system.configurations] == ["slack", "tight"]
    motion = ns.simulate(system, {}, {"x": 0, "v": 1}, "tight", transitions=2)
    # half a period with each stiffness: pi/2 with the frequency 2, pi with the frequency 1
    np.testing.assert_allclose(motion.times, [0, np.pi / 2, 3 * np.pi / 2], rtol=1e-14)


def test_a_new_element_says_what_must_not_be_negative() -> None:
    with pytest.raises(nonsmooth.derive.DeclarationError, match="stiffness is negative"):
        nonsmooth.derive.oscillator(
            "soft", ["x"], [[1]], [[1]], elements=[PiecewiseSpring("x", stiffness=-1)]
        )


def test_what_is_no_element_is_refused() -> None:
    with pytest.raises(nonsmooth.derive.DeclarationError, match="elements cannot hold namespace"):
        nonsmooth.derive.oscillator(
            "none", ["x"], [[1]], [[1]], elements=[SimpleNamespace(name="stranger")]
        )


def test_a_new_event_is_one_entry(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = EventKind(
        "the trace is -0.98", lambda multipliers, *_: multipliers.sum(axis=-1).real + 0.98
    )
    monkeypatch.setitem(KINDS, "level", kind)
    orbit = ns.solve("dry-friction/global-stick")
    branch = ns.continue_orbit(orbit, "eta", (0.9, 1.1))
    levels = [event for event in branch.events if event.kind == "level"]
    sides = np.sign(branch.trace + 0.98)
    assert len(levels) == np.count_nonzero(np.diff(sides)) > 0
    for event in levels:
        assert float(branch.orbit_at(event).trace) == pytest.approx(-0.98, abs=1e-8)
        assert "the trace is -0.98" in event.text
        assert not event.border_collision
        assert not event.switches
    branch.plot()


def draw_dwell_times(scene: Any, places: Sequence[Any]) -> None:
    """Draw the dwell times of an orbit as bars."""
    names = scene.orbit.dwell_time_names
    places[0].bar(names, [float(scene.orbit.values[name]) for name in names])
    places[0].set_title(scene.title)


def test_a_new_picture_is_one_entry(monkeypatch: pytest.MonkeyPatch) -> None:
    figure = pytest.importorskip("matplotlib.figure").Figure()
    module = ModuleType("nonsmooth.runtime.present.pictures.dwell_times")
    module.draw_dwell_times = draw_dwell_times  # made here
    monkeypatch.setitem(sys.modules, module.__name__, module)
    kind = Kind((5, 4), "dwell_times.draw_dwell_times", of_motions=False)
    monkeypatch.setitem(PICTURES, "dwell-times", kind)
    orbit = ns.solve("dry-friction/global-stick")
    axes = orbit.plot("dwell-times", figure.add_subplot())
    heights = [bar.get_height() for bar in axes.patches]
    assert sum(heights) == pytest.approx(float(orbit.period), rel=1e-12)
    assert axes.get_title() == "dry-friction/global-stick"
    with pytest.raises(ns.InputError, match="dwell-times"):  # it is listed with the others
        orbit.plot("dwell-tines", axes)


def test_a_new_command_is_one_function(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(app, "registered_commands", list(app.registered_commands))
    # the commands as they are with the new one, not those that other tests ask
    monkeypatch.setattr(typer.testing, "_get_command", typer.main.get_command)

    @command("frequency", "frequency dry-friction/symmetric")
    def frequency(orbit: str, *, reply: Reply) -> int:
        """Give the frequency of an orbit."""
        value = 1 / float(ns.solve(orbit).period)
        return reply.show(lambda: {"frequency": value}, lambda: typer.echo(f"{value:.6f}"))

    told = CliRunner().invoke(app, ["frequency", "dry-friction/global-stick"])
    assert told.exit_code == 0
    period = float(ns.solve("dry-friction/global-stick").period)
    assert float(told.stdout) == pytest.approx(1 / period, abs=1e-6)
    wrong = CliRunner().invoke(app, ["frequency", "dry-friction/nothing"])
    assert wrong.exit_code == 2
