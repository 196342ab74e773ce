"""The two engines, side by side in one test."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

ENGINES = ("c", "numpy")


def with_engine(backend: str, follow: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
    """What a function gives with one of the engines, and the kernels that go with it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NONSMOOTH_BACKEND", backend)
        return follow(*arguments, **options)


def with_both(follow: Callable[..., Any], *arguments: Any, **options: Any) -> list[Any]:
    """The same of the compiled engine, then of the one in Python."""
    return [with_engine(backend, follow, *arguments, **options) for backend in ENGINES]
