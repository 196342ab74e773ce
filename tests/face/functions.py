"""Functions with derivatives that are known, for the tests of what passes them on."""

from __future__ import annotations

import numpy as np

from nonsmooth import DifferentiableFunction


def made(*, pulled: bool = False, calls: list[str] | None = None) -> DifferentiableFunction:
    """Three values of two numbers, NaN where the first number is above 10; note each call."""
    noted = [] if calls is None else calls

    def evaluate(x: np.ndarray) -> np.ndarray:
        noted.append(f"evaluate {len(x)}")
        found = np.stack([x[:, 0] * x[:, 1], x[:, 0] ** 2, np.sin(x[:, 1])], axis=1)
        found[x[:, 0] > 10] = np.nan
        return found

    def jacobian(x: np.ndarray) -> np.ndarray:
        found = np.zeros((len(x), 3, 2))
        found[:, 0, 0], found[:, 0, 1] = x[:, 1], x[:, 0]
        found[:, 1, 0], found[:, 2, 1] = 2 * x[:, 0], np.cos(x[:, 1])
        found[x[:, 0] > 10] = np.nan
        return found

    def differentiate(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = evaluate(x)
        noted[-1] = f"differentiate {len(x)}"
        return values, jacobian(x)

    def pull(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        noted.append(f"pull {len(x)}")
        return np.einsum("nm,nmq->nq", y, jacobian(x))

    names = ("a", "b"), ("product", "square", "sine")
    return DifferentiableFunction(
        *names, np.ones(2), evaluate, differentiate, pull if pulled else None
    )
