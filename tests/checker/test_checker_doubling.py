"""The check of a doubling: it proves what is so, and refuses a file that was edited."""

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure, Malformed, check_doubling
from tests.certified import prove_doubling, signed
from tests.shared import shared_file

pytestmark = pytest.mark.compiled  # much slower without it
Content = dict[str, Any]


@pytest.fixture(scope="module")
def content() -> Content:
    path = shared_file("nonsmooth certified doubling", prove_doubling)
    assert ns.check_certificate(path).claims == {"doubling": "proved"}
    found: Content = json.loads(path.read_text())
    return found


def other_side(content: Content) -> None:
    content["doubled"]["side"] = "below"


def stable(content: Content) -> None:
    content["doubled"]["verdict"] = "stable"


def a_reason_for_nothing(content: Content) -> None:
    content["doubled"]["reason"] = "none"


def undecided_without_reason(content: Content) -> None:
    content["doubled"]["verdict"] = "undecided"


def proved_without_a_verdict(content: Content) -> None:
    content["doubled"].update(verdict="undecided", reason="not known")


def wider_amplitude(content: Content) -> None:
    content["doubled"]["amplitude"] = "2"


def negative_amplitude(content: Content) -> None:
    content["doubled"]["amplitude"] = "-1/10"


def moved_tube(content: Content) -> None:
    content["doubled"]["centre"][-1][0] += 1e-3


def narrow_tube(content: Content) -> None:
    content["doubled"]["radii"] = [1e-40] * len(content["doubled"]["radii"])


def wide_tube(content: Content) -> None:
    content["doubled"]["radii"] = [1.0] * len(content["doubled"]["radii"])


def another_rate(content: Content) -> None:
    content["doubled"]["rate"]["mid"] = "1.4e-1"


def another_tile(content: Content) -> None:
    tiles = content["branch"]["tiles"]
    place = next(k for k, tile in enumerate(tiles, 1) if tile["event"] is None)
    content["doubled"]["tile"] = place


def another_unknown(content: Content) -> None:
    content["doubled"]["scaled"] = "tau1"


def complete_with_a_reason(content: Content) -> None:
    content["end"] = "the time is over"


def complete_without_doubled_orbits(content: Content) -> None:
    content.update(doubled=None, claims={"doubling": "undecided"})


def claimed_without_doubled_orbits(content: Content) -> None:
    content.update(doubled=None, ended="unfinished")


def the_orbit_itself_as_doubled(content: Content) -> None:
    content["doubled"]["branch"] = copy.deepcopy(content["branch"])


def other_parameters(content: Content) -> None:
    content["doubled"]["branch"]["parameters"]["eta"] = "4.001"


def another_declaration(content: Content) -> None:
    row = content["doubled"]["branch"]["declaration"]["configurations"]["slip-slip"]["field"][2]
    row[0] = "-1.0001"


def doubled_from_elsewhere(content: Content) -> None:
    """The doubled branch is right, but it does not begin in the tube."""
    content["doubled"]["amplitude"] = "1/1000"


EDITS: tuple[Callable[[Content], None], ...] = (
    other_side, stable, a_reason_for_nothing, undecided_without_reason,
    proved_without_a_verdict, wider_amplitude, negative_amplitude, moved_tube, narrow_tube,
    wide_tube, another_rate, another_tile,
    another_unknown, complete_with_a_reason, complete_without_doubled_orbits,
    claimed_without_doubled_orbits,
    the_orbit_itself_as_doubled, other_parameters, another_declaration, doubled_from_elsewhere,
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: edit.__name__)
def test_what_is_false_is_refused(content: Content, edit: Callable[[Content], None]) -> None:
    edited = copy.deepcopy(content)
    edit(edited)
    with pytest.raises(Failure):
        check_doubling(signed(edited))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["dry-friction/global-stick", "rigid-stop/one-impact", "mine"])
def test_the_name_of_another_orbit_is_refused(content: Content, name: str, tmp_path: Path) -> None:
    path = tmp_path / "edited.json"
    path.write_text(json.dumps(signed({**content, "orbit": name})))
    assert name in str(ns.check_certificate(path).difference)


def test_a_file_that_was_edited_is_refused(content: Content) -> None:
    edited = copy.deepcopy(content)
    edited["end"] = "."
    with pytest.raises(Failure, match="checksum"):
        check_doubling(edited)
    del edited["ended"]
    with pytest.raises(Malformed):
        check_doubling(signed(edited))


def test_a_degenerate_flip_is_refused(content: Content) -> None:
    """A tube whose parameter would not move: the same polynomials without their bend."""
    edited = copy.deepcopy(content)
    rows = edited["doubled"]["centre"]
    rows[-1] = [rows[-1][0], *[0.0] * (len(rows[-1]) - 1)]
    with pytest.raises(Failure):
        check_doubling(signed(edited))
