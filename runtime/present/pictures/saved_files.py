"""Pictures of what is in a file: whatever was saved, but for proofs that are no map."""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.model.kernels import is_saved

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["figure_of"]

_BRANCH = "nonsmooth branch"


class _OneWay(NamedTuple):
    """A result that has one picture."""

    what: str
    names: str  # "orbit" or "system"
    name: str  # attribute that has it
    draw: str  # registered function


_IN_ONE_WAY: Mapping[str, _OneWay] = MappingProxyType(
    {
        _BRANCH: _OneWay("a branch", "orbit", "name", "draw_branch"),
        "nonsmooth design": _OneWay("a design", "orbit", "orbit.name", "draw_design"),
        "nonsmooth locus": _OneWay("a curve of events", "orbit", "name", "draw_locus"),
        "nonsmooth box certificate": _OneWay("a proven map", "orbit", "orbit", "draw_box"),
        "nonsmooth certified branch": _OneWay(
            "a certified branch", "orbit", "orbit", "draw_certified_branch"
        ),
        "nonsmooth certified doubling": _OneWay(
            "a certified doubling", "orbit", "orbit", "draw_doubling"
        ),
        "nonsmooth basin certificate": _OneWay(
            "a certificate of a basin", "orbit", "orbit", "draw_basin"
        ),
        "nonsmooth chaos certificate": _OneWay(
            "a certificate of chaos", "system", "system", "draw_chaos"
        ),
        "nonsmooth region certificate": _OneWay("a region", "system", "system", "draw_graph"),
        "nonsmooth sweep": _OneWay("a sweep", "system", "system", "draw_sweep"),
        "nonsmooth fit": _OneWay("a fit", "system", "system", "fit_figure"),
    }
)
_WITHOUT: Mapping[str, str] = MappingProxyType(
    {
        "nonsmooth certificate": "a certificate",
        "nonsmooth event certificate": "certificates of events",
        "nonsmooth census": "a census",
    }
)


def figure_of(
    path: Path, kind: str, periods: int, branch: Mapping[str, Any] | None = None
) -> tuple[dict[str, str], Figure]:
    """Read a file, and give what it names (the orbit or the system) with its figure.

    The file is JSON of an orbit, one of several as ``FILE.json:N``, a branch, a curve of
    events, a proven map, found orbits, a sweep, a fit or a design; .npz or .csv of a
    motion; or the folder of a chart. A certificate, certificates of events and a census
    have no picture. The kinds are those of `plot_orbit`; found orbits have "all", "time",
    "velocity" and "phase", and results that are drawn in one way have "all" only. `branch`
    has arguments of `draw_branch`, and is for a branch alone. `InputError` is raised if the
    file cannot be read or is cut, edited or foreign, or if it has no such kind or quantity.
    """
    from nonsmooth.runtime.present.files.loading import format_of, load
    from nonsmooth.runtime.present.files.named_entries import saved_orbit
    from nonsmooth.runtime.present.pictures.plot import orbit_figure, trajectory_figure

    there = path.exists() or ":" in path.name
    if branch is not None and there and (path.is_dir() or format_in(path) != _BRANCH):
        raise InputError(f"quantities are drawn of branches, and {path} is none")
    if path.is_dir():
        from nonsmooth.runtime.explore.charting.chart import reading
        from nonsmooth.runtime.explore.charting.classes import title_of
        from nonsmooth.runtime.present.pictures.charts import chart_figure

        _check_all(kind, "a chart")
        chart = load(path)
        with reading(path):
            return {"chart": title_of(chart)}, chart_figure(chart)
    if path.suffix.lower() in (".npz", ".csv"):
        motion = load(path)
        return {"system": motion.name}, trajectory_figure(motion, kind)
    if not path.exists() and is_saved(str(path)):
        orbit = saved_orbit(str(path))
        return {"orbit": orbit.name}, orbit_figure(orbit, kind, periods=periods)
    form = format_of(path)
    if form in _WITHOUT:
        raise InputError(
            f"{path} holds {_WITHOUT[form]}, of which there is no picture:"
            f" `nonsmooth certify check {path}` proves it again"
        )
    if form in _IN_ONE_WAY:
        entry = _IN_ONE_WAY[form]
        _check_all(kind, entry.what)
        result = load(path)
        named = {entry.names: attrgetter(entry.name)(result)}
        return named, registered(entry.draw)(result, **(branch or {}))
    result = load(path)
    if form == "nonsmooth found orbits":
        from nonsmooth.runtime.present.pictures.found import found_figure

        return {"system": result.system}, found_figure(result, kind, periods=periods)
    return {"orbit": result.name}, orbit_figure(result, kind, periods=periods)


def _check_all(kind: str, what: str) -> None:
    """Raise `InputError` for another kind of picture than the one that a result has."""
    if kind != "all":
        raise InputError(f"{what} has one kind of picture, all, not {kind}")
