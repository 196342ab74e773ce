"""The state of long work: it is kept from time to time, and handed on at Ctrl-C."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Generic, TypeVar

from nonsmooth.runtime.core.errors import Interrupted

_EVERY = 10.0  # seconds between states that are kept, at least
_LONGER = 20  # times as long as it takes to keep one

_State = TypeVar("_State")


class KeptState(Generic[_State]):
    """A context of long work, which gives `keep` its state every ten seconds or less often.

    Ctrl-C in it raises `Interrupted` with the state.
    """

    def __init__(
        self, state: Callable[[], _State], keep: Callable[[_State], object] | None
    ) -> None:
        self._state, self._keep = state, keep
        self._due = time.monotonic() + _EVERY

    def __enter__(self) -> KeptState[_State]:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: Any) -> None:
        if kind is not None and issubclass(kind, KeyboardInterrupt):
            raise Interrupted(self._state()) from None

    def step(self) -> None:
        """Keep the state, if it is due."""
        if self._keep is not None and time.monotonic() > self._due:
            begun = time.monotonic()
            self._keep(self._state())
            ended = time.monotonic()
            self._due = ended + max(_EVERY, _LONGER * (ended - begun))
