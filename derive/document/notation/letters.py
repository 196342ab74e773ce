"""Letters for matrices and vectors, none of which a system's own symbols have."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.document.notation.wording import Naming

__all__ = ["Letters", "letters_of"]

# what a reader expects first; the last one is free in practice
_CHOICES = {
    "matrix": ("A", r"\mathsf{A}"),
    "offset": ("b", r"\beta", r"\mathsf{b}"),
    "augmented": ("B", r"\mathsf{B}"),
    "eigenvalue": (r"\lambda", "s", "z", r"\mathsf{s}"),
    "discriminant": ("D", r"\Delta", r"\mathsf{D}"),
    "centre": (r"\mu", r"\nu", r"\mathsf{s}"),
    "projector": ("P", r"\Pi", r"\mathsf{P}"),
    "forcing": (r"\varphi", r"\mathsf{h}"),
    "reset": ("R", r"\mathsf{R}"),
    "jump": ("r", r"\varrho", r"\mathsf{r}"),
    "normal": ("n", r"\nu", r"\mathsf{n}"),
    "constant": ("c", r"\gamma", r"\mathsf{c}"),
    "field": ("f", "g", r"\mathsf{f}"),
    "saltation": ("S", r"\mathsf{S}"),
    "passage": ("N", "W", r"\mathsf{N}"),
    "remainder": ("m", "w", r"\mathsf{m}"),
    "embedding": ("E", r"\mathsf{E}"),
    "base": ("p", "a", r"\mathsf{p}"),
    "coordinates": ("q", r"\xi", r"\mathsf{q}"),
    "jacobian": ("J", r"\mathsf{J}"),
    "directions": ("L", r"\mathsf{L}"),
    "shift": (r"\sigma", r"\mathsf{z}"),
    "displacement": ("g", r"\mathsf{g}"),
    "damped": (r"\nu", r"\Omega", r"\mathsf{w}"),
    "phase": (r"\theta", r"\vartheta", r"\mathsf{t}"),
    "amplitude": ("H", "G", r"\mathsf{H}"),
    "lag": (r"\phi", r"\psi", r"\mathsf{l}"),
}
_KEPT = ("I", "M", "C", "K", r"\ell", r"\Phi", "t", "k", "j")


@dataclass(frozen=True)
class Letters:
    """LaTeX of the letters, by what each stands for.

    Attributes
    ----------
    matrix, offset : str
        Of the vector field y' = A y + b.
    augmented, eigenvalue, centre, projector : str
        Of the augmented matrix and its clusters of eigenvalues.
    discriminant : str
        Of one damped coordinate.
    forcing : str
        Part of the flow that does not depend on the state.
    reset, jump : str
        Matrix and constant of a reset.
    normal, constant : str
        Gradient and constant of a boundary.
    field, saltation : str
        Vector field in front of a transition, and its saltation matrix.
    passage, remainder : str
        Matrix and constant of one passage of an itinerary at given dwell times.
    embedding, base, coordinates : str
        The section at the start, E q + p.
    jacobian : str
        Of the Poincaré map.
    directions, shift : str
        Directions of the state that nothing depends on, and how far an orbit moves along them.
    displacement, damped : str
        Response to a displacement, and damped frequency.
    phase, amplitude, lag : str
        Phase of a forcing, amplitude of the response to it and how far it lags behind.
    """

    matrix: str
    offset: str
    augmented: str
    eigenvalue: str
    discriminant: str
    centre: str
    projector: str
    forcing: str
    reset: str
    jump: str
    normal: str
    constant: str
    field: str
    saltation: str
    passage: str
    remainder: str
    embedding: str
    base: str
    coordinates: str
    jacobian: str
    directions: str
    shift: str
    displacement: str
    damped: str
    phase: str
    amplitude: str
    lag: str


def letters_of(naming: Naming, symbols: Iterable[sp.Symbol]) -> Letters:
    """Letters that differ from those of the symbols, of the state and of each other."""
    taken = {naming.notation.symbol(s).partition("_")[0].partition("^")[0] for s in symbols}
    responses = naming.notation.responses
    taken |= {naming.state, naming.letter, responses.letter, responses.polynomial, *_KEPT}
    chosen: dict[str, str] = {}
    for role, choices in _CHOICES.items():
        chosen[role] = next((c for c in choices if c not in taken), choices[-1])
        taken.add(chosen[role])
    return Letters(**chosen)
