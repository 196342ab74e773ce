"""Chains of many matrices: against exact fractions, and as sharp as the true products are."""

from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, arb_mat

from nonsmooth.runtime.checker.orbits.matrix_chains import along_chain, framed_phases
from nonsmooth.runtime.core.taylor_models import space_of
from nonsmooth.runtime.core.values import flint_precision

Exact = list[list[Fraction]]

LONG = 24


def product(left: Exact, right: Exact) -> Exact:
    columns = list(zip(*right, strict=True))
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in columns]
        for row in left
    ]


def ball(x: Fraction) -> arb:
    return arb(x.numerator) / x.denominator


def balls(rows: Exact, radius: float = 0.0) -> arb_mat:
    return arb_mat([[ball(x) + arb(0, radius) for x in row] for row in rows])


def chain(seed: int) -> list[Exact]:
    """Turned and a bit shrunk: nothing grows but what plain balls make of it."""
    numbers = np.random.default_rng(seed)
    found = []
    for _ in range(LONG):
        a = Fraction(int(numbers.integers(10, 40)), 40)
        size = Fraction(9, 10) / (1 + a * a)
        cosine, sine = (1 - a * a) * size, 2 * a * size
        found.append([[cosine, sine], [-sine, cosine]])
    return found


def size_of(found: arb_mat) -> float:
    return max(float(x.rad()) for x in found.entries())


def test_a_long_product_holds_the_exact_one_and_is_sharper_than_a_plain_one() -> None:
    gains = []
    for seed in range(3):
        exact = chain(seed)
        whole = exact[0]
        for each in exact[1:]:
            whole = product(each, whole)
        steps: list[Any] = [balls(each, 1e-9) for each in exact]
        unit = arb_mat([[1, 0], [0, 1]])
        found = along_chain([step.__mul__ for step in steps], unit)
        assert all(found[i, j].contains(ball(whole[i][j])) for i in range(2) for j in range(2))
        plain = unit
        for step in steps:
            plain = step * plain
        gains.append(size_of(plain) / size_of(found))
    assert min(gains) > 10, gains


def test_a_chain_of_models_holds_the_product_at_each_of_their_points() -> None:
    exact = chain(7)
    with flint_precision(128):
        e = space_of(1, 3).variable(0, arb(0), arb(1) / 4096)
        unit = arb_mat([[1, 0], [0, 1]])
        steps = [unit * e + balls(each) for each in exact]
        found = along_chain([step.__mul__ for step in steps], unit)
        for place in (Fraction(-1), Fraction(0), Fraction(2, 3)):
            moved = [
                [
                    [x + place / 4096 * (i == j) for j, x in enumerate(row)]
                    for i, row in enumerate(m)
                ]
                for m in exact
            ]
            whole = moved[0]
            for each in moved[1:]:
                whole = product(each, whole)
            at = found.at([ball(place)])
            assert all(at[i, j].overlaps(ball(whole[i][j])) for i in range(2) for j in range(2))
            assert size_of(at) < 1e-3


def test_states_seen_from_frames_are_the_states() -> None:
    """Of affine maps, the last of them back in the first frame's coordinates."""
    numbers = np.random.default_rng(11)

    def some(rows: int) -> arb_mat:
        entries = numbers.uniform(-1, 1, (rows, 3)).round(3)
        if rows == 3:
            entries[-1] = [0, 0, 1]
        return arb_mat(entries.tolist())

    fields, resets, flows = ([some(3) for _ in range(LONG)] for _ in range(3))
    rows = [some(1) for _ in range(LONG)]
    with flint_precision(192):
        seen = framed_phases(fields, rows, resets, flows)
        y = z = arb_mat([["0.3"], ["-0.7"], [1]])
        for place in range(LONG):
            assert all(
                x.overlaps(w)
                for x, w in zip((seen.starts[place] * z).entries(), y.entries(), strict=True)
            )
            y, z = flows[place] * y, seen.flows[place] * z
            told = seen.ends[place] * z
            assert all(x.overlaps(w) for x, w in zip(told.entries(), y.entries(), strict=True))
            assert (seen.rows[place] * z)[0, 0].overlaps((rows[place] * y)[0, 0])
            rate = seen.ends[place] * (seen.fields[place] * z)
            told = fields[place] * y
            assert all(x.overlaps(w) for x, w in zip(told.entries(), rate.entries(), strict=True))
            y, z = resets[place] * y, seen.resets[place] * z
        assert all(
            x.overlaps(w) and x.rad() < 1e-30 for x, w in zip(z.entries(), y.entries(), strict=True)
        )
