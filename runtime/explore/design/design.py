"""Parameters in bounds at which an orbit is best, or has wanted values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, get_args

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.orbit_family import check_interval
from nonsmooth.runtime.explore.design.aim import Aim, MarginKey
from nonsmooth.runtime.explore.design.condition import DesignCondition, condition_in
from nonsmooth.runtime.explore.design.design_points import DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.largest import is_smooth_from_above
from nonsmooth.runtime.explore.design.limits import Optimality, bounds_met, optimality
from nonsmooth.runtime.explore.design.optimising import Ended, Method, optimise
from nonsmooth.runtime.explore.design.optimum import CONVERGED, NOT_REACHED, Design
from nonsmooth.runtime.explore.design.quantities import MULTIPLIER, PEAK, RADIUS
from nonsmooth.runtime.explore.design.solving import solve_conditions
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting import newton

__all__ = ["METHODS", "design"]

METHODS: tuple[str, ...] = get_args(Method)
MOST_ITERATIONS = 200
_OPTIMAL, _MET = 1e-5, 1e-8  # of the gradient that is left, and of a condition
_SOLVED = 1e-9
_NO_SLOPE = 1e-13  # of a quantity over an interval: nothing depends on the parameter
_LEAST_UNIT = 1e-3  # of a quantity that begins near zero


def design(
    orbit: Orbit,
    *,
    minimise: str | None = None,
    maximise: str | None = None,
    solve: Mapping[str, object] | None = None,
    over: Mapping[str, tuple[float, float]],
    subject_to: Iterable[str] = (),
    admissible: bool = True,
    method: str = "SLSQP",
    iterations: int = MOST_ITERATIONS,
    progress: Callable[[int], object] | None = None,
) -> Design:
    """Find parameters in bounds at which an orbit is best, or has wanted values.

    Each trial is reached by continuation from the nearest orbit that is known, so that all are
    of one branch; derivatives are exact. Where the branch does not lead to a trial, because it
    turns back, a phase vanishes or the orbit ceases to be a motion, the step is shortened. What
    is found is the optimum near the orbit, not the best of all.

    A spectral radius is minimised as the least level that no multiplier exceeds, by conditions
    on trace and determinant where there are up to two multipliers: so an optimum at which
    multipliers meet, where the radius has no derivative, is found as one, and `corner` says it.

    Parameters
    ----------
    orbit : Orbit
        A converged one, with parameters in the bounds.
    minimise, maximise : str, optional
        A quantity of the orbit, as `OrbitDerivatives.quantity` knows it: an unknown, ``period``,
        ``trace``, ``determinant``, ``spectral_radius``, ``maximum:x``, ``peak:x``,
        ``peak_acceleration:x``, ``dissipation``, ``margin``, ....
    solve : mapping of str to number or text, optional
        Wanted values in place of that, as many as parameters; ``multiplier`` is one of the
        orbit's multipliers, -1 at a flip.
    over : mapping of str to (float, float)
        Bounds of the parameters that vary: of those that were given for the orbit.
    subject_to : iterable of str
        Conditions such as ``period<=6.5``, ``trace>=0`` or ``multiplier=-1``.
    admissible : bool
        Whether each orbit has to be a motion of the real system.
    method : "SLSQP" or "trust-constr"
        The optimiser of SciPy.
    iterations : int
        At most so many in each round.
    progress : callable, optional
        Told how many orbits were visited.

    Returns
    -------
    Design
        With the orbit there. Its `status` is 0 where the conditions of an optimum hold, bounds
        and conditions among them, or the wanted values are met; else 1, and `message` says why.

    Raises
    ------
    InputError
        For unknown names, bounds without the orbit, as many wanted values as there are not
        parameters, a parameter that nothing depends on, an orbit that is no motion though it
        has to be, or other options that are wrong.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> found = ns.design(
    ...     ns.solve("dry-friction/symmetric"), minimise="spectral_radius", over={"V": (0.3, 3)}
    ... )
    >>> found.message, round(found.after["V"], 4)
    ('an optimum', 2.7457)
    """
    aim_name, quantity = _aim_of(minimise, maximise, solve)
    names, bounds = _bounds_of(orbit, over)
    conditions = _conditions_of(solve, subject_to, len(names))
    _check_options(method, iterations)
    asked = dict.fromkeys(([quantity] if quantity else []) + [c.quantity for c in conditions])
    measured = [name for name in asked if name != MULTIPLIER]
    if quantity == MULTIPLIER:
        raise InputError(f"{MULTIPLIER} is no quantity to {aim_name}: ask for {RADIUS}")
    rough = _rough(orbit, aim_name, quantity, conditions)
    points = DesignPoints(
        orbit, names, bounds, measured, rough=rough, admissible=admissible, progress=progress
    )
    first = points.visited[0]
    watched = _watched(first) if admissible and aim_name != "solve" else ()
    points.watching = bool(watched)
    size = abs(first.quantities.values[quantity]) if quantity else 1.0
    aim = Aim(
        quantity,
        -1 if aim_name == "maximise" else 1,
        conditions,
        max(size, _LEAST_UNIT),
        points.lengths,
        watched,
    )
    _check_dependence(points, aim)
    if aim_name == "solve":
        ended = solve_conditions(points, aim, iterations)
        method = "least-squares"
        left, status = _solved(aim, ended.point, names, bounds)
    else:
        chosen: Any = method
        ended = optimise(points, aim, chosen, iterations)
        left, status = _optimal(aim, ended.point, names, bounds)
    if not points.is_motion(ended.point):
        status, ended = NOT_REACHED, ended._replace(reason="the orbit there is no motion")
    return Design(
        aim=aim_name,
        quantity=quantity,
        parameters=names,
        bounds=bounds,
        conditions=conditions,
        method=method,
        quantities=tuple(asked),
        before=_told(points, first, asked, conditions),
        after=_told(points, ended.point, asked, conditions),
        gradient=_gradient(points, ended.point, measured),
        active=left.active,
        corner=left.corner,
        residual=left.residual,
        history=_history(points, ended, asked, conditions),
        status=status,
        message=_message(status, aim, ended, left),
        start=orbit,
        orbit=ended.point.orbit,
    )


def _aim_of(
    minimise: str | None, maximise: str | None, solve: Mapping[str, object] | None
) -> tuple[Any, str]:
    given = {"minimise": minimise, "maximise": maximise, "solve": solve}
    chosen = [name for name, value in given.items() if value]
    if len(chosen) != 1:
        raise InputError(f"one of minimise, maximise and solve is given, not {len(chosen)}")
    return chosen[0], minimise or maximise or ""


def _bounds_of(orbit: Any, over: Any) -> tuple[tuple[str, ...], np.ndarray]:
    if not isinstance(orbit, Orbit):
        raise InputError(f"{type(orbit).__name__} is no orbit, such as nonsmooth.solve gives")
    if orbit.status != newton.CONVERGED:
        raise InputError(f"{orbit.name} cannot be designed: {orbit.message}")
    if not isinstance(over, Mapping) or not over:
        raise InputError('over gives the bounds of parameters, such as {"V": (0.6, 1.3)}')
    opened = {table.name for table in orbit.system.parameters} - {*orbit.given, *orbit.unknowns}
    for name in over:
        if name in opened:
            raise InputError(
                f"no equation of {orbit.name} depends on {name}: it is at most a limit of its"
                " admissibility"
            )
    return tuple(over), np.array([check_interval(orbit, *each) for each in over.items()])


def _conditions_of(
    solve: Mapping[str, object] | None, subject_to: Iterable[str], count: int
) -> tuple[DesignCondition, ...]:
    texts = [subject_to] if isinstance(subject_to, str) else list(subject_to)
    if not solve:
        found = tuple(condition_in(text) for text in texts)
        for each in found:
            if each.quantity == MULTIPLIER and each.relation != "=":
                raise InputError(f"{each.text}: a multiplier is wanted by =, or {RADIUS} by <=")
        equations = sum(each.relation == "=" for each in found)
        if equations > count:
            raise InputError(f"{equations} equations for {count} parameters: solve for them")
        return found
    if texts:
        raise InputError("values that are solved for take no other conditions")
    wanted = tuple(
        DesignCondition(quantity=name, relation="=", value=as_value(value))
        for name, value in solve.items()
    )
    if len(wanted) != count:
        raise InputError(
            f"{len(wanted)} wanted values for {count} parameters: as many of one as of the other"
        )
    return wanted


def _watched(first: DesignPoint) -> tuple[MarginKey, ...]:
    """The boundaries that stay away; none where open parameters decide how far they are."""
    kernels = first.orbit.problem.kernels
    if kernels is not None and any(
        p.name not in first.orbit.opened for p in kernels.open_parameters
    ):
        return ()
    margins = first.quantities.derivatives.margins
    return tuple(MarginKey(m.phase, m.boundary) for m in margins)


def _check_options(method: str, iterations: int) -> None:
    if method not in METHODS:
        raise unknown_name("method", method, METHODS)
    if isinstance(iterations, bool) or not isinstance(iterations, int) or iterations < 1:
        raise InputError(f"iterations = {iterations} is not a positive integer")


def _rough(
    orbit: Orbit, aim: str, quantity: str, conditions: Sequence[DesignCondition]
) -> tuple[str, ...]:
    """The spectral radius where only levels above it are asked for, and these are smooth."""
    above = quantity != RADIUS or aim == "minimise"
    above &= all(c.relation == "<=" for c in conditions if c.quantity == RADIUS)
    if quantity.startswith(PEAK):
        return (quantity,)
    if above and is_smooth_from_above(orbit.derivatives()):
        return (RADIUS,)
    return ()


def _check_dependence(points: DesignPoints, aim: Aim) -> None:
    """Name a parameter that nothing that is asked for depends on."""
    first = points.visited[0]
    slopes = [aim.rows(first, 1.0, equal=equal).slopes for equal in (True, False)]
    if aim.quantity and not aim.levelled:
        slopes.append(aim.slope(first)[None])
    largest = np.abs(np.vstack(slopes)).max(axis=0)
    for place, name in enumerate(points.names):
        if largest[place] <= _NO_SLOPE:
            raise InputError(f"nothing that is asked for depends on {name}")


def _solved(
    aim: Aim, point: DesignPoint, names: Sequence[str], bounds: np.ndarray
) -> tuple[Optimality, int]:
    left = aim.missed(point)
    status = CONVERGED if left <= _SOLVED else NOT_REACHED
    return Optimality(bounds_met(point, names, bounds), left, ""), status


def _optimal(
    aim: Aim, point: DesignPoint, names: tuple[str, ...], bounds: np.ndarray
) -> tuple[Optimality, int]:
    left = optimality(aim, point, names, bounds)
    met = left.residual <= _OPTIMAL and aim.missed(point) <= _MET
    return left, CONVERGED if met else NOT_REACHED


def _told(
    points: DesignPoints,
    point: DesignPoint,
    asked: Iterable[str],
    conditions: Sequence[DesignCondition],
) -> dict[str, float]:
    values = {name: float(point.orbit.given[name]) for name in points.names}
    wanted = {c.quantity: float(c.value) for c in conditions}
    found = {name: point.quantities.quantity(name, wanted.get(name)) for name in asked}
    return {**values, **found}


def _gradient(
    points: DesignPoints, point: DesignPoint, measured: Iterable[str]
) -> dict[str, dict[str, float]]:
    return {
        name: dict(zip(points.names, point.quantities.slopes[name].tolist(), strict=True))
        for name in measured
    }


def _history(
    points: DesignPoints, ended: Ended, asked: Iterable[str], conditions: Sequence[DesignCondition]
) -> np.ndarray:
    names = tuple(asked)
    rows = [_told(points, point, names, conditions) for point in ended.history]
    return np.array([[row[name] for name in (*points.names, *names)] for row in rows])


def _message(status: int, aim: Aim, ended: Ended, left: Optimality) -> str:
    acting = ", ".join(limit.text for limit in left.active)
    if status == CONVERGED:
        if not aim.quantity:
            return "the wanted values are met"
        parts = [f"an optimum within {acting}" if acting else "an optimum"]
        return "; ".join([*parts, *([left.corner] if left.corner else [])])
    missed = [
        c
        for c in aim.conditions
        if np.abs(np.minimum(aim.condition_rows(ended.point, c).values, 0.0)).max() > _MET
        or (c.relation == "=" and aim.missed(ended.point) > _MET)
    ]
    told = f"{', '.join(c.text for c in missed)} not reached" if missed else "no optimum"
    why = ended.reason or (f"within {acting}" if acting else "the optimiser found no better one")
    return f"{told}: {why}"
