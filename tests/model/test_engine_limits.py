"""The limits that both engines share are said in one header."""

import re
from pathlib import Path

from nonsmooth.runtime.model import engine_run


def test_python_has_every_limit_of_the_header():
    header = Path(engine_run.__file__).parents[1] / "engine" / "engine_limits.h"
    found = re.findall(r"#define ([A-Z_]+) (\S+)", header.read_text())
    assert len(found) >= 8
    for name, number in found:
        assert getattr(engine_run, name) == float(number)
