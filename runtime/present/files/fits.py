"""Fits in files: every digit of the estimates, the measurements, and the fitted motion's data."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import encode, nan_as_null
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.explore.fitting.fit_record import Fit
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, system_in

__all__ = ["fit_json", "load_fit", "save_fit"]


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FitEntries(Fit):
    """Entries of the file of a fit: the fit, and its system as data if that is not built in."""

    tables: SavedSystem | None


_FIT = FileFormat(
    name="nonsmooth fit", what="saved fit", entries=FitEntries, version=1 + SAVED_VERSION
)


def save_fit(fit: Fit, path: str | os.PathLike[str]) -> None:
    """Write a fit to a file, which is replaced only when the new one is complete."""
    system, _, saved = named(known_system(fit.system))
    _FIT.write(path, FitEntries(**{**vars(fit), "system": system, "tables": saved}))


def load_fit(path: str | os.PathLike[str]) -> Fit:
    """Read a fit that `Fit.save` wrote, with every digit.

    An `InputError` with the file's name is raised if the file cannot be read, or is cut,
    edited or foreign.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> known = {"m1": 1, "m2": 2, "k1": 1, "k2": 5}
    >>> start = {"x1": 0, "x2": 0, "v1": 1.5, "v2": 0}
    >>> motion = ns.simulate("rigid-stop", known | {"r": "0.8"}, start, until=12)
    >>> data = {"first-reaches-stop": motion.times[1:]}
    >>> ns.fit(
    ...     "rigid-stop", data, parameters=known, bounds={"r": (0.5, 1)}, start=start, sigma=1e-3
    ... ).save("fit.json")
    >>> ns.load("fit.json").names
    ('r',)
    """
    with naming(path) as file:
        entries = {**vars(_FIT.read(file))}
        system_in(entries["system"], entries.pop("tables"))
        fit = Fit(**entries)
        count = len(fit.names)
        shapes = {
            (count,): (fit.estimates, fit.lower, fit.upper),
            (count, count): (fit.covariance,),
            (count, 2): (fit.bounds,),
        }
        fits = all(part.shape == shape for shape, parts in shapes.items() for part in parts)
        series = [each for one in fit.experiments for each in one.series]
        for each in series:
            parts = (each.places, each.times, each.values, each.fitted, each.sigma)
            fits &= len({len(part) for part in parts}) == 1
        for one in fit.experiments:
            count = len(one.responses)
            for each in one.series:
                here = (each.kind == "response") == bool(count)
                fits &= here and (not count or bool((each.places < count).all()))
        if not fits:
            raise InputError("its names, numbers and series do not belong together")
        return fit


def fit_json(fit: Fit) -> dict[str, Any]:
    """A fit as JSON; numbers are decimal strings with every digit, and null if unknown."""
    found = encode(fit)
    found["standard_errors"] = [repr(each) for each in fit.standard_errors.tolist()]
    found["correlation"] = [[repr(each) for each in row] for row in fit.correlation.tolist()]
    found["same_sequence"] = fit.same_sequence
    for entries, experiment in zip(found["experiments"], fit.experiments, strict=True):
        for written, series in zip(entries["series"], experiment.series, strict=True):
            written["residuals"] = [repr(each) for each in np.asarray(series.residuals).tolist()]
    return {name: nan_as_null(entry) for name, entry in found.items()}
