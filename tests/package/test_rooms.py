"""Modules say what they are, and none imports itself through others."""

import re

import grimp
import numpy as np
import pytest
from scipy.sparse.csgraph import connected_components

from tests.places import CHECKOUT

MODULES = [
    path for room in ("runtime", "derive") for path in sorted((CHECKOUT / room).rglob("*.py"))
]


@pytest.mark.slow
def test_a_module_says_in_one_sentence_what_it_is():
    first = {}
    for path in MODULES:
        said = re.match(r'r?"""(.*?)(?:"""|$)', path.read_text(encoding="utf-8"), re.MULTILINE)
        first.setdefault(said[1] if said else "", []).append(path.relative_to(CHECKOUT).as_posix())
    unsaid = {line: places for line, places in first.items() if len(line.split()) < 3}
    assert unsaid == {}
    assert {line: places for line, places in first.items() if len(places) > 1} == {}


@pytest.mark.parametrize("room", ["derive", "runtime"])
def test_no_modules_import_each_other_in_a_circle(room):
    graph = grimp.build_graph("nonsmooth", exclude_type_checking_imports=True)
    modules = sorted(name for name in graph.modules if name.startswith(f"nonsmooth.{room}."))
    place = {name: k for k, name in enumerate(modules)}
    imported = np.zeros((len(modules), len(modules)), dtype=bool)
    for name in modules:
        for other in graph.find_modules_directly_imported_by(name):
            if other in place:
                imported[place[name], place[other]] = True
    count, labels = connected_components(imported, directed=True, connection="strong")
    circles = [
        [name for name, label in zip(modules, labels, strict=True) if label == shared]
        for shared in np.flatnonzero(np.bincount(labels, minlength=count) > 1)
    ]
    assert circles == []
