"""The exceptions: one root, usual bases, messages of one line."""

import pickle

import pytest

import nonsmooth as ns
from nonsmooth.derive import Parameter, oscillator


@pytest.mark.parametrize(
    ("kind", "usual"),
    [(ns.InputError, ValueError), (ns.MissingExtra, ImportError), (ns.NoConvergence, Exception)],
)
def test_one_root_and_the_usual_base(kind, usual):
    assert issubclass(kind, ns.NonsmoothError)
    assert issubclass(kind, usual)


KNOWN = "known: chi, eta, V, e1, e2, us1, us2, ur1, ur2"


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("etta", f"unknown parameter 'etta'; did you mean 'eta'? {KNOWN}"),
        ("v", f"unknown parameter 'v'; did you mean 'V'? {KNOWN}"),
        ("zzzz", f"unknown parameter 'zzzz'; {KNOWN}"),
        ("a\nb", f"unknown parameter 'a\\nb'; {KNOWN}"),
    ],
)
def test_an_unknown_name_is_answered_with_the_nearest_and_all(name, message):
    with pytest.raises(ns.InputError) as caught:
        ns.solve("dry-friction/global-stick", {name: 1})
    assert str(caught.value) == message
    # exceptions travel between processes
    copy = pickle.loads(pickle.dumps(caught.value))
    assert type(copy) is ns.InputError
    assert str(copy) == message


def test_names_that_differ_in_case_are_kept_apart():
    parameters = [Parameter("k", "stiffness"), Parameter("K", "mass")]
    k, mass = (p.symbol for p in parameters)
    system = oscillator("cases", ["x"], [[mass]], [[k]], parameters=parameters)
    with pytest.raises(ns.InputError, match=r"did you mean 'k'\? known: k, K"):
        ns.simulate(system, {"k1": 1}, [0, 1], until=1)
