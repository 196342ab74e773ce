"""Parameters in bounds at which an orbit is best, or has wanted values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, get_args

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.resuming import check_same_question
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.orbit_family import check_interval
from nonsmooth.runtime.explore.design.aim import Aim, MarginKey, Trial
from nonsmooth.runtime.explore.design.branch_points import BranchPoints
from nonsmooth.runtime.explore.design.condition import DesignCondition, condition_in
from nonsmooth.runtime.explore.design.design_points import DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.largest import extreme_keys, is_largest_of_several
from nonsmooth.runtime.explore.design.limits import Optimality, bounds_met, optimality
from nonsmooth.runtime.explore.design.optimising import INTERRUPTED, Method, optimise
from nonsmooth.runtime.explore.design.optimum import CONVERGED, NOT_REACHED, Design
from nonsmooth.runtime.explore.design.quantities import MULTIPLIER, RADIUS, is_extreme
from nonsmooth.runtime.explore.design.solving import solve_conditions
from nonsmooth.runtime.explore.design.telling import (
    MET,
    gradient_of,
    iterates_of,
    message_of,
    values_of,
)
from nonsmooth.runtime.explore.design.worst_over import branch_interval, optimise_worst, spread
from nonsmooth.runtime.model.saved_system import same_system
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting import newton

__all__ = ["METHODS", "design"]

METHODS: tuple[str, ...] = get_args(Method)
MOST_ITERATIONS = 200
_OPTIMAL = 1e-5  # of the gradient that is left
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
    worst_over: Mapping[str, tuple[float, float]] | None = None,
    subject_to: Iterable[str] = (),
    admissible: bool = True,
    method: str = "SLSQP",
    iterations: int = MOST_ITERATIONS,
    resume: Design | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Design:
    """Find parameters in bounds at which an orbit is best, or has wanted values.

    Each trial is reached by continuation from the nearest orbit that is known, so that all are
    of one branch; derivatives are exact. Where the branch does not lead to a trial, because it
    turns back, a phase vanishes or the orbit ceases to be a motion, the step is shortened. What
    is found is the optimum near the orbit, not the best of all.

    A spectral radius is minimised as the least level that no multiplier exceeds, by conditions
    on traces and determinants of pairs of multipliers: so an optimum at which two meet, where the
    radius has no derivative, is found as one, and `corner` says it. A peak is minimised as the
    least level that none of the local extremes of the motion exceeds.

    With `worst_over` the quantity is the worst of all orbits along a branch in one more
    parameter, such as the peak over a resonance, and admissibility and all conditions hold all
    along it. The optimiser works with the orbits where something is worst; behind each of its
    rounds the whole branch is looked at anew, at last at 129 values of the parameter, and what is
    worse is taken too. All of the branch has to be of the orbit's itinerary, without folds.

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
    worst_over : mapping of str to (float, float), optional
        Another parameter, and the interval along which the worst value counts: the largest that
        is minimised, or the smallest that is maximised.
    subject_to : iterable of str
        Conditions such as ``period<=6.5``, ``trace>=0`` or ``multiplier=-1``.
    admissible : bool
        Whether each orbit has to be a motion of the real system.
    method : "SLSQP" or "trust-constr"
        The optimiser of SciPy.
    iterations : int
        At most so many in each round.
    resume : Design, optional
        An interrupted one of the same question: it goes on where it was left.
    progress : callable, optional
        Told how many iterates there are and how many orbits were visited, as they come.

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
        has to be, a branch that does not lead all along its interval, another question's design
        to resume, or other options that are wrong.
    Interrupted
        By Ctrl-C, once there is an iterate; its `partial` is the best Design until then.

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
    branch = branch_interval(orbit, worst_over, names)
    _check_options(method, iterations)
    _check_spread(branch is not None, aim_name, conditions)
    asked = dict.fromkeys(([quantity] if quantity else []) + [c.quantity for c in conditions])
    measured = [name for name in asked if name != MULTIPLIER]
    if quantity == MULTIPLIER:
        raise InputError(f"{MULTIPLIER} is no quantity to {aim_name}: ask for {RADIUS}")
    if resume is not None:
        question = _question(orbit, aim_name, quantity, names, bounds, conditions, branch)
        _check_resumed(question, resume, orbit)
        begins = resume.orbit
    else:
        begins = orbit
    history: list[Trial] = []

    def told(visited: int) -> None:
        if progress is not None:
            progress(len(history), visited)

    points = DesignPoints(
        begins,
        names if branch is None else (*names, branch[0]),
        bounds if branch is None else np.vstack([bounds, branch[1]]),
        measured,
        rough=_rough(aim_name, quantity, conditions),
        admissible=admissible,
        progress=told,
    )
    first = points.visited[0]
    watched = _watched(first) if admissible and aim_name != "solve" else ()
    points.watching = bool(watched)
    size = abs(first.quantities.values[quantity]) if quantity else 1.0
    sign = -1 if aim_name == "maximise" else 1
    several = is_extreme(quantity) and is_largest_of_several(quantity, sign)
    aim = Aim(
        quantity,
        sign,
        conditions,
        max(size, _LEAST_UNIT),
        np.asarray(bounds[:, 1] - bounds[:, 0]),
        watched,
        extreme_keys([first.quantities.derivatives], quantity) if several else (),
    )
    trials: DesignPoints | BranchPoints = points
    chosen: Any = method
    if branch is not None:
        aim, trials = spread(points, aim)
    begin: Trial = trials.visited[0]
    _check_dependence(names, begin, aim)
    if aim_name == "solve":
        ended = solve_conditions(points, aim, iterations, history)
        method = "least-squares"
        left, status = _solved(aim, ended.point, names, bounds)
    else:
        if isinstance(trials, BranchPoints):
            ended, trials = optimise_worst(trials, aim, chosen, iterations, history)
        else:
            ended = optimise(points, aim, chosen, iterations, history)
        where = trials.where if isinstance(trials, BranchPoints) else _nowhere
        left = optimality(aim, ended.point, names, bounds, where)
        met = left.residual <= _OPTIMAL and aim.missed(ended.point) <= MET
        status = CONVERGED if met else NOT_REACHED
    stopped = ended.reason == INTERRUPTED
    if stopped and len(history) < 2:
        raise KeyboardInterrupt
    if not stopped and not all(map(points.is_motion, ended.point.members)):
        status, ended = NOT_REACHED, ended._replace(reason="the orbit there is no motion")
    iterates = iterates_of(names, aim, history, asked)
    found = Design(
        aim=aim_name,
        quantity=quantity,
        parameters=names,
        bounds=bounds,
        worst_over={} if branch is None else dict([branch]),
        conditions=conditions,
        method=method,
        quantities=tuple(asked),
        before=values_of(names, aim, begin, asked) if resume is None else resume.before,
        after=values_of(names, aim, ended.point, asked),
        worst_at=_worst_at(left, branch),
        gradient=gradient_of(names, aim, ended.point, measured),
        active=left.active,
        corner=left.corner,
        residual=left.residual,
        history=iterates if resume is None else np.vstack([resume.history, iterates]),
        status=NOT_REACHED if stopped else status,
        message=message_of(aim, ended, left, converged=status == CONVERGED),
        start=orbit if resume is None else resume.start,
        orbit=aim.worst(ended.point).orbit if quantity else ended.point.members[0].orbit,
    )
    if stopped:
        raise Interrupted(found)
    return found


def _nowhere(_: DesignPoint) -> str:
    return ""


def _worst_at(
    left: Optimality, branch: tuple[str, tuple[float, float]] | None
) -> tuple[float, ...]:
    if branch is None:
        return ()
    return tuple(float(member.orbit.given[branch[0]]) for member in left.worst_at)


def _question(
    orbit: Orbit,
    aim: str,
    quantity: str,
    names: tuple[str, ...],
    bounds: np.ndarray,
    conditions: tuple[DesignCondition, ...],
    branch: tuple[str, tuple[float, float]] | None,
) -> dict[str, Any]:
    """What has to be the same where a design goes on."""
    varied = {*names, *([] if branch is None else [branch[0]])}
    return {
        "orbit": orbit.name.removeprefix(orbit.system.name),
        "aim": aim,
        "quantity": quantity,
        "parameters": names,
        "bounds": bounds,
        "conditions": conditions,
        "worst_over": {} if branch is None else dict([branch]),
        **{name: value for name, value in orbit.given.items() if name not in varied},
    }


def _check_resumed(asked: Mapping[str, Any], known: Design, orbit: Orbit) -> None:
    """Refuse to go on with the design of another question."""
    if not isinstance(known, Design):
        raise InputError(f"{type(known).__name__} is no design, such as nonsmooth.design gives")
    branch = next(iter(known.worst_over.items()), None)
    same = (known.aim, known.quantity, known.parameters, known.bounds, known.conditions, branch)
    check_same_question("design", asked, _question(known.orbit, *same))
    if not same_system(known.orbit.system, orbit.system):
        raise InputError(f"the declaration of {orbit.name} has changed since the design was saved")


def _check_spread(whole: bool, aim: str, conditions: Sequence[DesignCondition]) -> None:
    """Refuse what cannot hold all along a branch."""
    if not whole:
        return
    if aim == "solve":
        raise InputError("values that are solved for are of one orbit: leave out worst_over")
    for each in conditions:
        if each.relation == "=":
            raise InputError(f"{each.text}: an equation cannot hold all along worst_over")


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


def _rough(aim: str, quantity: str, conditions: Sequence[DesignCondition]) -> tuple[str, ...]:
    """Quantities of which levels above are asked for alone, and these are smooth."""
    rough = []
    sign = -1 if aim == "maximise" else 1
    if is_largest_of_several(quantity, sign):
        rough.append(quantity)
    asked = quantity != RADIUS or sign > 0
    if asked and all(c.relation == "<=" for c in conditions if c.quantity == RADIUS):
        rough.append(RADIUS)
    return tuple(rough)


def _check_dependence(names: Sequence[str], first: Trial, aim: Aim) -> None:
    """Name a parameter that nothing that is asked for depends on."""
    slopes = [aim.rows(first, 1.0, equal=equal).slopes for equal in (True, False)]
    if aim.quantity and not aim.levelled:
        slopes.append(aim.slope(first)[None])
    largest = np.abs(np.vstack(slopes)).max(axis=0)
    for place, name in enumerate(names):
        if largest[place] <= _NO_SLOPE:
            raise InputError(f"nothing that is asked for depends on {name}")


def _solved(
    aim: Aim, point: Trial, names: Sequence[str], bounds: np.ndarray
) -> tuple[Optimality, int]:
    left = aim.missed(point)
    status = CONVERGED if left <= _SOLVED else NOT_REACHED
    return Optimality(bounds_met(point, names, bounds), left, ""), status
