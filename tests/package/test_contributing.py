"""CONTRIBUTING.md tells the truth: its element works, and its commands and files are there."""

import re
import sys
from importlib.util import module_from_spec, spec_from_file_location

import pytest

import nonsmooth.derive
from tests.places import CHECKOUT

PAGE = (CHECKOUT / "CONTRIBUTING.md").read_text(encoding="utf-8")
ELEMENT = "nonsmooth.derive.building.backlash"


def executed(name, text, folder):
    """A module of that name, from a file."""
    path = folder / f"{name.rpartition('.')[2]}.py"
    path.write_text(text, encoding="utf-8")
    spec = spec_from_file_location(name, path)
    module = module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def test_the_element_of_the_page_passes_its_test(tmp_path, monkeypatch):
    element, check = re.findall(r"```python\n(.*?)```", PAGE, flags=re.DOTALL)
    for name in (ELEMENT, "check_of_the_page"):  # forgotten afterwards
        monkeypatch.setitem(sys.modules, name, None)
    module = executed(ELEMENT, element, tmp_path)
    tested = executed("check_of_the_page", check, tmp_path)
    tested.test_a_mass_with_play_comes_back()
    with pytest.raises(nonsmooth.derive.DeclarationError, match="clearance is negative"):
        nonsmooth.derive.oscillator(
            "tight", ["x"], [[1]], [[0]], elements=[module.Backlash("x", 1, -1)]
        )


def test_files_of_the_page_are_there():
    named = set(re.findall(r"`((?:\.?\w[\w.-]*/)+[\w.-]*)`", PAGE))
    named -= {"derive/building/backlash.py"}  # it is the reader's
    named |= set(re.findall(r"\]\(([\w./]+)\)", PAGE))
    assert len(named) > 12
    assert [name for name in sorted(named) if not (CHECKOUT / name).exists()] == []
