"""Systems: configurations, transitions and parameters, checked against each other.

A declaration says what the oscillator *is*; nothing is derived here. Every record is
frozen and checked when it is made, so that a wrong shape or name is reported at the line
that wrote it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import cache, cached_property, lru_cache
from pathlib import Path
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.algebra import affine_terms
from nonsmooth.derive.declaration.configuration import Configuration, Contact
from nonsmooth.derive.declaration.fields import declared
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.soundness import check_system, check_unique, named
from nonsmooth.derive.declaration.transition import ContactLaw, Transition
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.registry import registered

TIME = sp.Symbol("t", real=True)


@declared
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
        check_unique([str(s) for s in self.states], "state")
        check_unique([p.name for p in self.parameters], "parameter")
        names = [*map(str, self.states), *(p.name for p in self.parameters)]
        check_unique(names, "name")
        if str(TIME) in names:
            raise DeclarationError(
                f"the name {str(TIME)!r} is kept for the time: choose another, such as 'tau'"
            )
        check_system(self)

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
        return _hash(self, tuple(orbits)) if orbits else self._fingerprint

    @cached_property
    def _fingerprint(self) -> str:
        return _hash(self, ())

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
        source: str = self._emitted("emit_python", orbits)
        return source

    def library(self, orbits: Sequence[Any] = ()) -> dict[str, str]:
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
        files: dict[str, str] = self._emitted("emit_library", orbits)
        return files

    def _emitted(self, emitter: str, orbits: Sequence[Any]) -> Any:
        return registered(emitter)(self, orbits, f"the declaration of {self.name}")

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
        return named(self.configurations, name, f"system {self.name!r} has no configuration")

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
        reached = frozenset({boundary})
        for transition in self._transitions_at(source, reached):
            if transition.target == target:
                return transition
        if self.law is not None and self.law.decides(reached):
            reset = self.law.reset(source, reached, target)
            if reset is not None:
                return Transition(source, reached, target, (), reset)
        raise DeclarationError(f"no transition leads from {source!r} by {boundary!r} to {target!r}")

    def _transitions_at(self, source: str, boundaries: frozenset[str]) -> Iterable[Transition]:
        """The listed transitions out of a configuration by boundaries that are reached together."""
        return (t for t in self.transitions if (t.source, t.boundaries) == (source, boundaries))

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


@lru_cache(maxsize=4096)  # a declaration is checked again with each change of its coordinates
def _gradient(
    function: sp.Expr, states: tuple[sp.Symbol, ...]
) -> tuple[sp.ImmutableMatrix, sp.Expr]:
    slopes, rest = affine_terms(function, frozenset(states))
    row = sp.ImmutableMatrix([[slopes.get(s, sp.S.Zero) for s in states]])
    return row, sp.expand(rest)


def _hash(*declarations: Any) -> str:
    """Hash of declarations, of SymPy's version and of the code that derives from them.

    DeclarationError refuses an object that declares nothing.
    """
    return text_hash(sp.__version__, _code(), *map(_text, declarations))


def text_hash(*parts: str) -> str:
    """Hash of the texts as 16 hexadecimal digits."""
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def _text(value: Any) -> str:
    """A text that differs for different values, with all their parts."""
    if is_dataclass(value) and not isinstance(value, type):
        if hasattr(value, "identity"):  # of a system that is not listed
            return _text(value.identity)
        inside = ", ".join(f"{f.name}={_text(getattr(value, f.name))}" for f in fields(value))
        return f"{type(value).__name__}({inside})"
    if isinstance(value, Mapping | sp.Dict):
        entries = [f"{_text(key)}: {_text(entry)}" for key, entry in value.items()]
        # SymPy's own mappings have no order of their own
        return f"{{{', '.join(sorted(entries) if isinstance(value, sp.Dict) else entries)}}}"
    if isinstance(value, sp.MatrixBase):
        placed = (f"{place}: {sp.srepr(entry)}" for place, entry in sorted(value.todok().items()))
        return f"{type(value).__name__}({value.shape}, {{{', '.join(placed)}}})"
    if isinstance(value, sp.Basic):
        return str(sp.srepr(value))
    if isinstance(value, frozenset):
        return f"{{{', '.join(sorted(map(_text, value)))}}}"
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_text, value))})"
    if value is None or isinstance(value, str | bool | int):
        return repr(value)
    raise DeclarationError(f"a declaration holds {value!r}, which declares nothing")


@cache
def _code() -> str:
    """Hash of this package's sources, which makes another release derive anew."""
    digest = hashlib.sha256()
    root = Path(__file__).parents[1]
    for path in sorted(root.rglob("*.py")) + sorted(root.rglob("*.h")):
        digest.update(path.relative_to(root).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()
