"""Files of maps of two parameters whose curves are not true: they are refused, with the reason."""

from functools import partial

import pytest

from tests.certified import believed, content_of, placing, refused, signed, stating
from tests.proof import test_common_curves, test_fold_curves, test_regions, test_torus_curves
from tests.tables import slow

BEYOND = test_fold_curves.BEYOND
MAPS = {
    "flip": lambda: test_regions.small("flip"),
    "grazing": lambda: test_regions.small("grazing"),
    "fold": test_fold_curves.small,
    "common": test_common_curves.found,
    "torus": test_torus_curves.closed,
}


def event_in(content):
    """The event of the largest tile that a curve passes near its middle."""
    tiles = [t for t in content["tiles"] if t["event"] and abs(t["event"]["centre"][0]) < 0.9]
    return min(tiles, key=lambda t: sum(level for _, level in t["place"]))["event"]


def exchanged(event):
    event["below"], event["above"] = event["above"], event["below"]


def moved(event, away=1e-3):
    event["centre"][0] += away


def wide(event):
    """All that is stated of both sides is true, but regions would end at the wrong curve."""
    moved(event, 0.01)
    event["radius"] = 0.02


def own(event, verdict):
    side = "below" if event["above"] == BEYOND else "above"
    event[side] = verdict


def other_sheet(event):
    sheet = event["fold"]["sheet"]
    event["fold"]["sheet"] = "below" if sheet == "above" else "above"


def both_exchanged(event):
    """The verdicts are those of the orbits, but the map's own orbit is another one."""
    other_sheet(event)
    own(event, "unstable")
    event["fold"]["other"] = "proved"


SOON = ("flip", "grazing")  # proved in a blink
# of divided tiles by the kind of curve
DIVIDED = {
    "other sides of a flip": ("flip", exchanged, "other verdicts beside the event"),
    "other sides of a grazing": ("grazing", exchanged, "other verdicts|admissibility"),
    "another curve": ("grazing", partial(moved, away=0.01), "beside its band"),
    "a curve that is moved": ("flip", partial(moved, away=0.01), "beside its band"),
    "too narrow": ("grazing", stating(radius=1e-19), "beside its band"),
    "no width": ("grazing", stating(radius=0.0), "without width"),
    "negative width": ("grazing", stating(radius=-1e-3), "without width"),
    "too wide": ("flip", stating(radius=1e-3), "too wide"),
    "wide enough for a curve that is moved": ("flip", wide, "too wide"),
    "without bounds": ("flip", stating(radius=float("inf")), "wrong type"),
    "another kind": ("flip", stating(kind="neimark-sacker"), "happen twice|beside the"),
    "a fold": ("flip", stating(kind="fold"), "fold"),
    "another boundary": ("grazing", stating(boundary="falls"), "event|boundary"),
    "another phase": ("grazing", stating(phase=2), "boundary|configuration"),
    "no phase": ("grazing", stating(phase=None), "no phase"),
    "no such phase": ("grazing", stating(phase=9), "no such phase"),
    "no window": ("grazing", stating(window=[]), "window"),
    "another window": (
        "grazing", stating(window=["0", "1/100"]), "time of a grazing|outside|admissib"
    ),
    "another axis": ("flip", stating(axis=2), "happen twice|known|band"),
    "no parameter": ("flip", stating(axis=3), "no plane"),
    "several parts": ("flip", stating(centre=[0.9, 0.0, 0.5]), "several parts"),
    "a border twice": (
        "grazing", stating(also=[["grazing", 1, "wall", "inside"]]), "border twice"
    ),
}  # fmt: skip
FOLDED = {
    "other sides": (exchanged, "a verdict on the side of no orbits"),
    "a curve that is moved": (moved, "beside the band"),
    "too narrow": (stating(radius=1e-13), "beside the band"),
    "too wide": (stating(radius=1e-3), "too wide"),
    "another verdict": (lambda e: own(e, "unstable"), "beside the fold"),
    "not admissible": (lambda e: own(e, "not admissible"), "beside the fold"),
    "none on both sides": (lambda e: own(e, BEYOND), "no verdict on the side"),
    "another verdict of the other orbit": (
        stating("fold", other="proved"), "beside the fold"),
    "the other sheet": (other_sheet, "beside the fold"),
    "no sheets": (stating(fold=None), "without its orbits"),
    "another unknown": (stating("fold", coordinate="tau1"), "singular|Kraw|near|bent"),
    "no unknown": (stating("fold", coordinate="U"), "no such unknown"),
    "a tube that ends in the tile": (
        lambda e: e["fold"].update(half=e["fold"]["half"] / 2), "ends in the tile"),
    "a tube without width": (stating("fold", half=0.0), "without width"),
    "a tube beside the fold": (
        lambda e: e["fold"]["centre"].__setitem__(0, e["fold"]["centre"][0] + e["fold"]["half"]),
        "meet|band|ends|near|Krawczyk"),
    "another parameter across": (
        lambda e: e.update(axis=3 - e["axis"]),
        "band|ends|near|wide|parts|Kraw"),
    "a phase": (stating(phase=1), "a phase"),
    "a flip": (stating(kind="flip"), "fold"),
}  # fmt: skip
TOGETHER = {
    "a condition is left out": (lambda e: e["also"].pop(), "admissibility"),
    "another condition": (placing("also", 1, 2, "1.1"), "band|event|condition"),
    "no such condition": (placing("also", 1, 2, "9.1"), "condition|admissib"),
    "other sides": (
        lambda e: e.update(below=e["above"], above=e["below"]), "verdicts|admissibility"
    ),
}  # fmt: skip
CASES = [
    *((name, *case) for name, case in DIVIDED.items()),
    *((name, "fold", *case) for name, case in FOLDED.items()),
    *((name, "common", *case) for name, case in TOGETHER.items()),
    (
        "another kind of torus",
        "torus",
        stating(kind="flip"),
        "there may be another event",
    ),
    ("other sides of a torus", "torus", exchanged, "other verdicts|beside"),
    ("another torus", "torus", moved, "beside its band"),
]


@pytest.mark.parametrize(
    ("kind", "change", "told"),
    [
        pytest.param(
            *case, id=f"{name}, {case[0]}", marks=[pytest.mark.slow] * (case[0] not in SOON)
        )
        for name, *case in CASES
    ],
)
def test_false_curves_are_refused(kind, change, told):
    content = content_of(MAPS[kind]())
    change(event_in(content))
    refused(content, told)


@pytest.mark.parametrize("kind", [slow(k, when=k not in SOON) for k in MAPS])
def test_true_curves_pass_and_a_wider_band_is_true(kind):
    content = content_of(MAPS[kind]())
    believed(content)
    event_in(content)["radius"] *= 2
    believed(signed(content))


@pytest.mark.slow
def test_the_other_orbit_is_not_that_of_the_tiles_beside_it():
    content = content_of(test_fold_curves.folded())
    both_exchanged(event_in(content))
    refused(content, "not that of a tile beside it")
