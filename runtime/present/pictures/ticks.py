"""Numbers along axes: as few as stand apart, each written in full, in whatever figure."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text
from matplotlib.ticker import AutoLocator, MaxNLocator, ScalarFormatter

_GAP = 0.5  # of the size of a label: between two
_MOST = 9  # intervals between labels


def number_axes(axes: Axes) -> None:
    """Number the linear axes of a picture; those with other scales or labels stay as they are."""
    for axis in (axes.xaxis, axes.yaxis):
        own = axis.get_major_locator(), axis.get_major_formatter()
        if [type(one) for one in own] == [AutoLocator, ScalarFormatter]:
            axis.set_major_locator(_Apart())
            axis.set_major_formatter(_InFull())


class _InFull(ScalarFormatter):
    """Formatter that writes each number in full, without an offset beside the axis.

    For tiny numbers, or numbers that differ in late digits, matplotlib would write one,
    where a legend may be.
    """

    def __init__(self) -> None:
        super().__init__()
        self._places = np.zeros(0)

    def set_locs(self, locs: Any) -> None:
        """Set the places that are numbered."""
        self._places = np.asarray(locs, dtype=float)
        super().set_locs(locs)

    def __call__(self, number: float, pos: int | None = None) -> str:
        """A number with as many digits as distinguish it from its neighbours."""
        if not super().get_offset():
            return super().__call__(number, pos)
        step = np.diff(self._places).min(initial=np.inf)
        if abs(number) < step / 100:
            return "0"
        digits = 2 + math.ceil(math.log10(max(1.0, np.abs(self._places).max() / step)))
        return self.fix_minus(f"{number:.{digits}g}")

    def get_offset(self) -> str:
        """An empty text, as the labels are complete."""
        return ""


class _Apart(MaxNLocator):
    """Locator of round places, so few that their labels do not touch."""

    def __init__(self) -> None:
        super().__init__(_MOST, steps=[1, 2, 2.5, 5, 10])
        self._last: tuple[Any, Any] = (None, ())

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the labels between two ends, cached as a layout asks often for the same."""
        room = self._room()
        asked = (vmin, vmax, *room)
        if self._last[0] != asked:
            places: Any = ()
            for count in range(_MOST, 0, -1):
                self.set_params(nbins=count)
                places = super().tick_values(vmin, vmax)
                if not room or self._stand_apart(places, vmin, vmax, room):
                    break
            self._last = asked, places
        return self._last[1]

    def _room(self) -> tuple[Any, ...]:
        """The formatter, the size of labels in points, dots per inch, and pixels along the axis."""
        axis: Any = self.axis
        if axis is None or not hasattr(axis, "get_major_ticks"):
            return ()
        length = axis.axes.bbox.height if axis.axis_name == "y" else axis.axes.bbox.width
        size = axis._get_tick_label_size(axis.axis_name)
        return axis.get_major_formatter(), size, axis.get_figure().dpi, length

    def _stand_apart(self, places: Any, vmin: float, vmax: float, room: tuple[Any, ...]) -> bool:
        axis: Any = self.axis
        formatter, size, dpi, length = room
        upright = axis.axis_name == "y"
        shown = np.sort(places[(places >= min(vmin, vmax)) & (places <= max(vmin, vmax))])
        text = Text(fontsize=size, figure=axis.get_figure())
        sizes = []
        for label in formatter.format_ticks(shown):
            text.set_text(label)
            box = text.get_window_extent()
            sizes.append(box.height if upright else box.width)
        gap = _GAP * size * dpi / 72
        needed = (np.array(sizes[:-1]) + sizes[1:]) / 2 + gap * (0.2 if upright else 1)
        return bool((np.diff(shown) / abs(vmax - vmin) * length >= needed).all())
