"""The page of the verifier's lemmas numbers them, and names places that are there."""

import re
from functools import reduce
from importlib import import_module
from pathlib import Path

PAGE = (Path(__file__).parents[2] / "docs" / "theory" / "balls.md").read_text()
LEMMAS = re.findall(r"^\*\*Lemma (\d+) .*?\(((?:`[\w.]+`(?:, )?)+)\)$", PAGE, re.M | re.S)


def test_the_lemmas_are_numbered():
    assert [int(number) for number, _ in LEMMAS] == [*range(1, len(LEMMAS) + 1)]
    assert len(LEMMAS) == PAGE.count("**Lemma ") > 20


def test_each_lemma_stands_where_the_page_says():
    for _, places in LEMMAS:
        for place in re.findall(r"`([\w.]+)`", places):
            room, *names = (
                place.split(".") if place.startswith("core.") else ("checker", *place.split("."))
            )
            module = import_module(f"nonsmooth.runtime.{room}.{names[0]}")
            reduce(getattr, names[1:], module)
