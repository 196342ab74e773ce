"""Fitted steady responses between the points that were measured."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.explore.fitting.fit_record import Fit
from nonsmooth.runtime.explore.fitting.response_quantities import response_quantity
from nonsmooth.runtime.explore.fitting.steady_orbits import responses_at
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.structure import structure_of

__all__ = ["response_curves"]

_TURN = 2 * np.pi
_VALUES = 121  # from the smallest to the largest that was measured at


def response_curves(fit: Fit, experiment: int = 0) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Values (m,) of the parameter that was varied, and fitted responses (m,) of each column.

    They lie between the measured rows; the values are numbers of rows where no parameter was
    varied. Responses are NaN where that of the nearest row does not reach, and between
    responses of different phases. `experiment` counts from 0; an unknown one is refused.
    """
    found = fit.experiment(experiment)
    kernels = known_system(fit.system)
    structure = structure_of(kernels)
    quantities = {s.name: response_quantity(s.expression, structure) for s in found.series}
    if not found.along:
        values = np.arange(float(len(found.responses)))
        points = [dict(each.parameters) for each in found.responses]
        rows = np.arange(len(points))
    else:
        measured = np.array([float(each.parameters[found.along]) for each in found.responses])
        order = np.argsort(measured, kind="stable")
        values = np.linspace(measured.min(), measured.max(), _VALUES)
        rows = abs(values[:, None] - measured).argmin(axis=1)
        columns = {
            name: np.array([float(each.parameters[name]) for each in found.responses])[order]
            for name in found.responses[0].parameters
        }
        between = {n: np.interp(values, measured[order], c) for n, c in columns.items()}
        points = [{name: column[k] for name, column in between.items()} for k in range(_VALUES)]
    by = [found.along or next(iter(found.responses[0].parameters))]
    every = range(len(found.responses))
    orbits = [fit.response(row, experiment).derivatives(by) for row in every]
    curves = {name: np.full(len(values), np.nan) for name in quantities}
    own = [each.orbit.itinerary for each in orbits]
    for place, (row, point) in enumerate(zip(rows.tolist(), points, strict=True)):
        if place and own[row] != own[rows[place - 1]]:
            continue  # no line joins responses of different phases
        there, _ = responses_at(kernels, point, by, [orbits[row]], unstable=True)
        for each in there:
            for name, quantity in quantities.items():
                try:
                    curves[name][place] = quantity.of(each)[0]
                except NonsmoothError:
                    continue
    for series in found.series:
        if quantities[series.name].periodic:  # next to what was measured
            near = np.interp(values, *_sorted(series.times, series.values))
            curve = curves[series.name]
            curves[series.name] = curve + _TURN * np.round((near - curve) / _TURN)
    return values, curves


def _sorted(times: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    order = np.argsort(times, kind="stable")
    return times[order], values[order]
