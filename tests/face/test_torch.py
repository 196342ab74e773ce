"""Functions with derivatives in PyTorch: its own checkers, `torch.func`, and what is refused."""

from __future__ import annotations

import re
import sys
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth.torch import differentiable
from tests.face.functions import made
from tests.places import CHECKOUT

# its own forward mode uses what it has deprecated
pytestmark = pytest.mark.filterwarnings("ignore:.torch.jit:FutureWarning")


@pytest.fixture(scope="module")
def torch() -> Any:
    return pytest.importorskip("torch")


def at(torch: Any, *lead: int) -> Any:
    found = np.random.default_rng(5).normal(size=(*lead, 2))
    return torch.tensor(found, requires_grad=True)


@pytest.mark.parametrize("pulled", [False, True])
@pytest.mark.parametrize("lead", [(), (4,), (2, 3), (0,)])
def test_values_are_those_of_the_function(torch: Any, lead: tuple[int, ...], pulled: bool) -> None:
    source, x = made(pulled=pulled), at(torch, *lead)
    for given in (x, x.detach()):
        found = differentiable(source)(given)
        assert found.dtype == torch.float64
        assert_array_equal(found.detach().numpy(), source(x.detach().numpy()))


@pytest.mark.parametrize("pulled", [False, True])
@pytest.mark.parametrize("lead", [(), (3,), (2, 2)])
def test_torchs_own_checker_agrees(torch: Any, lead: tuple[int, ...], pulled: bool) -> None:
    options = {"check_forward_ad": True, "check_batched_grad": True}
    options |= {"check_batched_forward_grad": True, "check_undefined_grad": True}
    assert torch.autograd.gradcheck(
        differentiable(made(pulled=pulled)), (at(torch, *lead),), **options
    )


@pytest.mark.parametrize("pulled", [False, True])
def test_jacobians_are_those_of_the_function(torch: Any, pulled: bool) -> None:
    source, x, many = made(pulled=pulled), at(torch).detach(), at(torch, 2, 3).detach()
    function = differentiable(source)
    expected = source.jacobian(many.numpy()).swapaxes(0, 1)
    for transformed in (torch.func.jacrev, torch.func.jacfwd):
        assert_allclose(transformed(function)(x), source.jacobian(x.numpy()), rtol=1e-14)
        mapped = torch.vmap(torch.vmap(transformed(function), in_dims=1), in_dims=0, out_dims=1)
        assert_allclose(mapped(many.swapaxes(1, 2)), expected, rtol=1e-14)
    factors = torch.tensor([1.0, -2.0, 3.0], dtype=torch.float64)
    gradient = torch.func.grad(lambda x: function(x) @ factors)(x)
    assert_allclose(gradient, source.vjp(x.numpy(), factors.numpy()), rtol=1e-14)
    _, along = torch.func.jvp(function, (many,), (2 * many,))
    assert_allclose(along, source.jvp(many.numpy(), 2 * many.numpy()), rtol=1e-14)


@pytest.mark.parametrize("pulled", [False, True])
@pytest.mark.parametrize("axis", [0, 1])
def test_a_batch_is_one_call(torch: Any, pulled: bool, axis: int) -> None:
    calls: list[str] = []
    source, x = made(pulled=pulled, calls=calls), at(torch, 5).detach()
    function, given = differentiable(source), x.movedim(0, axis)
    found = torch.vmap(function, in_dims=axis)(given)
    assert calls == ["evaluate 5"]
    assert_array_equal(found, source(x.numpy()))
    calls.clear()
    found = torch.vmap(torch.func.grad(lambda x: function(x).sum()), in_dims=axis)(given)
    assert calls == (["evaluate 5", "pull 5"] if pulled else ["differentiate 5"])
    assert_allclose(found, source.vjp(x.numpy(), np.ones((5, 3))), rtol=1e-14)
    calls.clear()
    function(at(torch, 5)).sum().backward()
    assert calls == (["evaluate 5", "pull 5"] if pulled else ["differentiate 5"])


def test_it_composes_with_what_torch_differentiates_itself(torch: Any) -> None:
    function = differentiable(made())

    def whole(x: Any) -> Any:
        for _ in range(3):
            x = function(torch.sin(x))[..., :2]
        return x

    def plain(x: Any) -> Any:
        for _ in range(3):
            a, b = torch.sin(x).unbind(-1)
            x = torch.stack([a * b, a**2], -1)
        return x

    x = at(torch, 4)
    (found,) = torch.autograd.grad(whole(x).sum(), x)
    (expected,) = torch.autograd.grad(plain(x).sum(), x)
    assert_allclose(found, expected, rtol=1e-13)


@pytest.mark.parametrize("pulled", [False, True])
def test_where_there_is_no_value_all_is_nan(torch: Any, pulled: bool) -> None:
    x = torch.tensor([[1.0, 2.0], [11.0, 2.0]], dtype=torch.float64, requires_grad=True)
    values = differentiable(made(pulled=pulled))(x)
    values.sum().backward()
    for found in (values.detach(), x.grad):
        assert_array_equal(torch.isnan(found).any(1), [False, True])
        assert_array_equal(torch.isnan(found).all(1), [False, True])


@pytest.mark.parametrize("pulled", [False, True])
def test_second_derivatives_are_refused(torch: Any, pulled: bool) -> None:
    function, x = differentiable(made(pulled=pulled)), at(torch)
    (gradient,) = torch.autograd.grad((function(x) ** 2).sum(), x, create_graph=True)
    with pytest.raises(ns.InputError, match="first derivatives only"):
        gradient.sum().backward()
    for outer in (torch.func.jacrev, torch.func.jacfwd):
        for inner in (torch.func.jacrev, torch.func.jacfwd):
            with pytest.raises(ns.InputError, match="first derivatives only"):
                outer(inner(function))(x.detach())


def test_what_is_no_point_is_refused_in_one_line(torch: Any) -> None:
    function = differentiable(made())
    for x, message in (
        (torch.ones(3, dtype=torch.float64), "takes 2 numbers: a, b"),
        (torch.tensor(1.0, dtype=torch.float64), "no entries"),
        (torch.ones(2), "torch.float64, not torch.float32"),
        (np.ones(2), "torch.float64, not ndarray"),
    ):
        with pytest.raises(ns.InputError, match=message) as caught:
            function(x)
        assert "\n" not in str(caught.value)


def test_without_torch_the_command_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(ns.MissingExtra, match=r'pip install "nonsmooth\[torch\]"'):
        differentiable(made())


@pytest.mark.usefixtures("torch")
def test_the_session_of_the_page_runs() -> None:
    """PyTorch is not there when the page is made."""
    page = (CHECKOUT / "docs" / "how_to" / "ecosystems.md").read_text(encoding="utf-8")
    cells = re.findall(r"```\{code-cell\} ipython3\n(.*?)```", page, flags=re.DOTALL)
    (session,) = re.findall(r"```python\n(.*?)```", page, flags=re.DOTALL)
    names: dict[str, Any] = {}
    declared = [cell for cell in cells if "jax" not in cell and not cell.startswith(":tags")]
    exec(compile("\n".join([*declared, session]), "ecosystems.md", "exec"), names)
    assert_allclose(names["x"].grad, names["function"].vjp([0.5, 2.0], [1.0, 1.0, 0.0]))
