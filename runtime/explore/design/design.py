"""Parameters in bounds at which an orbit is best, or has wanted values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints, Trial
from nonsmooth.runtime.explore.design.optimising import (
    INTERRUPTED,
    Aim,
    Ended,
    Optimality,
    optimality,
    optimise,
    watched_margins,
)
from nonsmooth.runtime.explore.design.optimum import (
    CONVERGED,
    NOT_REACHED,
    Design,
    check_resumed,
    design_question,
)
from nonsmooth.runtime.explore.design.quantities import (
    MULTIPLIER,
    PURE,
    extreme_keys,
    is_extreme,
    is_largest_of_several,
    unit_of,
)
from nonsmooth.runtime.explore.design.worst_over import Trials, optimise_worst, spread
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.simulate import checked_count

MOST_ITERATIONS = 200
_OPTIMAL = 1e-5  # of the gradient that is left
_SOLVED = 1e-9
_NO_SLOPE = 1e-13  # of a quantity over an interval: nothing depends on the parameter
_MET = 1e-8  # of a condition


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
    checked_count("iterations", iterations, 1)
    question = design_question(orbit, minimise, maximise, solve, over, worst_over, subject_to)
    if resume is not None:
        check_resumed(question, orbit, resume)
    quantity, names, bounds = question.quantity, question.parameters, question.bounds
    branch, asked, measured = question.worst_over, question.asked, question.measured
    history: list[Trial] = []

    def told(visited: int) -> None:
        if progress is not None:
            progress(len(history), visited)

    def where(member: DesignPoint) -> str:
        """Position of an orbit on the branch, in words."""
        return "".join(f" at {n} = {float(member.orbit.given[n]):.6g}" for n in branch)

    points = DesignPoints(
        orbit if resume is None else resume.orbit,
        (*names, *branch),
        np.vstack([bounds, *branch.values()]),
        measured,
        rough=question.rough,
        admissible=admissible,
        progress=told,
    )
    first = points.visited[0]
    lengths = np.asarray(bounds[:, 1] - bounds[:, 0])
    # boundaries that must not be crossed; none if parameters that are left open decide on them
    watching = admissible and question.aim != "solve"
    watching = watching and not first.orbit.problem.left_open(first.orbit)
    watched = watched_margins(first.quantities, lengths) if watching else {}
    points.watching = bool(watched)
    units = {
        name: unit_of(value, first.quantities.slopes[name][: len(names)] * lengths)
        for name, value in first.quantities.values.items()
    }
    several = is_extreme(quantity) and is_largest_of_several(quantity, question.sign)
    aim = Aim(
        quantity,
        question.sign,
        question.conditions,
        units[quantity] if quantity else 1.0,
        lengths,
        {name: unit for name, unit in units.items() if name not in PURE},
        watched,
        extreme_keys([first.quantities.derivatives], quantity) if several else (),
    )
    trials = Trials(points, aim, iterations, history)
    trials = spread(trials) if branch else trials.begun(first.place)
    aim, begin = trials.aim, trials.visited[0]
    _check_dependence(names, begin, aim)
    ended = optimise_worst(trials) if branch else optimise(trials)
    left = optimality(aim, ended.point, names, bounds, where)
    met = left.residual <= (_OPTIMAL if quantity else _SOLVED) and aim.missed(ended.point) <= _MET
    status = CONVERGED if met else NOT_REACHED
    stopped = ended.reason == INTERRUPTED
    if stopped and len(history) < 2:
        raise KeyboardInterrupt
    if not stopped and not all(points.allowed(member.z) for member in ended.point.members):
        status, ended = NOT_REACHED, ended._replace(reason="the orbit there is no motion")
    rows = (_values_of(names, aim, point, asked) for point in history)
    iterates = [[row[name] for name in (*names, *asked)] for row in rows]
    found = Design(
        **vars(question),
        method="least-squares" if question.aim == "solve" else "SLSQP",
        quantities=asked,
        before=_values_of(names, aim, begin, asked) if resume is None else resume.before,
        after=_values_of(names, aim, ended.point, asked),
        worst_at=tuple(float(w.orbit.given[name]) for name in branch for w in left.worst_at),
        gradient={
            name: dict(zip(names, slopes[: len(names)].tolist(), strict=True))
            for name in measured
            for slopes in [_worst(aim, ended.point, name)[0].quantities.slopes[name]]
        },
        active=left.active,
        corner=left.corner,
        residual=left.residual,
        history=np.array([*(() if resume is None else resume.history), *iterates]),
        status=NOT_REACHED if stopped else status,
        message=_message_of(aim, ended, left, converged=status == CONVERGED),
        start=orbit if resume is None else resume.start,
        orbit=aim.worst(ended.point).orbit if quantity else ended.point.members[0].orbit,
    )
    if stopped:
        raise Interrupted(found)
    return found


def _check_dependence(names: Sequence[str], first: Trial, aim: Aim) -> None:
    """Refuse a parameter on which nothing that is asked for depends."""
    slopes = [aim.rows(first, 1.0, equal=equal).slopes for equal in (True, False)]
    if aim.quantity and not aim.levelled:
        slopes.append(aim.slope(first)[None])
    largest = np.abs(np.vstack(slopes)).max(axis=0)
    for place, name in enumerate(names):
        if largest[place] <= _NO_SLOPE:
            raise InputError(f"nothing that is asked for depends on {name}")


def _worst(aim: Aim, point: Trial, name: str) -> tuple[DesignPoint, float]:
    """The orbit of a trial at which a quantity has its worst value, and that value."""
    wanted = {c.quantity: float(c.value) for c in aim.conditions}
    below = [c.quantity for c in aim.conditions if c.relation == "<="]
    sign = aim.sign if name == aim.quantity else 1 if name in below else -1
    found = [each.quantities.quantity(name, wanted.get(name)) for each in point.members]
    worst = int(np.argmax(sign * np.array(found)))
    return point.members[worst], found[worst]


def _values_of(
    names: Sequence[str], aim: Aim, point: Trial, asked: Iterable[str]
) -> dict[str, float]:
    """Values of the parameters `names` and the quantities `asked` at a trial.

    Along a branch each quantity has its worst value.
    """
    given = point.members[0].orbit.given
    own = {name: float(given[name]) for name in names}
    return own | {name: _worst(aim, point, name)[1] for name in asked}


def _message_of(aim: Aim, ended: Ended, left: Optimality, *, converged: bool) -> str:
    """A text that says how a design ended."""
    if ended.reason == INTERRUPTED:
        return INTERRUPTED
    acting = ", ".join(limit.text for limit in left.active)
    if converged:
        if not aim.quantity:
            return "the wanted values are met"
        parts = [f"an optimum within {acting}" if acting else "an optimum"]
        return "; ".join([*parts, *([left.corner] if left.corner else [])])
    missed = {each.text for each in aim.limits(ended.point) if each.missed > _MET}
    wanted = [each.text for each in aim.conditions if each.text in missed]
    told = f"{', '.join(wanted)} not reached" if wanted else "no optimum"
    why = ended.reason or (f"within {acting}" if acting else "the optimiser found no better one")
    return f"{told}: {why}"


def along(
    design: Design, orbit: Orbit, parameter: str, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Values (count,) of a parameter over its interval, and the quantities (count, m) there.

    The parameter is one that varied, or that of the branch; the others are as for `orbit`, where
    the design began or ended. The quantities are NaN where the branch does not lead.
    """
    varied = dict(zip(design.parameters, design.bounds, strict=True))
    bounds = np.array([{**varied, **design.worst_over}[parameter]])
    wanted = [name for name in design.quantities if name != MULTIPLIER]
    points = DesignPoints(orbit, (parameter,), bounds, wanted, rough=wanted, admissible=False)
    begin = points.visited[0].place[0]
    parts = np.linspace(0.0, 1.0, count)
    found = np.full((count, len(design.quantities)), np.nan)
    sides = np.flatnonzero(parts >= begin), np.flatnonzero(parts < begin)[::-1]
    goals = [(c.quantity, float(c.value)) for c in design.conditions]
    for side in sides:
        for each in side:
            try:
                point = points.at(parts[each : each + 1])
            except Beyond:
                break
            found[each] = [
                point.quantities.quantity(name, dict(goals).get(name)) for name in design.quantities
            ]
    return bounds[0, 0] + parts * points.lengths[0], found
