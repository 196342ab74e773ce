"""Numbers along axes: as few as stand apart, each written in full, in whatever figure."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text
from matplotlib.ticker import AutoLocator, MaxNLocator, ScalarFormatter

__all__ = ["number_axes"]

_GAP = 0.5  # of the size of a label: between two
_MOST = 9  # intervals between labels


def number_axes(axes: Axes) -> None:
    """Number the axes of a picture; those that are not linear, or numbered otherwise, stay.

    Parameters
    ----------
    axes : Axes
    """
    for axis in (axes.xaxis, axes.yaxis):
        own = axis.get_major_locator(), axis.get_major_formatter()
        if [type(one) for one in own] == [AutoLocator, ScalarFormatter]:
            axis.set_major_locator(_Apart())
            axis.set_major_formatter(_InFull())


class _InFull(ScalarFormatter):
    """Numbers in full: what they have in common is not written beside the axis.

    Where they are tiny, or differ in late digits, matplotlib writes it there, where a legend
    may be.
    """

    def __init__(self) -> None:
        super().__init__()
        self._places = np.zeros(0)

    def set_locs(self, locs: Any) -> None:
        """Take the places that are numbered."""
        self._places = np.asarray(locs, dtype=float)
        super().set_locs(locs)

    def __call__(self, number: float, pos: int | None = None) -> str:
        """A number with as many digits as tell it from those beside it."""
        if not super().get_offset():
            return super().__call__(number, pos)
        step = np.diff(self._places).min(initial=np.inf)
        if abs(number) < step / 100:
            return "0"
        digits = 2 + math.ceil(math.log10(max(1.0, np.abs(self._places).max() / step)))
        return self.fix_minus(f"{number:.{digits}g}")

    def get_offset(self) -> str:
        """Nothing: the labels say all."""
        return ""


class _Apart(MaxNLocator):
    """Round places, so few that their labels do not touch."""

    def __init__(self) -> None:
        super().__init__(_MOST, steps=[1, 2, 2.5, 5, 10])

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the labels between two ends."""
        places: Any = ()
        for count in range(_MOST, 0, -1):
            self.set_params(nbins=count)
            places = super().tick_values(vmin, vmax)
            if self._stand_apart(places, vmin, vmax):
                break
        return places

    def _stand_apart(self, places: Any, vmin: float, vmax: float) -> bool:
        axis: Any = self.axis
        if axis is None or not hasattr(axis, "get_major_ticks"):
            return True
        shown = np.sort(places[(places >= min(vmin, vmax)) & (places <= max(vmin, vmax))])
        upright, bounds = axis.axis_name == "y", axis.axes.bbox
        length = bounds.height if upright else bounds.width
        like = axis._get_tick_label_size(axis.axis_name)
        sizes = []
        for label in axis.get_major_formatter().format_ticks(shown):
            box = Text(0, 0, label, fontsize=like, figure=axis.get_figure()).get_window_extent()
            sizes.append(box.height if upright else box.width)
        gap = _GAP * like * axis.get_figure().dpi / 72
        needed = (np.array(sizes[:-1]) + sizes[1:]) / 2 + gap * (0.2 if upright else 1)
        return bool((np.diff(shown) / abs(vmax - vmin) * length >= needed).all())
