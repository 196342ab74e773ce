"""Numbers along axes: as few as stand apart, each written in full, in whatever figure."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import AutoLocator, MaxNLocator, ScalarFormatter

# of labels, in units of their size: between two, of a letter, from line to line
_GAP, _WIDTH, _HEIGHT = 0.5, 0.62, 1.2
_MARKUP = re.compile(r"\\[a-z]+|[${}]")  # of a label as a formula
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

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the labels between two ends."""
        places: Any = ()
        for count in range(_MOST, 0, -1):
            self.set_params(nbins=count)
            places = super().tick_values(vmin, vmax)
            if self._stand_apart(np.sort(places), *sorted((vmin, vmax))):
                break
        return places

    def _stand_apart(self, places: Any, low: float, high: float) -> bool:
        axis: Any = self.axis
        if axis is None or not hasattr(axis, "get_major_ticks"):
            return True
        upright, box = axis.axis_name == "y", axis.axes.bbox
        shown = places[(places >= low) & (places <= high)]
        letter = axis._get_tick_label_size(axis.axis_name) * axis.get_figure().dpi / 72
        if upright:
            needed = np.full(max(len(shown) - 1, 0), _HEIGHT)
        else:
            labels = axis.get_major_formatter().format_ticks(shown)
            widths = [_WIDTH * len(_MARKUP.sub("", label)) for label in labels]
            needed = (np.array(widths[:-1]) + widths[1:]) / 2 + _GAP
        room = (box.height if upright else box.width) / (high - low)
        return bool((np.diff(shown) * room >= needed * letter).all())
