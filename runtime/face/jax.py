"""Functions with exact derivatives in JAX: ``pip install "nonsmooth[jax]"``."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, missing_extra

if TYPE_CHECKING:
    import jax

__all__ = ["differentiable"]

_MODES = ("both", "reverse")


def differentiable(
    function: DifferentiableFunction, *, mode: Literal["both", "reverse"] = "both"
) -> Callable[[Any], jax.Array]:
    """Make a JAX function of a function with exact derivatives.

    It can be compiled (``jax.jit``), mapped (``jax.vmap``: one call for the whole batch) and
    differentiated once. Derivatives come from `function`; JAX differentiates nothing in it.

    Parameters
    ----------
    function : DifferentiableFunction
        Of q numbers, with m values.
    mode : {"both", "reverse"}
        "both": the Jacobian is found in the same pass as the values, and forward and reverse
        mode (``jax.jvp``, ``jax.grad``, ``jax.jacfwd``, ``jax.jacrev``) take their products with
        it. "reverse": ``jax.grad`` and ``jax.jacrev`` alone, by the function's own reverse pass,
        which is faster where there are many numbers and few values.

    Returns
    -------
    callable
        Float64 arrays (..., q) to float64 arrays (..., m); NaN where there is no value.

    Raises
    ------
    MissingExtra
        If JAX is not installed.
    InputError
        If the mode is unknown, or is "reverse" and the function has no reverse pass. The JAX
        function raises it if JAX is without 64 bits, if the numbers are complex or not q, and if
        it is differentiated twice.

    Examples
    --------
    >>> from nonsmooth.jax import differentiable  # doctest: +SKIP
    >>> square = differentiable(function)  # doctest: +SKIP
    >>> jax.grad(lambda x: square(x)[0])(jax.numpy.array([3.0]))  # doctest: +SKIP
    Array([6.], dtype=float64)
    """
    if mode not in _MODES:
        raise InputError(f"unknown mode {mode!r}; known: {', '.join(_MODES)}")
    if mode == "reverse" and function.pull is None:
        raise InputError("the function has no reverse pass of its own: leave out mode='reverse'")
    try:
        import jax
    except ImportError:
        raise missing_extra("jax", "jax") from None
    inside = _reverse(function) if mode == "reverse" else _both(function)

    def evaluate(x: Any) -> jax.Array:
        if jax.dtypes.canonicalize_dtype(np.float64) != np.float64:
            raise InputError(
                "JAX computes with 32 bits, which would lose half of the digits:"
                " jax.config.update('jax_enable_x64', True) first"
            )
        if jax.numpy.iscomplexobj(x):
            raise InputError("the function takes real numbers, not complex ones")
        points = jax.numpy.asarray(x, dtype=np.float64)
        function.check_shape(points.shape)
        return inside(points)

    return evaluate


def _called(host: Callable[..., Any], shapes: Any, *arguments: jax.Array) -> Any:
    """Call a function of NumPy arrays from compiled code, once for a whole batch."""
    import jax

    def on_arrays(*given: Any) -> Any:
        return host(*map(np.asarray, given))

    return jax.pure_callback(on_arrays, shapes, *arguments, vmap_method="broadcast_all")


def _shape(*sizes: int) -> Any:
    import jax

    return jax.ShapeDtypeStruct(sizes, np.dtype(np.float64))


def _both(function: DifferentiableFunction) -> Callable[[jax.Array], jax.Array]:
    """Differentiate by a rule that is linear in the tangent, which JAX transposes itself."""
    import jax

    m, q = len(function.outputs), len(function.inputs)

    @jax.custom_jvp
    def values(x: jax.Array) -> jax.Array:
        return _called(function, _shape(*x.shape[:-1], m), x)

    @jax.custom_jvp
    def values_and_jacobian(x: jax.Array) -> tuple[jax.Array, jax.Array]:
        shapes = _shape(*x.shape[:-1], m), _shape(*x.shape[:-1], m, q)
        return _called(function.value_and_jacobian, shapes, x)

    @values.defjvp
    def along(primals: Any, tangents: Any) -> tuple[jax.Array, jax.Array]:
        found, jacobian = values_and_jacobian(*primals)
        return found, jax.numpy.einsum("...mq,...q->...m", jacobian, *tangents)

    values_and_jacobian.defjvp(_refuse)
    return values


def _reverse(function: DifferentiableFunction) -> Callable[[jax.Array], jax.Array]:
    """Differentiate by the function's own reverse pass."""
    import jax

    m = len(function.outputs)

    @jax.custom_vjp
    def values(x: jax.Array) -> jax.Array:
        return _called(function, _shape(*x.shape[:-1], m), x)

    @jax.custom_jvp
    def pulled(x: jax.Array, cotangent: jax.Array) -> jax.Array:
        return _called(function.vjp, _shape(*x.shape), x, cotangent)

    pulled.defjvp(_refuse)
    values.defvjp(lambda x: (values(x), x), lambda x, cotangent: (pulled(x, cotangent),))
    return values


def _refuse(primals: Any, tangents: Any) -> Any:
    raise InputError("the function has first derivatives only: it cannot be differentiated twice")
