"""The checker proves the claims of a certificate, from what its file states alone.

A file states a declaration of the system and what is claimed. Each kind of file has its function:

- `check`: one orbit, in a box of unknowns, with its derivatives by parameters. `JudgedOrbit` says
  what is proved of such an orbit: that is what `certify` states, and what a file is held against;
- `check_tiles`: a map over a box of parameters, `check_branch`: a branch, also beyond its borders;
- `check_events`: single events of orbits, `check_doubling`: what is beyond a flip;
- `check_census`: all orbits of an itinerary in a box of dwell times, by a tree of its parts;
- `check_chaos`: coverings and cone conditions of sets, `check_basin`: a contracted core and what
  leads to it, `check_graph`: images of boxes of a section, and trapping regions.

A claim that is not proved raises `Failure`, an entry of the wrong shape `Malformed`. Of the rest
of the program only `core` is imported: arithmetic (Taylor models, jets, rational functions and
irrational numbers, chains of matrices), sets and flows in double precision with bounds of their
rounding, grids of boxes, errors, and what gives work to processes. None of the code that finds
or proves orbits is.

All that is claimed is proved here alone, one motion from its start too, which has no file
(`state_sets.one_motion`): others only look for what may be proved, and ask these functions, or
those for a part of a file, before they state anything.
``python -m nonsmooth.runtime.checker FILE`` checks a file.
"""

from collections.abc import Callable, Mapping

from nonsmooth.runtime.checker.counting.census import check_census
from nonsmooth.runtime.checker.orbits.events import check_events
from nonsmooth.runtime.checker.orbits.points import check
from nonsmooth.runtime.checker.ranges.beyond import check_branch
from nonsmooth.runtime.checker.ranges.doubling import check_doubling
from nonsmooth.runtime.checker.ranges.tiles import check_tiles
from nonsmooth.runtime.checker.state_sets.basin import check_basin
from nonsmooth.runtime.checker.state_sets.chaos import check_chaos
from nonsmooth.runtime.checker.state_sets.graph import check_graph
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.checker.stated.shape import Malformed

__all__ = [
    "CHECKS",
    "Failure",
    "Malformed",
    "check",
    "check_branch",
    "check_events",
    "check_tiles",
]

CHECKS: Mapping[str, Callable[..., None]] = {  # of each kind of file, by its format
    "nonsmooth region certificate": check_graph,
    "nonsmooth basin certificate": check_basin,
    "nonsmooth certified doubling": check_doubling,
    "nonsmooth certified branch": check_branch,
    "nonsmooth box certificate": check_tiles,
    "nonsmooth event certificate": check_events,
    "nonsmooth chaos certificate": check_chaos,
    "nonsmooth census": check_census,
    "nonsmooth certificate": check,
}
