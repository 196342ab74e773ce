"""The loop of all long proofs: steps are taken, told and kept until Ctrl-C or time ends them.

What a step proposes to the checker, and what is tried next where that says undecided, each kind of
proof says in a generator of its steps.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Generator
from contextlib import closing
from typing import Any, TypeVar

from nonsmooth.runtime.core.errors import Interrupted

_EVERY = 10.0  # seconds between states that are kept, at least
_LONGER = 20  # times as long as it takes to keep one

_State = TypeVar("_State")
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
