"""The reproduced paper, made once for all tests that look at it."""

import io
import json
import os
from dataclasses import dataclass
from pathlib import Path

import pytest

from nonsmooth.runtime.present.paper import writing
from tests.present.formulas import given_formulas
from tests.shared import FOLDER, shared_value

EMPTY = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>'
DRAWN = (*(0, 5, 10), *range(12, 16))  # pictures that are not empty, by their places


@dataclass(frozen=True)
class Paper:
    """What is written of the paper, with proofs."""

    folder: Path
    figures: dict  # by their stems
    again: dict  # files of the pictures that are not empty, made a second time
    steps: tuple

    @property
    def results(self):
        """Numbers, as they are in the file."""
        return json.loads(self.read("results.json"))

    def read(self, name):
        """The text of a file."""
        return (self.folder / name).read_text(encoding="utf-8")


def written(folder, formulas, *, certified=False, pictures=()):
    """Reproduce the paper; its pictures are empty but those that are named by their places."""
    figure = pytest.importorskip("matplotlib.figure")
    drawn = []
    twice = []
    steps = []
    save = figure.Figure.savefig

    def saved(own, target, **options):
        second = io.BytesIO()
        if len(drawn) // 2 in pictures:
            for file in (target, second):
                save(own, file, **options)
        else:
            target.write(EMPTY)
        drawn.append(own)
        twice.append(second.getvalue())

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(figure.Figure, "savefig", saved)
        paths = writing.reproduce(folder, formulas, steps.append, certified=certified)
    files = [path for path in paths if path.suffix in (".svg", ".png")]
    figures = {path.stem: own for path, own in zip(files, drawn, strict=True)}
    again = {path.name: file for path, file in zip(files, twice, strict=True) if file}
    return Paper(folder, figures, again, tuple(steps))


@pytest.fixture(scope="session")
def paper():
    """The whole report, drawn by someone whose paper is black."""
    matplotlib = pytest.importorskip("matplotlib")
    for name in ("jinja2", "latex2mathml", "mdit_py_plugins"):
        pytest.importorskip(name)

    def draw():
        folder = Path(os.environ[FOLDER]) / "paper"
        with matplotlib.rc_context({"figure.facecolor": "black", "text.color": "white"}):
            return written(folder, given_formulas, certified=True, pictures=DRAWN)

    return shared_value("paper", draw)


@pytest.fixture(scope="session")
def orbits():
    """The orbits of the paper, to be put in the place of its computation."""
    return dict(writing.paper_orbits(lambda step: None))
