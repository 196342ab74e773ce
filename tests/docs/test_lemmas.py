"""The page of the verifier's lemmas numbers them, and names places that are there."""

import re
from pathlib import Path
from pkgutil import resolve_name

PAGE = (Path(__file__).parents[2] / "docs" / "theory" / "balls.md").read_text()
LEMMAS = re.findall(r"^\*\*Lemma (\d+) .*?\(((?:`[\w.]+`(?:, )?)+)\)$", PAGE, re.M | re.S)


def test_the_lemmas_are_numbered():
    assert [int(number) for number, _ in LEMMAS] == [*range(1, len(LEMMAS) + 1)]
    assert len(LEMMAS) == PAGE.count("**Lemma ") > 20


def test_each_lemma_stands_where_the_page_says():
    for _, places in LEMMAS:
        for place in re.findall(r"`([\w.]+)`", places):
            room = "" if place.startswith("core.") else "checker."
            resolve_name(f"nonsmooth.runtime.{room}{place}")
