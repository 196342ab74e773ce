"""Units as systems declare them, for the labels of pictures."""

from __future__ import annotations

import re
from dataclasses import dataclass

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.model.kernels import SystemKernels, load_system
from nonsmooth.runtime.model.naming import symbol

__all__ = ["NO_UNIT", "Units", "units_of", "with_unit"]

NO_UNIT = "nondimensional"
_FACTOR = r"(?:[kMGmunc\u00b5]?(?:g|m|s|N|Pa|J|W|Hz)|rad|deg|rpm|min|h|lbf?|in|ft|1|%)(?:\^?-?\d)?"
# what ends a parameter's description: ", nondimensional", ", kg", ", N*s/m" or "[m]"
_STATED = re.compile(rf"(?:, |\[)(?P<unit>{NO_UNIT}|{_FACTOR}(?:[*/]{_FACTOR})*)\]?$")


@dataclass(frozen=True)
class Units:
    """Units of a system."""

    parameters: dict[str, str]  # of those parameters whose description ends with a unit
    # "nondimensional" if all parameters are declared so; else empty, as positions, velocities and
    # times are in the user's units
    states: str

    def label(self, name: str) -> str:
        """A parameter, or another number of the system, in LaTeX with dollar signs and its unit."""
        return with_unit(f"${symbol(name)}$", self.parameters.get(name, self.states))

    def attributes(self, name: str = "") -> dict[str, str]:
        """The unit of a parameter as an attribute of an array; empty without a unit.

        Any name but that of a parameter stands for a state or time.
        """
        unit = self.parameters.get(name, self.states)
        return {"units": unit} if unit else {}

    def text(self, text: str, line: str = " ") -> str:
        """A text about states or times with their unit; `line` stands between the two."""
        return with_unit(text, self.states, line)


def with_unit(text: str, unit: str, line: str = " ") -> str:
    """A text and a unit in brackets, if there is one; `line` stands between the two.

    Examples
    --------
    >>> with_unit("time", "s")
    'time (s)'
    """
    return f"{text}{line}({unit})" if unit else text


def units_of(system: str | SystemKernels) -> Units:
    """The units that a system declares; none if it cannot be loaded."""
    try:
        kernels = load_system(system) if isinstance(system, str) else system
    except (NonsmoothError, OSError):
        return Units({}, "")
    found = {}
    for parameter in kernels.parameters:
        stated = _STATED.search(parameter.description)
        if stated:
            found[parameter.name] = stated["unit"]
    names = {parameter.name for parameter in kernels.parameters}
    plain = names and all(found.get(name) == NO_UNIT for name in names)
    return Units(found, NO_UNIT if plain else "")
