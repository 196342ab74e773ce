"""Whether a saved map is of the system and the orbit that it names."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import complete, system_parameters
from nonsmooth.runtime.present.checking.certificates import Named, given_values, named_in
from nonsmooth.runtime.proof.parametric_declaration import orbit_declaration

__all__ = ["compare_box"]


def compare_box(content: Mapping[str, Any], folder: Path) -> bool:
    """Compare names, values and declaration with the system and the orbit that are named.

    Returns
    -------
    bool
        Whether that could be done: the system is there.

    Raises
    ------
    Failure, InputError
        If they differ.
    """
    if not content["declaration"]:
        return False
    named = named_in(content, folder)
    if named is None:
        return False
    named.check_chosen(content["chosen"])
    box = {name: tuple(map(Fraction, ends)) for name, ends in content["box"].items()}
    given = given_values(content["parameters"])
    for corner in product(*box.values()):
        _check_values(named, given | dict(zip(box, map(as_value, corner), strict=True)))
    names, closing = content["declaration"]["parameters"], content["closing"]
    declared = orbit_declaration(
        named.kernels, named.derived, named.cycle, names, named.start, named.dwell
    )
    if declared != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} over the box")
    if closing["kind"] == "period" and closing["period"] != named.period:
        raise Failure("the period is not the one that is given")
    return True


def _check_values(named: Named, values: dict[str, Value]) -> None:
    """Refuse names that were not to be given, and values that are in no domain."""
    if named.derived is None:
        own = {name: value for name, value in values.items() if name != named.period}
        system_parameters(named.kernels, own)
        return
    try:
        complete(named.derived, values)
    except NoConvergence as problem:
        raise Failure(str(problem)) from None
