"""Horseshoes whose sets are given: they are proved in seconds, without the search."""

from pathlib import Path

from flint import fmpq

from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.chaos.certify_chaos import _ChaosQuestion
from nonsmooth.runtime.proof.chaos.h_sets import HSet
from nonsmooth.runtime.proof.chaos.search import Horseshoe
from nonsmooth.runtime.proof.sets.sections import forcing_section, transition_section
from nonsmooth.runtime.proof.statement import exact_system

INVERTED = Path(__file__).with_name("inverted_oscillator.py")
INVERTED_DATA = {"r": "0.7", "a": "2", "w": "4"}
_INVERTED_SETS = (
    HSet("A", ("-0.5111", "-0.0990"), (("-0.0452", "-0.0597"), ("0.0674", "-0.0901"))),
    HSet("B", ("-0.8590", "-0.4984"), (("0.0453", "0.0594"), ("0.0028", "0.1361"))),
)

# two masses on a belt, both of which stick in turn
FRICTION_DATA = {
    "chi": "0.34",
    "eta": "2.88",
    "V": "1.23",
    "us1": "0.75",
    "us2": "1.19",
    "ur1": "2.04",
    "ur2": "1.83",
}
# a mass that is folded back by a wall: its horseshoe is proved and checked in a blink
FOLDED = Path(__file__).with_name("folded_oscillator.py")
FOLDED_DATA = {"r": "3", "c": "0.8"}
_FOLDED_SETS = (
    HSet("A", ("0.455",), (("0.025",),)),
    HSet("B", ("0.745",), (("0.045",),)),
)


def folded_section(system):
    """Where it is kicked."""
    source = system.structure.configuration("back")
    boundary = system.structure.boundary(source, "rises")
    target = system.structure.configuration("out")
    return transition_section(system, source, frozenset({boundary}), target)


def folded_horseshoe(*, exponents=False):
    """Two sets on a section of one coordinate: A covers B, which covers both."""

    guess = Horseshoe(2, _FOLDED_SETS, ((0, 1), (1, 0), (1, 1)))
    kernels = load_system(str(FOLDED))
    return proved(kernels, FOLDED_DATA, folded_section, guess, exponents=exponents)


def inverted_horseshoe(*, exponents):
    """Two sets on a section of two coordinates: A covers A and B, which covers A."""

    def section(system):
        return forcing_section(system, 0, (fmpq(-1), fmpq(0)))

    guess = Horseshoe(1, _INVERTED_SETS, ((0, 0), (0, 1), (1, 0)))
    return proved(load_system(str(INVERTED)), INVERTED_DATA, section, guess, exponents=exponents)


def proved(
    kernels,
    data,
    section,
    guess,
    *,
    exponents=False,
):
    """What is proved of given sets."""
    with flint_precision(80):
        exact = exact_system(kernels, data)
        question = _ChaosQuestion(
            kernels, exact, guess.iterates, 3000, exponents, 80, lambda done: None
        )
        found = question.prove(section(exact), guess)
    assert found is not None, question.tried
    return found
