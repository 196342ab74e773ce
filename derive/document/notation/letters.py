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
    """LaTeX of a letter for each meaning."""

    matrix: str  # A of the vector field y' = A y + b
    offset: str  # b of the vector field
    augmented: str  # matrix A with the column b
    eigenvalue: str  # of the augmented matrix
    discriminant: str  # of one damped coordinate
    centre: str  # of a cluster of eigenvalues
    projector: str  # of a cluster of eigenvalues
    forcing: str  # part of the flow that does not depend on the state
    reset: str  # matrix of a reset
    jump: str  # constant of a reset
    normal: str  # gradient of a boundary
    constant: str  # of a boundary
    field: str  # vector field in front of a transition
    saltation: str  # saltation matrix of a transition
    passage: str  # matrix of one passage of an itinerary at given dwell times
    remainder: str  # constant of one passage
    embedding: str  # E of the section E q + p at the start
    base: str  # p of the section
    coordinates: str  # q of the section
    jacobian: str  # of the Poincaré map
    directions: str  # directions of the state that nothing depends on
    shift: str  # how far an orbit moves along them
    displacement: str  # response to a displacement
    damped: str  # damped frequency
    phase: str  # of a forcing
    amplitude: str  # of the response to a forcing
    lag: str  # of the response behind the forcing


def letters_of(naming: Naming, symbols: Iterable[sp.Symbol]) -> Letters:
    """Letters different from those of the symbols and the state, and from each other."""
    taken = {naming.notation.symbol(s).partition("_")[0].partition("^")[0] for s in symbols}
    responses = naming.notation.responses
    taken |= {naming.state, naming.letter, responses.letter, responses.polynomial, *_KEPT}
    chosen: dict[str, str] = {}
    for role, choices in _CHOICES.items():
        chosen[role] = next((c for c in choices if c not in taken), choices[-1])
        taken.add(chosen[role])
    return Letters(**chosen)
