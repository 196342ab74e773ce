"""Functions with exact derivatives in PyTorch: ``pip install "nonsmooth[torch]"``."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, missing_extra

if TYPE_CHECKING:
    import torch

__all__ = ["differentiable"]


def differentiable(function: DifferentiableFunction) -> Callable[[torch.Tensor], torch.Tensor]:
    """Make a PyTorch function of a function with exact derivatives.

    It works with ``backward``, forward-mode automatic differentiation and ``torch.func``
    (``torch.vmap``: one call for the whole batch), once: there are no second derivatives. It
    computes on the processor, whatever device the tensors are on.

    Parameters
    ----------
    function : DifferentiableFunction
        Of q numbers, with m values. The reverse mode takes its own reverse pass if it has one.

    Returns
    -------
    callable
        Float64 tensors (..., q) to float64 tensors (..., m); NaN where there is no value.

    Raises
    ------
    MissingExtra
        If PyTorch is not installed.
    InputError
        The PyTorch function raises it if it is not given a tensor of float64, if its last axis
        has not q entries, and if it is differentiated twice.

    Examples
    --------
    >>> from nonsmooth.torch import differentiable  # doctest: +SKIP
    >>> square = differentiable(function)  # doctest: +SKIP
    >>> x = torch.tensor([3.0], dtype=torch.float64, requires_grad=True)  # doctest: +SKIP
    >>> square(x).sum().backward()  # doctest: +SKIP
    >>> x.grad  # doctest: +SKIP
    tensor([6.], dtype=torch.float64)
    """
    try:
        import torch
    except ImportError:
        raise missing_extra("torch", "torch") from None
    values = _operations()

    def evaluate(x: torch.Tensor) -> torch.Tensor:
        if not isinstance(x, torch.Tensor) or x.dtype != torch.float64:
            given = x.dtype if isinstance(x, torch.Tensor) else type(x).__name__
            raise InputError(f"the function takes a tensor of torch.float64, not {given}")
        function.check_shape(tuple(x.shape))
        return values.apply(x, function, x.requires_grad)[0]

    return evaluate


def _on_arrays(host: Callable[..., np.ndarray], *tensors: torch.Tensor) -> torch.Tensor:
    """Call a function of NumPy arrays on tensors, and give what it returns as a tensor."""
    import torch

    found = host(*(tensor.detach().cpu().numpy() for tensor in tensors))
    return torch.from_numpy(np.ascontiguousarray(found)).to(tensors[0].device)


@cache
def _operations() -> Any:
    """Make the operation that PyTorch's machinery knows how to differentiate and to map.

    It is a class of PyTorch's kind, and PyTorch is imported when it is asked for.
    """
    import torch

    def in_front(info: Any, dim: int | None, tensor: torch.Tensor) -> torch.Tensor:
        if dim is None:
            return tensor.expand(info.batch_size, *tensor.shape)
        return tensor.movedim(dim, 0)

    def has_rules(tensor: torch.Tensor) -> bool:
        """Tell whether rules of this module apply to a tensor: not under PyTorch's older vmap."""
        try:
            tensor.detach()
        except RuntimeError:
            return False
        return True

    class Once(torch.autograd.Function):
        """An operation that is computed on the host and has no derivatives itself."""

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            pass

        @staticmethod
        def backward(ctx: Any, *cotangents: Any) -> Any:
            raise InputError(
                "the function has first derivatives only: it cannot be differentiated twice"
            )

        @staticmethod
        def jvp(ctx: Any, *tangents: Any) -> Any:
            return Once.backward(ctx)

    class Jacobian(Once):
        """The Jacobian at points, which is `known` already if that has entries."""

        @staticmethod
        def forward(
            x: torch.Tensor, known: torch.Tensor, function: DifferentiableFunction
        ) -> torch.Tensor:
            return known.clone() if known.numel() else _on_arrays(function.jacobian, x)

        @staticmethod
        def vmap(info: Any, dims: Any, x: Any, known: Any, function: Any) -> Any:
            if dims[1] is not None:
                known = known.movedim(dims[1], 0)
            return Jacobian.apply(in_front(info, dims[0], x), known, function), 0

    class Pulled(Once):
        """Products of cotangents with the Jacobian, by the function's own reverse pass."""

        @staticmethod
        def forward(
            x: torch.Tensor, cotangent: torch.Tensor, function: DifferentiableFunction
        ) -> torch.Tensor:
            return _on_arrays(function.vjp, x, cotangent)

        @staticmethod
        def vmap(info: Any, dims: Any, x: Any, cotangent: Any, function: Any) -> Any:
            along = (in_front(info, dim, t) for dim, t in zip(dims, (x, cotangent), strict=False))
            return Pulled.apply(*along, function), 0

    class Values(torch.autograd.Function):
        """Values, and the Jacobian in the same pass where the reverse mode will need it."""

        @staticmethod
        def forward(
            x: torch.Tensor, function: DifferentiableFunction, tracked: bool
        ) -> tuple[torch.Tensor, torch.Tensor]:
            if not tracked or function.pull is not None:
                return _on_arrays(function, x), x.new_empty(0)
            values, jacobian = function.value_and_jacobian(x.detach().cpu().numpy())
            return _on_arrays(lambda _: values, x), _on_arrays(lambda _: jacobian, x)

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            x, ctx.function, _ = inputs
            ctx.mark_non_differentiable(output[1])
            ctx.save_for_backward(x, output[1])
            ctx.save_for_forward(x, output[1])

        @staticmethod
        def backward(ctx: Any, cotangent: Any, _: Any) -> Any:
            x, known = ctx.saved_tensors
            if ctx.function.pull is not None and has_rules(cotangent):
                return Pulled.apply(x, cotangent, ctx.function), None, None
            jacobian = Jacobian.apply(x, known, ctx.function)
            return (cotangent.unsqueeze(-2) @ jacobian).squeeze(-2), None, None

        @staticmethod
        def jvp(ctx: Any, tangent: Any, *_: Any) -> Any:
            jacobian = Jacobian.apply(*ctx.saved_tensors, ctx.function)
            return (jacobian @ tangent.unsqueeze(-1)).squeeze(-1), None

        @staticmethod
        def vmap(info: Any, dims: Any, x: Any, function: Any, tracked: bool) -> Any:
            found = Values.apply(x.movedim(dims[0], 0), function, tracked)
            return found, (0, 0 if found[1].numel() else None)

    return Values
