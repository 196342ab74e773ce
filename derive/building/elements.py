"""What an oscillator is built from beside its matrices: stops, friction, sliders, regions.

Values may be numbers or SymPy expressions of parameters. A direction is the name of a
coordinate, or a mapping of coordinates to weights: ``{"x2": 1, "x1": -1}`` is the relative
coordinate x2 - x1; or a vector of n weights. Units are the user's own, consistent.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Protocol

import sympy as sp

from nonsmooth.derive.building.matrices import is_array, values_of_doubles
from nonsmooth.derive.declaration.fields import declared, exact, made, set_fields
from nonsmooth.derive.errors import DeclarationError

Direction = str | Mapping[str, Any] | Sequence[Any]


class Element(Protocol):
    """An element that makes an oscillator nonsmooth; `part_of` gives its regimes and forces."""

    @property
    def name(self) -> str:
        """Name of the element, with which the names of its boundaries begin."""


@declared
class Harmonic:
    """Force ``cosine cos(frequency t + phase) + sine sin(frequency t + phase)``.

    It adds two states, c = cos(frequency t) and s = sin(frequency t), with c' = -frequency s
    and s' = frequency c. All harmonics count one time t, so that their phases are relative to
    each other; of a single one the phase moves the time alone. A foot that moves by
    Y cos(frequency t) below a spring k and a damper c acts with the cosine k Y and the sine
    -c frequency Y.

    Parameters
    ----------
    frequency : number or expression
        Angular frequency.
    cosine, sine : n values, or mapping of coordinate to value
        Amplitudes of the forces on the coordinates; zero where not given.
    phase : number or expression

    Examples
    --------
    >>> from nonsmooth.derive import Harmonic, oscillator
    >>> oscillator("forced", ["x"], [[1]], [[4]], forcing=[Harmonic(1, cosine=[1])]).states
    (x, v, c1, s1)
    """

    frequency: Any
    cosine: Sequence[Any] | Mapping[str, Any] = ()
    sine: Sequence[Any] | Mapping[str, Any] = ()
    phase: Any = 0

    def __post_init__(self) -> None:
        _check(self.frequency, "a harmonic's frequency", lower=0, strict=True)


@declared
class RigidStop:
    """A rigid stop with Newton's law of impact, ``w x'+ = -restitution w x'-``.

    The impulse acts along w, so that any mass matrix serves. Impacts that accumulate, and
    those of restitution 0, end in lasting contact (`contact`), which is left when the stop
    would have to pull. Friction takes part in no impact; a stop in lasting contact does.
    Stops reached at one instant: see `simultaneous_impacts` of `oscillator`.

    Boundaries ``NAME-reaches-stop`` (of `free`) and ``NAME-leaves-stop`` (of `contact`).

    Parameters
    ----------
    coordinate : str or mapping
        Direction w: a coordinate, or weights of several; {"x2": 1, "x1": -1} is x2 - x1.
    at : number or expression
        Value of w x at the stop.
    restitution : number or expression
        Coefficient of restitution in [0, 1].
    side : {"upper", "lower"}
        Whether w x stays below or above `at`.
    name : str
        ``COORDINATE-SIDE`` when omitted.

    Raises
    ------
    DeclarationError
        For a restitution outside [0, 1], or an unknown side.
    """

    coordinate: Direction
    at: Any
    restitution: Any
    side: Literal["upper", "lower"] = "upper"
    name: str = ""

    def __post_init__(self) -> None:
        _settle_direction(self, f"-{self.side}")
        _check(self.at, f"place of {self.name!r}")
        _check(self.restitution, f"restitution of {self.name!r}", lower=0, upper=1)


@declared
class SoftStop:
    """A stop of finite stiffness, with a damper of its own.

    With the penetration g, the force of the stop is stiffness g + damping g' in contact.
    ``released="gap"`` keeps the contact until the gap opens (g = 0): a damped stop then pulls
    a little before. ``released="force"`` ends it when the force vanishes; the mass is then
    `released`, without a force, until the gap opens or the force would push again. The force of
    a stop without a damper vanishes as the gap opens: both are the same, ``"gap"``, and a
    damping that may be zero on its domain is refused with ``"force"``.

    Boundaries ``NAME-reaches-stop`` (of `free`), ``NAME-leaves-stop`` (of `contact`), and
    ``NAME-opens`` and ``NAME-meets-again`` (of `released`).

    Parameters
    ----------
    coordinate : str or mapping
        Direction w: a coordinate, or weights of several; {"x2": 1, "x1": -1} is x2 - x1.
    at : number or expression
        Value of w x at which the gap is closed.
    stiffness, damping : number or expression
    side : {"upper", "lower"}
        Whether w x grows or falls into the stop.
    released : {"gap", "force"}
    name : str
        ``COORDINATE-SIDE`` when omitted.

    Raises
    ------
    DeclarationError
        For a negative stiffness or damping, an unknown side, or an unknown release;
        `oscillator` raises it for a damping that may be zero with ``"force"``.

    Examples
    --------
    >>> from nonsmooth.derive import SoftStop, oscillator
    >>> spring = SoftStop("x", at=1, stiffness=10, name="spring")
    >>> system = oscillator("clearance", ["x"], [[1]], [[1]], elements=[spring])
    >>> [c.name for c in system.configurations]
    ['free', 'contact']
    """

    coordinate: Direction
    at: Any
    stiffness: Any
    damping: Any = 0
    side: Literal["upper", "lower"] = "upper"
    released: Literal["gap", "force"] = "gap"
    name: str = ""

    def __post_init__(self) -> None:
        _settle_direction(self, f"-{self.side}")
        _check(self.at, f"place of {self.name!r}")
        _check(self.stiffness, f"stiffness of {self.name!r}", lower=0)
        _check(self.damping, f"damping of {self.name!r}", lower=0)
        if exact(self.damping) == 0:
            set_fields(self, released="gap")


@declared
class Friction:
    """Dry friction on a belt, on the ground (velocity 0), or between two coordinates.

    With the relative velocity r = w x' - velocity, the friction force along w is

    * `slip`, r < 0: kinetic normal + falling r,
    * `overshoot`, r > 0: -(kinetic normal - falling r),
    * `stick`, r = 0: what holds it, up to static normal either way,
    * `lifted`, where the normal load is not positive: none,
    * `exhausted-slip` and `exhausted-overshoot`, where ``falling |r|`` is above ``kinetic normal``:
      none.

    A normal load that changes with the state may vanish: the contact lifts, and when the load
    returns it slips, overshoots, or, at r = 0, sticks if it can. A positive constant load adds
    no configuration, nor does a `falling` that is not positive. At r = 0 a contact sticks if it
    can. Contacts that the mass matrix couples are decided together, by one law: see
    `nonsmooth.derive.declaration.transition.ContactLaw`. An impact acts on no friction; behind it
    the velocities that have jumped, and a load that depends on them, tell the regime.

    Boundaries ``NAME-reaches-belt`` (of `slip` and `overshoot`), ``NAME-breaks-forward`` and
    ``NAME-breaks-backward`` (of `stick`; forward into `slip`); ``NAME-exhausts`` (of `slip` and
    `overshoot`) and ``NAME-recovers`` where the kinetic force is exhausted and returns;
    ``NAME-lifts`` and ``NAME-lands`` where the normal load vanishes and returns. A contact that
    sticks breaks before it lifts: its limit vanishes with the load.

    Parameters
    ----------
    coordinate : str or mapping
        Direction w: a coordinate, or weights of several; {"x2": 1, "x1": -1} is x2 - x1.
    kinetic, static : number or expression
        Forces, or with `normal` the coefficients; `static` is `kinetic` when omitted.
    velocity : number or expression
        Velocity of the belt.
    falling : number or expression
        Slope by which the kinetic force falls with ``|r|``; a negative number lets it rise.
    normal : number, expression, SoftStop or str
        Normal load: an expression affine in the state, whose symbols bear the names of the
        states; or a soft stop of the oscillator, itself or its name, whose push is the load
        while it touches.
    name : str
        The coordinate when omitted.

    Raises
    ------
    DeclarationError
        For negative numbers, or kinetic above static.

    Examples
    --------
    >>> from nonsmooth.derive import Friction, oscillator
    >>> belt = Friction("x", kinetic=1, static=2, velocity=1, name="belt")
    >>> system = oscillator("mass-on-belt", ["x"], [[1]], [[1]], elements=[belt])
    >>> [c.name for c in system.configurations]
    ['slip', 'stick', 'overshoot']
    """

    coordinate: Direction
    kinetic: Any
    static: Any = None
    velocity: Any = 0
    falling: Any = 0
    normal: Any = 1
    name: str = ""

    def __post_init__(self) -> None:
        _settle_direction(self)
        if self.static is None:
            set_fields(self, static=self.kinetic)
        _check(self.kinetic, f"kinetic friction of {self.name!r}", lower=0)
        _check(self.static, f"static friction of {self.name!r}", lower=0)
        _check(self.velocity, f"velocity of {self.name!r}")
        _check(self.falling, f"falling of {self.name!r}")
        if not isinstance(self.normal, (str, *ELEMENTS)):
            _check(self.normal, f"normal load of {self.name!r}")
        excess = exact(self.static) - exact(self.kinetic)
        if excess.is_negative:
            raise DeclarationError(
                f"{self.name!r}: kinetic friction {self.kinetic} is above static {self.static}"
            )


@declared
class Slider:
    """A spring in series with a massless Coulomb slider (Jenkins element).

    The position of the slider is a state of its own, ``s_NAME``. The force on the oscillator
    along w is -stiffness (w x - s) while the slider is `stuck`, and -limit or limit while it
    is dragged `forward` or `backward`; it turns where w x' does.

    Boundaries ``NAME-slides-forward`` and ``NAME-slides-backward`` (of `stuck`), and
    ``NAME-turns`` (of the others).

    Parameters
    ----------
    coordinate : str or mapping
        Direction w: a coordinate against the ground, or the difference of two.
    stiffness, limit : number or expression
        Positive.
    name : str
        The coordinate when omitted, without a hyphen.

    Raises
    ------
    DeclarationError
        For a stiffness or limit that is not positive.

    Examples
    --------
    >>> from nonsmooth.derive import Slider, oscillator
    >>> jenkins = Slider("x", stiffness=2, limit=1, name="jenkins")
    >>> system = oscillator("yielding", ["x"], [[1]], [[1]], elements=[jenkins])
    >>> [c.name for c in system.configurations], system.states
    (['stuck', 'forward', 'backward'], (x, v, s_jenkins))
    """

    coordinate: Direction
    stiffness: Any
    limit: Any
    name: str = ""

    def __post_init__(self) -> None:
        _settle_direction(self)
        _check(self.stiffness, f"stiffness of {self.name!r}", lower=0, strict=True)
        _check(self.limit, f"limit of {self.name!r}", lower=0, strict=True)


@declared
class Terms:
    """Terms ``damping x' + stiffness x = load`` that are added to the equations.

    Parameters
    ----------
    stiffness, damping : n x n matrices
        Zero when omitted.
    load : n values
        Zero when omitted.
    """

    stiffness: Any = None
    damping: Any = None
    load: Any = None


@declared
class Regions:
    """Terms that change across a plane of the state.

    Motions have to cross the plane: the forces are to be continuous there, or to lead both to
    one side. Where they hold the motion on the plane use `Friction`.

    Boundaries ``NAME-rises`` (of `below`) and ``NAME-falls`` (of `above`).

    Parameters
    ----------
    function : expression
        Affine in the state; symbols bear the names of the states.
    below, above : Terms
        Added where `function` is negative, and where it is positive.
    name : str

    Examples
    --------
    >>> from nonsmooth.derive import Regions, Terms, oscillator
    >>> stiffer = Regions("x", below=Terms(), above=Terms(stiffness=[[3]]), name="spring")
    >>> system = oscillator("bilinear", ["x"], [[1]], [[1]], elements=[stiffer])
    >>> [c.name for c in system.configurations]
    ['below', 'above']
    """

    function: Any
    below: Terms = Terms()
    above: Terms = Terms()
    name: str = "region"


ELEMENTS = (RigidStop, SoftStop, Friction, Slider, Regions)


def _direction_name(direction: Direction) -> str:
    """Name of a coordinate; of a direction the names of its coordinates, joined by hyphens."""
    if isinstance(direction, str):
        return direction
    if not isinstance(direction, Mapping):
        raise DeclarationError("an element whose direction is a vector needs a name")
    return "-".join(made(Mapping[str, Any], direction, "a direction"))


def _settle_direction(element: Any, ending: str = "") -> None:
    """Name an element by its direction if it has no name, and make a vector of doubles exact."""
    direction = element.coordinate
    set_fields(element, name=element.name or _direction_name(direction) + ending)
    if is_array(direction):
        weights = values_of_doubles(direction, f"element {element.name!r}")
        set_fields(element, coordinate=tuple(weights))


def _check(
    value: Any, what: str, lower: int | None = None, upper: int | None = None, strict: bool = False
) -> None:
    """Refuse a value that is known to lie outside its range; parameters may lie inside."""
    number = made(sp.Expr, value, what)
    if number.is_number and not (number.is_real and number.is_finite):
        raise DeclarationError(f"{what} is not a real number: {value}")
    if lower is None:
        return
    if upper is not None:
        if (number - lower).is_negative or (upper - number).is_negative:
            raise DeclarationError(f"{what} is not in [{lower}, {upper}]: {value}")
    elif strict and (number - lower).is_nonpositive:
        raise DeclarationError(f"{what} is not positive: {value}")
    elif (number - lower).is_negative:
        raise DeclarationError(f"{what} is negative: {value}")
