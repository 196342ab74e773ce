"""Figures of results, as they are drawn by themselves and from their files."""

from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from nonsmooth.runtime.present.pictures.saved_files import figure_of as figure_of_file


def figure_of(axes):
    """Give the figure of what a result's `plot` gave."""
    return np.ravel(axes)[0].figure


def figure_in(path, kind="all", **view):
    """Give the figure of a file, outside pyplot, as the command draws it."""
    return figure_of_file(path, kind, 1, view or None)[1]


def figure_of_saved(result, kind="all", **view):
    """Give the figure of a result that is saved in a file."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "result.json"
        result.save(path)
        return figure_in(path, kind, **view)


def legend_of(axes):
    """Give the texts of a legend."""
    return [text.get_text() for text in axes.get_legend().get_texts()]


def with_multipliers(orbit, *numbers):
    """An orbit with other multipliers; a 1 among them is a trivial one."""
    found, stability = replace(orbit), orbit.stability
    (one, *_) = stability.multipliers
    every = tuple(
        replace(one, real=m.real, imaginary=m.imag, trivial=m == 1) for m in map(complex, numbers)
    )
    vars(found.evaluation)["stability"] = replace(stability, multipliers=every)
    return found
