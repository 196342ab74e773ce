"""Count the internal names that tests import: pairs of a module below the packages and a name.

Tests of a room are to use what other rooms use of it, or the public packages: each pair is
something that a change of the inside breaks.

    python scripts/development/internal_imports.py [--list]
"""

from __future__ import annotations

import argparse
import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

TESTS = Path(__file__).resolve().parents[2] / "tests"
PUBLIC = {"nonsmooth", "nonsmooth.derive", "nonsmooth.jax", "nonsmooth.torch"}


def internal(file: Path) -> Iterator[tuple[str, str]]:
    """Yield each internal module with a name that a file imports from it, or "*" for itself."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            pairs = [(node.module or "", alias.name) for alias in node.names]
        elif isinstance(node, ast.Import):
            pairs = [(alias.name, "*") for alias in node.names]
        else:
            continue
        for module, name in pairs:
            if module.startswith("nonsmooth.") and module not in PUBLIC:
                yield module, name


def main() -> None:
    """Print how many there are, and of which rooms."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--list", action="store_true", help="each pair, and how many files use it")
    chosen = parser.parse_args()
    files = Counter(pair for file in sorted(TESTS.rglob("*.py")) for pair in set(internal(file)))
    rooms = Counter(".".join(module.split(".")[1:3]) for module, _ in files)
    print(f"{len(files)} pairs of {len({module for module, _ in files})} modules")
    for room, count in rooms.most_common():
        print(f"{count:6} {room}")
    if chosen.list:
        for (module, name), count in sorted(files.items()):
            print(f"{count:4} {module} {name}")


if __name__ == "__main__":
    main()
