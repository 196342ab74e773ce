"""The check of a cascade: it proves what is so, and refuses a file that was edited."""

import copy
import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure, Malformed, check_cascade
from tests.certified import prove_cascade
from tests.shared import shared_file

pytestmark = pytest.mark.compiled  # much slower without it
Content = dict[str, Any]


@pytest.fixture(scope="module")
def content() -> Content:
    path = shared_file("nonsmooth certified cascade", prove_cascade)
    assert ns.check_certificate(path).claims == {"doublings": "proved"}
    found: Content = json.loads(path.read_text())
    return found


def signed(content: Content) -> Content:
    covered = {key: value for key, value in content.items() if key != "sha256"}
    digest = hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()
    return {**covered, "sha256": digest}


def other_side(content: Content) -> None:
    content["doublings"][0]["side"] = "below"


def stable(content: Content) -> None:
    content["doublings"][0]["verdict"] = "stable"


def a_reason_for_nothing(content: Content) -> None:
    content["doublings"][0]["reason"] = "none"


def undecided_without_reason(content: Content) -> None:
    content["doublings"][0]["verdict"] = "undecided"


def proved_without_a_verdict(content: Content) -> None:
    content["doublings"][0].update(verdict="undecided", reason="not known")


def wider_amplitude(content: Content) -> None:
    content["doublings"][0]["amplitude"] = "2"


def negative_amplitude(content: Content) -> None:
    content["doublings"][0]["amplitude"] = "-1/10"


def moved_tube(content: Content) -> None:
    content["doublings"][0]["centre"][-1][0] += 1e-3


def narrow_tube(content: Content) -> None:
    content["doublings"][0]["radii"] = [1e-40] * len(content["doublings"][0]["radii"])


def wide_tube(content: Content) -> None:
    content["doublings"][0]["radii"] = [1.0] * len(content["doublings"][0]["radii"])


def another_rate(content: Content) -> None:
    content["doublings"][0]["rate"]["mid"] = "1.4e-1"


def another_tile(content: Content) -> None:
    tiles = content["branches"][0]["tiles"]
    place = next(k for k, tile in enumerate(tiles, 1) if tile["event"] is None)
    content["doublings"][0]["tile"] = place


def another_unknown(content: Content) -> None:
    content["doublings"][0]["scaled"] = "tau1"


def more_than_asked(content: Content) -> None:
    content["asked"] = 0


def more_asked(content: Content) -> None:
    content["asked"] = 2


def complete_with_less(content: Content) -> None:
    content.update(asked=2, end="", claims={"doublings": "undecided"})


def complete_with_a_reason(content: Content) -> None:
    content["end"] = "the time is over"


def claimed_without_a_doubling(content: Content) -> None:
    content["doublings"] = []
    content["branches"] = content["branches"][:1]


def the_orbit_itself_as_doubled(content: Content) -> None:
    content["branches"][1] = copy.deepcopy(content["branches"][0])


def other_parameters(content: Content) -> None:
    content["branches"][1]["parameters"]["eta"] = "4.001"


def another_declaration(content: Content) -> None:
    row = content["branches"][1]["declaration"]["configurations"]["slip-slip"]["field"][2]
    row[0] = "-1.0001"


def doubled_from_elsewhere(content: Content) -> None:
    """The doubled branch is right, but it does not begin in the tube."""
    content["doublings"][0]["amplitude"] = "1/1000"


EDITS: tuple[Callable[[Content], None], ...] = (
    other_side, stable, a_reason_for_nothing, undecided_without_reason,
    proved_without_a_verdict, wider_amplitude, negative_amplitude, moved_tube, narrow_tube,
    wide_tube, another_rate, another_tile,
    another_unknown, more_than_asked, more_asked, claimed_without_a_doubling,
    complete_with_less, complete_with_a_reason,
    the_orbit_itself_as_doubled, other_parameters, another_declaration, doubled_from_elsewhere,
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: edit.__name__)
def test_what_is_false_is_refused(content: Content, edit: Callable[[Content], None]) -> None:
    edited = copy.deepcopy(content)
    edit(edited)
    with pytest.raises(Failure):
        check_cascade(signed(edited))


def test_one_of_two_doublings_alone_is_not_the_claim(content: Content) -> None:
    edited = copy.deepcopy(content)
    edited["doublings"].append({**edited["doublings"][0], "verdict": "undecided", "reason": "no"})
    edited["branches"].append(edited["branches"][-1])
    edited["asked"] = 2
    with pytest.raises(Failure, match="the claim is another one"):
        check_cascade(signed(edited))


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
        check_cascade(edited)
    del edited["asked"]
    with pytest.raises(Malformed):
        check_cascade(signed(edited))


def test_a_degenerate_flip_is_refused(content: Content) -> None:
    """A tube whose parameter would not move: the same polynomials without their bend."""
    edited = copy.deepcopy(content)
    rows = edited["doublings"][0]["centre"]
    rows[-1] = [rows[-1][0], *[0.0] * (len(rows[-1]) - 1)]
    with pytest.raises(Failure):
        check_cascade(signed(edited))
