"""Systems: configurations, transitions and parameters, checked against each other.

A declaration says what the oscillator *is*; nothing is derived here. Every record is
frozen and checked when it is made, so that a wrong shape or name is reported at the line
that wrote it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.algebra import (
    affine_terms,
    cancel,
    is_affine,
    is_surely_positive_definite,
)
from nonsmooth.derive.declaration.configuration import Configuration, Contact
from nonsmooth.derive.declaration.contact_law import ContactLaw
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.fingerprint import fingerprint
from nonsmooth.derive.declaration.names import check_unique
from nonsmooth.derive.declaration.parameter import Parameter, check_finite, exact, is_rational
from nonsmooth.derive.declaration.soundness import check_soundness
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.registry import registered

__all__ = [
    "System",
]

TIME = sp.Symbol("t", real=True)


@dataclass(frozen=True)
class System:
    """Configurations, transitions and parameters of a piecewise-linear oscillator.

    Parameters
    ----------
    name : str
        Name used on the command line and for the generated files.
    description : str
        One line for lists.
    states : tuple of symbols
        For second-order motions the n positions, then the n velocities.
    parameters : tuple of Parameter
    configurations : tuple of Configuration
    transitions : tuple of Transition
        Ordered: the first whose set of boundaries matches and whose conditions hold.
    constraints : tuple of expressions
        Rational functions of the parameters, each nonnegative.
    contacts : tuple of Contact
        Forces of the surroundings, to be observed along a motion.
    forcing : tuple of (symbol, symbol)
        States c and s of each harmonic forcing: c' = -w s and s' = w c in every configuration,
        c^2 + s^2 = 1, so that c = cos(w t) from c = 1, s = 0.
    law : ContactLaw, optional
        What decides where no transition is listed: contacts that the mass matrix couples.
    model : tuple of str
        What stands behind the equations, such as units and force laws, in paragraphs with LaTeX
        between dollars; one that is a formula alone has a line of its own.

    Raises
    ------
    DeclarationError
        For a repeated or unknown name, a matrix of the wrong size, a function that is not
        affine in the state, a symbol that is neither a state nor a parameter, a number that
        is not finite, or what cannot move: see `nonsmooth.derive.declaration.soundness`.

    Examples
    --------
    >>> import sympy as sp
    >>> from nonsmooth.derive import Boundary, Configuration, SecondOrder, System, Transition
    >>> x, v = sp.symbols("x v", real=True)
    >>> free = Configuration("free", SecondOrder([[1]], [[1]]), (Boundary("meets-stop", x - 1),))
    >>> bounce = Transition("free", {"meets-stop"}, "free", reset={v: -v})
    >>> System("bouncing", "a mass and a stop; nondimensional", (x, v), (), (free,), (bounce,)).name
    'bouncing'
    """

    name: str
    description: str
    states: tuple[sp.Symbol, ...]
    parameters: tuple[Parameter, ...]
    configurations: tuple[Configuration, ...]
    transitions: tuple[Transition, ...] = ()
    constraints: tuple[sp.Expr, ...] = ()
    contacts: tuple[Contact, ...] = ()
    forcing: tuple[tuple[sp.Symbol, sp.Symbol], ...] = ()
    law: ContactLaw | None = None
    model: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for attribute in (
            "states",
            "parameters",
            "configurations",
            "transitions",
            "constraints",
            "contacts",
            "forcing",
            "model",
        ):
            object.__setattr__(self, attribute, tuple(getattr(self, attribute)))
        object.__setattr__(self, "constraints", tuple(map(exact, self.constraints)))
        check_unique([str(s) for s in self.states], "state")
        check_unique([p.name for p in self.parameters], "parameter")
        names = [*map(str, self.states), *(p.name for p in self.parameters)]
        check_unique(names, "name")
        if str(TIME) in names:
            raise DeclarationError(
                f"the name {str(TIME)!r} is kept for the time: choose another, such as 'tau'"
            )
        check_unique([c.name for c in self.configurations], "configuration")
        for constraint in self.constraints:
            where = f"constraint {constraint} >= 0"
            check_finite(constraint, where)
            self._check_symbols(constraint.free_symbols, where, states_allowed=False)
            if not is_rational(constraint):
                raise DeclarationError(
                    f"{where} is no rational function of parameters with rational coefficients"
                )
        for configuration in self.configurations:
            self._check_configuration(configuration)
        for transition in self.transitions:
            self._check_transition(transition)
        check_unique([c.name for c in self.contacts], "contact")
        for contact in self.contacts:
            where = f"contact {contact.name!r}"
            for name in contact.forces:
                self.configuration(name)
            for function in (*contact.forces.values(), contact.velocity, contact.surface):
                self._check_affine(function, where)
        for cosine, sine in self.forcing:
            self._check_forcing(cosine, sine)
        check_soundness(self)

    def fingerprint(self, orbits: Sequence[Any] = ()) -> str:
        """Hash the system and orbits of it; equal declarations give equal hashes.

        Parameters
        ----------
        orbits : sequence of Itinerary
            Orbits of the system.

        Returns
        -------
        str
            16 hexadecimal digits.
        """
        return fingerprint(self, tuple(orbits)) if orbits else self._fingerprint

    @cached_property
    def _fingerprint(self) -> str:
        return fingerprint(self, ())

    def __getstate__(self) -> dict[str, Any]:
        """The declaration alone, without what was derived from it."""
        return {name: value for name, value in vars(self).items() if not name.startswith("_")}

    def source(self, orbits: Sequence[Any] = ()) -> str:
        """Derive the system and orbits of it as the text of a Python module.

        Parameters
        ----------
        orbits : sequence of Itinerary
            Orbits of the system.

        Returns
        -------
        str
            Tables and kernels, over any arithmetic.
        """
        source: str = registered("emit_python")(self, orbits, f"the declaration of {self.name}")
        return source

    def library(self, orbits: Sequence[Any] = ()) -> dict[str, str]:
        """Derive the same as `source` as the files of an extension in C, and as `source` gives it.

        Parameters
        ----------
        orbits : sequence of Itinerary
            Orbits of the system.

        Returns
        -------
        dict of file name to text
        """
        emit = registered("emit_library")
        files: dict[str, str] = emit(self, orbits, f"the declaration of {self.name}")
        return files

    def many_points(self, orbits: Sequence[Any] = ()) -> dict[str, str]:
        """Derive what solves orbits at many points, damped and forced ones too.

        Parameters
        ----------
        orbits : sequence of Itinerary
            Orbits of the system.

        Returns
        -------
        dict of file name to text
            Of an extension in C, and a Python module of the same kernels.
        """
        emit = registered("emit_many_points")
        files: dict[str, str] = emit(self, orbits, f"the declaration of {self.name}")
        return files

    def configuration(self, name: str) -> Configuration:
        """Give the configuration of a name.

        Parameters
        ----------
        name : str

        Returns
        -------
        Configuration

        Raises
        ------
        DeclarationError
            If there is none of that name.
        """
        for configuration in self.configurations:
            if configuration.name == name:
                return configuration
        known = ", ".join(c.name for c in self.configurations)
        raise DeclarationError(
            f"system {self.name!r} has no configuration {name!r} (it has: {known})"
        )

    def transition(self, source: str, boundary: str, target: str) -> Transition:
        """Find the transition between two configurations, listed or of the law.

        Parameters
        ----------
        source : str
            Configuration before.
        boundary : str
            The one boundary that is reached.
        target : str
            Configuration behind.

        Returns
        -------
        Transition

        Raises
        ------
        DeclarationError
            If no transition leads there.
        """
        for transition in self.transitions:
            if (transition.source, transition.target) == (source, target) and (
                transition.boundaries == {boundary}
            ):
                return transition
        if self.law is not None and self.law.decides(frozenset({boundary})):
            reset = self.law.reset(source, frozenset({boundary}), target)
            if reset is not None:
                return Transition(source, frozenset({boundary}), target, (), reset)
        raise DeclarationError(f"no transition leads from {source!r} by {boundary!r} to {target!r}")

    def gradient(self, function: sp.Expr) -> tuple[sp.Matrix, sp.Expr]:
        """Give the row n and the constant c of an affine function ``n y + c`` of the state.

        Parameters
        ----------
        function : expression
            Affine in the states.

        Returns
        -------
        tuple of row (N,) and expression
        """
        row, constant = _gradient(function, self.states)
        return sp.Matrix(row), constant

    def _check_configuration(self, configuration: Configuration) -> None:
        where = f"configuration {configuration.name!r}"
        dynamics, size = configuration.dynamics, len(self.states)
        if isinstance(dynamics, SecondOrder):
            if 2 * dynamics.mass.rows != size:
                raise DeclarationError(
                    f"{where}: mass is {dynamics.mass.rows} x {dynamics.mass.rows},"
                    f" but the system has {size} states ({size // 2} positions)"
                )
            for symbol in dynamics.held:
                if symbol not in self.states[: size // 2]:
                    raise DeclarationError(f"{where}: held coordinate {symbol} is not a position")
            held = dynamics.held_at(self.states)
            free = [i for i in range(dynamics.mass.rows) if i not in held]
            surely = is_surely_positive_definite(dynamics.mass)
            if free and not surely and dynamics.mass.extract(free, free).det() == 0:
                raise DeclarationError(f"{where}: mass of the free coordinates is singular")
        elif dynamics.matrix.rows != size:
            raise DeclarationError(
                f"{where}: matrix is {dynamics.matrix.rows} x {dynamics.matrix.rows},"
                f" but the system has {size} states"
            )
        self._check_symbols(dynamics.free_symbols(), where, states_allowed=False)
        for boundary in configuration.boundaries:
            self._check_affine(boundary.function, f"{where}, boundary {boundary.name!r}")
        for function in configuration.constraints:
            self._check_affine(function, f"{where}, constraint {function}")

    def _check_transition(self, transition: Transition) -> None:
        where = f"transition {transition.source!r} -> {transition.target!r}"
        source = self.configuration(transition.source)
        self.configuration(transition.target)
        if not transition.boundaries:
            raise DeclarationError(f"{where}: no boundary is named")
        for name in sorted(transition.boundaries):
            source.boundary(name)
        for condition in transition.conditions:
            self.configuration(condition.along)
            self._check_affine(condition.function, where)
        for symbol, expression in transition.reset.items():
            if symbol not in self.states:
                raise DeclarationError(f"{where}: reset of {symbol}, which is not a state")
            self._check_affine(expression, f"{where}, reset of {symbol}")

    def _check_forcing(self, cosine: sp.Symbol, sine: sp.Symbol) -> None:
        """Refuse a pair that turns differently in some configuration, or that a reset changes."""
        where = f"forcing {cosine}, {sine}"
        for symbol in (cosine, sine):
            if symbol not in self.states:
                raise DeclarationError(f"{where}: {symbol} is not a state")
        speeds = set()
        for configuration in self.configurations:
            matrix, offset = configuration.dynamics.field(self.states)
            rates = {
                symbol: sum(
                    (weight * self.states[j] for (_, j), weight in matrix.row(i).todok().items()),
                    offset[i],
                )
                for symbol in (cosine, sine)
                for i in [self.states.index(symbol)]
            }
            speed = matrix[self.states.index(sine), self.states.index(cosine)]
            wanted = {cosine: -speed * sine, sine: speed * cosine}
            for symbol, rate in wanted.items():
                if sp.expand(rates[symbol] - rate) != 0:
                    raise DeclarationError(
                        f"{where}: in {configuration.name!r} it does not turn, c' = -w s, s' = w c"
                    )
            speeds.add(cancel(speed))
        if len(speeds) > 1 and len({sp.simplify(speed) for speed in speeds}) > 1:
            raise DeclarationError(f"{where}: it turns at different speeds: {speeds}")
        for transition in self.transitions:
            if {cosine, sine} & set(transition.reset):
                raise DeclarationError(
                    f"transition {transition.source!r} -> {transition.target!r} resets the {where}"
                )

    def _check_affine(self, function: sp.Expr, where: str) -> None:
        check_finite(function, where)
        self._check_symbols(function.free_symbols, where)
        if not is_affine(function, frozenset(self.states)):
            raise DeclarationError(f"{where}: {function} is not affine in the state")

    def _check_symbols(
        self, symbols: Iterable[Any], where: str, *, states_allowed: bool = True
    ) -> None:
        known = {p.symbol for p in self.parameters} | (
            set(self.states) if states_allowed else set()
        )
        unknown = sorted(str(s) for s in set(symbols) - known)
        if unknown and unknown[0] in map(str, known):
            raise DeclarationError(
                f"{where}: symbol {unknown[0]} has other assumptions than the declared"
                f" {unknown[0]}: use the symbol of the states, or Parameter.symbol"
            )
        if unknown:
            raise DeclarationError(
                f"{where}: symbol {unknown[0]} is neither a state nor a parameter"
                if states_allowed
                else f"{where}: symbol {unknown[0]} is not a parameter"
            )


@lru_cache(maxsize=4096)  # a declaration is checked again with each change of its coordinates
def _gradient(
    function: sp.Expr, states: tuple[sp.Symbol, ...]
) -> tuple[sp.ImmutableMatrix, sp.Expr]:
    slopes, rest = affine_terms(function, frozenset(states))
    row = sp.ImmutableMatrix([[slopes.get(s, sp.S.Zero) for s in states]])
    return row, sp.expand(rest)
