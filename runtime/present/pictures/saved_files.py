"""Pictures of what is in a file: whatever was saved, but for proofs that are no map."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.model.kernels import is_saved

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["BranchView", "figure_of"]

_BRANCH = "nonsmooth branch"

Drawn = tuple[dict[str, str], "Figure"]  # what was drawn: the name of the orbit or the system


class BranchView(NamedTuple):
    """What is drawn of a branch, as arguments of `branch_figure`."""

    quantities: tuple[str, ...]
    over: str | None
    frequency: str  # "angular" or "cycles"


def figure_of(path: Path, kind: str, periods: int, view: BranchView | None = None) -> Drawn:
    """Read a file, and give what it names (the orbit or the system) with its figure.

    The file is JSON of an orbit, one of several as ``FILE.json:N``, a branch, a curve of
    events, a proven map, found orbits, a sweep, a fit or a design; .npz or .csv of a
    motion; or the folder of a chart. A certificate, certificates of events and a census
    have no picture. The kinds are those of `plot_orbit`; found orbits have "all", "time",
    "velocity" and "phase", and results that are drawn in one way have "all" only. `view` is
    for a branch, and None for its defaults. `InputError` is raised if the file cannot be
    read or is cut, edited or foreign, or if it has no such kind or quantity.
    """
    if view is not None and (path.exists() or ":" in path.name):
        if path.is_dir() or format_in(path) != _BRANCH:
            raise InputError(f"quantities are drawn of branches, and {path} is none")
        return _in_one_way("a branch", kind, lambda file: _branch(file, *view), path)
    if path.is_dir():
        return _in_one_way("a chart", kind, _chart, path)
    if path.suffix.lower() in (".npz", ".csv"):
        from nonsmooth.runtime.present.files.motions import load_trajectory
        from nonsmooth.runtime.present.pictures.scenes import trajectory_figure

        motion = load_trajectory(path)
        return {"system": motion.name}, trajectory_figure(motion, kind)
    from nonsmooth.runtime.present.files.loading import format_of
    from nonsmooth.runtime.present.files.named_entries import saved_orbit
    from nonsmooth.runtime.present.pictures.plot import orbit_figure

    if not path.exists() and is_saved(str(path)):
        orbit = saved_orbit(str(path))
        return {"orbit": orbit.name}, orbit_figure(orbit, kind, periods=periods)
    form = format_of(path)
    if form in _WITHOUT:
        raise InputError(
            f"{path} holds {_WITHOUT[form]}, of which there is no picture:"
            f" `nonsmooth certify --check {path}` proves it again"
        )
    if form in _IN_ONE_WAY:
        return _in_one_way(_IN_ONE_WAY[form][0], kind, _IN_ONE_WAY[form][1], path)
    if form == "nonsmooth found orbits":
        from nonsmooth.runtime.present.files.found import load_found
        from nonsmooth.runtime.present.pictures.found import found_figure

        found = load_found(path)
        return {"system": found.system}, found_figure(found, kind, periods=periods)
    from nonsmooth.runtime.present.files.orbits import load_orbit_file

    orbit = load_orbit_file(path)
    return {"orbit": orbit.name}, orbit_figure(orbit, kind, periods=periods)


def _in_one_way(what: str, kind: str, draw: Callable[[Path], Drawn], path: Path) -> Drawn:
    if kind != "all":
        raise InputError(f"{what} has one kind of picture, all, not {kind}")
    return draw(path)


def _chart(path: Path) -> Drawn:
    from nonsmooth.runtime.explore.charting.chart import load_chart, reading
    from nonsmooth.runtime.explore.charting.classes import title_of
    from nonsmooth.runtime.present.pictures.charts import chart_figure

    chart = load_chart(path)
    with reading(path):
        return {"chart": title_of(chart)}, chart_figure(chart)


def _branch(path: Path, *view: Any) -> Drawn:
    from nonsmooth.runtime.present.files.branches import load_branch
    from nonsmooth.runtime.present.pictures.branches import branch_figure

    branch = load_branch(path)
    return {"orbit": branch.name}, branch_figure(branch, *view)


def _locus(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.loci import load_locus
    from nonsmooth.runtime.present.pictures.branches import locus_figure

    locus = load_locus(path)
    return {"orbit": locus.name}, locus_figure(locus)


def _design(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.designs import load_design
    from nonsmooth.runtime.present.pictures.designs import design_figure

    found = load_design(path)
    return {"orbit": found.orbit.name}, design_figure(found)


def _of_orbit(found: Any) -> Drawn:
    return {"orbit": found.orbit}, found.plot()


def _proven_map(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.box_certificates import load_box_certificate

    return _of_orbit(load_box_certificate(path))


def _certified_branch(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.certified_branches import load_certified_branch

    return _of_orbit(load_certified_branch(path))


def _certified_doubling(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.certified_doublings import load_certified_doubling

    return _of_orbit(load_certified_doubling(path))


def _basin(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.basin_certificates import load_basin_certificate
    from nonsmooth.runtime.present.pictures.certified_basins import basin_figure

    found = load_basin_certificate(path)
    return {"orbit": found.orbit}, basin_figure(found)


def _chaos(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.chaos_certificates import load_chaos_certificate
    from nonsmooth.runtime.present.pictures.horseshoes import chaos_figure

    found = load_chaos_certificate(path)
    return {"system": found.system}, chaos_figure(found)


def _graph(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.graph_certificates import load_graph_certificate
    from nonsmooth.runtime.present.pictures.box_graphs import graph_figure

    found = load_graph_certificate(path)
    return {"system": found.system}, graph_figure(found)


def _sweep(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.sweeps import load_sweep
    from nonsmooth.runtime.present.pictures.maps import draw_sweep

    diagram = load_sweep(path)
    return {"system": diagram.system}, draw_sweep(diagram)


def _fit(path: Path) -> Drawn:
    from nonsmooth.runtime.present.files.fits import load_fit
    from nonsmooth.runtime.present.pictures.fits import fit_figure

    fit = load_fit(path)
    return {"system": fit.system}, fit_figure(fit)


_WITHOUT = {
    "nonsmooth certificate": "a certificate",
    "nonsmooth event certificate": "certificates of events",
    "nonsmooth census": "a census",
}
_IN_ONE_WAY: dict[str, tuple[str, Callable[[Path], Drawn]]] = {
    _BRANCH: ("a branch", _branch),
    "nonsmooth design": ("a design", _design),
    "nonsmooth locus": ("a curve of events", _locus),
    "nonsmooth box certificate": ("a proven map", _proven_map),
    "nonsmooth certified branch": ("a certified branch", _certified_branch),
    "nonsmooth certified doubling": ("a certified doubling", _certified_doubling),
    "nonsmooth basin certificate": ("a certificate of a basin", _basin),
    "nonsmooth chaos certificate": ("a certificate of chaos", _chaos),
    "nonsmooth graph certificate": ("a graph of boxes", _graph),
    "nonsmooth sweep": ("a sweep", _sweep),
    "nonsmooth fit": ("a fit", _fit),
}
