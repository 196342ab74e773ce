"""What all pictures share: colours, dashes, legends, and where boundaries lie.

Colours are those of Okabe and Ito and of Tol, which colour-blind readers can tell apart;
lines differ by their dashes too.
"""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra, unknown_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "LINES",
    "SHADES",
    "band_style",
    "check_picture",
    "chosen_masses",
    "configuration_color",
    "dot_style",
    "draw_arrow",
    "draw_levels",
    "drawn_alone",
    "finish",
    "fits",
    "given_axes",
    "line_style",
    "mark_style",
    "noun",
    "shaded",
    "tex_number",
    "within",
]

_HUES = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")
_DASHES: tuple[Any, ...] = ("-", (0, (5, 1.6)), "-.", ":")
_MARKS = "osD^vPX*"
# each colour with its own dashes, then with the others': no two lines are alike
LINES = tuple((_HUES[k % 4], _DASHES[(k + k // 4) % 4]) for k in range(16))
SHADES = 3  # of a colour that can be told apart
_HEIGHT, _WIDTH = 0.07, 0.12  # of a label, in those of the data
_LETTER, _HANDLE = 0.066, 0.45  # inches: of small print, and of what stands before a label
_TITLE = 0.08  # inches of a letter of a title
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
    return shaded(_CONFIGURATIONS, place)


def shaded(colors: Sequence[str], place: int) -> str:
    """A colour by its place: those that are given, then the same darker, then paler.

    Parameters
    ----------
    colors : sequence of str
        As "#RRGGBB".
    place : int
        From 0.

    Returns
    -------
    str
        A colour of matplotlib.
    """
    turn, number = divmod(place, len(colors))
    other, share = ((0, 0.0), (0, 0.4), (255, 0.55))[turn % SHADES]
    parts = (int(colors[number][k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round((1 - share) * part + share * other):02X}" for part in parts)


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
    """Numbers, title, and a legend between it and the frame, where it covers no curve.

    Parameters
    ----------
    axes : Axes
        What is drawn into.
    title : str
        Empty for none.
    """
    from nonsmooth.runtime.present.pictures.ticks import number_axes

    number_axes(axes)
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
        room = (axes.figure.bbox.width - axes.bbox.x0) / axes.figure.dpi
        text = within(title, room)
        axes.set_title(text, loc="left", fontsize="medium", pad=6 + 14 * rows, va="bottom")
    axes.spines[["top", "right"]].set_visible(False)


def within(title: str, room: float) -> str:
    """A title in as many lines as fit into some inches."""
    return textwrap.fill(title, max(int(room / _TITLE), 10)) if title.strip() else title


def fits(label: str, axes: Axes, share: float) -> bool:
    """Whether a label in small print is shorter than a share of the width of Axes."""
    return _LETTER * _letters(label) <= share * axes.bbox.width / axes.figure.dpi


def _letters(label: str) -> int:
    """About how many letters a label has that may be a formula."""
    return len(re.sub(r"[$\\{}_^]|mathrm", "", re.sub(r"\\(?!mathrm)[a-z]+", "x", label)))


def _columns(axes: Axes, labels: Sequence[str]) -> int:
    """As many columns of a legend as are about as wide as the Axes."""
    square = axes.get_aspect() == 1  # the layout makes it as narrow as it is low
    room = (min(axes.bbox.size) if square else axes.bbox.width) / axes.figure.dpi
    inches = [_HANDLE + _LETTER * _letters(label) for label in labels]
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


def mark_style(place: int) -> dict[str, Any]:
    """Colour and marker of one of several points.

    Parameters
    ----------
    place : int
        Its number, from 0.

    Returns
    -------
    dict
        Arguments of matplotlib's `plot`.
    """
    marker = _MARKS[(place % 4 + place // 4) % len(_MARKS)]
    return {"color": _HUES[place % 4], "marker": marker, "linestyle": "none"}


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


def tex_number(value: float) -> str:
    """A number in TeX's notation, short where it has an exponent."""
    text = f"{value:.6g}"
    if "e" not in text:
        return text
    digits, exponent = f"{value:.2e}".split("e")
    return f"{float(digits):g}\\cdot 10^{{{int(exponent)}}}"


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
