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
    """Units of a system.

    Attributes
    ----------
    parameters : dict of str to str
        Of those parameters whose description ends with a unit.
    states : str
        "nondimensional" where all parameters are said to be so; else empty: positions,
        velocities and times are in the user's own units.
    """

    parameters: dict[str, str]
    states: str

    def label(self, name: str) -> str:
        """A parameter, or another number of the system, as a formula with its unit.

        Returns
        -------
        str
            In LaTeX, with dollar signs.
        """
        return with_unit(f"${symbol(name)}$", self.parameters.get(name, self.states))

    def attributes(self, name: str = "") -> dict[str, str]:
        """The unit of a parameter, or of a state or time, as an attribute of an array.

        Parameters
        ----------
        name : str
            Of a parameter; any other name stands for a state or time.

        Returns
        -------
        dict of str to str
            Empty without a unit.
        """
        unit = self.parameters.get(name, self.states)
        return {"units": unit} if unit else {}

    def text(self, text: str, line: str = " ") -> str:
        """A text about states or times with their unit.

        Parameters
        ----------
        text : str
        line : str
            What stands between the text and the unit.
        """
        return with_unit(text, self.states, line)


def with_unit(text: str, unit: str, line: str = " ") -> str:
    """A text and a unit in brackets, if there is one.

    Parameters
    ----------
    text, unit : str
    line : str
        What stands between them.

    Examples
    --------
    >>> with_unit("time", "s")
    'time (s)'
    """
    return f"{text}{line}({unit})" if unit else text


def units_of(system: str | SystemKernels) -> Units:
    """What a system says of its units; nothing where it cannot be loaded."""
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
