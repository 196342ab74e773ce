"""What is measured, read from expressions such as ``x1 - x2`` or ``acceleration:x1 + 9.81``.

An output is affine in the state, accelerations and forces of contacts too: these in each
configuration with numbers of its own, which depend on the parameters.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.expressions import Function
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.simulation.observables import acceleration_rows, force_rows

__all__ = ["Output", "output_of"]

# the grammar of expressions has integers: a decimal is a quotient of two
_DECIMAL = re.compile(r"(?<![\w.])(\d+\.\d*|\.\d+|\d+(?=[eE]))([eE][+-]?\d+)?(?![\w.])")
_TOLERANCE = 1e-9
_LONGEST = 40  # characters of a number
_PLACEHOLDER = "output_term_"
_ACCELERATION, _FORCE = "acceleration", "force"
_DERIVED = re.compile(rf"\b({_ACCELERATION}|{_FORCE})\s*:\s*([\w-]*)")


class _Term(NamedTuple):
    """An acceleration or a force in an output."""

    kind: str
    name: str


class Output(NamedTuple):
    """An affine function of the state in each configuration."""

    # (N + k + 1,), coefficients of the states, of k accelerations and forces, and the constant
    row: np.ndarray
    terms: tuple[_Term, ...]  # ``acceleration`` and a state, or ``force`` and a contact

    def in_configurations(
        self, structure: Structure, fields: np.ndarray, rows: np.ndarray
    ) -> np.ndarray:
        """The affine function in each configuration, (..., configurations, N + 1).

        `fields` (..., configurations, N, N + 1) and `rows` (..., R, N + 1) are the tables of the
        system, also with steps.
        """
        size = len(self.row) - len(self.terms) - 1
        found = np.zeros((*fields.shape[:-2], size + 1), dtype=fields.dtype)
        found[...] = np.append(self.row[:size], self.row[-1])
        for factor, term in zip(self.row[size:-1].tolist(), self.terms, strict=True):
            if term.kind == _FORCE:
                place = [contact.name for contact in structure.contacts].index(term.name)
                found += factor * force_rows(structure, rows, place)
            else:
                place = structure.states.index(term.name)
                found += factor * acceleration_rows(structure, fields, place)
        return found


def output_of(text: str, structure: Structure) -> Output:
    """An affine function of states, accelerations and forces of contacts, from its text.

    Texts are such as ``x1 - x2``, ``acceleration:x1 + 9.81`` or ``force:wall``. Refused is a text
    that is no such expression, or not affine.
    """
    contacts = [contact.name for contact in structure.contacts]
    known = {_ACCELERATION: list(structure.states), _FORCE: contacts}
    terms: list[_Term] = []

    def named(found: re.Match[str]) -> str:
        kind, name = found[1], found[2]
        rest = ""
        while not (own := _named(name, known[kind])) and "-" in name:  # of force:wall-x force:wall
            name, _, cut = name.rpartition("-")
            rest = f"-{cut}{rest}"
        if not own:
            what = "contact" if kind == _FORCE else "state"
            raise unknown_name(what, found[2], known[kind])
        term = _Term(kind, own)
        if term not in terms:
            terms.append(term)
        return f"{_PLACEHOLDER}{terms.index(term)}{rest}"

    plain = _DERIVED.sub(named, text)
    places = [f"{_PLACEHOLDER}{place}" for place in range(len(terms))]
    return Output(_affine_row(plain, [*structure.states, *places], told=text), tuple(terms))


def _named(name: str, known: Sequence[str]) -> str:
    """The known name itself, or the contact of an element: ``wall-stop`` for ``wall``.

    It is empty if no name, or more than one, fits.
    """
    found = [name] if name in known else [each for each in known if each.startswith(f"{name}-")]
    return found[0] if len(found) == 1 and name else ""


def _affine_row(text: str, names: Sequence[str], told: str | None = None) -> np.ndarray:
    """Coefficients of an affine function of N named variables, then its constant, (N + 1,).

    Texts are such as ``x1 - x2`` or ``9.81*v1 + 1/2``; messages call the text `told`. Refused
    is a text that is no expression of the variables, or not affine in them.

    Examples
    --------
    >>> _affine_row("2*(x1 - x2) + 0.5", ["x1", "x2"]).tolist()
    [2.0, -2.0, 0.5]
    """
    size, told = len(names), text if told is None else told
    function = Function(
        takes=(" ".join(names),),
        inputs=((size,),),
        outputs=((),),
        names=("output",),
        since=(0,),
        terms=(),
        gives=(_DECIMAL.sub(_fraction, text),),
    )

    def value(state: np.ndarray) -> float:
        with np.errstate(all="ignore"):
            return float(function(list(state), lib=FLOATS))

    try:
        constant = value(np.zeros(size))
        row = np.array([*(value(unit) - constant for unit in np.eye(size)), constant])
        probes = np.random.default_rng(1).uniform(-3, 3, (3, size))
        found = np.array([value(probe) for probe in probes])
    except (InputError, ZeroDivisionError, ValueError, OverflowError) as problem:
        known = ", ".join(name for name in names if not name.startswith(_PLACEHOLDER))
        raise InputError(f"output {told!r} is no expression of {known}: {problem}") from None
    expected = probes @ row[:-1] + constant
    if not np.allclose(found, expected, rtol=_TOLERANCE, atol=_TOLERANCE):
        raise InputError(f"output {told!r} is not affine in the states")
    if not row[:-1].any():
        raise InputError(f"output {told!r} depends on no state")
    return row


def _fraction(found: re.Match[str]) -> str:
    if len(found[0]) > _LONGEST:
        raise InputError(f"output {found[0][:40]!r}... is too long a number")
    exact = Fraction(found[0])
    return f"({exact.numerator}/{exact.denominator})"
