"""How a search asks the checker, and the loop of all long proofs in which it does.

The checker is asked about every claim before the claim is stated. What a step of a search proposes
to it, and what is tried next where it says undecided, each kind of proof says in a generator of its
steps: these are taken, told and kept until Ctrl-C or time ends them.
"""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import closing, contextmanager
from typing import Any, TypeVar

from nonsmooth.runtime.checker.stated.exact import Entries, Failure
from nonsmooth.runtime.core.errors import Interrupted
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

# what the checker raises where something is not proved, or beyond what can be enclosed
REFUSED = (Failure, ArithmeticError, ValueError)

_BITS = 64  # the precision of the process in which a file is checked


@contextmanager
def asking() -> Iterator[None]:
    """Raise what the checker refuses, or cannot enclose, as `NotCovered` with the reason."""
    try:
        with flint_precision(_BITS):
            yield
    except Failure as failure:
        raise NotCovered(f"the checker refuses it: {failure}") from None
    except (ArithmeticError, ValueError) as problem:  # numbers beyond what can be enclosed
        told = f"{type(problem).__name__}: {problem}"
        raise NotCovered(f"the checker refuses it: {told}") from None


def refusal(check: Callable[[], object]) -> str:
    """Return the reason why a check by the checker fails, or an empty text if it succeeds."""
    try:
        with asking():
            check()
    except NotCovered as reason:
        return str(reason)
    return ""


def holds(check: Callable[[], object]) -> bool:
    """Return whether the checker refuses nothing, at the working precision."""
    try:
        check()
    except REFUSED:
        return False
    return True


def as_read(told: Mapping[str, Any]) -> Entries:
    """Return entries as they are read back after they were written as JSON."""
    found: Entries = json.loads(json.dumps(told))
    return found


_EVERY = 10.0  # seconds between states that are kept, at least
_LONGER = 20  # times as long as it takes to keep one

_State = TypeVar("_State")
Begin = Callable[[str], object]  # of which step begins
Progress = Callable[[float, int], object]  # of a share that is done, and a count
Steps = Generator[tuple[Any, ...], None, None]  # each with what progress is told


def proved_by_steps(
    steps: Steps,
    state: Callable[[], _State],
    progress: Callable[..., object] = lambda *told: None,
    keep: Callable[[_State], object] | None = None,
    seconds: float = math.inf,
) -> _State:
    """Take the steps of a search; return the state behind the last one.

    Each step proposes a part of the proof, asks the checker, and yields what `progress` is told.
    `keep` is given the state every ten seconds or less often, and Ctrl-C raises `Interrupted` with
    it. Behind the first step that ends after so many seconds no other is begun.
    """
    begun = time.monotonic()
    due, until = begun + _EVERY, begun + seconds
    try:
        with closing(steps):
            for told in steps:
                progress(*told)
                now = time.monotonic()
                if keep is not None and now > due:
                    keep(state())
                    ended = time.monotonic()
                    due = ended + max(_EVERY, _LONGER * (ended - now))
                if time.monotonic() > until:
                    break
        return state()
    except Interrupted:
        raise
    except KeyboardInterrupt:
        raise Interrupted(state()) from None
