"""What the paper says without a number, and what we add to it, decided by computation."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.explore.intervals import Interval, admissible_intervals, singular_values
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.paper.records import Finding, Table

__all__ = [
    "admissible_periods",
    "rigid_limit",
    "saltation_matters",
    "singular_periods",
    "symmetric_portraits",
    "trace_criterion",
]

LONGEST_PERIOD = 8 * np.pi
_STIFFEST = 10  # decades of k3


def singular_periods(rigid: Orbit) -> Table:
    """Table of the periods at which the half-period conditions leave the rigid orbit undetermined.

    Each row is one period, nondimensional; `rigid` is the orbit of the rigid stop at the
    paper's data.
    """
    found = singular_values(rigid.name, "T", 0, LONGEST_PERIOD)
    return Table(
        "Singular periods up to $8\\pi$, at the paper's data",
        ("$T$", "$T / 2\\pi$"),
        tuple((f"{value:.12f}", f"{value / (2 * np.pi):.8f}") for value in found),
    )


def admissible_periods(rigid: Orbit) -> Table:
    """Table of the intervals of the period in which the rigid orbit is a motion of the system.

    Each row is one interval, nondimensional; `rigid` is the orbit of the rigid stop at the
    paper's data.
    """
    found = admissible_intervals(rigid.name, "T", 0, LONGEST_PERIOD)
    return Table(
        "Periods up to $8\\pi$ with an admissible one-impact orbit, at the paper's data",
        ("From", "To", "Below, what fails", "Above, what fails"),
        tuple(
            (f"{i.lower:.10f}", f"{i.upper:.10f}", *(_reason(i, side) for side in (0, 1)))
            for i in found
        ),
    )


def _reason(interval: Interval, side: int) -> str:
    text = (interval.below, interval.above)[side]
    return text.replace("first-reaches-stop", "*first-reaches-stop*")


def rigid_limit(rigid: Orbit) -> Finding:
    """Finding on the elastic orbits for ever stiffer stops, and on their rate of convergence.

    It has the errors, nondimensional, by stiffness; `rigid` is the orbit of the rigid stop
    at the paper's data.
    """
    target = {name: float(rigid.unknowns[name]) for name in ("y", "u")}
    rows, errors = [], []
    for decade in range(_STIFFEST + 1):
        stiffness = 10.0**decade
        soft = solve("elastic-stop/one-contact", {"k3": stiffness}).unknowns
        scale = np.sqrt(stiffness)
        u, y = soft["u"] + target["u"], soft["y"] - target["y"]
        errors.append((scale * u, scale * y, scale * soft["tau"]))
        rows.append(
            (
                f"$10^{{{decade}}}$",
                f"{soft['u']:.9f}",
                *(f"{e:.6f}" for e in errors[-1]),
                f"{scale * soft['w']:.6f}",
            )
        )
    rates = [
        float(np.log10(abs(errors[-3][i] / errors[-1][i])) / 2 - 0.5) for i in range(2)
    ]  # exponent of k3 over the last two decades
    holds = all(abs(rate + 0.5) < 0.01 for rate in rates)
    return Finding(
        "Sec. 2.4: the limit of a rigid stop",
        "These periodic orbits tend to the periodic orbits related to rigid impact when the"
        " stop's stiffness tends to infinity.",
        "holds" if holds else "undecided",
        "",
        f"At fixed period the elastic orbit has $u \\to -u_\\mathrm{{rigid}}$, since it starts in"
        " front of the contact and the rigid one behind it. Over the last two decades $u$ tends"
        f" to it as $k_3^{{{rates[0]:.4f}}}$ and $y$ as $k_3^{{{rates[1]:.4f}}}$: the error falls"
        " with the time of contact, $\\tau \\approx \\pi \\sqrt{m_1 / k_3}$.",
        Table(
            "Elastic orbits of period $2\\pi$; errors times $\\sqrt{k_3}$",
            (
                "$k_3$",
                "$u$",
                r"$\sqrt{k_3}\,(u + u_\mathrm{rigid})$",
                r"$\sqrt{k_3}\,(y - y_\mathrm{rigid})$",
                r"$\sqrt{k_3}\,\tau$",
                r"$\sqrt{k_3}\,w$",
            ),
            tuple(rows),
        ),
    )


def symmetric_portraits(symmetric: Orbit) -> Finding:
    """Finding on the symmetry of both phase portraits of the symmetric orbit, and its stability.

    It has the largest defect of the symmetry in each state, nondimensional; the orbit is at
    the paper's data.
    """
    motion, tau = symmetric.motion(), float(symmetric.values["tau"])
    times = np.linspace(0, motion.period, 2001)
    there, mirrored = motion(times), motion(tau - times)
    defects = [np.abs(there[:, i] + sign * mirrored[:, i]).max() for i, sign in enumerate((1, 1))]
    defects += [np.abs(there[:, i] - mirrored[:, i]).max() for i in (2, 3)]
    stability = symmetric.stability
    largest = max((m for m in stability.multipliers), key=lambda m: abs(float(m.real)))
    return Finding(
        "Sec. 3.2: the symmetry of the phase portraits",
        "The phase portraits of the system are symmetrical with respect to the lines"
        " corresponding to the constant part of the solution.",
        "holds" if max(defects) < 1e-12 else "does not hold",
        "",
        "With $z_i = x_i - \\tilde d_{0i}$ the motion obeys $z(\\tau - t) = -z(t)$ and"
        " $z'(\\tau - t) = z'(t)$: each portrait is its own mirror image in $z_i = 0$. The paper"
        " does not say whether this orbit is stable: its largest multiplier is"
        f" {float(largest.real):.8f}, so that it is {stability.verdict}.",
        Table(
            "Largest defect of the symmetry over a period",
            ("State", "Defect"),
            tuple(
                (f"${name}$", f"{defect:.0e}")
                for name, defect in zip(("z_1", "z_2", "z_1'", "z_2'"), defects, strict=True)
            ),
        ),
    )


def trace_criterion(stick: Orbit) -> Finding:
    """Finding on the paper's criterion of conditional stability, decided for its data.

    It has determinant and trace, nondimensional; `stick` is the orbit with global stick at
    the paper's data.
    """
    stability = stick.stability
    jacobian = stick.evaluate("poincare_jacobian")
    determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0]
    return Finding(
        "Sec. 5: the trace criterion",
        "J is a 2 by 2 singular matrix and the periodic solution is conditionally stable if"
        r" $|\mathrm{trace}(J)| < 1$.",
        "holds" if abs(determinant) < 1e-25 else "does not hold",
        "",
        f"The determinant of $J$ is {float(determinant):.0e} in 50 digits, its trace"
        f" {float(stability.trace):.12f}: the margin $1 - |\\mathrm{{trace}}(J)|$ is"
        f" {float(stability.margin):.8f}, and the orbit of the printed $e_1$, $e_2$ is"
        f" {stability.verdict} (conditionally, in the paper's word).",
    )


def saltation_matters(orbits: tuple[Orbit, ...]) -> Table:
    """Table of multipliers with and without saltation matrices, as products of all local maps.

    Each orbit has a row; the multipliers are nondimensional.
    """
    rows = []
    for orbit in orbits:
        known = sorted((complex(m.real, m.imaginary) for m in orbit.stability.multipliers), key=_by)
        full = _eigenvalues(np.array(orbit.monodromy, dtype=float))
        without = _eigenvalues(_without_saltation(orbit))
        rows.append((f"*{orbit.name}*", *(_list(values) for values in (known, full, without))))
    return Table(
        "Multipliers of the Poincaré map; eigenvalues of the monodromy matrix; those of the"
        " product of flows and resets alone, wrong wherever the vector field jumps (at the elastic"
        " stop it does not)",
        ("Orbit", "Poincaré map", "Monodromy matrix", "Without saltation"),
        tuple(rows),
    )


def _without_saltation(orbit: Orbit) -> np.ndarray:
    """The product of flows and resets: saltation matrices without their rank-one part."""
    kernels = orbit.kernels
    parameters = [float(orbit.values[name]) for name in kernels.parameter_names]
    spectrum, _ = kernels.spectrum(parameters)
    product = np.eye(len(kernels.table["states"]))
    for (configuration, _, _), time, reset in zip(
        kernels.table["phases"], orbit.dwell_times, kernels.table["resets"], strict=True
    ):
        arguments = (configuration, parameters, spectrum, float(time))
        origin = np.asarray(kernels.flow(*arguments, np.zeros(len(product))))
        moved = np.asarray(kernels.flow(*arguments, product.T)) - origin
        product = np.array(reset, dtype=float) @ moved.T
    return product


def _eigenvalues(matrix: np.ndarray) -> list[complex]:
    return sorted(np.linalg.eigvals(matrix).astype(complex).tolist(), key=_by)


def _by(value: complex) -> tuple[float, float, float]:
    return (-round(abs(value), 5), -round(value.real, 5), -value.imag)


def _list(values: list[complex]) -> str:
    return ", ".join(
        f"{v.real:.5f}" + (f"{v.imag:+.5f} i" if abs(v.imag) > 1e-6 else "") for v in values
    ).replace("-0.00000", "0.00000")
