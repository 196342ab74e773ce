"""The report's page in a real browser: quiet, offline and no wider than the window."""

from pathlib import Path

import pytest

from tests.chromium import look_at

pytestmark = pytest.mark.browser


@pytest.mark.slow
def test_page_opens_offline_and_fits(paper):
    """It is seen whole in wide and narrow windows, and asks for nothing."""
    path = paper.folder / "report.html"
    for width, seen in zip((1280, 390), look_at(path, 1280, 390), strict=True):
        assert seen.width == width
        assert seen.scroll_width <= width
        assert seen.wide == seen.complaints == seen.requests == []
        assert seen.chapters == [
            *("rigid-impact", "soft-impact", "symmetrical-periodic-solution"),
            *("periodic-solution-including-a-global-sticking-phase", "solution-ii"),
            *("stability-and-the-poincaré-map", "proofs", "misprints"),
        ]


def test_missing_browser_fails_only_where_it_is_needed(monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.setenv("NONSMOOTH_NEEDS_BROWSER", "1")
    with pytest.raises(pytest.fail.Exception, match="no browser"):
        look_at(Path("report.html"), 390)
    monkeypatch.delenv("NONSMOOTH_NEEDS_BROWSER")
    with pytest.raises(pytest.skip.Exception, match="no browser"):
        look_at(Path("report.html"), 390)
