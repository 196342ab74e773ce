"""Stops that are reached at one instant, in proofs: every order of impacts has to agree."""

import copy
from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from tests.certified import believed, content_of, placing, refused, struck, struck_together

BOTH = ("a-reaches-stop", "b-reaches-stop")
OPEN = "the orders in which a-reaches-stop and b-reaches-stop act need not agree"


of_laws = pytest.mark.parametrize(
    ("law", "coupling"), [(None, "0"), ("sequence", "0"), ("moreau", "0"), ("moreau", "1/4")]
)


@cache
def saved(law=None, coupling="0"):
    return content_of(ns.certify(struck_together(law, coupling)))


@of_laws
def test_masses_that_are_struck_together_are_proved(law, coupling):
    content = saved(law, coupling)
    assert content["itinerary"] == [["free-free", "+".join(BOTH)]] * len(content["itinerary"])
    assert content["claims"]["admissibility"] == "proved"
    numbers = {t.get("order", 0) for t in content["declaration"]["transitions"]}
    assert numbers >= {1, 2} if law is None else numbers == {0}
    assert len(content["closing"]["vanishing"]) == 2  # x1 = x2, v1 = v2
    believed(content)


def of_order(content, number):
    return [t for t in content["declaration"]["transitions"] if t.get("order", 0) == number]


def renumbered(content, number, other):
    for transition in of_order(content, number):
        transition["order"] = other


def without(content, number):
    left = [t for t in content["declaration"]["transitions"] if t.get("order", 0) != number]
    content["declaration"]["transitions"] = left


def one_mass_alone(content):
    """In the second order only the second mass is struck."""
    for transition in of_order(content, 2):
        transition["reset"] = of_order(content, 1)[-1]["reset"]


def elsewhere(content):
    for transition in of_order(content, 2):
        transition["target"] = "contact-free"


FALSE = {
    "one order twice": lambda content: renumbered(content, 2, 1),
    "another number": lambda content: renumbered(content, 2, 3),
    "no number": lambda content: renumbered(content, 1, 0),
    "an order is left out": lambda content: without(content, 2),
    "the orders do not agree": one_mass_alone,
    "an order leads elsewhere": elsewhere,
    "nothing vanishes": lambda content: content["closing"].pop("vanishing"),
    "one vanishes alone": lambda content: content["closing"]["vanishing"].pop(),
    "another sum": placing("closing", "vanishing", 0, 1, "1"),
    "not at zero": placing("closing", "vanishing", 0, 6, "1"),
    "a mass is at rest": placing("closing", "vanishing", 1, 3, "0"),
    "twice": lambda content: content["closing"]["vanishing"].append(
        content["closing"]["vanishing"][0]
    ),
    "the forcing vanishes": lambda content: content["closing"]["vanishing"].extend(
        [["0", "0", "0", "0", "1", "0", "0"], ["0", "0", "0", "0", "0", "1", "0"]]
    ),
}


@pytest.mark.parametrize("name", FALSE)
def test_false_orders_and_symmetries_are_refused(name):
    content = copy.deepcopy(saved())
    FALSE[name](content)
    refused(content)


def test_orders_that_do_not_agree_are_left_open():
    content = copy.deepcopy(saved())
    one_mass_alone(content)
    found = JudgedOrbit(content).admissibility
    assert found.claim == "undecided"
    assert OPEN in found.reason


@of_laws
def test_motions_of_masses_that_are_struck_together_are_proved(law, coupling):
    start = [0, 0, 1, 1, 1, 0]
    proof = ns.certify.motion(struck(law), {"c": coupling}, start, "free-free", 3)
    assert proof.decided
    assert proof.sets == (BOTH,) * 3
    motion = ns.simulate(struck(law), {"c": coupling}, start, transitions=3)
    states = [[float(x) for x in state] for state in proof.states]
    np.testing.assert_allclose(motion.states, states, atol=1e-13)


def test_a_motion_whose_impacts_have_no_order_is_proved_up_to_there():
    proof = ns.certify.motion(struck(), {"c": "1/4"}, [0, 0, 1, 1, 1, 0], "free-free", 3)
    assert not proof.decided
    assert OPEN in str(proof.reason)
    assert proof.transitions == 0
