"""Print the lowest version of each dependency that pyproject.toml allows, as pip's requirements."""

import re
import tomllib
from pathlib import Path

project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
groups = [project["dependencies"], *project["optional-dependencies"].values()]
for requirement in sorted({requirement for group in groups for requirement in group}):
    if bound := re.fullmatch(r"([\w-]+(?:\[\w+\])?)>=([\w.]+)", requirement):
        print(f"{bound[1]}=={bound[2]}")
