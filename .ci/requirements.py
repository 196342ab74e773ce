"""Print what pip installs for a quick part of the suite: requirements of pyproject.toml.

`lowest` is the lowest version of each that is allowed; `newest` leaves the versions to pip, and
what only the documentation and the tests need to others. Without PyTorch and JAX: they are large,
and this part of the suite does not use them.
"""

import re
import sys
import tomllib
from pathlib import Path

LEFT = {"lowest": ("jax", "torch"), "newest": ("docs", "jax", "test", "torch")}

versions = sys.argv[1]
project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
extras = project["optional-dependencies"]
groups = [project["dependencies"], *(extras[n] for n in extras if n not in LEFT[versions])]
for requirement in sorted({requirement for group in groups for requirement in group}):
    bound = re.fullmatch(r"([\w-]+(?:\[\w+\])?)>=([\w.]+)", requirement)
    if bound and versions == "lowest":
        print(f"{bound[1]}=={bound[2]}")
    elif bound:
        print(requirement)
