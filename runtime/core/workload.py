"""How large a work is, before it begins: what memory holds, and how many hours it takes.

Estimates are low on purpose: a work that is refused is too large on any machine of this size.
"""

from __future__ import annotations

import math
import os
import sys
from contextlib import suppress
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError

HOURS = 24.0  # of all processors of this machine, that a work may take unasked
# of one processor; scripts/benchmark.py measures them
SECONDS = {
    "orbit": 2e-6,  # a point of a chart of a derived orbit
    "composed orbit": 2e-5,  # the same of an orbit that is composed from tables
    "transition": 3e-7,  # of a motion, in the compiled engine
    "proved transition": 1e-3,
    "point": 2e-4,  # of a branch
    "fit": 1e-3,  # of parameters to measurements, from one guess
    "tile": 1e-2,  # of a proven map
    "image": 1e-3,  # of a box of a proven graph
}
BYTES = 8  # of a number
_CGROUPS = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")


class TooLarge(InputError):
    """A work is larger than the memory, or the hours, that there are for it."""


def check_memory(what: str, size: float) -> None:
    """Raise `TooLarge` for a work whose numbers do not fit into the memory of this machine.

    `what` names the work with its number: ``"10000 values of 60 samples"``; `size` is the
    least number of bytes that it needs.

    Examples
    --------
    >>> check_memory("10 values", 80)
    """
    there = memory_here()
    if not size <= there:
        raise TooLarge(
            f"{what} take at least {_amount(size / 1e9)} GB of memory, where {there / 1e9:.3g} are"
        )


def check_hours(what: str, seconds: float, *, yes: bool) -> None:
    """Raise `TooLarge` for a work of more than `HOURS` on this machine, unless it is asked for.

    `what` names the work with its number: ``"10000 starts"``; `seconds` are those of one
    processor, at least. `yes` says that such a work was asked for; the message names the
    option that does so.

    Examples
    --------
    >>> check_hours("10000 starts", 20.0, yes=False)
    """
    processors = os.cpu_count() or 1
    if not yes and not seconds / 3600 / processors <= HOURS:
        raise TooLarge(
            f"{hours_told(what, seconds / processors)}, more than {HOURS:g}:"
            " --yes begins them all the same"
        )


def hours_told(what: str, seconds: float) -> str:
    """A sentence on how long a work takes at least; `what` names it with its number.

    Examples
    --------
    >>> hours_told("10000 starts", 7200.0)
    '10000 starts take at least 2 hours here'
    """
    return f"{what} take at least {_amount(seconds / 3600)} hours here"


def memory_here() -> float:
    """Bytes of memory that this process may take; those of the machine if nothing limits it."""
    found = [math.inf]
    with suppress(AttributeError, OSError, ValueError):
        found.append(float(os.sysconf("SC_PAGE_SIZE")) * os.sysconf("SC_PHYS_PAGES"))
    for place in _CGROUPS:
        with suppress(OSError, ValueError):
            found.append(float(Path(place).read_text(encoding="ascii")))
    if sys.platform != "win32":
        import resource

        soft, _ = resource.getrlimit(resource.RLIMIT_AS)
        found.append(math.inf if soft == resource.RLIM_INFINITY else float(soft))
    return min(found)


def _amount(number: float) -> str:
    """A number as text: to three digits, or from 1000 to 10^9 as an integer."""
    return f"{number:,.0f}" if 1000 <= number < 1e9 else f"{number:.3g}"
