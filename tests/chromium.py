"""One headless Chromium that opens page after page, and what it sees on each."""

import fcntl
import json
import os
import shutil
import signal
import time
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from select import select
from tempfile import TemporaryDirectory
from threading import Thread

import pytest

SECONDS = 300
LOCAL = "127.0.0.1"
OPTIONS = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    *("--disable-dev-shm-usage", "--allow-file-access-from-files", "--hide-scrollbars"),
    *("--enable-logging=stderr", "--v=0"),
    f"--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE {LOCAL}",
]
UNRENDERED = r"/\\\(|\\\[|\\begin\{|\$\$/"
# What a reader would see of it, once formulas and pictures are there.
LOOK = (
    """(async () => {
  if (window.MathJax && MathJax.startup) await MathJax.startup.promise;
  const article = document.querySelector("article") || document.body;
  const words = document.createTreeWalker(article, NodeFilter.SHOW_TEXT, (text) =>
    text.parentElement.closest("pre, code, script, style, mjx-container")
      ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT);
  const formulas = [...document.querySelectorAll(".math")]
    .filter((one) => !one.querySelector("mjx-container") || one.querySelector("mjx-merror"))
    .map((one) => one.textContent);
  while (words.nextNode())
    if ("""
    + UNRENDERED
    + """.test(words.currentNode.data)) formulas.push(words.currentNode.data.trim());
  const wide = [...document.body.querySelectorAll("*")].filter((one) => {
    const box = one.getBoundingClientRect();
    return box.width && box.right > innerWidth + 1 && !inside(one.parentElement);
  });
  function inside(element) {
    return element && element !== document.body
      && (getComputedStyle(element).overflowX !== "visible"
        || getComputedStyle(element).position === "fixed" || inside(element.parentElement));
  }
  const shown = (one) => one.checkVisibility({ visibilityProperty: true, opacityProperty: true })
    && one.getBoundingClientRect().width > 0 && one.innerText.trim() !== "";
  return JSON.stringify({
    title: document.title,
    chapters: [...document.querySelectorAll("main > section")].filter(shown).map((one) => one.id),
    formulas,
    pictures: [...document.images].filter((one) => !one.complete || !one.naturalWidth)
      .map((one) => one.getAttribute("src")),
    unnamed: [...document.images].filter((one) => !one.hasAttribute("alt"))
      .map((one) => one.getAttribute("src")),
    width: innerWidth,
    scroll_width: document.documentElement.scrollWidth,
    wide: wide.map((one) => one.outerHTML.slice(0, 120)),
    links: [...document.links].map((one) => one.getAttribute("href")),
    anchors: [...document.querySelectorAll("[id]")].map((one) => one.id),
  });
})()"""
)


@dataclass(frozen=True)
class Seen:
    """What a page showed in a window of one width, and what it complained of until then.

    Attributes
    ----------
    title : str
    chapters : list of str
        Ids of the sections of ``main`` that can be seen.
    formulas : list of str
        Those that are not set, as they stand in the page.
    pictures, unnamed : list of str
        Addresses of those that did not load, and of those without a text in their place.
    width, scroll_width : int
        In pixels, of the window and of what is in it.
    wide : list of str
        Beginnings of the elements that stand out at the right and are in no box of their own.
    links, anchors : list of str
        Addresses as the page gives them, and ids that links may name.
    complaints : list of str
        Errors and warnings of the console, and what could not be loaded.
    requests : list of str
        Addresses outside the site that the page asked for.
    """

    title: str
    chapters: list[str]
    formulas: list[str]
    pictures: list[str]
    unnamed: list[str]
    width: int
    scroll_width: int
    wide: list[str]
    links: list[str]
    anchors: list[str]
    complaints: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)


@contextmanager
def served(site):
    """Serve a folder on this machine alone, at the address that is given."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_):
            """Tell nothing: the browser does."""

    server = ThreadingHTTPServer((LOCAL, 0), partial(Quiet, directory=str(site)))
    Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://{LOCAL}:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()


class Window:
    """A page of a browser that is driven over a pair of pipes."""

    def __init__(self, commands, answers):
        self._commands, self._answers = commands, answers
        self._said = b""
        self._count = 0
        self._session = None
        self._events = []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        attached = self.ask("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")

    def ask(self, method, **parameters):
        """Send one command of the DevTools protocol and give its result."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next_message()
            if answer.get("id") == self._count:
                assert "error" not in answer, f"{method}: {answer['error']}"
                return answer["result"]
            self._events.append(answer)

    def run(self, script):
        """Give the value of an expression, awaited, in the page."""
        asked = {"expression": script, "awaitPromise": True, "returnByValue": True}
        answer = self.ask("Runtime.evaluate", **asked)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def resize(self, width):
        """Give the window a width in pixels."""
        size = {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False}
        self.ask("Emulation.setDeviceMetricsOverride", **size)

    def open(self, address, width):
        """Open a page in a window of a width in pixels and wait until it has loaded."""
        self.resize(width)
        self._events.clear()
        self.ask("Page.navigate", url=address)
        while not any(event["method"] == "Page.loadEventFired" for event in self._events):
            self._events.append(self._next_message())

    def look(self, address, *widths):
        """Open a page and say what is seen in windows of these widths, one after the other."""
        self.open(address, widths[0])
        return [self._seen(address, width) for width in widths]

    def _seen(self, address, width):
        self.resize(width)
        facts = json.loads(self.run(LOOK))
        asked = [e["params"] for e in self._events if e["method"] == "Network.requestWillBeSent"]
        urls = [one["request"]["url"] for one in asked]
        site = address.split("/")[2]
        return Seen(
            **facts,
            complaints=list(filter(None, map(complaint, self._events))),
            requests=[url for url in urls if url.startswith("http") and url.split("/")[2] != site],
        )

    def _next_message(self):
        until = time.monotonic() + SECONDS
        while b"\0" not in self._said:
            ready, _, _ = select([self._answers], [], [], max(0.0, until - time.monotonic()))
            read = os.read(self._answers, 1 << 20) if ready else b""
            assert read, f"the browser was silent for {SECONDS} s"
            self._said += read
        message, _, self._said = self._said.partition(b"\0")
        return json.loads(message)


def complaint(event):
    """What an event of the browser complains of, if it does."""
    told = event.get("params", {})
    match event["method"]:
        case "Runtime.exceptionThrown":
            return json.dumps(told["exceptionDetails"])[:500]
        case "Runtime.consoleAPICalled" if told["type"] in {"error", "warning", "assert"}:
            return json.dumps(told["args"])[:500]
        case "Log.entryAdded" if told["entry"]["level"] in {"error", "warning"}:
            return f"{told['entry']['text']} {told['entry'].get('url', '')}"
        case "Network.loadingFailed" if not told.get("canceled"):
            return f"{told['errorText']} ({told['type']})"
        case "Network.responseReceived" if told["response"]["status"] >= 400:
            return f"{told['response']['status']} {told['response']['url']}"
    return None


def find_browser():
    """Path of Chromium; without it the test is skipped, or fails where it must not be."""
    names = ("chromium", "chromium-browser", "google-chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        reason = f"no browser: none of {', '.join(names)} is installed"
        (pytest.fail if os.environ.get("NONSMOOTH_NEEDS_BROWSER") else pytest.skip)(reason)
    return found


def look_at(path, *widths):
    """What the page of a file shows in windows of these widths."""
    with window() as page:
        return page.look(path.resolve().as_uri(), *widths)


@contextmanager
def window():
    """Start a browser that asks no other machine for anything, and give its page."""
    browser = find_browser()
    # it may still be writing there when the folder is removed
    with TemporaryDirectory(ignore_cleanup_errors=True) as name:
        place = Path(name)
        ours, theirs = os.pipe(), os.pipe()
        # numbers that cannot be 3 and 4, which the browser reads and writes
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in (theirs[0], ours[1])]
        log = os.open(place / "log", os.O_WRONLY | os.O_CREAT)
        actions = [(os.POSIX_SPAWN_DUP2, ends[0], 3), (os.POSIX_SPAWN_DUP2, ends[1], 4)]
        actions += [(os.POSIX_SPAWN_DUP2, log, 1), (os.POSIX_SPAWN_DUP2, log, 2)]
        command = [browser, *OPTIONS, "--remote-debugging-pipe", f"--user-data-dir={place}/profile"]
        process = os.posix_spawn(browser, command, os.environ, file_actions=actions)
        for end in (*ends, theirs[0], ours[1], log):
            os.close(end)
        try:
            try:
                page = Window(theirs[1], ours[0])
            except (AssertionError, BrokenPipeError) as silent:
                said = (place / "log").read_text("utf-8", errors="replace")
                pytest.fail(f"the browser did not begin ({silent!r}):\n{said[-3000:]}")
            yield page
        finally:
            os.close(theirs[1])  # without its pipe the browser ends
            finish(process)
            os.close(ours[0])


def finish(process):
    """Wait until a process has ended, and end it if it takes long."""
    for _ in range(100):
        if os.waitpid(process, os.WNOHANG)[0]:
            return
        time.sleep(0.1)
    os.kill(process, signal.SIGKILL)
    os.waitpid(process, 0)
