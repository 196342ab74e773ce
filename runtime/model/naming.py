"""Names as people see them, names of a composed orbit's unknowns, and units of labels."""

from __future__ import annotations

import os
import re
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.model.kernels import SystemKernels, load_system
from nonsmooth.runtime.model.structure import FORCING_PHASE

_GREEK = re.compile(
    "alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau"
    "|upsilon|phi|chi|psi|omega"
    "|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega"
)

_HASH = re.compile("@[0-9a-f]{16}")  # of a system's data or declaration


def cycle_label(system: str, count: int) -> str:
    """Label of an orbit with `count` phases that no declaration names."""
    return f"{system}, {count} phase{'' if count == 1 else 's'}"


def dwell_names(count: int, taken: Container[str]) -> tuple[str, ...]:
    """Names of dwell times that were not declared: tau1, tau2, ... except those that are taken."""
    stem = "tau"
    while any(f"{stem}{i}" in taken for i in range(1, count + 1)):
        stem = f"dwell_{stem}"
    return tuple(f"{stem}{i}" for i in range(1, count + 1))


def start_names(
    states: Sequence[str], taken: Container[str], declared: Mapping[str, str] | None = None
) -> tuple[str, ...]:
    """Names of the states' values at the start, in the states' order.

    A name is the declared one (`declared` maps states to names), or x10 for x1 if that is free.
    """
    known = declared or {}
    return tuple(
        known.get(name, name if f"{name}0" in taken or f"{name}0" in states else f"{name}0")
        for name in states
    )


def is_hashed(system: str) -> bool:
    """Whether a name has the form in which files name a system by its content; no path has it."""
    return re.fullmatch(rf"[^/\\:]+{_HASH.pattern}", system) is not None


def shown_name(name: str) -> str:
    """The name to show, ``system`` or ``system/orbit``, of a built-in one or of one in a file.

    Examples
    --------
    >>> shown_name("/home/me/gear.py:rattle"), shown_name("dry-friction/symmetric")
    ('gear/rattle', 'dry-friction/symmetric')
    >>> shown_name("/home/me/found.json:2")
    'found.json:2'
    """
    name = _HASH.sub("", name)
    if not (os.path.isabs(name) or ":" in name or name.endswith(".py")):
        return name
    base = os.path.basename(name)
    system, _, orbit = base.partition(":")
    if system.endswith(".json"):
        return base
    return "/".join(filter(None, (system.removesuffix(".py"), orbit)))


def itinerary_text(itinerary: Sequence[tuple[str, str]]) -> str:
    """Configurations and the boundaries by which they are left; equal phases are counted.

    Examples
    --------
    >>> itinerary_text([("slip", "belt-reached"), ("stick", "belt-breaks")])
    'slip, belt-reached -> stick, belt-breaks'
    >>> itinerary_text([("free", "right"), ("free", "left"), ("free", "left")])
    'free, right -> 2 x (free, left)'
    """
    phases = []
    for (configuration, boundary), repeated in groupby(itinerary):
        count = len(list(repeated))
        text = f"{configuration}, {boundary}"
        if boundary == FORCING_PHASE:
            text = f"{configuration}, no boundary is reached"
        phases.append(text if count == 1 else f"{count} x ({text})")
    return " -> ".join(phases)


def symbol(name: str) -> str:
    r"""LaTeX of a name, without dollar signs: Greek letters by name, the rest as a subscript.

    Examples
    --------
    >>> symbol("z10"), symbol("tau1"), symbol("ta"), symbol("V")
    ('z_{10}', '\\tau_{1}', 't_{a}', 'V')
    """
    match = re.fullmatch(r"([A-Za-z]+?)(\d*)", name)
    if match is None:
        return rf"\mathrm{{{name}}}".replace("_", r"\_")
    stem, index = match.groups()
    if _GREEK.fullmatch(stem):
        base = f"\\{stem}"
    elif len(stem) <= 2:
        base, index = stem[0], stem[1:] + index
    else:
        base = rf"\mathrm{{{stem}}}"
    return f"{base}_{{{index}}}" if index else base


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
