"""Documents cite the publication of an orbit, and number their equations by sections."""

import re
from dataclasses import replace
from itertools import chain

import pytest

from nonsmooth.derive import DeclarationError, Itinerary, Source
from nonsmooth.derive.document.blocks import Document, Heading, Paragraph, Table
from nonsmooth.derive.systems import declaration
from tests.documents import document_of, labels_by_section
from tests.latex_reader import ORBITS

# all numbered equations of the source paper
PAPER = (*(f"({number})" for number in range(1, 19)), "(A.1)", "(A.2)", "(A.3)")
MISSING = ("(A.1)", "(A.2)", "(A.3)")
MISPRINTED = {
    "(2)": "which prints $x_{1}$ without the dot of the velocity",
    "(4)": "which prints the last entry of the stiffness matrix as $k_{1} + k_{3}$",
    "(10)": "which prints the upper right block as $V t I$",
    "(15)": "which prints $H$ for the flow $h$",
    "Sec. 2.4": "without the dot of the velocity",
}


def texts(document: Document) -> list[str]:
    """All running text of a document, notes beside formulas and cells of tables included."""
    found = [b.text for b in document.blocks if isinstance(b, Paragraph)]
    found += [f.note for f in document.formulas if f.note]
    return found + [
        cell
        for block in document.blocks
        if isinstance(block, Table)
        for cell in chain.from_iterable(block.rows)
    ]


def test_the_documents_have_every_equation_of_the_paper_but_the_missing_ones() -> None:
    shown = " ".join(text for name in ORBITS for text in texts(document_of(name)[0]))
    cited = set(re.findall(r"= (\(\S+\)) of Pascal \(2011\)", shown))
    assert cited == set(PAPER) - set(MISSING)


def test_misprints_are_told_where_they_are_cited() -> None:
    told = [text for name in ORBITS for text in texts(document_of(name)[0])]
    for place, sentence in MISPRINTED.items():
        assert any(f"{place} of Pascal (2011), " in t and sentence in t for t in told), place


@pytest.mark.parametrize("name", ORBITS)
def test_equations_are_numbered_by_sections(name: str) -> None:
    document, _ = document_of(name)
    labels = [f.label for f in document.formulas if f.label]
    headings = [b.number for b in document.blocks if isinstance(b, Heading) and b.level == 1]
    assert headings == list(range(1, len(headings) + 1))
    assert labels == labels_by_section(document)
    cited = {m for t in texts(document) for m in re.findall(r"(?:^|\s)\((\d[\d.]*)\)(?! of)", t)}
    assert labels
    assert cited - {"2011"} <= set(labels)


def sourced(**changes: object) -> Itinerary:
    """The global stick orbit with another source."""
    orbit = declaration("dry-friction").global_stick
    return replace(orbit, source=replace(orbit.source, misprints={}, **changes))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"equations": {"phase 5": "(1)"}}, r"place of 'phase 5', which is unknown \(known: .*end"),
        ({"equations": {"flow free": "(1)"}}, "place of 'flow free', which is unknown"),
        ({"flows": {"free": "H"}}, "letter for the flow of 'free', which is unknown"),
        ({"states": tuple("abcdef")}, "letters for 6 states, but the start and 4 phases have 5"),
    ],
)
def test_a_source_with_what_the_orbit_does_not_have_is_refused(
    changes: dict[str, object], message: str
) -> None:
    with pytest.raises(DeclarationError, match=message):
        sourced(**changes)


def test_a_misprint_belongs_to_a_place_that_is_named() -> None:
    with pytest.raises(DeclarationError, match=r"a misprint at '\(3\)', which no equation names"):
        Source("Pascal (2011)", {"start": "(2)"}, misprints={"(3)": "which prints nothing"})


def test_a_rotated_orbit_has_no_source() -> None:
    orbit = declaration("dry-friction").global_stick
    assert orbit.rotated(0).source == orbit.source
    assert orbit.rotated(1).source is None
