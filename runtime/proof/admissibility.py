"""Whether a proved orbit is a motion of the real system, for all times of all its phases.

No boundary of a phase's configuration is reached before the phase ends, the one that ends it
is reached from inside, nothing else is reached then, and of the transitions that are declared
for it the first whose conditions hold is the itinerary's. The full cycle is looked at: no
symmetry is taken for granted.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.taylor_models import matrix, range_of
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.events.transition_choice import first_following
from nonsmooth.runtime.proof.admissibility_conditions import Derivative, Follower, Plan, Watched
from nonsmooth.runtime.proof.motion.exact_rows import evaluate
from nonsmooth.runtime.proof.sign_along_phase import Crossed, EventFunctions, ExactZeros
from nonsmooth.runtime.shooting.variational import Phase, Shooting

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Judgement", "Margin", "judge"]


class Margin(NamedTuple):
    """How clearly a boundary is respected.

    Attributes
    ----------
    phase : int
    configuration, boundary : str
    quantity : {"distance", "departure", "speed"}
        The boundary function stays below minus that; its first derivative that is not zero
        at the start is below minus that; the boundary is reached with at least that speed.
    least : arb
        Positive, exact.
    """

    phase: int
    configuration: str
    boundary: str
    quantity: str
    least: arb


class Judgement(NamedTuple):
    """Verdict "proved", "refuted" or "undecided", the reason where it is not proved, margins."""

    verdict: str
    reason: str
    margins: tuple[Margin, ...]


class _Refuted(Exception):
    pass


def judge(
    plans: Sequence[Plan], phases: Sequence[Phase], now: Shooting, dwell: Sequence[Any]
) -> Judgement:
    """Judge an orbit whose start and dwell times are enclosed, at the working precision.

    Parameters
    ----------
    plans : sequence of Plan
        In the numbers of the phases.
    phases : sequence of Phase
    now : Shooting
        Over the enclosures.
    dwell : sequence of arb or TaylorModel

    Returns
    -------
    Judgement
        "refuted" once a phase is, "proved" if all phases are, else "undecided".
    """
    margins: list[Margin] = []
    undecided = ""
    for plan, phase, time in zip(plans, phases, dwell, strict=True):
        name = f"phase {plan.place + 1}, {plan.configuration}"
        try:
            margins += _Phase(plan, phase.field, now, time).judged()
        except _Refuted as found:
            return Judgement("refuted", f"{name}: {found}", ())
        except Undecided as trouble:
            undecided = undecided or f"{name}: {trouble.reason}"
    if undecided:
        return Judgement("undecided", undecided, ())
    return Judgement("proved", "", tuple(margins))


class _Phase:
    """One phase of an orbit."""

    def __init__(self, plan: Plan, field: Any, now: Shooting, dwell: Any) -> None:
        self.plan, self.field, self.dwell = plan, field, dwell
        self.first = now.starts[plan.place]
        self.start = plan.starts.tighten(self.first.entries()[:-1])
        self.behind = plan.ends.tighten(now.ends[plan.place].entries()[:-1])

    def judged(self) -> list[Margin]:
        """Margins of all boundaries; raises where one is crossed or cannot be decided."""
        if not self.dwell > 0:
            if self.dwell < 0:
                raise _Refuted("its dwell time is negative")
            raise Undecided("its dwell time cannot be told from 0")
        for row in self.plan.held:
            value = evaluate(row, self.start)
            if value > 0 or value < 0:
                raise _Refuted("what it holds does not hold where it begins")
            raise Undecided("whether what it holds holds where it begins", digits=False)
        found: list[Margin] = []
        functions = None
        for watched in self.plan.watched:
            name, begins = watched.name, watched.begins
            if begins is not None:
                value = _signed(begins, self.start, f"{name} where it begins: its")
                if value > 0:
                    raise _Refuted(f"{name} is passed where it begins")
            if watched.reached:
                found.append(self._margin(name, "speed", self._speed(watched)))
            if begins is not None and begins.order:
                found.append(self._margin(name, "departure", -value))
            if watched.still:
                if begins is not None and not begins.order:
                    found.append(self._margin(name, "distance", -value))
                continue
            functions = functions or EventFunctions(self.field, self.first, self.dwell)
            least = self._distance(functions, watched)
            if least is not None:
                found.append(self._margin(name, "distance", least))
        self._follows()
        return found

    def _margin(self, boundary: str, quantity: str, least: Any) -> Margin:
        plan = self.plan
        return Margin(plan.place, plan.configuration, boundary, quantity, range_of(least).lower())

    def _speed(self, watched: Watched) -> Any:
        """Speed at which a boundary is reached that is exactly zero at the end."""
        name = watched.name
        if any(watched.ends):
            value = evaluate(watched.ends, self.behind)
            if value > 0 or value < 0:
                raise _Refuted(f"{name} is not reached where it ends")
            raise Undecided(f"whether {name} is reached where it ends", digits=False)
        speed = evaluate(watched.speed, self.behind)
        if speed > 0:
            return speed
        if speed < 0:
            raise _Refuted(f"{name} is reached from outside")
        raise Undecided(f"{name} may be reached tangentially")

    def _distance(self, functions: EventFunctions, watched: Watched) -> arb | None:
        """Prove that a boundary is not reached inside the phase; by how much, if anything."""
        order = 0 if watched.begins is None else watched.begins.order
        zeros = ExactZeros(order, watched.reached)
        function = functions.function(matrix([watched.row]))
        try:
            if not (zeros.order or zeros.last):
                least = (-functions.largest(function) / 2).mid()
                if least > 0:
                    try:
                        functions.stays_negative([part.raised(least) for part in function], zeros)
                        return least
                    except (Crossed, Undecided):
                        pass  # a smaller distance may do
            functions.stays_negative(function, zeros)
        except Crossed as found:
            raise _Refuted(
                f"{watched.name} is crossed before it ends, {found.time.str(6, radius=False)}"
                " after its start"
            ) from None
        except Undecided as trouble:
            raise Undecided(f"{watched.name}: {trouble.reason}") from None
        return None

    def _follows(self) -> None:
        """Prove that in every order what follows first is the itinerary's transition."""
        for followers in self.plan.orders:
            self._first(followers)

    def _first(self, followers: Sequence[Follower]) -> None:
        """Prove that of these the first whose conditions hold is wanted."""
        follower, trouble = first_following(followers, self._sign)
        if follower is not None and trouble is not None:
            raise Undecided(f"whether {follower.target} follows")
        if follower is not None and follower.wanted:
            return
        last = follower or followers[-1]
        if last.doubt:
            raise Undecided(last.doubt, digits=False)
        if follower is not None:
            raise _Refuted(f"{follower.target} follows, or another transition to it")
        raise _Refuted(f"{last.target} does not follow: its conditions do not hold")

    def _sign(self, behind: Derivative | None) -> int:
        """Sign of a function behind the end; 0 for none."""
        if behind is None:
            return 0
        return 1 if _signed(behind, self.behind, "it") > 0 else -1


def _signed(derivative: Derivative, state: Sequence[Any], told: str) -> Any:
    """The value of a derivative, which is not zero.

    Raises
    ------
    Undecided
        If it cannot be told from zero.
    """
    value = evaluate(derivative.row, state)
    if value > 0 or value < 0:
        return value
    raise Undecided(f"{told} derivative of order {derivative.order} cannot be told from 0")
