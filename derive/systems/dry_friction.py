"""Coupled oscillators excited by dry friction, as in the third section of the paper.

Two masses on a belt of velocity V, coupled by linear springs. Nondimensional, with time
in units of 1/omega_3, omega_3 = sqrt((k1 + k2)/m1), and forces divided by k1 + k2:

    x1'' + x1 - chi x2 = u1,          chi = k2/(k1 + k2),
    x2'' + chi eta (x2 - x1) = eta u2,  eta = m1/m2.

Each mass slips (x' < V, u = us), sticks (x' = V, ``|u| < ur``) or overshoots (x' > V,
u = -us), which makes nine configurations. f1 and f2 are the forces that friction has to
balance on a mass that sticks.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary, Phase, Reference
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.presentation import Presentation
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition

_PARAMETERS = (
    Parameter("chi", "stiffness ratio k2/(k1 + k2), nondimensional", upper=1),
    Parameter("eta", "mass ratio m1/m2, nondimensional"),
    Parameter("V", "velocity of the belt, nondimensional"),
    Parameter("us1", "slipping friction force on the first mass, nondimensional"),
    Parameter("ur1", "static friction force on the first mass, nondimensional"),
    Parameter("us2", "slipping friction force on the second mass, nondimensional"),
    Parameter("ur2", "static friction force on the second mass, nondimensional"),
)
chi, eta, V, us1, ur1, us2, ur2 = (p.symbol for p in _PARAMETERS)
x1, x2, v1, v2 = states = sp.symbols("x1 x2 v1 v2", real=True)

POSITIONS, VELOCITIES = (x1, x2), (v1, v2)
FORCES = (x1 - chi * x2, chi * (x2 - x1))
SLIPPING, STATIC = (us1, us2), (ur1, ur2)
MASSES = ("first", "second")
REGIMES = ("slip", "stick", "overshoot")


def _boundaries(mass: int, regime: str) -> tuple[Boundary, ...]:
    """Boundaries at which one mass leaves its regime."""
    name, relative, force = MASSES[mass], VELOCITIES[mass] - V, FORCES[mass]
    if regime == "stick":
        return (
            Boundary(f"{name}-breaks-forward", force - STATIC[mass]),
            Boundary(f"{name}-breaks-backward", -force - STATIC[mass]),
        )
    sign = 1 if regime == "slip" else -1
    return (Boundary(f"{name}-reaches-belt", sign * relative, acts_when="reached"),)


def _configuration(regimes: tuple[str, str]) -> Configuration:
    """Configuration of both regimes: equations (6) to (9), or with a slip force reversed."""
    friction = {"slip": 1, "stick": 0, "overshoot": -1}
    u1, u2 = (friction[r] * u for r, u in zip(regimes, SLIPPING, strict=True))
    return Configuration(
        "-".join(regimes),
        SecondOrder(
            mass=sp.eye(2),
            stiffness=sp.Matrix([[1, -chi], [-chi * eta, chi * eta]]),
            load=(u1, eta * u2),
            held={x: V for x, r in zip(POSITIONS, regimes, strict=True) if r == "stick"},
        ),
        tuple(b for mass, r in enumerate(regimes) for b in _boundaries(mass, r)),
    )


def _choices(mass: int, along: str) -> tuple[tuple[str, tuple[Condition, ...]], ...]:
    """Regimes that a mass may take at x' = V, in the order in which they are tried.

    It slides when |f| exceeds ur, or equals it and the first nonzero derivative along the
    sticking motion leads beyond; else it sticks.
    """
    forward = FORCES[mass] - STATIC[mass]
    backward = -FORCES[mass] - STATIC[mass]
    return (
        ("slip", (Condition(forward, along),)),
        ("overshoot", (Condition(backward, along),)),
        ("stick", ()),
    )


def _transitions(regimes: tuple[str, str]) -> tuple[Transition, ...]:
    """Transitions for every set of boundaries that one configuration reaches at one instant."""
    source = "-".join(regimes)
    events = [
        [None, *(b.name for b in _boundaries(mass, regime))] for mass, regime in enumerate(regimes)
    ]
    found = []
    for names in product(*events):
        moved = [mass for mass in (0, 1) if names[mass] is not None]
        if not moved:
            continue
        # the second mass, if it is at the belt's velocity, is stuck while the first decides
        at_belt = ["stick" if m in moved else r for m, r in enumerate(regimes)]
        first = _choices(0, f"stick-{at_belt[1]}") if 0 in moved else ((regimes[0], ()),)
        for regime, conditions in first:
            second = _choices(1, f"{regime}-stick") if 1 in moved else ((regimes[1], ()),)
            for other, more in second:
                target = (regime, other)
                reset = {VELOCITIES[m]: V for m in moved if target[m] == "stick"}
                found.append(
                    Transition(
                        source,
                        frozenset(n for n in names if n is not None),
                        "-".join(target),
                        conditions + more,
                        reset,
                    )
                )
    return tuple(found)


def _friction(mass: int, pairs: tuple[tuple[str, str], ...]) -> Contact:
    """Friction force of the belt on one mass: us, the force that it balances, or -us."""
    force = {"slip": SLIPPING[mass], "stick": FORCES[mass], "overshoot": -SLIPPING[mass]}
    return Contact(
        f"{MASSES[mass]}-friction",
        VELOCITIES[mass],
        {"-".join(pair): force[pair[mass]] for pair in pairs},
        surface=V,
    )


_MODEL = (
    "Dry friction on a belt of velocity $V$ drives two masses: springs tie the first to the ground"
    " and the second to the first. In time $t$, with the friction forces $F_{1}$ and $F_{2}$,",
    r"$m_{1} \frac{\mathrm{d}^{2} x_{1}}{\mathrm{d} t^{2}} + \left(k_{1} + k_{2}\right) x_{1}"
    r" - k_{2} x_{2} = F_{1},\qquad m_{2} \frac{\mathrm{d}^{2} x_{2}}{\mathrm{d} t^{2}}"
    r" + k_{2} \left(x_{2} - x_{1}\right) = F_{2}.$",
    r"Time is counted in units of $1/\bar{\omega}$ ($1/\omega_{3}$ in the paper), and forces are"
    " divided by $k_{1} + k_{2}$, which makes them displacements, in any unit of length:",
    r"$\bar{\omega} = \sqrt{\frac{k_{1} + k_{2}}{m_{1}}},\qquad \chi = \frac{k_{2}}{k_{1} + k_{2}},"
    r"\qquad \eta = \frac{m_{1}}{m_{2}},\qquad u_{1} = \frac{F_{1}}{k_{1} + k_{2}},"
    r"\qquad u_{2} = \frac{F_{2}}{k_{1} + k_{2}}.$",
    r"With a prime for the derivative by $\bar{\omega} t$, and $V$ in these units, this is",
    r"$x_{1}'' + x_{1} - \chi x_{2} = u_{1},\qquad"
    r" x_{2}'' + \chi \eta \left(x_{2} - x_{1}\right) = \eta u_{2}.$",
    "Friction follows Coulomb's law with a slipping force $u_{si}$ and a greater static one"
    " $u_{ri}$. A mass that is slower or faster than the belt slips,",
    r"$u_{i} = u_{si} \text{ for } x_{i}' < V,\qquad u_{i} = - u_{si} \text{ for } x_{i}' > V.$",
    r"At the velocity of the belt it sticks, $u_{i} = \varphi_{i}$, while the force"
    r" $\varphi_{i}$ that keeps it there is smaller than $u_{ri}$ in magnitude,",
    r"$\varphi_{1} = x_{1} - \chi x_{2},\qquad"
    r" \varphi_{2} = \chi \left(x_{2} - x_{1}\right);$",
    r"where it is greater, friction is $u_{si}$ in its direction, and the mass slips.",
)


def _declare() -> System:
    pairs: tuple[tuple[str, str], ...] = tuple(product(REGIMES, REGIMES))
    return System(
        name="dry-friction",
        model=_MODEL,
        description="two coupled oscillators on a driving belt with dry friction (Sec. 3)",
        states=states,
        parameters=_PARAMETERS,
        configurations=tuple(_configuration(pair) for pair in pairs),
        transitions=tuple(t for pair in pairs for t in _transitions(pair)),
        constraints=(ur1 - us1, ur2 - us2),
        contacts=tuple(_friction(mass, pairs) for mass in (0, 1)),
    )


system = _declare()

# z = x - d, d the centre of the slip-slip configuration (6), and e = ur - us
_E1 = Parameter("e1", "excess ur1 - us1 of static over slipping friction", closed=True)
_E2 = Parameter("e2", "excess ur2 - us2 of static over slipping friction", closed=True)
shifted = Presentation(
    states=(*sp.symbols("z1 z2", real=True), v1, v2),
    origin=(
        (us1 + us2) / (1 - chi),
        (chi * us1 + us2) / (chi * (1 - chi)),
        0,
        0,
    ),
    parameters=(_E1, _E2),
    substitution={ur1: us1 + _E1.symbol, ur2: us2 + _E2.symbol},
)

_PAPER = "Pascal (2011)"
_TIME = r"which prints $t = \omega_{3} t'$ for $t' = \omega_{3} t$"
_WITH_GLOBAL_STICK = Source(
    _PAPER,
    equations={
        "configuration slip-slip": "(6)",
        "configuration slip-stick": "(7)",
        "configuration stick-slip": "(8)",
        "configuration stick-stick": "(9)",
        "model": "Sec. 3",
        "flow stick-stick": "(10)",
        "start": "(11)",
        "phase 1": "(12)",
        "end 1": "(12)",
        "phase 2": "(13)",
        "end 2": "(14)",
        "phase 3": "(15)",
        "end 3": "(16)",
        "phase 4": "(17)",
        "end 4": "(18)",
        "closure": "(18)",
        "map": "Sec. 5",
        "trace": "Sec. 5",
        "turn": "(A.1)",
        "compatibility": "(A.2)",
        "linear start": "(A.3)",
    },
    flows={"stick-stick": "D", "slip-stick": r"\Gamma", "slip-slip": "h", "stick-slip": "C"},
    states=("Z_{0}", "Z_{a}", "Z_{c}", "Z_{d}"),
    section=r"\Sigma_{0}",
    misprints={
        "(10)": "which prints the upper right block as $V t I$",
        "(15)": "which prints $H$ for the flow $h$",
        "(A.1)": r"which prints $\tilde N_{2}$ in the place of $\tilde N_{3}$, $T$ for $\tau_{2}$"
        " and $H$ for $h$",
        "Sec. 3": _TIME,
    },
)

global_stick = Itinerary(
    name="global-stick",
    system=system,
    phases=(
        Phase("stick-stick", "first-breaks-forward", "ta"),
        Phase("slip-stick", "second-breaks-forward", "tau"),
        Phase("slip-slip", "first-reaches-belt", "tau1"),
        Phase("stick-slip", "second-reaches-belt", "tau2"),
    ),
    presentation=shifted,
    reference=Reference(
        parameters={"chi": "0.5", "eta": "1", "V": "1", "e1": "3.0195", "e2": "0.4831"},
        guess={
            "z10": "1.1838",
            "z20": "-2.6715",
            "ta": "1",
            "tau": "2",
            "tau1": "1.568",
            "tau2": "3.28",
        },
    ),
    source=replace(
        _WITH_GLOBAL_STICK,
        equations={**_WITH_GLOBAL_STICK.equations, "reference": "the data of Sec. 3.3"},
        misprints={
            **_WITH_GLOBAL_STICK.misprints,
            "the data of Sec. 3.3": "whose numbers belong to no single orbit",
        },
    ),
)

# Sec. 3.2: z1 and z2 are odd in time about the middle of each phase
symmetric = Itinerary(
    name="symmetric",
    system=system,
    phases=(
        Phase("slip-slip", "second-reaches-belt", "tau"),
        Phase("slip-stick", "second-breaks-forward", "tau1"),
    ),
    presentation=shifted,
    start={"z1": "z10", "z2": "z20", "v1": "v10"},
    reversor={z: -z for z in shifted.states[:2]},
    reference=Reference(
        parameters={"chi": "0.4", "eta": "4", "V": "0.6773", "e2": "0.5"},
        guess={
            "z10": "-0.4898",
            "z20": "0.7602",
            "v10": "-0.111",
            "tau": "2.651",
            "tau1": "2.245",
        },
    ),
    source=Source(
        _PAPER,
        equations={
            "configuration slip-slip": "(6)",
            "configuration slip-stick": "(7)",
            "model": "Sec. 3",
            "symmetry": "Sec. 3.2",
            "reference": "the data of Sec. 3.2",
        },
        flows={"slip-slip": "h", "slip-stick": r"\Gamma"},
        states=("Z_{0}",),
        misprints={
            "Sec. 3": _TIME,
            "the data of Sec. 3.2": r"of which $\tau_{1}$ is not right to its digits",
        },
    ),
)

# the limit of the global stick orbit at ta = 0: the second mass reaches the belt at the
# instant at which the first breaks away, which fixes one parameter
solution_ii = replace(
    global_stick,
    name="solution-ii",
    vanishing=("ta",),
    solved_for=("e1",),
    start={"z1": "z10", "z2": "z20"},
    reference=Reference(
        parameters={"chi": "0.5", "eta": "1", "V": "1", "e2": "0.4831"},
        guess={
            "z10": "2",
            "z20": "-3",
            "tau": "2",
            "tau1": "1.568",
            "tau2": "3.28",
            "e1": "3.5",
        },
    ),
    source=_WITH_GLOBAL_STICK,
)

orbits = (symmetric, global_stick, solution_ii)
