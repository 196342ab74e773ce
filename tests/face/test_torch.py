"""Functions with derivatives in PyTorch: its own checkers, `torch.func`, and what is refused."""

import re

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.torch import differentiable
from tests.face.bridges import Bridge, Laws, at, made, refused_in_one_line
from tests.places import CHECKOUT

# its own forward mode uses what it has deprecated
pytestmark = pytest.mark.filterwarnings("ignore:.torch.jit:FutureWarning")


@pytest.fixture(scope="module")
def torch():
    return pytest.importorskip("torch")


class TestTorch(Laws):
    @pytest.fixture(params=[False, True])
    def bridge(self, torch, request):
        options = {"check_forward_ad": True, "check_batched_grad": True}
        options |= {"check_batched_forward_grad": True, "check_undefined_grad": True}

        def tensor(x):
            return torch.tensor(x, requires_grad=True)

        return Bridge(
            name="torch",
            numbers=torch,
            transformations=torch.func,
            tensor=torch.tensor,
            differentiable=differentiable,
            ways=(lambda f, x: f(torch.tensor(x)), lambda f, x: f(tensor(x)).detach()),
            check=lambda f, x: torch.autograd.gradcheck(f, (tensor(x),), **options),
            pulled=request.param,
            reverse_calls=["evaluate 5", "pull 5"] if request.param else ["differentiate 5"],
        )

    def test_backward_is_one_call_and_once(self, bridge, torch):
        calls = []
        source, function = bridge.of(calls=calls)
        x = torch.tensor(at(5), requires_grad=True)
        function(x).sum().backward()
        assert calls == bridge.reverse_calls
        assert_allclose(x.grad, source.vjp(at(5), np.ones((5, 3))), rtol=1e-14)
        (gradient,) = torch.autograd.grad((function(x) ** 2).sum(), x, create_graph=True)
        with pytest.raises(ns.InputError, match="first derivatives only"):
            gradient.sum().backward()


def test_what_is_no_point_is_refused_in_one_line(torch):
    for x, message in (
        (torch.ones(3, dtype=torch.float64), "takes 2 numbers: a, b"),
        (torch.tensor(1.0, dtype=torch.float64), "no entries"),
        (torch.ones(2), "torch.float64, not torch.float32"),
        (np.ones(2), "torch.float64, not ndarray"),
    ):
        refused_in_one_line(differentiable(made()), x, message)


@pytest.mark.usefixtures("torch")
def test_the_session_of_the_page_runs():
    """PyTorch is not there when the page is made."""
    page = (CHECKOUT / "docs" / "how_to" / "ecosystems.md").read_text(encoding="utf-8")
    cells = re.findall(r"```\{code-cell\} ipython3\n(.*?)```", page, flags=re.DOTALL)
    (session,) = re.findall(r"```python\n(.*?)```", page, flags=re.DOTALL)
    names = {}
    declared = [cell for cell in cells if "jax" not in cell and not cell.startswith(":tags")]
    exec(compile("\n".join([*declared, session]), "ecosystems.md", "exec"), names)
    assert_allclose(names["x"].grad, names["function"].vjp([0.5, 2.0], [1.0, 1.0, 0.0]))
