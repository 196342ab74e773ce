"""What the files hold, entry by entry: what is missing, unknown or of another type is refused.

A type stands for its instances, a pattern for texts that it matches, [shape] for a list of any
length, (shape, ...) for one of this length, {name: shape} for exactly these names, `Named` for
any names, `Maybe` for an entry that may be missing, and `Either` for one of several.
"""

import math
import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from nonsmooth.runtime.checker.stated.exact import NUMBER, Failure

__all__ = [
    "BASIN",
    "BRANCH",
    "CENSUS",
    "CERTIFICATE",
    "CHAOS",
    "DOUBLING",
    "EVENTS",
    "GRAPH",
    "MAP",
    "Malformed",
    "check_bits",
    "check_shape",
    "check_sharp",
]


class Malformed(Failure):
    """An entry of a file is missing, unknown, or of another type."""


class Named(NamedTuple):
    """The shape of a dict with any names, whose entries have one shape."""

    shape: Any


class Maybe(NamedTuple):
    """The shape of an entry that may be missing."""

    shape: Any


class Either(NamedTuple):
    """One of several shapes."""

    shapes: tuple[Any, ...]


_WRONG: tuple[str, ...] = ("is of the wrong type",)
_FEWEST, _MOST = 53, 400_000  # bits
_MOST_TO_DIGIT = 8  # bits: a box is as wide as half of them at most, which are 6.6 to a digit
_VERDICT = re.compile("proved|refuted|undecided")
_BALL = {"mid": NUMBER, "rad": NUMBER}
_BALLS = Named(_BALL)
_BOX = [{"name": str, "mid": NUMBER, "rad": NUMBER}]
_TERMS = [(NUMBER, [int])]
_NUMBER = Either((NUMBER, _BALL, {"above": _TERMS, "below": _TERMS}))
_ROW = [_NUMBER]
_TRANSITION = {
    "source": str,
    "boundaries": [str],
    "conditions": [(_ROW, str, bool)],
    "reset": [_ROW],
    "target": str,
}
_ORDER = {"order": int}
_STEPS = {"steps": [{"kinetic": [str], "regimes": [str]}]}
_LAW = {
    "contacts": [
        {
            "name": str,
            "friction": bool,
            "static": _ROW,
            "kinetic": _ROW,
            "slipping": _ROW,
            "overshooting": _ROW,
        }
    ],
    "coupling": [_ROW],
    "arrivals": Named(int),
    "limits": Named(int),
    "configurations": Named({"regimes": [str], "others": str, "idle": [int]}),
    "free": Named([_ROW]),
}
_DECLARATION = {
    "parameters": [str],
    "states": [str],
    "start": [str],
    "forcing": [(int, int)],
    "configurations": Named({"field": [_ROW], "boundaries": Named(_ROW), "held": [_ROW]}),
    "transitions": [
        Either((_TRANSITION, {**_TRANSITION, **_ORDER}, {**_TRANSITION, **_STEPS})),
    ],
    "phases": [
        {"configuration": str, "boundaries": [str], "transition": int, "dwell_time": str},
    ],
}
_CONSTANTS: Any = ({}, {"constants": [str]})
_CLOSINGS = (
    {"kind": re.compile("state")},
    {"kind": re.compile("forcing"), "turns": int},
    {
        "kind": re.compile("period"),
        "period": str,
        "dropped": int,
        "form": [_ROW],
        "constants": Named(_NUMBER),
    },
)
_UP_TO_SHIFT = {"translations": [[NUMBER]]}
_CLOSING = Either((*_CLOSINGS, *({**closing, **_UP_TO_SHIFT} for closing in _CLOSINGS)))
_ALONG_ONE = {"vanishing": [[NUMBER]]}
_CLAIMS = {"existence": _VERDICT, "admissibility": _VERDICT, "stability": _VERDICT}
_FILE = {
    "format": str,
    "version": int,
    "package": str,
    "request": Maybe(dict),  # what a command was asked, for --resume
    "sha256": str,
}
_ORBIT = {
    "orbit": str,
    "system": str,
    "tables": Either((type(None), dict)),  # what the declaration is compared with
    "parameters": Named(str),
    "itinerary": [(str, str)],
}
_STATEMENT = {
    **_ORBIT,
    "chosen": [str],
    "declaration": Either(
        (
            {},
            *({**_DECLARATION, **law, **own} for law in ({}, {"law": _LAW}) for own in _CONSTANTS),
        )
    ),
    "closing": Either(({}, _CLOSING)),
}
_JUDGED = {
    "claims": _CLAIMS,
    "stability": re.compile("stable|neutral"),
    "reasons": Named(str),
    "enclosures": _BALLS,
}

_POINT = {
    **_STATEMENT,
    **_JUDGED,
    "closing": Either(
        ({}, _CLOSING, *({**closing, **_ALONG_ONE} for closing in _CLOSING.shapes)),
    ),
    "given_period": str,
    "bits": int,
    "multipliers": [{"re": _BALL, "im": _BALL}],
    "other_multipliers": Either((re.compile(""), NUMBER)),
    "margins": [
        {
            "phase": int,
            "configuration": str,
            "boundary": str,
            "quantity": re.compile("distance|departure|speed"),
            "least": NUMBER,
        }
    ],
    "box": _BOX,
    # where derivatives are asked for
    "derivatives": Maybe(Named(_BALLS)),
    "directions": Maybe(Named(Named(NUMBER))),
    "no_derivatives": Maybe(Named(str)),
}
CERTIFICATE = {**_FILE, **_POINT}
_BESIDE = re.compile("proved|unstable|not admissible")
_SIDE = re.compile("proved|unstable|not admissible|beyond a fold")
MAP = {
    **_FILE,
    **_STATEMENT,
    **_JUDGED,
    "box": Named((NUMBER, NUMBER)),
    "shares": {
        "proved": float,
        "unstable": float,
        "not admissible": float,
        "divided": float,
        "beyond a fold": float,
        "undecided": float,
    },
    "tiles": [
        {
            "place": [(int, int)],
            "claims": _CLAIMS,
            "reasons": Named(str),
            "enclosures": _BALLS,
            "guess": [float],
            "looked_at": bool,
            "event": Either(
                (
                    type(None),
                    {
                        "kind": str,
                        "phase": Either((int, type(None))),
                        "configuration": str,
                        "boundary": str,
                        "instant": str,
                        "window": [NUMBER],
                        "also": [(str, int, str, str)],
                        "axis": int,
                        "centre": [float],
                        "radius": float,
                        "below": _SIDE,
                        "above": _SIDE,
                        "fold": Either(
                            (
                                type(None),
                                {
                                    "coordinate": str,
                                    "centre": [float],
                                    "half": float,
                                    "sheet": re.compile("below|above"),
                                    "other": _BESIDE,
                                },
                            )
                        ),
                    },
                )
            ),
        }
    ],
}
EVENTS = {
    **_FILE,
    "events": [
        {
            **_STATEMENT,
            "kind": str,
            "text": str,
            "parameter": str,
            "phase": Either((int, type(None))),
            "configuration": str,
            "boundary": str,
            "instant": str,
            "claim": re.compile("proved|undecided"),
            "reason": str,
            "bits": int,
            "enclosures": _BALLS,
            "box": _BOX,
        }
    ],
}
_VERDICTS = re.compile("stable|neutral|unstable|not admissible|undecided")
_EVENT = {
    "kind": str,
    "phase": Either((int, type(None))),
    "configuration": str,
    "boundary": str,
    "instant": str,
    "lower": NUMBER,
    "upper": NUMBER,
    "window": [NUMBER],
    "also": [(str, int, str, str)],
    "enclosures": _BALLS,
}


def _branch(event: Any) -> dict[str, Any]:
    """Return the shape of a branch with such events."""
    return {
        **_STATEMENT,
        "stability": re.compile("stable|neutral"),
        "parameter": str,
        "interval": (NUMBER, NUMBER),
        "unknown_names": [str],
        "claims": {"branch": re.compile("proved|undecided")},
        "start": int,
        "ends": (str, str),
        "tiles": [
            {
                "coordinate": str,
                "lower": NUMBER,
                "upper": NUMBER,
                "forwards": bool,
                "before": _VERDICTS,
                "after": _VERDICTS,
                "reason": str,
                "centre": [[float]],
                "radii": [float],
                "divided": Either((int, type(None))),
                "event": Either((type(None), event)),
            }
        ],
    }


_BEYOND = {
    "side": re.compile("above|below"),
    "own": re.compile("above|below"),
    "verdict": re.compile("stable|neutral|unstable"),
    "branch": _branch(_EVENT),
}
BRANCH = {**_FILE, **_branch({**_EVENT, "beyond": Maybe([_BEYOND])})}
_DOUBLED = {
    "tile": int,
    "scaled": str,
    "amplitude": NUMBER,
    "side": re.compile("above|below"),
    "verdict": re.compile("stable|unstable|undecided"),
    "reason": str,
    "rate": _BALL,
    "centre": [[float]],
    "radii": [float],
    "branch": _branch(_EVENT),
}
DOUBLING = {
    **_FILE,
    "orbit": str,
    "claims": {"doubling": re.compile("proved|undecided")},
    "ended": re.compile("complete|unfinished|no flip|not covered|not proved"),
    "end": str,
    "branch": _branch(_EVENT),
    "doubled": Either((type(None), _DOUBLED)),
}
CHAOS = {
    **_FILE,
    "system": str,
    "tables": Either((type(None), dict)),
    "parameters": Named(str),
    "claim": re.compile("proved|undecided"),
    "reason": str,
    "configuration": str,
    "phase": [NUMBER],
    "source": str,
    "boundary": str,
    "coordinates": [str],
    "iterates": int,
    "h_sets": [{"name": str, "centre": [NUMBER], "sides": [[NUMBER]]}],
    "coverings": [(str, str)],
    "itineraries": Named([(str, str, str)]),
    "growth": re.compile(r"\d{1,4000}(/[1-9]\d{0,3999})?", re.ASCII),
    "entropy": NUMBER,
    "cones": Either(
        (
            type(None),
            {
                "forms": Named([NUMBER]),
                "strips": [(str, str, [(NUMBER, NUMBER)])],
                "expansion": NUMBER,
                "contraction": NUMBER,
                "exponent": NUMBER,
            },
        )
    ),
    "parts": int,
    "tried": [str],
    "bits": int,
    "declaration": Either(({}, _DECLARATION, {**_DECLARATION, **_CONSTANTS[1]})),
}
_GRID = Either((type(None), {"exponents": [int], "first": [int], "counts": [int]}))
BASIN = {
    **_FILE,
    **{name: CHAOS[name] for name in (
        "system", "tables", "parameters", "claim", "reason", "configuration", "phase", "source",
        "boundary", "coordinates", "iterates", "bits", "declaration",
    )},
    "orbit": str,
    "core": Either((type(None), {"name": str, "centre": [NUMBER], "sides": [[NUMBER]]})),
    "itinerary": [(str, str, str)],
    "contraction": NUMBER,
    "grid": _GRID,
    "ranks": [(int, int)],
    "tiles": _GRID,
    "states": [str],
    "box": Named((float, float)),
    "verdicts": [(int, int)],
    "widest": float,
    "most": int,
}  # fmt: skip
_RUNS = [(int, int)]
GRAPH = {
    **_FILE,
    **{name: CHAOS[name] for name in (
        "system", "tables", "parameters", "claim", "configuration", "phase", "source", "boundary",
        "coordinates", "bits",
    )},
    "grid": _GRID,
    "divided": [_RUNS],
    "edges": [(int, int, int)],
    "outside": _RUNS,
    "unknown": _RUNS,
    "trapping": _RUNS,
    "components": _RUNS,
    "ranks": _RUNS,
    "widest": [float],
    "most": int,
    "longest": int,
    "declaration": Either((_DECLARATION, {**_DECLARATION, **_CONSTANTS[1]})),
}  # fmt: skip
_BOUNDS = Named((NUMBER, NUMBER))
CENSUS = {
    **_FILE,
    **_ORBIT,
    "chosen": [str],
    "given_period": str,
    "largest": NUMBER,
    "declaration": _STATEMENT["declaration"],
    "box": [str],
    "conditions": [str],
    "count": int,
    "admissible": int,
    "decided": bool,
    "statement": str,
    "orbits": [
        {"unique": _BOUNDS, "certificate": Either((type(None), _POINT)), "reason": str},
    ],
    "undecided": [{"bounds": _BOUNDS, "reason": str}],
    "bits": int,
    "looked": int,
    "trees": [re.compile(r"[-*=?a-z]*")],
}


def check_shape(entry: Any, shape: Any) -> None:
    """Raise `Malformed` if the entries of a file, read from JSON, have another shape.

    A shape is a type, a pattern, `Either`, `Maybe`, `Named`, a dict, a list of one shape,
    or a tuple. The message says where what is wrong.
    """
    if found := _misfit(entry, shape):
        wrong, *places = found
        raise Malformed(f"{' of '.join([*places, 'the file'])} {wrong}")


def check_bits(content: dict[str, Any]) -> int:
    """Return the bits of precision that the file states; `Malformed` if too few or too many."""
    bits: int = content["bits"]
    if not _FEWEST <= bits <= _MOST:
        raise Malformed(f"{bits} bits are not from {_FEWEST} to {_MOST}")
    return bits


def check_sharp(box: list[dict[str, str]], bits: int) -> None:
    """Refuse more bits than the digits of a box of unknowns can use: they would only take time.

    `box` has a "mid" for each unknown. `Failure` is raised if the bits are too many.
    """
    digits = max((len(side["mid"]) for side in box), default=0)
    if bits > _MOST_TO_DIGIT * digits + _FEWEST:
        raise Failure(f"{bits} bits are more than the {digits} digits of its unknowns are for")


def _apart(entry: Any, shape: Any) -> float:
    """By how many names an entry differs from a shape; infinity where one of them has none."""
    both = isinstance(entry, dict) and isinstance(shape, dict)
    return len(entry.keys() ^ shape.keys()) if both else math.inf


def _misfit(entry: Any, shape: Any) -> tuple[str, ...]:
    """Return what is wrong with an entry, then where, from the inside out; () if nothing is."""
    parts: Iterable[tuple[Any, Any, Any]] = ()
    kind, fits = type(shape), False
    if kind is re.Pattern:
        fits = isinstance(entry, str) and shape.fullmatch(entry)
    elif kind is list:
        fits = isinstance(entry, list)
        parts = ((number, part, shape[0]) for number, part in enumerate(entry, 1)) if fits else ()
    elif kind is type:
        fits = type(entry) is shape
    elif kind is Maybe:
        return _misfit(entry, shape.shape)
    elif kind is Either:
        if any(not _misfit(entry, each) for each in shape.shapes):
            return ()
        return _misfit(entry, min(shape.shapes, key=lambda each: _apart(entry, each)))
    elif kind is Named:
        fits = isinstance(entry, dict)
        parts = ((name, part, shape.shape) for name, part in entry.items()) if fits else ()
    elif kind is dict:
        fits = isinstance(entry, dict)
        for name in sorted(entry.keys() ^ shape.keys()) if fits else ():
            if not isinstance(shape.get(name), Maybe):
                return "is missing" if name in shape else "is unknown", repr(name)
        parts = ((name, part, shape[name]) for name, part in entry.items()) if fits else ()
    else:  # a tuple
        fits = isinstance(entry, list) and len(entry) == len(shape)
        parts = zip(range(1, len(shape) + 1), entry, shape, strict=True) if fits else ()
    for place, part, inner in parts:
        if found := _misfit(part, inner):
            return *found, repr(place) if isinstance(place, str) else f"entry {place}"
    return () if fits else _WRONG
