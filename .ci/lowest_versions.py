"""Print the lowest version of each dependency that pyproject.toml allows, as pip's requirements.

Without PyTorch and JAX: they are large, and the part of the suite that is run with these versions
does not use them.
"""

import re
import tomllib
from pathlib import Path

LARGE = ("jax", "torch")

project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
extras = project["optional-dependencies"]
groups = [project["dependencies"], *(extras[name] for name in extras if name not in LARGE)]
for requirement in sorted({requirement for group in groups for requirement in group}):
    if bound := re.fullmatch(r"([\w-]+(?:\[\w+\])?)>=([\w.]+)", requirement):
        print(f"{bound[1]}=={bound[2]}")
