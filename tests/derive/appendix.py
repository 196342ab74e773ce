"""The Appendix's route to the global stick orbit, by one linear map over the period.

Z(T) = N~ Z0 with N~ = C(tau2) h(tau1) Gamma(tau) D(ta), in blocks

    N~ = (N~1 N~2; N~3 N~4),   Z0 = (z0, z0'),   z0' = (V, ..., V).

Periodicity (A.1) reads (N~1 - I) z0 + N~2 z0' = 0 and N~3 z0 + (N~4 - I) z0' = 0. Both have
the same z0 if the compatibility conditions (A.2) hold, M~ z0' = 0 with
M~ = (N~1 - I)^-1 N~2 - N~3^-1 (N~4 - I); z0 then is (A.3), and the switching conditions
(12), (14) complete the equations for the dwell times.
"""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from nonsmooth.derive import DerivationError, EquationSystem
from nonsmooth.derive.equations.program import Argument, Kernel, Output, Stage, assign, prune

__all__ = ["MISPRINTS", "appendix_kernel"]

MISPRINTS = {
    "stick-block": "Eq. (10): the block V t I, where z' already carries V",
    "lower-left-block": "Eq. (A.1): N2 printed in place of N3",
}


def appendix_kernel(orbit: EquationSystem, printed: Collection[str] = ()) -> Kernel:
    """Equations in the dwell times alone, and the start (A.3).

    Parameters
    ----------
    orbit : EquationSystem
        Starts with every coordinate held at one velocity, and its flows have no offset.
    printed : collection of str
        Keys of `MISPRINTS` to apply, in order to show what they do.

    Returns
    -------
    Kernel
        Takes parameters, spectrum and dwell times; gives as many residuals (the n
        compatibility conditions, then the switching conditions of the first phases) and
        the n positions of the start.

    Raises
    ------
    DerivationError
        If the orbit is not of that kind.
    """
    links, states = orbit.chain.links, orbit.system.states
    size = len(states) // 2
    start = orbit.chain.section.state
    velocity = start[size]
    if any(start[size + i] != velocity for i in range(size)) or velocity.free_symbols & set(
        orbit.unknowns
    ):
        raise DerivationError("the Appendix's route starts with all coordinates held alike")
    if any(not offset.is_zero_matrix for link in links for offset in link.flow.offsets):
        raise DerivationError("the Appendix's route needs flows without an offset")

    stages: list[Stage] = [s for s in orbit.chain.stages if s.title.startswith("functions of")]
    product = sp.eye(2 * size)
    partial = []
    for index, link in enumerate(links):
        transfer = link.transfer
        if index == 0 and "stick-block" in printed:
            transfer = transfer.copy().as_mutable()
            transfer[:size, size:] *= velocity
        names = [f"n{index + 1}_{i + 1}{j + 1}" for i in range(2 * size) for j in range(2 * size)]
        step, values = assign(f"map after {link.dwell}", names, transfer * product)
        product = sp.Matrix(2 * size, 2 * size, values)
        partial.append(product)
        stages.append(step)
    upper, right = product[:size, :size] - sp.eye(size), product[:size, size:]
    lower, corner = product[size:, :size], product[size:, size:] - sp.eye(size)
    if "lower-left-block" in printed:
        lower = product[:size, size:]
    begin = sp.Matrix([velocity] * size)
    first = _solved(upper, right * begin, "upper", stages)
    second = _solved(lower, corner * begin, "lower", stages)
    compatibility = [a - b for a, b in zip(first, second, strict=True)]
    step, values = assign("start (A.3)", [f"{s}_0" for s in states[:size]], [-e for e in first])
    stages.append(step)
    state = sp.Matrix([*values, *begin])
    switching = []
    for phase, matrix in zip(orbit.itinerary.phases[: len(links) - size], partial, strict=False):
        boundary = orbit.system.configuration(phase.configuration).boundary(phase.boundary)
        normal, constant = orbit.system.gradient(boundary.function)
        switching.append((normal * matrix * state)[0] + constant)
    dwell = tuple(link.dwell for link in links)
    return Kernel(
        "appendix",
        "Compatibility (A.2) and switching conditions in the dwell times, and the start (A.3).",
        (
            Argument("parameters", (len(orbit.parameters),), orbit.parameters),
            Argument("spectrum", (len(orbit.spectrum.symbols),), orbit.spectrum.symbols),
            Argument("dwell_times", (len(dwell),), dwell),
        ),
        (
            Output("residual", (len(dwell),), tuple([*compatibility, *switching])),
            Output("start", (size,), tuple(values)),
        ),
        prune(stages, [*compatibility, *switching, *values]),
    )


def _solved(matrix: sp.Matrix, right: sp.Matrix, name: str, stages: list[Stage]) -> list[sp.Expr]:
    """Entries of ``matrix^-1 right`` by Cramer's rule, on named entries."""
    size = matrix.rows
    names = [f"{name}_{i + 1}{j + 1}" for i in range(size) for j in range(size)]
    entries, values = assign(f"{name} block", names, matrix)
    named = sp.Matrix(size, size, values)
    vector, values = assign(f"{name} side", [f"{name}_side{i + 1}" for i in range(size)], right)
    stages += [entries, vector]
    return list(named.adjugate() * sp.Matrix(values) / named.det())
