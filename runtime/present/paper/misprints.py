"""The paper's misprints, each with the computation that shows it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.paper.contact import contact_orbits
from nonsmooth.runtime.present.paper.records import Finding, Table

__all__ = ["misprints"]

_CLEAR = 1e-4  # beyond it a difference is no rounding, of the paper's digits or ours


def misprints(rigid: Orbit, elastic: Orbit, symmetric: Orbit, stick: Orbit) -> tuple[Finding, ...]:
    """Findings on all misprints, in the order of the paper.

    The orbits are those of the paper at its data; `stick` is the one with global stick.
    """
    return (
        _impact_law(rigid),
        _contact_stiffness(elastic),
        _mirrored_state(elastic),
        _time_scale(),
        _global_stick_flow(),
        _appendix_block(stick),
        _appendix_time(stick),
        _digits_of_global_stick(stick),
        _digits_of_symmetric(symmetric),
    )


def _impact_law(rigid: Orbit) -> Finding:
    values = {name: float(x) for name, x in rigid.values.items()}
    m1, m2, k1, k2 = (values[name] for name in ("m1", "m2", "k1", "k2"))

    def energy(state: Sequence[float]) -> float:
        x1, x2, v1, v2 = state
        return (m1 * v1**2 + m2 * v2**2 + k1 * (x1 - x2) ** 2 + k2 * x2**2) / 2

    before = [1.0, values["y"], -values["u"], 0.0]
    printed = [-before[0], *before[1:]]
    corrected = [*before[:2], -before[2], before[3]]
    rows = [
        ("in front of the impact", before),
        ("behind it, as printed", printed),
        ("behind it, velocity reversed", corrected),
    ]
    return Finding(
        "Eq. (2): the impact law",
        "$x_1^{+} = -x_1^{-}$ (perfect elastic impact)",
        _verdict(energy(printed) - energy(before), energy(corrected) - energy(before)),
        r"$\dot x_1^{+} = -\dot x_1^{-}$: the velocity is reversed, not the position.",
        "As printed, the first mass would jump from the stop at $x_1 = 1$ to $x_1 = -1$, and the"
        " energy with it; an elastic impact keeps both position and energy.",
        Table(
            "The impact of the rigid orbit at the paper's data",
            ("State", "$x_1$", r"$\dot x_1$", "Energy"),
            tuple((name, _text(s[0]), _text(s[2]), _text(energy(s))) for name, s in rows),
        ),
    )


def _contact_stiffness(elastic: Orbit) -> Finding:
    data = {name: float(elastic.values[name]) for name in ("m1", "m2", "k1", "k2", "k3", "T")}
    rows = []
    for label, last in (
        ("k_1 + k_3", data["k1"] + data["k3"]),
        ("k_1 + k_2", data["k1"] + data["k2"]),
    ):
        for found in contact_orbits(data, last):
            answer = "yes" if found.admissible else f"no: {found.failure}"
            rows.append((f"${label}$", _text(found.tau), _text(found.u), answer))
    counts = [sum(label in row[0] and row[3] == "yes" for row in rows) for label in ("k_3", "k_2")]
    return Finding(
        "Eq. (4): the stiffness in contact",
        "$K_1[2,2] = k_1 + k_3$",
        "misprint" if counts[0] == 0 < counts[1] else "undecided",
        "$K_1[2,2] = k_1 + k_2$: the stop acts on the first mass alone.",
        "All solutions of the half-phase conditions with $0 < \\tau < T$, for both matrices: with"
        f" the printed one {_count(counts[0])} of them is admissible, with the corrected one"
        f" {_count(counts[1])}.",
        Table(
            "One-contact solutions at the paper's data",
            ("$K_1[2,2]$", r"$\tau$", "$u$", "Admissible"),
            tuple(rows),
        ),
    )


def _mirrored_state(elastic: Orbit) -> Finding:
    start, end = (np.array([float(x) for x in row]) for row in elastic.states[:2])
    rules = [
        ("as printed, $-x_0$: first mass", end[2], -start[0]),
        ("as printed, $-x_0$: second mass", end[3], -start[1]),
        (r"corrected, $-\dot x_0$: first mass", end[2], -start[2]),
        (r"corrected, $-\dot x_0$: second mass", end[3], -start[3]),
    ]
    rows = [(name, _text(a), _text(b), f"{abs(a - b):.1e}") for name, a, b in rules]
    differences = [abs(a - b) for _, a, b in rules]
    return Finding(
        "Sec. 2.4: the rule at the end of the contact",
        r"$X(\tau) = (x_0, -x_0)$",
        _verdict(min(differences[:2]), max(differences[2:])),
        r"$X(\tau) = (x_0, -\dot x_0)$: a dot is lost.",
        "The velocities at the end of the contact phase of the elastic orbit.",
        Table(
            "Velocities at the end of the contact",
            ("Rule", r"$\dot x(\tau)$", "by the rule", "Difference"),
            tuple(rows),
        ),
    )


def _time_scale() -> Finding:
    k1, k2, m1 = 3.0, 5.0, 2.0
    omega = np.sqrt((k1 + k2) / m1)
    # x = cos(omega t) solves m1 x'' + (k1 + k2) x = 0; in t' its frequency has to be 1
    printed, corrected = omega * omega, omega / omega
    rows = [
        (r"as printed, $t = \omega_3 t'$", _text(printed)),
        (r"corrected, $t' = \omega_3 t$", _text(corrected)),
    ]
    return Finding(
        "Sec. 3: the nondimensional time",
        r"$t = \omega_3 t'$",
        _verdict(printed - 1, corrected - 1),
        r"$t' = \omega_3 t$",
        "With $x_2 = 0$ and no friction the first mass has the frequency $\\omega_3$ in $t$, and by"
        " $x_1'' + x_1 = 0$ the frequency 1 in $t'$. For $m_1 = 2$, $k_1 = 3$, $k_2 = 5$:",
        Table("Frequency in the scaled time", ("Scaling", "Frequency"), tuple(rows)),
    )


def _global_stick_flow() -> Finding:
    rows: list[tuple[str, str, float]] = []
    for velocity in ("1", "1.1"):
        orbit = solve("dry-friction/global-stick", {"V": velocity})
        turn, time = _period_map(orbit), float(orbit.unknowns["ta"])
        for label, factor in (("$V t I$, as printed", float(velocity)), ("$t I$", 1.0)):
            # N D for the D of the label: a turn, with the time of D's own block taken back
            around = turn @ _stick_matrix((factor - 1) * time)
            rows.append((velocity, label, _defect(around, orbit.states[0])))
    return Finding(
        "Eq. (10): the flow of the global stick phase",
        "the upper right block of $D$ is $V t I$",
        _verdict(rows[2][2], rows[3][2]),
        "it is $t I$: the velocities that it multiplies are already $V$.",
        "The state after one period, less the start, of the orbit that the equations give: only"
        " with $t I$ it closes. The two agree at $V = 1$ alone, the paper's value.",
        Table(
            "Closure of the global stick orbit",
            ("$V$", "Block", "Defect"),
            tuple((velocity, label, f"{defect:.0e}") for velocity, label, defect in rows),
        ),
    )


def _appendix_block(stick: Orbit) -> Finding:
    around = _period_map(stick)
    start = np.array([float(x) for x in stick.states[0]])
    z, rate = start[:2], start[2:]
    identity = np.eye(2)
    rows: list[tuple[str, float]] = []
    for label, block in (
        (r"$\tilde N_2$, as printed", around[:2, 2:]),
        (r"$\tilde N_3$", around[2:, :2]),
    ):
        residual = block @ z + (around[2:, 2:] - identity) @ rate
        rows.append((label, float(np.abs(residual).max())))
    return Finding(
        "Eq. (A.1): the lower left block",
        r"the lower left block of $N$ and $\tilde N$ is $N_2$, $\tilde N_2$",
        _verdict(rows[0][1], rows[1][1]),
        r"it is $N_3$, $\tilde N_3$, as in the conditions above it.",
        r"The second periodicity condition $\tilde N_3 z_0 + (\tilde N_4 - I) z_0' = 0$ at the"
        " orbit, with either block.",
        _defects("Second periodicity condition", ("Block", "Residual"), rows),
    )


def _appendix_time(stick: Orbit) -> Finding:
    rows: list[tuple[str, float]] = []
    for label, time in (
        ("the period, $T$ of Sec. 2", float(stick.period)),
        (r"$\tau_2$", float(stick.unknowns["tau2"])),
    ):
        rows.append((label, _defect(_period_map(stick, tau2=time), stick.states[0])))
    return Finding(
        "Eq. (A.1): the time $T$",
        r"$\tilde N = C(T) H(\tau_1) \Gamma(\tau) D(t_a)$",
        _verdict(rows[0][1], rows[1][1]),
        r"$T$ is $\tau_2$ there, and $H$, here and in Eq. (15), is the flow $h$ of the slip-slip"
        " configuration: $H$ is that of Sec. 2.",
        "The state after one period, less the start, with either time.",
        _defects("Closure with either time", ("$T$", "Defect"), rows),
    )


def _digits_of_global_stick(stick: Orbit) -> Finding:
    kernels = stick.kernels
    printed = {"z10": 1.1838, "z20": -2.6715, "ta": 1.0, "tau": 2.0, "tau1": 1.568, "tau2": 3.28}
    parameters = [float(stick.values[name]) for name in kernels.parameter_names]
    spectrum, _ = kernels.spectrum(parameters)
    residual = kernels.evaluate("residual", at=(parameters, spectrum, list(printed.values())))
    rows = list(zip(kernels.table["equations"], residual.tolist(), strict=True))
    switching, closing = np.abs(residual[:4]).max(), np.abs(residual[4:]).max()
    return Finding(
        "Sec. 3.3: the printed digits",
        "$e_1 = 3.0195$ and $e_2 = 0.4831$ with $t_a = 1$, $\\tau = 2$, $\\tau_1 = 1.568$,"
        " $\\tau_2 = 3.28$, $z_{10} = 1.1838$, $z_{20} = -2.6715$",
        "misprint" if closing > 100 * switching else "undecided",
        "They belong to no single orbit: that of the printed $e_1$, $e_2$ has slightly different"
        " $t_a$, $z_{10}$, $z_{20}$; that of the printed $t_a$, $\\tau$ slightly different $e_1$,"
        " $e_2$. Both are above.",
        "The six equations at the printed digits: the switching conditions hold to the digits"
        " printed, the positions do not return.",
        _defects("Equations at the printed digits", ("Equation", "Left-hand side"), rows),
    )


def _digits_of_symmetric(symmetric: Orbit) -> Finding:
    rows, missed = [], []
    for name, label, printed in (("tau", r"$\tau$", "2.65"), ("tau1", r"$\tau_1$", "2.2407")):
        ours = float(symmetric.unknowns[name])
        difference = ours - float(printed)
        unit = 10.0 ** -len(printed.partition(".")[2])
        missed.append(abs(difference) > unit)
        rows.append((label, printed, _text(ours), f"{100 * difference / ours:+.2f} %"))
    return Finding(
        "Sec. 3.2: the printed digits",
        r"$\tau = 2.65$, $\tau_1 = 2.2407$",
        "misprint" if any(missed) else "holds",
        r"$\tau_1$ is not right to the digits that are printed: both hold to about 0.2 %.",
        "The dwell times of the symmetric orbit at the paper's data.",
        Table("Dwell times", ("Quantity", "Printed", "Ours", "Difference"), tuple(rows)),
    )


def _period_map(orbit: Orbit, **changed: float) -> np.ndarray:
    """The matrix of the Appendix at an orbit, some of whose unknowns are changed."""
    kernels, values = orbit.kernels, {**orbit.values, **changed}
    parameters = [float(values[name]) for name in kernels.parameter_names]
    spectrum, _ = kernels.spectrum(parameters)
    unknowns = [float(values[name]) for name in kernels.unknowns]
    table = kernels.evaluate("period_map", at=(parameters, spectrum, unknowns))
    return np.asarray(table)[:, :-1]


def _stick_matrix(time: float) -> np.ndarray:
    """The matrix D of Eq. (10), with the block t I."""
    matrix = np.eye(4)
    matrix[:2, 2:] = time * np.eye(2)
    return matrix


def _defect(around: np.ndarray, start: Iterable[Any]) -> float:
    state = np.array([float(x) for x in start])
    return float(np.abs(around @ state - state).max())


def _defects(caption: str, header: tuple[str, str], rows: Iterable[tuple[str, float]]) -> Table:
    return Table(caption, header, tuple((label, f"{number:.1e}") for label, number in rows))


def _verdict(printed: float, corrected: float) -> str:
    """The text "misprint" if the printed value clearly fails where the corrected one holds.

    Otherwise it is "undecided".
    """
    return "misprint" if abs(printed) > _CLEAR > 1e6 * abs(corrected) else "undecided"


def _text(number: float, digits: int = 8) -> str:
    return f"{float(number):.{digits}g}"


def _count(number: int) -> str:
    return ("none", "one", "two", "three")[number] if number < 4 else str(number)
