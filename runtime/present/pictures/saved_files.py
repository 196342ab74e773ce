"""Pictures of what is in a file: whatever was saved, but for proofs that are no map."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.explore.finding.find import Found
from nonsmooth.runtime.explore.fitting.fit import Fit
from nonsmooth.runtime.model.kernels import is_saved
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.files.kept import KINDS
from nonsmooth.runtime.present.files.loading import format_of, load
from nonsmooth.runtime.present.files.named_entries import saved_orbit
from nonsmooth.runtime.present.pictures.plot import motion_figure
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_BRANCH = "nonsmooth branch"


def figure_of(
    path: Path, kind: str, periods: int, branch: Mapping[str, Any] | None = None
) -> tuple[dict[str, str], Figure]:
    """Read a file, and give what it names (the orbit or the system) with its figure.

    The file is one that `load` reads. A certificate, certificates of events and a census have no
    picture. The kinds are those of `plot_motion`; found orbits have "all", "time", "velocity" and
    "phase", and results that are drawn in one way have "all" only. `branch` has arguments of
    `draw_branch`, and is for a branch alone. `InputError` is raised if the file cannot be read or
    is cut, edited or foreign, or if it has no such kind or quantity.
    """
    there = path.exists() or ":" in path.name
    if branch is not None and there and (path.is_dir() or format_in(path) != _BRANCH):
        raise InputError(f"quantities are drawn of branches, and {path} is none")
    if path.is_dir():
        from nonsmooth.runtime.explore.charting.chart import reading
        from nonsmooth.runtime.explore.charting.classes import title_of
        from nonsmooth.runtime.present.pictures.charts import chart_figure

        _check_all(kind, "chart")
        chart = load(path)
        with reading(path):
            return {"chart": title_of(chart)}, chart_figure(chart)
    one = not path.exists() and is_saved(str(path))
    result = saved_orbit(str(path)) if one else load(path)
    if isinstance(result, Orbit):
        return {"orbit": result.name}, motion_figure(result, kind, periods=periods)
    if isinstance(result, Trajectory):
        return {"system": result.name}, motion_figure(result, kind)
    if isinstance(result, Found):
        return {"system": result.system}, result.plot(kind, periods=periods)
    what = KINDS[format_of(path)].what.removeprefix("saved ")
    if not hasattr(result, "plot"):
        raise InputError(
            f"{path} holds a {what}, of which there is no picture:"
            f" `nonsmooth certify check {path}` proves it again"
        )
    _check_all(kind, what)
    orbit = getattr(result, "orbit", None)
    named = {"system": result.system} if orbit is None else {"orbit": getattr(orbit, "name", orbit)}
    if isinstance(result, Fit):
        return named, registered("fit_figure")(result)
    return named, result.plot(**(branch or {}))


def _check_all(kind: str, what: str) -> None:
    """Raise `InputError` for another kind of picture than the one that a result has."""
    if kind != "all":
        raise InputError(f"a {what} has one kind of picture, all, not {kind}")
