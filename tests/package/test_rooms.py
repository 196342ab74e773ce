"""The docstring of each room of runtime/ lists exactly the modules that stand in it."""

import ast
import re
from pathlib import Path

import grimp
import numpy as np
import pytest
from scipy.sparse.csgraph import connected_components

from tests.places import CHECKOUT

RUNTIME = CHECKOUT / "runtime"
ROOMS = [path.parent for path in sorted(RUNTIME.rglob("__init__.py")) if path.parent.name != "face"]
ROW = re.compile(r"^`(\w+)` +(\S.*)$", re.MULTILINE)


def standing_in(room: Path) -> set[str]:
    """Modules and rooms in a room; `face` is the package `nonsmooth` itself."""
    modules = {path.stem for path in room.glob("*.py") if not path.stem.startswith("__")}
    return modules | {path.parent.name for path in room.glob("*/__init__.py")} - {"face"}


@pytest.mark.parametrize("room", ROOMS, ids=lambda room: room.relative_to(RUNTIME).as_posix())
def test_a_room_lists_its_modules(room: Path) -> None:
    text = ast.get_docstring(ast.parse((room / "__init__.py").read_text(encoding="utf-8")))
    assert text, f"{room} does not say what it is"
    first, listed = text.split("\n")[0], [name for name, _ in ROW.findall(text)]
    assert len(first.split()) > 4, f"{room}: a stranger does not recognise it by {first!r}"
    assert first.endswith(".")
    assert len(listed) == len(set(listed))
    assert set(listed) == standing_in(room)


@pytest.mark.parametrize("room", ["derive", "runtime"])
def test_no_modules_import_each_other_in_a_circle(room: str) -> None:
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
