"""Phases that may vanish: equations and section maps that are regular there.

A phase may begin and end on one boundary: its equation is divided by the dwell time.
Where the dwell time t is zero the switching condition n y(t) = 0 holds whatever the speed is. As
n y(0) = 0 follows from the phase before, (n y(t) - n y(0)) / t = 0 has the same solutions for
all other t, and is regular at zero.

Of an orbit that is no function of time the equations stay as they are. If all lasts in the phase
that is known where it begins, as what sticks does, its changes at a fixed time are the section's,
up to the flow, which the next section removes: that map needs no speed of the boundary function.
"""

from typing import Any, NamedTuple

from flint import arb

from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import Numbers, demand, product
from nonsmooth.runtime.core.rational_functions import pivot
from nonsmooth.runtime.core.taylor_models import matrix, middle_of


class Short(NamedTuple):
    """A phase that may vanish, with equations and a section map that are regular there."""

    place: int  # number of the phase, from 0
    # for each phase the column c with F+ R - R F- = c (n F-) where n y = 0, exact; None where there
    # is none or none is used
    jumps: list[Any]
    divided: bool  # whether its switching condition is divided by its dwell time


def short_phase(declared: StatedSystem, place: int) -> Short:
    """Return a phase (counted from 0) as one that may vanish, by equations regular there.

    `Failure` is raised if its condition cannot be divided by its dwell time, or if its
    start is not regular.
    """
    steps = declared.steps
    demand(0 <= place < len(steps) and len(steps) > 1, "there is no such phase to divide")
    kind = declared.closing["kind"]
    covered = declared.rational and not declared.translations and kind in ("forcing", "state")
    demand(covered, "no phase can be divided")
    if kind == "state":
        return _sticking(declared, place)
    before = steps[place - 1]
    start, last = product(steps[place].exit, before.reset), before.exit
    together = all(a * y == b * x for a, x in zip(start, last, strict=True)
                   for b, y in zip(start, last, strict=True))  # fmt: skip
    demand(together and any(last), "a phase that is divided does not begin where it may end")
    return Short(place, [_jump(declared, k) for k in range(len(steps))], True)


def _sticking(declared: StatedSystem, place: int) -> Short:
    """Return a phase as one in which all that is known where it begins lasts."""
    begins, lasts, _ = declared.known[place]
    demand(begins and len(begins) == len(lasts), "what is known of a short phase does not last")
    before = (place - 1) % len(declared.steps)
    jump = _jump(declared, before)
    demand(jump is not None, "a short phase does not begin regularly")
    return Short(place, [jump if k == before else None for k in range(len(declared.steps))], False)


def _jump(declared: StatedSystem, place: int) -> list[Any] | None:
    """Return the jump of the velocity behind a phase over the rate of its boundary function.

    None is returned if there is no such column.
    """
    step, following = declared.steps[place], declared.steps[(place + 1) % len(declared.steps)]
    own = pivot(step.exit)

    def left(row: Numbers) -> list[Any]:
        if own is None:
            return list(row)
        share = row[own] / step.exit[own]
        return [x - share * y for x, y in zip(row, step.exit, strict=True)]

    rate = left(product(step.exit, step.field))
    first = pivot(rate)
    if first is None:
        return None
    found: list[Any] = []
    for ahead, behind in zip(following.field, step.reset, strict=True):
        both = zip(product(ahead, step.reset), product(behind, step.field), strict=True)
        jump = left([x - y for x, y in both])
        share = jump[first] / rate[first]
        if any(x - share * y for x, y in zip(jump, rate, strict=True)):
            return None
        found.append(share)
    return found


def means(row: Any, b: Any, time: Any) -> tuple[Any, Any]:
    """Return the means (1, m) of row exp (b s) and of row exp (b s) s / time over s up to a time.

    The time may be zero.
    """
    size, inner, entries = b.nrows(), b * time, row.entries()
    numbers = (middle_of(entry).man_exp() for entry in entries)
    unit = arb(2) ** int(max(power + mantissa.bit_length() for mantissa, power in numbers))
    rows: list[list[Any]] = [[0, 1, *([0] * size)], [0, 0, *(entry / unit for entry in entries)]]
    rows += [[0, 0, *(inner[i, j] for j in range(size))] for i in range(size)]
    found = matrix(rows).exp()
    mean, earlier = (matrix([[found[k, 2 + j] for j in range(size)]]) * unit for k in (1, 0))
    return mean, mean - earlier
