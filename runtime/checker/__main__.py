"""Check one file: ``python -m nonsmooth.runtime.checker FILE``."""

import json
import sys

from nonsmooth.runtime.checker import (
    check,
    check_basin,
    check_branch,
    check_census,
    check_chaos,
    check_doubling,
    check_events,
    check_graph,
    check_tiles,
)

with open(sys.argv[1], encoding="utf-8") as file:
    content = json.load(file)
if "edges" in content:
    check_graph(content)
elif "ranks" in content:
    check_basin(content)
elif "doubled" in content:
    check_doubling(content)
elif "unknown_names" in content:
    check_branch(content)
elif "tiles" in content:
    check_tiles(content)
elif "events" in content:
    check_events(content)
elif "h_sets" in content:
    check_chaos(content)
elif "orbits" in content:
    check_census(content)
else:
    check(content)
print("every claim is proved")
