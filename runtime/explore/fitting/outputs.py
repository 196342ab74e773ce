"""What is measured of a motion, and of a steady response.

An output, such as ``x1 - x2`` or ``acceleration:x1 + 9.81``, is affine in the state,
accelerations and forces of contacts: these in each configuration with numbers of its own, which
depend on the parameters. Of a steady response it is the peak of an output, its amplitude, average
or first harmonic; extremes are guaranteed, and differentiated where they are attained.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.expressions import Function
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.simulation.observables import acceleration_rows, force_rows

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives

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
    return Output(_affine_row(plain, [*structure.states, *places], text), tuple(terms))


def _named(name: str, known: Sequence[str]) -> str:
    """The known name itself, or the contact of an element: ``wall-stop`` for ``wall``.

    It is empty if no name, or more than one, fits.
    """
    found = [name] if name in known else [each for each in known if each.startswith(f"{name}-")]
    return found[0] if len(found) == 1 and name else ""


def _affine_row(text: str, names: Sequence[str], told: str) -> np.ndarray:
    """Coefficients of an affine function of N named variables, then its constant, (N + 1,).

    Texts are such as ``x1 - x2`` or ``9.81*v1 + 1/2``; messages call the text `told`. Refused
    is a text that is no expression of the variables, or not affine in them.

    Examples
    --------
    >>> _affine_row("2*(x1 - x2) + 0.5", ["x1", "x2"], "gap").tolist()
    [2.0, -2.0, 0.5]
    """
    size = len(names)
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


class ResponseQuantity(NamedTuple):
    """A number that is measured of a steady response."""

    kind: str  # a key of `KINDS`
    output: Output
    text: str  # as it was written

    @property
    def periodic(self) -> bool:
        """Whether it is an angle, which is the same after a full turn."""
        return self.kind == "phase"

    def of(self, derivatives: OrbitDerivatives) -> tuple[float, np.ndarray]:
        """Its value along an orbit (by tables), and its derivatives (q,).

        Raises `InputError` if there is no derivative.
        """
        along = derivatives.along
        row = self.output.in_configurations(
            along.structure, along.numbers.fields, along.numbers.rows
        )
        value, rates = KINDS[self.kind](along, row, self.text)
        return float(value), rates


def response_quantity(text: str, structure: Structure) -> ResponseQuantity:
    """A quantity of a steady response, from its text ``KIND:OUTPUT``.

    KIND is a key of `KINDS` and OUTPUT an affine function of states, accelerations and forces,
    such as ``amplitude:x1 - x2`` or ``rms:acceleration:x``. Refused are an unknown kind, a
    function that is not affine, and a first harmonic without a forcing.
    """
    kind, colon, output = (part.strip() for part in text.partition(":"))
    if not colon or not output:
        raise InputError(f"response {text!r} is not KIND:OUTPUT; kinds are {', '.join(KINDS)}")
    if kind not in KINDS:
        raise unknown_name("kind of response", kind, KINDS)
    if kind in _OF_FORCING and not structure.forcing:
        raise InputError(
            f"response {text!r} belongs to a forcing, which {shown_name(structure.name)} has not"
        )
    return ResponseQuantity(kind, output_of(output, structure), text)


Value = tuple[float, np.ndarray]


def _amplitude(along: OrbitMotionDerivatives, row: np.ndarray, _: str) -> Value:
    high, low = along.extremes(row)
    return (high.value - low.value) / 2, (high.rates - low.rates) / 2


def _harmonic(along: OrbitMotionDerivatives, row: np.ndarray, text: str) -> Value:
    _, _, cosine, sine = _averages(along, row)
    return _root(4 * (cosine**2 + sine**2), text)


def _phase(along: OrbitMotionDerivatives, row: np.ndarray, text: str) -> Value:
    _, _, cosine, sine = _averages(along, row)
    (c, by_c), (s, by_s) = _parts(cosine), _parts(sine)
    square = c**2 + s**2
    if not square > 0:
        raise InputError(f"{text}: there is no first harmonic")
    return float(np.arctan2(-s, c)), (s * by_c - c * by_s) / square


def _root(square: np.ndarray, text: str) -> Value:
    if not square[0].real > 0:
        raise InputError(f"{text} is zero: it has no derivative")
    return _parts(np.sqrt(square))


def _parts(number: np.ndarray) -> Value:
    return float(number[0].real), imaginary_parts(number, None)


def _averages(along: OrbitMotionDerivatives, row: np.ndarray) -> np.ndarray:
    """Averages (4, q) of f, f^2, f cos and f sin, with complex steps.

    f is an affine function by its `row` (q, configurations, N + 1). The angle is that of the
    first forcing; without one there are zeros.
    """
    row, forcing = row[:, :, None], along.structure.forcing
    units = np.eye(row.shape[-1])[list(forcing[0] if forcing else ())]
    angles = np.broadcast_to(units, (*row.shape[:2], *units.shape))
    moments = along.moved.moments(np.concatenate([row, angles], axis=2))[:, 0]
    parts = [moments[:, -1], moments[:, 0], *moments[:, 1:-1].T]
    parts += [0 * parts[0]] * (4 - len(parts))
    period = stepped(float(along.period), along.moved.rates[1, :, -1], None)
    return np.asarray(np.array(parts) / period)


_OF_FORCING = ("harmonic", "phase")
# of the output's rows (q, configurations, N + 1), with complex steps, and its text
KINDS: Mapping[str, Callable[[OrbitMotionDerivatives, np.ndarray, str], Value]] = {
    "maximum": lambda along, row, _: along.extremes(row)[0][:2],
    "minimum": lambda along, row, _: along.extremes(row)[1][:2],
    "peak": lambda along, row, text: along.peak(row, text)[:2],
    "amplitude": _amplitude,
    "mean": lambda along, row, _: _parts(_averages(along, row)[0]),
    "rms": lambda along, row, text: _root(_averages(along, row)[1], text),
    "harmonic": _harmonic,
    "phase": _phase,
}
