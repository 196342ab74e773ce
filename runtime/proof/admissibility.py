"""Whether a proved orbit is a motion of the real system, for all times of all its phases.

No boundary of a phase's configuration is reached before the phase ends, the one that ends it
is reached from inside, nothing else is reached then, and of the transitions that are declared
for it the first whose conditions hold is the itinerary's. The full cycle is looked at: no
symmetry is taken for granted.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.taylor_models import matrix
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.events.transition_choice import first_following
from nonsmooth.runtime.proof.admissibility_conditions import Derivative, Follower, Plan, Watched
from nonsmooth.runtime.proof.motion.exact_rows import evaluate
from nonsmooth.runtime.proof.sign_along_phase import Crossed, EventFunctions, ExactZeros
from nonsmooth.runtime.shooting.variational import Phase, Shooting

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Judgement", "OpenInequality", "judge"]


class OpenInequality(NamedTuple):
    """A strict inequality of an orbit that becomes an equality at a border collision.

    By kind: "vanishing-phase" says that the dwell time is positive; "entry" and "tangent" that
    the first nonzero derivative of a boundary function at the phase's start is negative, and
    "tangent" at the end that the function's rate is positive; "simultaneous" that another
    boundary function is negative at the end; "grazing" that its maximum inside the phase is
    negative; "condition" that a condition of a transition is as the itinerary asks.
    """

    kind: str
    phase: int  # counted from 0
    # for a condition its place: "2.1" is the first one of the second listed transition
    boundary: str
    instant: str  # "", "start", "inside" or "end"

    @property
    def slow(self) -> bool:
        """Whether the inequality says that a boundary is reached with positive speed."""
        return (self.kind, self.instant) == ("tangent", "end")


class Judgement(NamedTuple):
    """The verdict about an orbit's admissibility, with its reason."""

    verdict: str  # "proved", "refuted" or "undecided"
    reason: str  # empty if proved
    # what an undecided verdict could not decide; None stands for anything else than such an
    # inequality
    open: tuple[OpenInequality | None, ...] = ()
    # for each assumed grazing the begin and end of the window of time that holds the maximum
    touching: Mapping[OpenInequality, tuple[arb, arb]] = MappingProxyType({})


class _Refuted(Exception):
    pass


class _NotTold(Exception):
    """The sign of an inequality cannot be decided."""

    def __init__(self, which: OpenInequality, reason: str) -> None:
        super().__init__(reason)
        self.which, self.reason = which, reason


@contextmanager
def _opens(which: OpenInequality) -> Iterator[None]:
    """Turn `Undecided` inside the block into `_NotTold` of an inequality.

    What more digits cannot decide either stays `Undecided`.
    """
    try:
        yield
    except Undecided as trouble:
        if not trouble.digits:
            raise
        raise _NotTold(which, trouble.reason) from None


def judge(
    plans: Sequence[Plan],
    phases: Sequence[Phase],
    now: Shooting,
    dwell: Sequence[Any],
    assumed: Collection[OpenInequality] = (),
) -> Judgement:
    """Judge whether an orbit whose start and dwell times are enclosed is a motion of the system.

    The plans are in the numbers of the phases, and `now` is the passage over the enclosures. The
    inequalities in `assumed` are taken to hold. The verdict is "refuted" as soon as one phase is
    refuted, "proved" if all phases are proved, else "undecided".
    """
    open_: list[OpenInequality | None] = []
    touching: dict[OpenInequality, tuple[arb, arb]] = {}
    undecided = ""
    for plan, phase, time in zip(plans, phases, dwell, strict=True):
        name = f"phase {plan.place + 1}, {plan.configuration}"
        try:
            judged = _Phase(plan, phase.field, now, time, assumed)
            judged.judge()
        except _Refuted as found:
            return Judgement("refuted", f"{name}: {found}")
        if judged.open:
            undecided = undecided or f"{name}: {judged.open[0][1]}"
            open_ += [which for which, _ in judged.open]
        touching |= judged.touching
    if undecided:
        return Judgement("undecided", undecided, tuple(open_), touching)
    return Judgement("proved", "", touching=touching)


class _Phase:
    """One phase of an orbit, with the inequalities that its judgement leaves open."""

    def __init__(
        self, plan: Plan, field: Any, now: Shooting, dwell: Any, assumed: Collection[OpenInequality]
    ) -> None:
        self.plan, self.field, self.dwell, self.assumed = plan, field, dwell, assumed
        self.first = now.starts[plan.place]
        self.start = plan.starts.tighten(self.first.entries()[:-1])
        self.behind = plan.ends.tighten(now.ends[plan.place].entries()[:-1])
        self.open: list[tuple[OpenInequality | None, str]] = []
        self.touching: dict[OpenInequality, tuple[arb, arb]] = {}
        reached = [watched.name for watched in plan.watched if watched.reached]
        self.ending = OpenInequality("vanishing-phase", plan.place, "+".join(reached), "")

    def judge(self) -> None:
        """Judge all boundaries and keep what is undecided in `open`.

        It raises `_Refuted` where the phase is no motion of the system.
        """
        if not self.dwell > 0 and self.ending not in self.assumed:
            if self.dwell < 0:
                raise _Refuted("its dwell time is negative")
            self.open.append((self.ending, "its dwell time cannot be told from 0"))
            return
        try:
            self._held()
            functions = None
            for watched in self.plan.watched:
                functions = functions or (
                    None if watched.still else EventFunctions(self.field, self.first, self.dwell)
                )
                try:
                    self._watched(watched, functions)
                except _NotTold as trouble:
                    if not self._bends(watched, functions):
                        self._not_inside(watched, functions)
                        self.open.append((trouble.which, trouble.reason))
            self._follows()
        except Undecided as trouble:
            self.open.append((None, trouble.reason))

    def _held(self) -> None:
        for row in self.plan.held:
            value = evaluate(row, self.start)
            if value > 0 or value < 0:
                raise _Refuted("what it holds does not hold where it begins")
            raise Undecided("whether what it holds holds where it begins", digits=False)

    def _watched(self, watched: Watched, functions: EventFunctions | None) -> None:
        """Prove that one boundary is respected."""
        name, begins, place = watched.name, watched.begins, self.plan.place
        order = 0 if begins is None else begins.order
        if self.ending in self.assumed and self._bends(watched, functions):
            return
        rising = int(watched.reached)
        if begins is not None:
            which = OpenInequality("tangent" if order else "entry", place, name, "start")
            if which in self.assumed:
                order = watched.follows
                begins = None
            elif watched.reached and not order and self.ending in self.assumed:
                begins = None  # it rises from there to zero
        if begins is not None:
            with _opens(which):
                value = _signed(begins, self.start, f"{name} where it begins: its")
            if value > 0:
                raise _Refuted(f"{name} is passed where it begins")
        if watched.reached:
            which = OpenInequality("tangent", place, name, "end")
            if which in self.assumed:
                rising = 2
            else:
                with _opens(which):
                    self._speed(watched)
                rising = 2
        if functions is None or watched.still:
            return
        zeros = ExactZeros(order, rising, falls=begins is not None and begins.order > 0)
        self._inside(functions, watched, zeros)

    def _not_inside(self, watched: Watched, functions: EventFunctions | None) -> None:
        """Refute the phase if the boundary is proved to be crossed inside it.

        It is called where the boundary's inequality at an end of the phase is undecided.
        """
        if functions is None or watched.still:
            return
        time = functions.crossed(functions.function(matrix([watched.row])))
        if time is not None:
            raise _Refuted(_crossed(watched.name, time))

    def _bends(self, watched: Watched, functions: EventFunctions | None) -> bool:
        """Whether a boundary function that is exactly zero at both ends of the phase is convex.

        As the dwell time is positive, the function is then negative inside, and the boundary is
        left and reached with a nonzero speed.
        """
        begins = watched.begins
        if functions is None or begins is None or begins.order != 1 or not watched.reached:
            return False
        if any(watched.ends):
            return False
        bend = matrix([watched.row]) * self.field * self.field
        try:
            functions.stays_negative(functions.function(-bend), ExactZeros(0, 0))
        except (Crossed, Undecided):
            return False
        return True

    def _speed(self, watched: Watched) -> None:
        """Prove that the boundary is reached with a positive speed where the phase ends."""
        name = watched.name
        if any(watched.ends):
            value = evaluate(watched.ends, self.behind)
            if value > 0 or value < 0:
                raise _Refuted(f"{name} is not reached where it ends")
            raise Undecided(f"whether {name} is reached where it ends", digits=False)
        speed = evaluate(watched.speed, self.behind)
        if speed < 0:
            raise _Refuted(f"{name} is reached from outside")
        if not speed > 0:
            raise Undecided(f"{name} may be reached tangentially")

    def _inside(self, functions: EventFunctions, watched: Watched, zeros: ExactZeros) -> None:
        """Prove that a boundary is not reached inside the phase."""
        place, name = self.plan.place, watched.name
        grazing = OpenInequality("grazing", place, name, "inside")
        together = OpenInequality("simultaneous", place, name, "end")
        if together in self.assumed:
            zeros = zeros._replace(last=1)
        function = functions.function(matrix([watched.row]))
        try:
            if grazing in self.assumed:
                window = functions.touched(function, zeros)
                if window is None:
                    raise Undecided("it may be touched more than once")
                number, begin, end = window
                self.touching[grazing] = (function[number].time(begin), function[number].time(end))
                return
            functions.stays_negative(function, zeros)
        except Crossed as found:
            raise _Refuted(_crossed(name, found.time)) from None
        except Undecided as trouble:
            last = evaluate(watched.ends, self.behind)
            at_end = not (zeros.last or last < 0 or last > 0)
            which = together if at_end else grazing
            raise _NotTold(which, f"{name}: {trouble.reason}") from None

    def _follows(self) -> None:
        """Prove that in every order the itinerary's transition is the first to follow."""
        for followers in self.plan.orders:
            left = self._left(followers)
            if left is not None:
                self._first(left)

    def _left(self, followers: Sequence[Follower]) -> list[Follower] | None:
        """Return the followers that remain if the assumed conditions are as assumed.

        None if a condition is undecided and not assumed.
        """
        opens = self._open_conditions(followers)
        left = [(which, target) for which, target in opens if which not in self.assumed]
        if left:
            self.open += [(which, f"whether {target} follows") for which, target in left]
            return None
        taken = {int(which.boundary.split(".")[0]) for which, _ in opens}
        return [
            follower._replace(conditions=()) if number in taken else follower
            for number, follower in enumerate(followers, 1)
            if follower.wanted or number not in taken
        ]

    def _first(self, followers: Sequence[Follower]) -> None:
        """Prove that the first follower whose conditions hold is the itinerary's."""
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

    def _open_conditions(self, followers: Sequence[Follower]) -> list[tuple[OpenInequality, str]]:
        """Return the undecided conditions on which alone the itinerary's transition depends.

        Each comes with its transition's target. A transition has at most one: all its other
        conditions hold, so where it changes, another transition follows, or none.
        """
        if len(self.plan.orders) > 1 or any(follower.doubt for follower in followers):
            return []
        found = []
        for number, follower in enumerate(followers, 1):
            left = []
            for k, (behind, expected) in enumerate(follower.conditions, 1):
                try:
                    if (self._sign(behind) > 0) != expected:
                        break
                except Undecided as trouble:
                    left.append(k if trouble.digits else 0)
            else:
                if len(left) > 1 or 0 in left:
                    return []
                if left:
                    name = f"{number}.{left[0]}"
                    which = OpenInequality("condition", self.plan.place, name, "end")
                    found.append((which, follower.target))
                elif not follower.wanted:
                    return []
        return found

    def _sign(self, behind: Derivative | None) -> int:
        """Return the sign of a function just behind the phase's end; 0 for the zero function."""
        if behind is None:
            return 0
        return 1 if _signed(behind, self.behind, "it") > 0 else -1


def _crossed(name: str, time: arb) -> str:
    return f"{name} is crossed before it ends, {time.str(6, radius=False)} after its start"


def _signed(derivative: Derivative, state: Sequence[Any], told: str) -> Any:
    """Return the value of a derivative, and raise `Undecided` if its ball contains zero."""
    value = evaluate(derivative.row, state)
    if value > 0 or value < 0:
        return value
    raise Undecided(f"{told} derivative of order {derivative.order} cannot be told from 0")
