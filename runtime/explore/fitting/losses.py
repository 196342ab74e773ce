"""Loss functions of squared residuals, as SciPy's `least_squares` has them, with derivatives.

P. J. Huber, Robust Statistics (1981); B. Triggs et al., Bundle adjustment (1999).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name

__all__ = ["LOSSES", "check_loss", "loss_of"]

Loss = Callable[[np.ndarray], np.ndarray]


def _linear(z: np.ndarray) -> np.ndarray:
    return np.array([z, np.ones_like(z), np.zeros_like(z)])


def _soft_l1(z: np.ndarray) -> np.ndarray:
    root = np.sqrt(1 + z)
    return np.array([2 * (root - 1), 1 / root, -0.5 / root**3])


def _huber(z: np.ndarray) -> np.ndarray:
    far = np.maximum(z, 1.0)
    inside, root = z <= 1, np.sqrt(far)
    return np.array(
        [
            np.where(inside, z, 2 * root - 1),
            np.where(inside, 1.0, 1 / root),
            np.where(inside, 0.0, -0.5 / far**1.5),
        ]
    )


def _cauchy(z: np.ndarray) -> np.ndarray:
    return np.array([np.log1p(z), 1 / (1 + z), -1 / (1 + z) ** 2])


LOSSES: Mapping[str, Loss] = {
    "linear": _linear,
    "soft_l1": _soft_l1,
    "huber": _huber,
    "cauchy": _cauchy,
}


def check_loss(name: str) -> None:
    """Refuse an unknown loss; the message lists the known ones."""
    if name not in LOSSES:
        raise unknown_name("loss", name, LOSSES)


def loss_of(name: str, count: int) -> Loss:
    """A loss for residuals of which the first `count` are data; those of priors stay squared.

    It maps squared residuals (m,) to the loss and its first two derivatives (3, m).
    """
    own = LOSSES[name]

    def loss(z: np.ndarray) -> np.ndarray:
        return np.concatenate([own(z[:count]), _linear(z[count:])], axis=1)

    return loss
