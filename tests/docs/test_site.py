"""The documentation builds without a warning, and a browser shows every page of it whole."""

import fcntl
import json
import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote, urljoin, urlsplit

import pytest

import nonsmooth
import nonsmooth.derive
import nonsmooth.jax
import nonsmooth.torch
from tests.chromium import served, window
from tests.cli.terminal import all_commands
from tests.places import CHECKOUT, records

PACKAGES = (nonsmooth, nonsmooth.derive, nonsmooth.jax, nonsmooth.torch)
PUBLIC = {f"{package.__name__}.{n}" for package in PACKAGES for n in package.__all__}
PUBLIC |= {f"nonsmooth.certify.{n}" for n in vars(type(nonsmooth.certify)) if n[0] != "_"}
PUBLIC |= {f"{record.__module__}.{name}" for name, record in records().items()}
WITHOUT_PAGE = {"nonsmooth.__version__"}
WIDTHS = (1280, 400)
# Addresses of what a search has found, when it is done.
SEARCHED = """(async () => {
  const done = () => /Search Results/.test(document.querySelector("#search-results h2")?.innerText);
  for (let tries = 0; tries < 200 && !done(); tries++)
    await new Promise((wait) => setTimeout(wait, 100));
  const results = [...document.querySelectorAll("#search-results li a")];
  return JSON.stringify(results.map((one) => one.getAttribute("href")));
})()"""
BROKEN = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>broken</title></head><body><article>
<p>A formula that is not set: \\\\(x^2\\\\), and <span class="math">y</span>.</p>
<div style="width: 900px">wide</div>
<div style="width: 200px; overflow-x: auto"><div style="width: 900px">in a box</div></div>
<img src="picture.png"><img src="https://example.org/picture.png" alt="">
<a id="place" href="#place">here</a><a href="#nowhere">nowhere</a><a href="other.html">other</a>
<a href="https://example.org/">elsewhere</a><a href="https://nonsense">nonsense</a>
<script>console.error("an error"); throw new Error("thrown");</script>
</article></body></html>
"""


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """Build the site as its one command does: once, though several processes ask for it."""
    place = tmp_path_factory.getbasetemp()
    place = place.parent if place.name.startswith("popen-gw") else place
    out = place / "documentation" / "site"
    with (place / "documentation.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (out / "searchindex.js").is_file():
            options = ["-j", "auto", "-W", "--keep-going"]
            command = [sys.executable, "-m", "sphinx", *options, "docs", str(out)]
            built = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True)
            assert built.returncode == 0, built.stderr[-5000:]
    return out


@pytest.fixture(scope="module")
def browser():
    """One browser for all pages."""
    with window() as page:
        yield page


def pages(site):
    """Addresses of all pages in a folder, from it."""
    found = (file.relative_to(site).as_posix() for file in site.rglob("*.html"))
    return sorted(page for page in found if not page.startswith("_"))


def faults(seen):
    """What is wrong with a page as it was seen in one window after the other."""
    found = {
        f"{name} at {one.width}": what
        for one in seen
        for name, what in (
            ("no title", not one.title),
            ("formulas that are not set", one.formulas),
            ("pictures that are not there", one.pictures),
            ("pictures without a text", one.unnamed),
            ("wider than the window", one.scroll_width > one.width and (one.wide or True)),
            ("complaints", one.complaints),
            ("asked of others", one.requests),
        )
    }
    return {name: what for name, what in found.items() if what}


def leads_somewhere(link, page, seen, site):
    """Whether a link of a page leads to a file and a place in it, or has the form of an address."""
    target = urlsplit(urljoin(f"http://site/{page}", link))
    if target.netloc != "site":
        return (
            re.fullmatch(r"https?://[\w-]+(\.[\w-]+)+", f"{target.scheme}://{target.netloc}")
            is not None
        )
    place = unquote(target.path).strip("/") or "index.html"
    if place not in seen:
        return (site / place).is_file()
    return not target.fragment or unquote(target.fragment) in seen[place][0].anchors


@pytest.mark.slow
@pytest.mark.browser
def test_every_page_is_shown_whole(site, browser):
    with served(site) as address:
        seen = {page: browser.look(f"{address}/{page}", *WIDTHS) for page in pages(site)}
    assert len(seen) > len(PUBLIC)
    assert {page: wrong for page, each in seen.items() if (wrong := faults(each))} == {}
    links = {(page, link) for page, (one, *_) in seen.items() for link in one.links}
    assert [link for link in sorted(links) if not leads_somewhere(*link[::-1], seen, site)] == []


@pytest.mark.slow
@pytest.mark.browser
def test_search_finds_a_word_and_a_name(site, browser):
    with served(site) as address:
        for word, page in (
            ("saltation", "theory/"),
            ("continue_orbit", "nonsmooth.continue_orbit"),
        ):
            browser.open(f"{address}/search.html?q={word}", WIDTHS[0])
            found = browser.run(SEARCHED)
            assert any(page in link for link in json.loads(found)), (word, found)


@pytest.mark.slow
@pytest.mark.parametrize(("command", "code"), [("list", 0), ("list no-such-system", 2)])
def test_a_command_that_fails_makes_the_build_fail(tmp_path, command, code):
    head = "---\nfile_format: mystnb\nkernelspec:\n  name: python3\n---\n\n# A page\n\n"
    (tmp_path / "index.md").write_text(
        f"{head}```{{code-cell}} ipython3\n!nonsmooth {command}\n```\n"
    )
    (tmp_path / "conf.py").write_text(
        f"import sys, os\nsys.path.insert(0, {str(CHECKOUT / 'docs' / '_extensions')!r})\n"
        "extensions = ['myst_nb', 'failing_commands']\n"
        "nb_execution_raise_on_error = True\n"
        f"os.environ['PATH'] = {str(Path(sys.executable).parent)!r} + ':' + os.environ['PATH']\n"
    )
    words = [sys.executable, "-m", "sphinx", "-T", str(tmp_path), str(tmp_path / "site")]
    told = subprocess.run(words, capture_output=True, text=True, timeout=600, check=False)
    assert (told.returncode == 0) == (code == 0), told.stderr
    assert ("unknown system 'no-such-system'" in told.stderr) == (code != 0)


@pytest.mark.slow
def test_every_public_name_has_a_page(site):
    told = {file.stem for file in (site / "reference" / "api").glob("*.html")}
    assert told >= PUBLIC - WITHOUT_PAGE


@pytest.mark.slow
def test_every_command_and_option_is_told(site):
    page = (site / "reference" / "command_line.html").read_text("utf-8")
    anchors = set(re.findall(r'id="([^"]+)"', page))
    for name, command in all_commands().items():
        anchor = "-".join(("nonsmooth", *name.split()))
        assert anchor in anchors
        for option in (one for p in command.params for one in p.opts if one.startswith("--")):
            assert f"cmdoption-{anchor}-{option.lstrip('-')}" in anchors


@pytest.mark.browser
def test_what_is_broken_is_noticed(tmp_path, browser):
    (tmp_path / "broken.html").write_text(BROKEN, encoding="utf-8")
    with served(tmp_path) as address:
        both = browser.look(f"{address}/broken.html", 1280, 400)
    seen = both[1]
    assert len(seen.formulas) == 2
    assert seen.pictures == ["picture.png", "https://example.org/picture.png"]
    assert seen.unnamed == ["picture.png"]
    assert (seen.scroll_width > 890, len(seen.wide)) == (True, 1)
    for said in ("an error", "thrown", "404", "ERR_NAME_NOT_RESOLVED"):
        assert any(said in complaint for complaint in seen.complaints)
    assert seen.requests == ["https://example.org/picture.png"]
    assert len(faults([seen])) == 6
    assert {name for name in faults(both) if name.startswith("wider")} == {
        "wider than the window at 400"
    }
    all_seen = {"broken.html": both}
    lost = [x for x in seen.links if not leads_somewhere(x, "broken.html", all_seen, tmp_path)]
    assert lost == ["#nowhere", "other.html", "https://nonsense"]
