"""What is wrong in a question for orbits is named on one line, whoever would answer it."""

import math

import numpy as np
import pytest

import nonsmooth as ns
from tests.two_masses import PHASES, STICKING

GUESS = [1.02, 2.0, 1.57, 3.28]
ORBIT = "dry-friction/global-stick"
MANY = STICKING | {"V": [1.0, 1.01]}
KERNELS = {"orbit": ORBIT}
TABLES = {
    "orbit": "dry-friction", "parameters": STICKING, "itinerary": PHASES, "guess": GUESS
}  # fmt: skip
# by their kernels: one orbit, then many
NAMED = [
    ({"unknown": ("e3",), "given": {"ta": 1}}, "'e3'.*did you mean 'e[12]'"),
    ({"unknown": ("e1",), "given": {"tao": 1}}, "'tao'.*did you mean 'ta'"),
    ({"unknown": ("e1",), "given": {}}, "as many"),
    ({"unknown": ("e1", "e2"), "given": {"ta": 1}}, "as many"),
    ({"given": {"ta": 1}}, "as many"),
    ({"unknown": ("e1", "e1"), "given": {"ta": 1, "tau": 2}}, "twice"),
    ({"unknown": ("e1",), "given": {"ta": "one"}}, "ta"),
    ({"unknown": ("e1",), "given": {"ta": math.nan}}, "ta"),
    ({"unknown": ("e1",), "given": {"ta": 1}, "parameters": {"e1": 3}}, "e1 is both"),
    ({"guess": [1, 2, 3]}, "3 values.*6 unknowns"),
    ({"guess": [1] * 7}, "7 values"),
    ({"guess": {"taus": 1}}, "'taus'"),
    ({"guess": [1, 2, 3, 4, 5, math.inf]}, "not"),
    ({"parameters": {"etta": 1}}, "did you mean 'eta'"),
    ({"parameters": {"chi": 1}}, r"chi = 1 is outside its domain \(0, 1\)"),
    ({"parameters": {"V": math.nan}}, "V"),
    ({"parameters": {"e2": -1e-9}}, "e2 = -1e-09 is outside"),
    ({"orbit": "dry-friction/global-stuck"}, f"did you mean '{ORBIT}'"),
    ({"orbit": "dry-friction"}, "unknown orbit"),
    ({"orbit": ""}, "unknown orbit"),
    ({"threads": 2, "chunk": 9}, "threads and chunk: of many parameter points"),
    ({"derivatives": "V"}, "derivatives: of many parameter points"),
    ({"admissibility": False}, "admissibility: of many parameter points"),
    ({"multipliers": True}, "multipliers: of many parameter points"),
]
NAMED_MANY = [
    *(
        ({"parameters": {"V": [1.0], **given}}, named)
        for given, named in (
            ({"etta": 1.0}, "unknown parameter 'etta'; did you mean 'eta'"),
            ({"us3": 1.0}, "unknown parameter 'us3'"),
            ({"z10": 1.0}, "unknown parameter 'z10'"),
            ({"eta": [1.0, 2.0], "V": [1.0, 2.0, 3.0]}, "do not broadcast"),
            *(
                ({"eta": eta}, "parameter eta")
                for eta in (
                    "one", ["one", "two"], 1 + 1j, np.array([1 + 1j, 2]), [[1.0], [1.0, 2.0]],
                    {"a": 1}, [True, False], np.array(["2020-01-01"], dtype="datetime64[D]"),
                )
            ),
            ({"eta": None}, "eta"),
        )
    ),
    *(
        ({"parameters": {"V": [1.0]}, **options}, named)
        for options, named in (
            ({"threads": 0}, "threads = 0"),
            ({"threads": -2}, "threads = -2"),
            ({"chunk": 0}, "chunk = 0"),
            ({"digits": 20, "unknown": "e1"}, "unknown and digits: of one parameter point only"),
            ({"symmetry": {"x": "-x"}}, "symmetry: of one parameter point only"),
        )
    ),
]  # fmt: skip
COMPOSED = [
    ({"itinerary": []}, "no phase"),
    ({"itinerary": [("stick-stick",)], "guess": [1]}, "itinerary takes"),
    ({"itinerary": [PHASES[0], PHASES[2]], "guess": [1, 1]}, "from stick-stick to slip-slip"),
    ({"itinerary": [("stik", "first-breaks-forward")], "guess": [1]}, "unknown configuration"),
    ({"itinerary": [("stick-stick", "first-reaches-belt")], "guess": [1]}, "unknown boundary"),
    ({"orbit": "dry-frictoin"}, "dry-friction"),
    ({"parameters": {"chi": 0.5}}, "needs a value"),
    ({"parameters": STICKING | {"chi": 2}}, "chi"),
    ({"guess": None}, "takes a guess"),
    ({"guess": [1, 2, 3]}, "3 values: it takes 4"),
    ({"guess": [1, 2, 3, math.nan]}, "finite"),
    ({"guess": [1, 2, 3, -1]}, "positive"),
    ({"guess": {"tau1": 1, "tau2": 2, "tau3": 1}}, "no tau4"),
    ({"guess": {"tau": 1}}, "unknown variable"),
    ({"guess": [*GUESS, 1, 2]}, "6 values: it takes 4"),
    ({"guess": [*GUESS, 1, 2, 3, math.inf]}, "finite"),
    ({"digits": 0}, "digits"),
    ({"given": {"period": -1}}, "period"),
    ({"given": {"tau1": 1}}, "exchanged"),
    ({"unknown": ["V"]}, "exchanged"),
    ({"parameters": MANY | {"eta": [1, 2, 3]}}, "broadcast"),
    ({"parameters": MANY | {"W": [1, 2]}}, "unknown parameter"),
    ({"parameters": STICKING | {"V": ["a"]}}, "V"),
    ({"parameters": {"V": [1.0]}}, "needs a value"),
    ({"parameters": MANY, "guess": np.ones((3, 4))}, "broadcast"),
    ({"parameters": MANY, "threads": 0}, "threads"),
    ({"parameters": MANY, "given": {"period": -1.0}}, "period"),
]


@pytest.mark.parametrize(
    ("base", "changes", "told"),
    [
        *((KERNELS, *row) for row in (*NAMED, *NAMED_MANY)),
        *((TABLES, *row) for row in COMPOSED),
    ],
)
def test_what_is_wrong_is_named_on_one_line(base, changes, told):
    with pytest.raises(ns.InputError, match=told) as caught:
        ns.solve(**(base | changes))
    assert "\n" not in str(caught.value)
