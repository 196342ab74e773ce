"""Pages as headless Chromium shows them."""

import json
import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

SECONDS = 60
OPTIONS = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    *("--disable-dev-shm-usage", "--allow-file-access-from-files", "--hide-scrollbars"),
    *("--enable-logging=stderr", "--v=0", "--host-resolver-rules=MAP * ~NOTFOUND"),
]

# A window may not be narrower than 500 pixels, but a frame may.
FRAME = """<!DOCTYPE html>
<html><head><meta charset="utf-8"><title>frame</title></head><body>
<script>
function boxed(element) {
  return element.localName !== "main"
    && (getComputedStyle(element).overflowX !== "visible" || boxed(element.parentElement));
}
function measure(frame) {
  const page = frame.contentDocument;
  const shown = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty:
    true }) && element.getBoundingClientRect().width > 0 && element.innerText.trim() !== "";
  document.body.dataset.facts = JSON.stringify({
    chapters: [...page.querySelectorAll("main > section")].filter(shown).map((one) => one.id),
    width: frame.contentWindow.innerWidth,
    scroll_width: page.documentElement.scrollWidth,
    wide: [...page.querySelectorAll("main *")].filter((one) => !boxed(one.parentElement)
      && one.getBoundingClientRect().right > frame.contentWindow.innerWidth + 1)
      .map((one) => one.outerHTML.slice(0, 80)),
  });
}
</script>
<iframe src="ADDRESS" style="width: WIDTHpx; height: 900px; border: 0" onload="measure(this)">
</iframe>
</body></html>
"""


@dataclass(frozen=True)
class PageFacts:
    """What a page did and how it lies in the window.

    Attributes
    ----------
    chapters : tuple of str
        Ids of the sections of ``main`` that can be seen.
    width, scroll_width : int
        Of the window, and of what is in it, in pixels.
    wide : tuple of str
        Beginnings of the elements that stand out at the right and are in no box of their own.
    messages : tuple of str
        What the console said.
    requests : tuple of str
        Addresses that the page asked for, other than files and data.
    """

    chapters: tuple[str, ...]
    width: int
    scroll_width: int
    wide: tuple[str, ...]
    messages: tuple[str, ...]
    requests: tuple[str, ...]


def find_browser() -> str:
    """Path of Chromium; without it the test is skipped, or fails where it must not be."""
    names = ("chromium", "chromium-browser", "google-chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        reason = f"no browser: none of {', '.join(names)} is installed"
        (pytest.fail if os.environ.get("NONSMOOTH_NEEDS_BROWSER") else pytest.skip)(reason)
    return found


def inspect_page(path: Path, width: int) -> PageFacts:
    """Open a page from its file, in a window of a width in pixels, and look at it."""
    browser = find_browser()
    assert path.is_file(), f"there is no page {path}"
    with folder() as place:
        frame = place / "frame.html"
        address = path.resolve().as_uri()
        frame.write_text(FRAME.replace("ADDRESS", address).replace("WIDTH", str(width)), "utf-8")
        log = place / "requests.json"
        command = [browser, *OPTIONS, "--window-size=1400,1000", f"--user-data-dir={place}/profile"]
        command += [f"--log-net-log={log}", "--dump-dom", frame.as_uri()]
        dumped, said = run(command)
        found = re.search(r'data-facts="([^"]*)"', dumped)
        assert found, f"{path} was not measured; the browser said:\n{said[-3000:]}"
        facts: dict[str, Any] = json.loads(unescape(found[1]))
        return PageFacts(
            chapters=tuple(facts["chapters"]),
            width=facts["width"],
            scroll_width=facts["scroll_width"],
            wide=tuple(facts["wide"]),
            messages=tuple(re.findall(r"CONSOLE.*", said)),
            requests=tuple(dict.fromkeys(requests(log))),
        )


@contextmanager
def folder() -> Iterator[Path]:
    """A folder in which the browser may still be writing when it is removed."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as name:
        yield Path(name)


def run(command: list[str]) -> tuple[str, str]:
    """Both outputs of the browser."""
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=SECONDS, check=False, errors="replace"
        )
    except subprocess.TimeoutExpired as late:
        pytest.fail(f"the browser was not done in {SECONDS} s: {late.stderr!r}")
    assert done.returncode == 0, f"the browser failed:\n{done.stderr[-3000:]}"
    return done.stdout, done.stderr


def requests(log: Path) -> Iterator[str]:
    """Addresses in a net log that a page of a file asked for."""
    recorded = json.loads(log.read_text("utf-8"))
    start = recorded["constants"]["logEventTypes"]["URL_REQUEST_START_JOB"]
    for event in recorded["events"]:
        details = event.get("params", {})
        url = details.get("url", "")
        own = details.get("initiator", "").startswith(("file:", "null"))
        if event["type"] == start and own and not url.startswith(("file:", "data:", "chrome")):
            yield url
