"""The two engines, side by side in one test."""

import pytest

ENGINES = ("c", "numpy")


def with_engine(backend, follow, *arguments, **options):
    """What a function gives with one of the engines, and the kernels that go with it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NONSMOOTH_BACKEND", backend)
        return follow(*arguments, **options)


def with_both(follow, *arguments, **options):
    """The same of the compiled engine, then of the one in Python."""
    return [with_engine(backend, follow, *arguments, **options) for backend in ENGINES]
