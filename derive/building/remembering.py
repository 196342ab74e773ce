"""Results of a method kept with the object that they belong to."""

from __future__ import annotations

from collections.abc import Callable
from functools import update_wrapper
from typing import Any, Concatenate, ParamSpec, TypeVar

__all__ = ["remembered"]

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")


def remembered(
    method: Callable[Concatenate[Any, _Arguments], _Result],
) -> Callable[Concatenate[Any, _Arguments], _Result]:
    """The method with its results stored in the object, one for each tuple of arguments.

    Unlike `functools.cache` it does not keep its objects alive.
    """
    place = f"_remembered_{method.__name__}"

    def call(owner: Any, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> _Result:
        known: dict[Any, _Result] = owner.__dict__.setdefault(place, {})
        key = (args, tuple(kwargs.items()))
        if key not in known:
            known[key] = method(owner, *args, **kwargs)
        return known[key]

    update_wrapper(call, method)
    return call
