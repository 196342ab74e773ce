"""The exact system of a certificate, as the file states it and the checker reads it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.certification.closing import Closing
from nonsmooth.runtime.certification.quotients import Quotient
from nonsmooth.runtime.certification.tables import Tables, rational_of
from nonsmooth.runtime.composition.passage import Cycle
from nonsmooth.runtime.values import Value

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["closing_json", "decimals", "declaration_json", "entry", "rational", "value_json"]

_RADIUS = 3  # digits that a radius needs


def rational(text: str) -> fmpq:
    """A decimal or a fraction, exactly."""
    return rational_of(Fraction(text))


def decimals(ball: arb, bits: int, digits: int = _RADIUS) -> tuple[str, str]:
    """Middle and radius of a decimal ball around a ball: as many digits as count.

    So many bits are enough of an exact number.
    """
    if ball.is_zero():
        return "0e0", "0e0"
    middle, radius, exponent = map(int, ball.mid_rad_10exp(int(bits * 0.302) + 5))
    drop = max(0, len(str(radius)) - digits)
    unit = 10**drop
    middle = (2 * middle + unit) // (2 * unit)
    return _scientific(middle, exponent + drop), _scientific(radius // unit + 2, exponent + drop)


def _scientific(integer: int, exponent: int) -> str:
    digits = str(abs(integer))
    sign, tail = "-" * (integer < 0), digits[1:]
    return f"{sign}{digits[0]}{'.' * bool(tail)}{tail}e{exponent + len(tail)}"


def declaration_json(tables: Tables, cycle: Cycle) -> dict[str, Any]:
    """Configurations and transitions that the proof is about, with all their numbers."""
    structure = cycle.structure
    needed = set(cycle.configurations)
    transitions: list[dict[str, Any]] = []
    phases = []
    for configuration, taken in zip(cycle.configurations, cycle.transitions, strict=True):
        shapes = structure.boundaries[configuration]
        names = structure.configurations
        own = -1
        for other in structure.transitions[configuration]:
            if other.boundaries != taken.boundaries:
                continue
            entry = {
                "source": names[configuration],
                "boundaries": sorted(shapes[b].name for b in other.boundaries),
                "conditions": [
                    [_row(tables.rows[row]), names[along], holds]
                    for row, along, holds in other.conditions
                ],
                "reset": [_row(row) for row in tables.resets[other.reset][:-1]],
                "target": names[other.target],
            }
            needed |= {along for _, along, _ in other.conditions}
            if entry not in transitions:
                transitions.append(entry)
            if other is taken:
                own = transitions.index(entry)
        phases.append((configuration, own))
    return {
        "states": list(structure.states),
        "forcing": [list(pair) for pair in structure.forcing],
        "configurations": {
            structure.configurations[c]: {
                "field": [_row(row) for row in tables.fields[c][:-1]],
                "boundaries": {b.name: _row(tables.rows[b.row]) for b in structure.boundaries[c]},
                "held": [_row(tables.rows[row]) for row in structure.constraints[c]],
            }
            for c in sorted(needed)
        },
        "transitions": transitions,
        "phases": [
            {
                "configuration": structure.configurations[c],
                "boundaries": cycle.itinerary[place][1].split("+"),
                "transition": own,
            }
            for place, (c, own) in enumerate(phases)
        ],
    }


def closing_json(closing: Closing, cycle: Cycle, bits: int) -> dict[str, Any]:
    """How the cycle closes; the energy's form where there is one."""
    told: dict[str, Any] = {"kind": closing.kind, "dropped": closing.dropped}
    if closing.kind == "forcing":
        told["turns"] = closing.turns
    if closing.translations:
        told["translations"] = [_row(row) for row in closing.translations]
    if closing.form is not None:
        period = closing.period
        told["period"] = value_json(period, bits) if isinstance(period, Value) else entry(period)
        told["form"] = [_row(row) for row in closing.form.omega]
        names = cycle.structure.configurations
        told["constants"] = {names[c]: entry(x) for c, x in closing.form.constants.items()}
    return told


def value_json(value: Value, bits: int) -> Any:
    """A value exactly, or a ball around it."""
    return entry(value.ball(bits + 32)) if value.exact is None else str(value.exact)


def _terms(polynomial: Any) -> list[list[Any]]:
    """Coefficients and exponents."""
    terms = polynomial.to_dict().items()
    return [[str(c), [int(e) for e in exponents]] for exponents, c in terms]


def _row(row: Sequence[Any]) -> list[Any]:
    return [entry(number) for number in row]


def entry(number: Any) -> Any:
    """A fraction as text, a rational function by its polynomials, a ball by middle and radius."""
    if isinstance(number, Quotient):
        return {"above": _terms(number.above), "below": _terms(number.below)}
    if not hasattr(number, "rad"):
        return str(number)
    if number.is_exact():
        mantissa, exponent = number.man_exp()
        return str(Fraction(int(mantissa)) * Fraction(2) ** int(exponent))
    middle, radius = decimals(number, max(64, number.rel_accuracy_bits() + 32))
    return {"mid": middle, "rad": radius}
