"""The check of certificates, from nothing but their files and ball arithmetic.

A certificate holds a declaration, an itinerary, a box of unknowns or tiles of parameters, and
what is claimed. Here all of it is proved again, of a census each orbit, apart from the program
that wrote it: of that only the arithmetic is imported, Taylor models, jets, rational functions,
and sets in double precision with their linear flows, and what gives parts to processes.
The prover asks the same functions before it states anything, but for basins and graphs.
``python -m nonsmooth.runtime.checker FILE`` checks a file.
"""

from nonsmooth.runtime.checker.basin import check_basin
from nonsmooth.runtime.checker.beyond import check_branch
from nonsmooth.runtime.checker.census import check_census
from nonsmooth.runtime.checker.chaos import check_chaos
from nonsmooth.runtime.checker.doubling import check_cascade
from nonsmooth.runtime.checker.events import check_events
from nonsmooth.runtime.checker.exact import Failure
from nonsmooth.runtime.checker.graph import check_graph
from nonsmooth.runtime.checker.points import check
from nonsmooth.runtime.checker.shape import Malformed
from nonsmooth.runtime.checker.tiles import check_tiles

__all__ = [
    "Failure",
    "Malformed",
    "check",
    "check_basin",
    "check_branch",
    "check_cascade",
    "check_census",
    "check_chaos",
    "check_events",
    "check_graph",
    "check_tiles",
]
