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

from nonsmooth.runtime.core.errors import InputError, missing_extra, one_or_several, unknown_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_HUES = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")
_DASHES: tuple[Any, ...] = ("-", (0, (5, 1.6)), "-.", ":")
_MARKS = "osD^vPX*"
# each colour with its own dashes, then with the others': no two lines are alike
LINES = tuple((_HUES[k % 4], _DASHES[(k + k // 4) % 4]) for k in range(16))
SHADES = 3  # of a colour that can be told apart
_HEIGHT, _WIDTH = 0.07, 0.12  # of a label, in those of the data
_LETTER, _HANDLE = 0.066, 0.45  # inches: of small print, and of what stands before a label
_TITLE = 0.08  # inches of a letter of a title
_CONSTANT, _AROUND = 1e-9, 0.05  # of the size of what is drawn: below is rounding; what is shown
_CONFIGURATIONS = (
    *("#99DDFF", "#EEDD88", "#FFAABB", "#BBCC33", "#DDDDDD"),
    *("#EE8866", "#77AADD", "#44BB99", "#AAAA00"),
)


def configuration_color(place: int) -> str:
    """Colour (of matplotlib) of a configuration by its index in the system."""
    return shaded(_CONFIGURATIONS, place)


def shaded(colors: Sequence[str], place: int) -> str:
    """Colour (of matplotlib) number `place`, from 0.

    It is one of those given as "#RRGGBB", then the same darker, then paler.
    """
    turn, number = divmod(place, len(colors))
    other, share = ((0, 0.0), (0, 0.4), (255, 0.55))[turn % SHADES]
    parts = (int(colors[number][k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round((1 - share) * part + share * other):02X}" for part in parts)


def check_picture(kind: str, kinds: Sequence[str]) -> None:
    """Raise `InputError` for an unknown kind of picture, and `MissingExtra` without matplotlib."""
    if kind not in kinds:
        raise unknown_name("kind of picture", kind, kinds)
    check_matplotlib()


def check_matplotlib() -> None:
    """Raise `MissingExtra` if matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401 (is it there?)
    except ImportError:
        raise missing_extra("plot", "matplotlib") from None


def chosen_masses(masses: Iterable[int] | None, count: int, name: str) -> tuple[int, ...]:
    """Indices, from 0, of the masses that are drawn, in the order given; None stands for all.

    `name` is what is drawn, for the message of the `InputError` that is raised if there is
    no such mass, or if none is chosen.
    """
    every = range(count)
    drawn = tuple(every) if masses is None else one_or_several(masses)
    if not drawn or not all(mass in every for mass in drawn):
        raise InputError(f"masses = {list(drawn)}: {name} has {list(every)}")
    return drawn


def given_axes(axes: Any, kind: str, counts: Sequence[int]) -> list[Axes]:
    """List of the Axes that a caller gave: one of them, or an array of them.

    Their number has to be one of `counts`, or `InputError` is raised.
    """
    places: list[Axes] = list(np.ravel(np.asarray(axes, dtype=object)))
    if len(places) not in counts or not all(hasattr(place, "get_xlim") for place in places):
        raise InputError(
            f"axes: {kind!r} is drawn into {' or '.join(map(str, counts))} Axes;"
            f" given: {len(places)} {type(places[0]).__name__ if places else 'objects'}"
        )
    return places


def drawn_alone(
    kind: str,
    size: tuple[float, float],
    draw: Callable[[Axes], object],
    axes: Any = None,
    compose: Callable[[Figure], object] | None = None,
) -> Any:
    """Draw into one Axes that a caller gave, or else into a new figure outside pyplot.

    `draw` takes the Axes, and `size` is that of the figure in inches. If a figure of its own
    shows more, `compose` draws all of it. The result is the Axes that were given, or the figure.
    """
    check_matplotlib()
    if axes is not None:
        (own,) = given_axes(axes, kind, [1])
        draw(own)
        return own
    from matplotlib.figure import Figure

    figure = Figure(figsize=size)
    figure.set_layout_engine("constrained")
    if compose is None:
        draw(figure.add_subplot())
    else:
        compose(figure)
    return figure


def draw_levels(axes: Axes, levels: Mapping[float, str], *, upright: bool = False) -> None:
    """Draw lines where boundaries lie, horizontal or upright; near ones share a label."""
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
    """Draw an arrow in the direction of the motion, where the velocity is lowest.

    Positions (n,) and velocities (n,) are in the units of the Axes; the colour is that of
    `style`.
    """
    place = min(max(int(np.argmin(v)), 1), len(v) - 1)
    arrow = {"arrowstyle": "-|>", "color": style["color"], "linewidth": 0, "mutation_scale": 16}
    axes.annotate("", (x[place], v[place]), (x[place - 1], v[place - 1]), arrowprops=arrow)


def finish(axes: Axes, title: str, across: str = "", up: str = "") -> None:
    """Add numbers, labels of the axes, a title, and a legend above the frame, off the curves.

    Labels that are empty stay as they are; there is no title if it is empty. The legend has each
    label once.
    """
    from nonsmooth.runtime.present.pictures.ticks import number_axes

    number_axes(axes)
    if across:
        axes.set_xlabel(across)
    if up:
        axes.set_ylabel(up)
    entries: dict[str, Any] = {}
    for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
        entries.setdefault(label, handle)
    labels = list(entries)
    columns = _columns(axes, labels)
    if labels:
        axes.legend(
            list(entries.values()),
            labels,
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


def widen(axes: Axes) -> None:
    """Widen the range of the upright axis if the values on it differ by rounding only."""
    low, high = axes.dataLim.intervaly
    size = max(abs(low), abs(high))
    if 0 <= high - low < _CONSTANT * size:  # the range of no data is turned round
        left = axes.dataLim.intervalx[0]
        axes.update_datalim([(left, low - _AROUND * size), (left, high + _AROUND * size)])
        axes.autoscale_view()


def within(title: str, room: float) -> str:
    """The title, broken into lines that fit into so many inches."""
    return textwrap.fill(title, max(int(room / _TITLE), 10)) if title.strip() else title


def fits(label: str, axes: Axes, share: float) -> bool:
    """Whether a label in small print is shorter than a share of the Axes' width."""
    return _LETTER * _letters(label) <= share * axes.bbox.width / axes.figure.dpi


def _letters(label: str) -> int:
    """Approximate number of letters of a label, which may be a formula."""
    return len(re.sub(r"[$\\{}_^]|mathrm", "", re.sub(r"\\(?!mathrm)[a-z]+", "x", label)))


def _columns(axes: Axes, labels: Sequence[str]) -> int:
    """Number of columns of a legend that is about as wide as the Axes."""
    square = axes.get_aspect() == 1  # the layout makes it as narrow as it is low
    room = (min(axes.bbox.size) if square else axes.bbox.width) / axes.figure.dpi
    inches = [_HANDLE + _LETTER * _letters(label) for label in labels]
    for columns in range(len(labels), 1, -1):
        if sum(max(column) for column in np.array_split(inches, columns)) <= room:
            return columns
    return 1


def line_style(mass: int) -> dict[str, Any]:
    """Colour and dashes of a mass (numbered from 0), as arguments of matplotlib's `plot`."""
    color, dashes = LINES[mass % len(LINES)]
    return {"color": color, "linestyle": dashes, "linewidth": 1.6}


def mark_style(place: int) -> dict[str, Any]:
    """Colour and marker of one of several points, as arguments of matplotlib's `plot`."""
    marker = _MARKS[(place % 4 + place // 4) % len(_MARKS)]
    return {"color": _HUES[place % 4], "marker": marker, "linestyle": "none"}


def band_style(color: str) -> dict[str, Any]:
    """Style of the parts in which a mass sticks, as arguments of matplotlib's `plot`."""
    shape = {"linewidth": 6, "alpha": 0.3, "solid_capstyle": "butt", "zorder": 1.5}
    return {**shape, "color": color}


def dot_style(style: Mapping[str, Any]) -> dict[str, Any]:
    """Style of the marks at transitions, as arguments of matplotlib's `plot`.

    Their colour is that of the line in `style`.
    """
    shape = {"linestyle": "none", "marker": "o", "markersize": 4.5, "zorder": 3}
    return {**shape, "markerfacecolor": "white", "markeredgecolor": style["color"]}


def tex_number(value: float) -> str:
    """A number in TeX's notation, with fewer digits if it has an exponent."""
    text = f"{value:.6g}"
    if "e" not in text:
        return text
    digits, exponent = f"{value:.2e}".split("e")
    return f"{float(digits):g}\\cdot 10^{{{int(exponent)}}}"


def noun(kind: str, labels: Sequence[str]) -> str:
    """Label of an axis: the kind of state, in the plural for several labels, and the labels."""
    plural = {"position": "positions", "velocity": "velocities", "state": "states"}[kind]
    return f"{kind if len(labels) == 1 else plural} {', '.join(labels)}"
