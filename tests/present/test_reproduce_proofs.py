"""The chapter on proofs of the reproduced paper."""

import mpmath

from nonsmooth import refine, solve
from nonsmooth.runtime.present.paper.proofs import with_certificates
from nonsmooth.runtime.present.paper.records import Chapter, Report, Table, Text

NAMES = ("dry-friction/global-stick", "dry-friction/solution-ii")


def test_claims_and_reasons_stand_before_the_last_chapter() -> None:
    chapters = tuple(Chapter(name, name, (Text(name),)) for name in ("first", "last"))
    orbits = {name: refine(solve(name), 30) for name in NAMES}
    steps: list[str] = []
    report = with_certificates(Report("", (), chapters, {"kept": 1}), orbits, steps.append)
    assert [chapter.title for chapter in report.chapters] == ["first", "Proofs", "last"]
    assert report.results["kept"] == 1
    proved, limit = (report.results["certificates"][name] for name in NAMES)
    assert set(proved["claims"].values()) == {"proved"}
    middle = proved["trace"].partition(" +/- ")[0]
    assert abs(float(middle) - float(orbits[NAMES[0]].trace)) < 1e-14
    assert set(limit["claims"].values()) == {"undecided"}
    assert "border collision" in limit["reasons"]["existence"]
    (table,) = (block for block in report.chapters[1].blocks if isinstance(block, Table))
    assert [row[0] for row in table.rows] == list(NAMES)
    assert f"proof of {NAMES[1]}" in steps
    collision = report.results["collisions"][NAMES[1]]
    assert collision["claim"] == "proved"
    with mpmath.workdps(60):
        middle, radius = (mpmath.mpf(collision["enclosures"]["e1"][k]) for k in ("mid", "rad"))
        assert abs(orbits[NAMES[1]].unknowns["e1"] - middle) < radius + mpmath.mpf(10) ** -29
    texts = [block.text for block in report.chapters[1].blocks if isinstance(block, Text)]
    assert any("shrinks to zero" in text for text in texts)
