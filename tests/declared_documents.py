"""Systems without closed forms, and itineraries in them, for the tests of documents."""

import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    Harmonic,
    Itinerary,
    Parameter,
    Phase,
    Regions,
    RigidStop,
    SecondOrder,
    SoftStop,
    System,
    Terms,
    Transition,
    chain_matrices,
    oscillator,
)


def forced_stop():
    """Damped mass under harmonic forcing, in front of a stop: states x, v and c, s."""
    zeta, omega, r = sp.symbols("zeta Omega r", positive=True)
    stop = RigidStop("x", at=1, restitution=r, name="stop")
    forcing = [Harmonic(omega, cosine={"x": 1})]
    damping = [[2 * zeta]]
    return oscillator("forced", ["x"], [[1]], [[1]], damping, forcing=forcing, elements=[stop])


def impacts(count):
    """That many impacts in a period of the orbit."""
    phases = tuple(Phase("free", "stop-reaches-stop", f"tau{k + 1}") for k in range(count))
    return Itinerary("impacts", forced_stop(), phases)


def chain(damping="0.1"):
    """Three masses between two walls; the outer ones in front of elastic stops."""
    k, stop = sp.symbols("k kappa", positive=True)
    mass, stiffness, _ = chain_matrices([1, 1, 1], [k, k, k, k], fixed="both")
    stops = [
        SoftStop("x1", at=-1, stiffness=stop, side="lower", name="left"),
        SoftStop("x3", at=1, stiffness=stop, name="right"),
    ]
    damper = sp.Rational(str(damping)) * sp.eye(3)
    return oscillator("chain", ["x1", "x2", "x3"], mass, stiffness, damper, elements=stops)


def rattle(damping="0.1"):
    """The chain meets its left stop and then its right one."""
    turn = [
        ("free-free", "left-reaches-stop"), ("contact-free", "left-leaves-stop"),
        ("free-free", "right-reaches-stop"), ("free-contact", "right-leaves-stop"),
    ]  # fmt: skip
    phases = [Phase(*phase, f"tau{k}") for k, phase in enumerate(turn, start=1)]
    return Itinerary("rattle", chain(damping), tuple(phases))


def one_mass(zeta, square=1):
    """One damped mass in front of a stop."""
    damping, stop = [[2 * sp.sympify(zeta)]], RigidStop("x", at=2, restitution=1, name="stop")
    return oscillator("mass", ["x"], [[1]], [[square]], damping, load=[1], elements=[stop])


def masses(count):
    """Masses in a row whose first spring may push: their frequencies may be imaginary."""
    first = sp.Symbol("k", real=True)
    mass, stiffness, _ = chain_matrices([1] * count, [first, *[1] * (count - 1)])
    stop = RigidStop("x1", at=1, restitution=1, name="stop")
    names = [f"x{i}" for i in range(1, count + 1)]
    description = "masses & springs"
    return oscillator("masses", names, mass, stiffness, elements=[stop], description=description)


def pair():
    """Two masses that meet their stops, also both at one instant, without any condition."""
    stops = [SoftStop(name, at=1, stiffness=3, name=f"{name}-pad") for name in ("x", "y")]
    return oscillator("pair", ["x", "y"], sp.diag(1, 2), sp.eye(2), elements=stops)


def switched():
    """Damping that changes its sign where the velocity passes one."""
    above = Terms(damping=[["0.8"]], load=["0.8"])
    speed = Regions(sp.Symbol("v") - 1, above=above, name="speed")
    return oscillator("switched", ["x"], [[1]], [[1]], [["-0.2"]], load=["-0.2"], elements=[speed])


def switching(turns=1):
    """The cycle of switched damping, that many times."""
    turn = [("above", "speed-falls"), ("below", "speed-rises")]
    phases = [Phase(*phase, f"tau{k}") for k, phase in enumerate(turns * turn, start=1)]
    return Itinerary("cycle", switched(), tuple(phases))


def drop():
    """A ball that falls and bounces: one coordinate, an offset, no centre, no frequency."""
    g, r, w = (Parameter(n, n, upper=u) for n, u in (("g", sp.oo), ("r", 1), ("w", sp.oo)))
    h, v = sp.symbols("h v", real=True)
    falling = SecondOrder([[1]], [[0]], (-g.symbol,))
    bounce = Transition("falling", {"lands"}, "falling", (), {v: w.symbol - r.symbol * v})
    configuration = Configuration("falling", falling, (Boundary("lands", -h),))
    system = System("ball", "a falling ball", (h, v), (g, r, w), (configuration,), (bounce,))
    return Itinerary("bounce", system, (Phase("falling", "lands", "tau"),))
