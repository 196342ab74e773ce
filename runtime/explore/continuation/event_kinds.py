"""The kinds of events along a branch, by name."""

__all__ = ["BORDER_COLLISIONS", "KINDS", "SWITCHES"]

KINDS = {
    "fold": "the branch turns",
    "flip": "a multiplier is -1: an orbit of twice the period branches off",
    "neimark-sacker": "a pair of multipliers is on the unit circle: a torus branches off",
    "branch-point": "a multiplier is 1: another branch crosses",
    "symmetry-breaking": "a pair of orbits without the symmetry branches off",
    "grazing": "a boundary is touched inside a phase",
    "tangent": "a phase leaves its boundary, or reaches it, without speed",
    "entry": "a boundary is already reached where a phase begins",
    "simultaneous": "another boundary is reached at the same instant",
    "condition": "a condition of a transition just holds",
    "vanishing-phase": "a dwell time shrinks to zero",
    "admissibility": "the orbit ceases to be a motion of the real system",
}

SWITCHES = ("flip", "symmetry-breaking", "branch-point")

BORDER_COLLISIONS = (
    "grazing",
    "tangent",
    "entry",
    "simultaneous",
    "condition",
    "vanishing-phase",
    "admissibility",
)
