"""The exceptions: one root, usual bases, messages of one line."""

import pickle

import pytest

from nonsmooth.runtime.core import errors


@pytest.mark.parametrize(
    ("kind", "usual"),
    [
        (errors.InputError, ValueError),
        (errors.MissingExtra, ImportError),
        (errors.NoConvergence, Exception),
    ],
)
def test_one_root_and_the_usual_base(kind: type[Exception], usual: type[Exception]) -> None:
    assert issubclass(kind, errors.NonsmoothError)
    assert issubclass(kind, usual)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("etta", "unknown parameter 'etta'; did you mean 'eta'? known: chi, eta, V, e1, e2"),
        ("v", "unknown parameter 'v'; did you mean 'V'? known: chi, eta, V, e1, e2"),
        ("zzzz", "unknown parameter 'zzzz'; known: chi, eta, V, e1, e2"),
        ("a\nb", "unknown parameter 'a\\nb'; known: chi, eta, V, e1, e2"),
    ],
)
def test_unknown_name_suggests_and_lists(name: str, message: str) -> None:
    problem = errors.unknown_name("parameter", name, ["chi", "eta", "V", "e1", "e2"])
    assert isinstance(problem, errors.InputError)
    assert str(problem) == message


def test_unknown_name_keeps_names_that_differ_in_case() -> None:
    assert "did you mean 'v'?" in str(errors.unknown_name("unknown", "v1", ["v", "V"]))


def test_unknown_name_without_any_known_name() -> None:
    assert str(errors.unknown_name("system", "rigid", [])) == "unknown system 'rigid'"


def test_missing_extra_gives_the_command() -> None:
    problem = errors.missing_extra("plot", "matplotlib")
    assert str(problem) == 'matplotlib is not installed: pip install "nonsmooth[plot]"'
    assert problem.name == "matplotlib"


def test_exceptions_travel_between_processes() -> None:
    problem = errors.unknown_name("orbit", "x", ["y"])
    copy = pickle.loads(pickle.dumps(problem))
    assert type(copy) is errors.InputError
    assert str(copy) == str(problem)
