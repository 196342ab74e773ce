"""Pictures of what is in a file: orbits, a branch, a proven map, a motion, a chart."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from nonsmooth.runtime.certification.boxes.record import FORMAT as BOX
from nonsmooth.runtime.continuation.event import FORMAT as BRANCH
from nonsmooth.runtime.continuation.event import LOCUS_FORMAT as LOCUS
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import is_of_format
from nonsmooth.runtime.finding import saved as found_orbits
from nonsmooth.runtime.kernels import is_saved

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["figure_of"]


def figure_of(path: Path, kind: str, periods: int) -> tuple[dict[str, str], Figure]:
    """Read a file and draw what is in it.

    Parameters
    ----------
    path : Path
        JSON of an orbit, one of several as ``FILE.json:N``, a branch, a curve of events, a
        proven map or found orbits; .npz or .csv of a motion; folder of a chart.
    kind : str
        As for `plot_orbit`; found orbits have "all", "time", "velocity" and "phase",
        and a chart only "all".
    periods : int
        How many periods of an orbit to draw against time.

    Returns
    -------
    dict of str
        What was drawn: the name of the orbit or of the system.
    Figure

    Raises
    ------
    InputError
        If the file cannot be read or is cut, edited or foreign, or for a kind that it has not.
    """
    if path.is_dir():
        from nonsmooth.runtime.charting.chart import load_chart
        from nonsmooth.runtime.charting.classes import title_of
        from nonsmooth.runtime.pictures.charts import chart_figure
        from nonsmooth.runtime.pictures.drawing import check_picture

        check_picture(kind, ("all",))
        chart = load_chart(path)
        return {"chart": title_of(chart)}, chart_figure(chart)
    if path.suffix.lower() in (".npz", ".csv"):
        from nonsmooth.runtime.pictures.scenes import trajectory_figure
        from nonsmooth.runtime.simulation.saved import load_trajectory

        motion = load_trajectory(path)
        return {"system": motion.name}, trajectory_figure(motion, kind)
    if is_of_format(path, BRANCH):
        from nonsmooth.runtime.continuation.drawing import branch_figure
        from nonsmooth.runtime.continuation.saved import load_branch

        branch = load_branch(path)
        if kind != "all":
            raise InputError(f"a branch has one kind of picture, all, not {kind}")
        return {"orbit": branch.name}, branch_figure(branch)
    if is_of_format(path, BOX):
        from nonsmooth.runtime.certification.boxes.drawing import box_figure
        from nonsmooth.runtime.certification.boxes.saved import load_box_certificate

        certificate = load_box_certificate(path)
        if kind != "all":
            raise InputError(f"a proven map has one kind of picture, all, not {kind}")
        return {"orbit": certificate.orbit}, box_figure(certificate)
    if is_of_format(path, LOCUS):
        from nonsmooth.runtime.continuation.drawing import locus_figure
        from nonsmooth.runtime.continuation.saved_locus import load_locus

        locus = load_locus(path)
        if kind != "all":
            raise InputError(f"a curve of events has one kind of picture, all, not {kind}")
        return {"orbit": locus.name}, locus_figure(locus)
    if is_of_format(path, found_orbits.FORMAT):
        from nonsmooth.runtime.pictures.found import found_figure

        found = found_orbits.load_found(path)
        return {"system": found.system}, found_figure(found, kind, periods=periods)
    from nonsmooth.runtime.orbit import Orbit
    from nonsmooth.runtime.saved import load_orbit_file
    from nonsmooth.runtime.saved_orbits import saved_orbit

    numbered = not path.exists() and is_saved(str(path))
    orbit = saved_orbit(str(path)) if numbered else load_orbit_file(path)
    if isinstance(orbit, Orbit):
        from nonsmooth.runtime.pictures.plot import orbit_figure

        return {"orbit": orbit.name}, orbit_figure(orbit, kind, periods=periods)
    from nonsmooth.runtime.pictures.composed import composed_figure

    return {"orbit": orbit.name}, composed_figure(orbit, kind, periods=periods)
