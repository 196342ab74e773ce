"""Documents cite the publication of an orbit, and number their equations by sections."""

import random
import re

import numpy as np
import pytest

from nonsmooth.derive.document.blocks import Formula
from nonsmooth.derive.systems import declaration
from tests.documents import document_of
from tests.formulas.pages import texts_of
from tests.latex_reader import ORBITS, reading

# all numbered equations of the source paper
PAPER = (*(f"({number})" for number in range(1, 19)), "(A.1)", "(A.2)", "(A.3)")


def test_every_equation_of_the_paper_is_cited():
    told = [
        text for name in ORBITS for block in document_of(name).blocks for text in texts_of(block)
    ]
    cited = set(re.findall(r"= (\(\S+\)) of Pascal \(2011\)", " ".join(told)))
    assert cited == set(PAPER)


@pytest.mark.parametrize("name", ["dry-friction", *(n for n in ORBITS if "friction" in n)])
def test_the_model_scales_to_the_equations_that_are_declared(name):
    document = document_of(name)
    formulas = [b.latex for b in document.section("The model") if isinstance(b, Formula)]
    relations = re.split(r",\s*\\qquad|[.,;]?\s*(?:\\\\\s|\\end\{aligned\})", " ".join(formulas))
    texts = dict(
        re.sub(r"\\begin\{aligned\}|&(?:\\qquad\{\})?", "", relation).strip().split(" = ", 1)
        for relation in relations
        if " = " in relation
    )
    draw = random.Random(4)
    known = {f"{letter}_{{{i}}}": draw.uniform(0.3, 2.0) for letter in "mkFx" for i in (1, 2)}
    read = reading(known).latex
    chi, eta, frequency = (read(texts[letter]) for letter in (r"\chi", r"\eta", r"\bar{\omega}"))
    mass = np.diag([known["m_{1}"], known["m_{2}"]])
    k1, k2 = known["k_{1}"], known["k_{2}"]
    stiffness = np.array([[k1 + k2, -k2], [-k2, k2]])
    forces = np.array([known["F_{1}"], known["F_{2}"]])
    friction = [read(texts[f"u_{{{i}}}"]) for i in (1, 2)]

    system = declaration("dry-friction").system
    values = {"chi": chi, "eta": eta, "us1": friction[0], "us2": friction[1]}
    numbers = {p.symbol: values.get(p.name, 1.0) for p in system.parameters}
    numbers |= dict(zip(system.states, [known["x_{1}"], known["x_{2}"], 1.0, 1.0], strict=True))
    dynamics = system.configuration("slip-slip").dynamics
    declared = [np.array(m.subs(numbers), dtype=float) for m in (dynamics.stiffness, dynamics.load)]
    scale = np.linalg.inv(mass) / frequency**2
    assert scale @ stiffness == pytest.approx(declared[0])
    assert scale @ forces == pytest.approx(declared[1].ravel())
    holding = reading({**known, r"\chi": chi}).latex
    for i, contact in enumerate(system.contacts, start=1):
        force = contact.forces["stick-stick"].subs(numbers)
        assert holding(texts[rf"\varphi_{{{i}}}"]) == pytest.approx(float(force))
