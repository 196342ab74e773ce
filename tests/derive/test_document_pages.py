"""Every formula of every document: the same on the page in each format, and none left out."""

import pytest

from tests.documents import declarations, document_of, marked
from tests.formulas.pages import on_pages

pytest.importorskip("latex2mathml")


@pytest.mark.parametrize("name", marked(declarations(), "den_hartog/without-rest"))
def test_every_format_shows_the_same_formulas(name: str) -> None:
    document, _ = document_of(name)
    own, *formats = on_pages(document).items()
    assert own[1].total() > 10
    for format, shown in formats:
        more, less = shown - own[1], own[1] - shown
        assert not more, (format, list(more)[:2])
        assert not less, (format, list(less)[:2])
