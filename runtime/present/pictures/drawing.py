"""What all pictures share: colours, dashes, legends, and where boundaries lie.

Colours are those of Okabe and Ito and of Tol, which colour-blind readers can tell apart;
lines differ by their dashes too.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra, unknown_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

__all__ = [
    "LINES",
    "band_style",
    "check_picture",
    "chosen_masses",
    "configuration_color",
    "dot_style",
    "draw_arrow",
    "draw_levels",
    "drawn_alone",
    "finish",
    "given_axes",
    "line_style",
    "noun",
    "part_tick_labels",
]

LINES = (("#0072B2", "-"), ("#D55E00", (0, (5, 1.6))), ("#009E73", "-."), ("#CC79A7", ":"))
_FEWEST = 2  # labels of an axis, however long they are
_HEIGHT, _WIDTH = 0.07, 0.12  # of a label, in those of the data
_CONFIGURATIONS = (
    *("#99DDFF", "#EEDD88", "#FFAABB", "#BBCC33", "#DDDDDD"),
    *("#EE8866", "#77AADD", "#44BB99", "#AAAA00"),
)


def configuration_color(place: int) -> str:
    """Colour of a configuration by its place in the system.

    Parameters
    ----------
    place : int
        Number of the configuration.

    Returns
    -------
    str
        A colour of matplotlib.
    """
    return _CONFIGURATIONS[place % len(_CONFIGURATIONS)]


def check_picture(kind: str, kinds: Sequence[str]) -> None:
    """Refuse an unknown kind of picture, and say so if matplotlib is not installed.

    Parameters
    ----------
    kind : str
        The kind that is asked for.
    kinds : sequence of str
        Those there are.

    Raises
    ------
    InputError
        If there is no such kind.
    MissingExtra
        If matplotlib is not installed.
    """
    if kind not in kinds:
        raise unknown_name("kind of picture", kind, kinds)
    check_matplotlib()


def check_matplotlib() -> None:
    """Say so if matplotlib is not installed.

    Raises
    ------
    MissingExtra
        If matplotlib is not installed.
    """
    try:
        import matplotlib  # noqa: F401 (is it there?)
    except ImportError:
        raise missing_extra("plot", "matplotlib") from None


def chosen_masses(masses: Iterable[int] | None, count: int, name: str) -> tuple[int, ...]:
    """Masses that are drawn; all when none are given.

    Parameters
    ----------
    masses : iterable of int, optional
        Numbers of masses, from 0.
    count : int
        How many masses there are.
    name : str
        Of what is drawn, for the message.

    Returns
    -------
    tuple of int
        In the order in which they were given.

    Raises
    ------
    InputError
        If there is no such mass, or none is chosen.
    """
    every = range(count)
    drawn = tuple(every if masses is None else masses)
    if not drawn or not set(drawn) <= set(every):
        raise InputError(f"masses = {list(drawn)}: {name} has {list(every)}")
    return drawn


def given_axes(axes: Any, kind: str, counts: Sequence[int]) -> list[Axes]:
    """Axes that a caller gave, as many as the kind takes.

    Parameters
    ----------
    axes : Axes or an array of them
        What the caller gave.
    kind : str
        Kind of picture, for the message.
    counts : sequence of int
        How many Axes it takes: one of these numbers.

    Returns
    -------
    list of Axes
        In their order.

    Raises
    ------
    InputError
        If they are not as many, or no Axes.
    """
    places: list[Axes] = list(np.ravel(np.asarray(axes, dtype=object)))
    if len(places) not in counts or not all(hasattr(place, "plot") for place in places):
        raise InputError(
            f"{kind!r} is drawn into {' or '.join(map(str, counts))} Axes;"
            f" given: {len(places)} {type(places[0]).__name__ if places else 'objects'}"
        )
    return places


def drawn_alone(
    kind: str, size: tuple[float, float], draw: Callable[[Axes], None], axes: Any = None
) -> Any:
    """Draw into Axes that a caller gave, or into those of a figure of its own.

    Parameters
    ----------
    kind : str
        Kind of picture, for the message.
    size : tuple of (float, float)
        Of the figure, in inches.
    draw : callable
        Takes the Axes.
    axes : Axes, optional

    Returns
    -------
    Figure or Axes
        The figure, outside pyplot, or the Axes that were given.

    Raises
    ------
    InputError
        If these are not one.
    MissingExtra
        If matplotlib is not installed.
    """
    check_matplotlib()
    if axes is not None:
        (own,) = given_axes(axes, kind, [1])
        draw(own)
        return own
    from matplotlib.figure import Figure

    figure = Figure(figsize=size)
    figure.set_layout_engine("constrained")
    draw(figure.add_subplot())
    return figure


def draw_levels(axes: Axes, levels: Mapping[float, str], *, upright: bool = False) -> None:
    """Draw lines where boundaries lie: across the Axes, or upright; near ones share a label.

    Parameters
    ----------
    axes : Axes
        What is drawn into.
    levels : dict of float to str
        Label of each level.
    upright : bool, default False
        Whether the lines stand upright.
    """
    line: dict[str, Any] = {"color": "0.3", "linewidth": 0.9, "linestyle": ":", "zorder": 1.4}
    low, high = axes.dataLim.intervalx if upright else axes.dataLim.intervaly
    nearest = (_WIDTH if upright else _HEIGHT) * (high - low)
    groups: list[list[float]] = []
    for level in sorted(levels):
        (axes.axvline if upright else axes.axhline)(level, **line)
        if groups and level - groups[-1][-1] < nearest:
            groups[-1].append(level)
        else:
            groups.append([level])
    for group in groups:
        text = "\n".join(levels[level] for level in reversed(group))
        if upright:
            place, offset, transform = (group[-1], 1.0), (3, -3), axes.get_xaxis_transform()
        else:
            middle = (group[0] + group[-1]) / 2
            place, offset, transform = (1.0, middle), (3, 0), axes.get_yaxis_transform()
        side = "top" if upright else "center"
        axes.annotate(text, place, offset, transform, "offset points", va=side)


def draw_arrow(axes: Axes, x: np.ndarray, v: np.ndarray, style: Mapping[str, Any]) -> None:
    """Show the direction of the motion, where the velocity is lowest.

    Parameters
    ----------
    axes : Axes
        What is drawn into.
    x : array (n,)
        Positions along the motion, in the Axes' units.
    v : array (n,)
        Velocities there, in the Axes' units.
    style : dict
        Of the line; its colour is taken.
    """
    place = min(max(int(np.argmin(v)), 1), len(v) - 1)
    arrow = {"arrowstyle": "-|>", "color": style["color"], "linewidth": 0, "mutation_scale": 16}
    axes.annotate("", (x[place], v[place]), (x[place - 1], v[place - 1]), arrowprops=arrow)


def finish(axes: Axes, title: str) -> None:
    """Title, and a legend between it and the frame, where it covers no curve.

    Parameters
    ----------
    axes : Axes
        What is drawn into.
    title : str
        Empty for none.
    """
    _, labels = axes.get_legend_handles_labels()
    columns = _columns(axes, labels)
    if labels:
        axes.legend(
            loc="lower left",
            bbox_to_anchor=(0, 1),
            ncols=columns,
            frameon=False,
            fontsize="small",
            borderpad=0.1,
            borderaxespad=0.3,
            handlelength=2.2,
            columnspacing=1.2,
            handletextpad=0.5,
        )
    if title:
        rows = math.ceil(len(labels) / columns)
        axes.set_title(title, loc="left", fontsize="medium", pad=6 + 14 * rows)
    axes.spines[["top", "right"]].set_visible(False)


def part_tick_labels(figure: Figure) -> None:
    """Write the numbers of axes in full, and as few of them as do not touch each other.

    Where they are tiny, or differ in late digits, matplotlib writes what they have in common
    beside the axes, where a legend may be.
    """
    from matplotlib.ticker import FuncFormatter, MaxNLocator, ScalarFormatter

    numbered = [
        axis
        for axes in figure.axes
        for axis in (axes.xaxis, axes.yaxis)
        if isinstance(axis.get_major_formatter(), ScalarFormatter) and axis.get_scale() == "linear"
    ]
    figure.draw_without_rendering()
    for axis in numbered:
        if axis.get_offset_text().get_text():
            axis.set_major_formatter(FuncFormatter(partial(_in_full, axis)))
    touching = numbered
    while touching:
        figure.draw_without_rendering()
        touching = [
            axis for axis in touching if _touch(axis) and len(axis.get_majorticklocs()) > _FEWEST
        ]
        for axis in touching:
            count = len(axis.get_majorticklocs())
            axis.set_major_locator(MaxNLocator(count // 2, steps=[1, 2, 2.5, 5, 10]))


def _in_full(axis: Axis, number: float, _: int | None) -> str:
    """A number with as many digits as tell it from those beside it."""
    places = axis.get_majorticklocs()
    step = np.diff(places).min(initial=np.inf)
    if abs(number) < step / 100:
        return "0"
    digits = 2 + math.ceil(math.log10(max(1.0, np.abs(places).max() / step)))
    return f"{number:.{digits}g}".replace("-", "\N{MINUS SIGN}")


def _touch(axis: Axis) -> bool:
    """Whether two labels of an axis that was drawn touch each other."""
    ends = sorted(axis.get_view_interval())
    shown = [
        tick.label1.get_window_extent()
        for tick in axis.get_major_ticks()
        if tick.label1.get_visible()
        and tick.label1.get_text()
        and ends[0] <= tick.get_loc() <= ends[1]
    ]
    return any(first.overlaps(second) for first, second in itertools.pairwise(shown))


def _columns(axes: Axes, labels: Sequence[str]) -> int:
    """As many columns of a legend as are about as wide as the Axes."""
    square = axes.get_aspect() == 1  # the layout makes it as narrow as it is low
    room = (min(axes.bbox.size) if square else axes.bbox.width) / axes.figure.dpi
    inches = [0.45 + 0.066 * len(re.sub(r"[$\\{}_^]|mathrm", "", label)) for label in labels]
    for columns in range(len(labels), 1, -1):
        if sum(max(column) for column in np.array_split(inches, columns)) <= room:
            return columns
    return 1


def line_style(mass: int) -> dict[str, Any]:
    """Colour and dashes of a mass.

    Parameters
    ----------
    mass : int
        Its number, from 0.

    Returns
    -------
    dict
        Arguments of matplotlib's `plot`.
    """
    color, dashes = LINES[mass % len(LINES)]
    return {"color": color, "linestyle": dashes, "linewidth": 1.6}


def band_style(color: str) -> dict[str, Any]:
    """Style of the parts in which a mass sticks.

    Parameters
    ----------
    color : str
        Of the mass.

    Returns
    -------
    dict
        Arguments of matplotlib's `plot`.
    """
    shape = {"linewidth": 6, "alpha": 0.3, "solid_capstyle": "butt", "zorder": 1.5}
    return {**shape, "color": color}


def dot_style(style: Mapping[str, Any]) -> dict[str, Any]:
    """Style of the marks at the transitions.

    Parameters
    ----------
    style : dict
        Of the line; its colour is taken.

    Returns
    -------
    dict
        Arguments of matplotlib's `plot`.
    """
    shape = {"linestyle": "none", "marker": "o", "markersize": 4.5, "zorder": 3}
    return {**shape, "markerfacecolor": "white", "markeredgecolor": style["color"]}


def noun(kind: str, labels: Sequence[str]) -> str:
    """Position, velocity or state, in the number that the labels have, and the labels.

    Parameters
    ----------
    kind : {"position", "velocity", "state"}
        What is drawn.
    labels : sequence of str
        Of the states.

    Returns
    -------
    str
        For an axis.
    """
    plural = {"position": "positions", "velocity": "velocities", "state": "states"}[kind]
    return f"{kind if len(labels) == 1 else plural} {', '.join(labels)}"
