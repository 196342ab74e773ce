"""What the commands answer is what they answered when their answers were recorded.

After a change that is meant: ``python -m tests.golden.record``; to see every digit that a change
moves: ``python -m tests.golden.record --exact``.
"""

import json

import pytest

from tests.golden.comparing import agreement, differences
from tests.golden.record import ANSWERS, answers, commands

# other processors and libraries round otherwise
DIGITS = 1e-9


@pytest.mark.usefixtures("committed_derivation")
def test_commands_answer_as_recorded(tmp_path):
    recorded = json.loads(ANSWERS.read_text())
    assert [entry["command"] for entry in recorded] == commands()
    found = []
    for old, new in zip(recorded, answers(commands(), tmp_path), strict=True):
        within = agreement(old["command"], DIGITS)
        places = differences(old, json.loads(json.dumps(new)), within)
        found += [f"{old['command']}: {place}" for place in places]
    assert found == []


def test_differences_are_told():
    old = {"a": ["1.0000000001", 2, True], "checksum": "x", "b": None}
    new = {"a": ["1.0", 2, True], "checksum": "y", "b": None}
    assert list(differences(old, new, 1e-9)) == []
    assert list(differences(old, new, 0.0)) == ["/a/0: '1.0000000001' became '1.0'"]
    for other in ({"a": ["1.0", 2, 1], "b": None}, {"a": ["1.0", 2], "b": None}, {"a": new["a"]}):
        assert list(differences(new, other, 1e-9))
