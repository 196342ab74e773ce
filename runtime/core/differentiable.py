"""Functions with exact derivatives, as optimisers and other libraries take them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, one_or_several, unknown_name
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.values import real_array

Derivatives = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]
Pullback = Callable[[np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True, eq=False, repr=False)
class DifferentiableFunction(Shown):
    """A function of q numbers with m values, and its exact derivatives.

    Where it has no value, as where there is no orbit, values and derivatives are NaN.

    Attributes
    ----------
    inputs, outputs : tuple of str
        Names of the q numbers and of the m values.
    reference : array (q,)
        Where it was made.
    evaluate : callable
        Points (n, q) to values (n, m).
    differentiate : callable
        Points (n, q) to values (n, m) and Jacobians (n, m, q).
    pull : callable, optional
        Points (n, q) and cotangents (n, m) to their products with the Jacobians (n, q), where
        these are found faster than the Jacobians (reverse mode).

    Examples
    --------
    >>> square = DifferentiableFunction(
    ...     ("x",), ("y",), np.array([1.0]), lambda x: x**2, lambda x: (x**2, 2 * x[..., None])
    ... )
    >>> square([3.0]).tolist(), square.jacobian([3.0]).tolist()
    ([9.0], [[6.0]])
    """

    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    reference: np.ndarray
    evaluate: Callable[[np.ndarray], np.ndarray]
    differentiate: Derivatives
    pull: Pullback | None = None

    def __call__(self, x: Any) -> np.ndarray:
        """Values (..., m) of the function at points (..., q)."""
        points, lead = self._points(x)
        return self.evaluate(points).reshape(*lead, len(self.outputs))

    def jacobian(self, x: Any) -> np.ndarray:
        """Differentiate all values by all numbers.

        Parameters
        ----------
        x : array (..., q)

        Returns
        -------
        array (..., m, q)
        """
        return self.value_and_jacobian(x)[1]

    def value_and_jacobian(self, x: Any) -> tuple[np.ndarray, np.ndarray]:
        """Evaluate the function and its Jacobian in one pass.

        Parameters
        ----------
        x : array (..., q)

        Returns
        -------
        tuple of array (..., m) and array (..., m, q)
        """
        points, lead = self._points(x)
        values, jacobian = self.differentiate(points)
        shape = (*lead, len(self.outputs))
        return values.reshape(shape), jacobian.reshape(*shape, len(self.inputs))

    def jvp(self, x: Any, direction: Any) -> np.ndarray:
        """Differentiate all values along a direction (forward mode).

        Parameters
        ----------
        x, direction : array (..., q)

        Returns
        -------
        array (..., m)
        """
        along = _weights("direction", direction, self.inputs)
        return np.asarray((self.jacobian(x) @ along[..., None])[..., 0])

    def vjp(self, x: Any, cotangent: Any) -> np.ndarray:
        """Differentiate one combination of the values by all numbers (reverse mode).

        Parameters
        ----------
        x : array (..., q)
        cotangent : array (..., m)
            Factors of the values.

        Returns
        -------
        array (..., q)
        """
        factors = _weights("cotangent", cotangent, self.outputs)
        if self.pull is None:
            return np.asarray((factors[..., None, :] @ self.jacobian(x))[..., 0, :])
        points, lead = self._points(x)
        flat = np.broadcast_to(factors, (*lead, len(self.outputs))).reshape(len(points), -1)
        return self.pull(points, flat).reshape(*lead, len(self.inputs))

    def scipy_pair(
        self, output: str | None = None
    ) -> tuple[Callable[..., Any], Callable[..., Any]]:
        """Give the function and its derivatives as SciPy's solvers and optimisers take them.

        Parameters
        ----------
        output : str, optional
            The one value that is minimised; otherwise all of them, as residuals or equations.

        Returns
        -------
        fun, jac : tuple of callable
            Of all values: arrays (q,) to (m,) and (m, q), for ``least_squares`` and ``root``. Of
            one: to a float and its gradient (q,), for ``minimize``.

        Raises
        ------
        InputError
            If no value has that name.

        Examples
        --------
        >>> from scipy.optimize import minimize
        >>> valley = DifferentiableFunction(
        ...     ("x",), ("y",), np.array([1.0]), lambda x: x**2, lambda x: (x**2, 2 * x[..., None])
        ... )
        >>> fun, jac = valley.scipy_pair("y")
        >>> bool(minimize(fun, [1.0], jac=jac).success)
        True
        """
        if output is None:
            return self.__call__, self.jacobian
        if output not in self.outputs:
            raise unknown_name("output", output, self.outputs)
        place = self.outputs.index(output)
        return lambda x: float(self(x)[place]), lambda x: self.jacobian(x)[place]

    def check_shape(self, shape: tuple[int, ...]) -> None:
        """Refuse points whose last axis does not hold the q numbers.

        Parameters
        ----------
        shape : tuple of int

        Raises
        ------
        InputError
            The numbers are named.
        """
        *_, last = ("no entries", *one_or_several(shape))
        if last != len(self.inputs):
            raise InputError(
                f"the function takes {len(self.inputs)} numbers: {', '.join(self.inputs)};"
                f" the last axis has {last}"
            )

    def _points(self, x: Any) -> tuple[np.ndarray, tuple[int, ...]]:
        array = _unnamed("x", x, self.inputs)
        self.check_shape(array.shape)
        return array.reshape(-1, len(self.inputs)), array.shape[:-1]


def _unnamed(label: str, given: Any, names: tuple[str, ...]) -> np.ndarray:
    """The array of numbers that is given; an `InputError` refuses numbers by names."""
    if hasattr(given, "keys"):
        raise InputError(f"{label} takes numbers in the order {', '.join(names)}, not by names")
    return real_array(label, given)


def _weights(label: str, given: Any, names: tuple[str, ...]) -> np.ndarray:
    """Array (..., k) with a number for each of k names."""
    array = _unnamed(label, given, names)
    if array.shape[-1:] != (len(names),):
        raise InputError(f"{label} has the shape {array.shape}; one number each for {names}")
    return array
