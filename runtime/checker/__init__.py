"""The check of certificates, from nothing but their files and ball arithmetic.

A certificate holds a declaration, an itinerary, a box of unknowns or tiles of parameters, and
what is claimed. Here all of it is proved again, of a census each orbit, apart from the program
that wrote it: of that only the arithmetic is imported, Taylor models, jets, rational functions,
and sets in double precision with their linear flows, and what gives parts to processes.
The prover asks the same functions before it states anything.
The table is in the order in which to read.
``python -m nonsmooth.runtime.checker FILE`` checks a file.

==============  ===========================================================
`exact`         numbers as they are stated, and exact arithmetic of rows
`shape`         what the files hold, entry by entry
`declared`      what is declared, and what follows from it without rounding
`contacts`      transitions of a contact law, derived again
`parameters`    the values of what the declaration is a function of
`short`         equations and maps that are regular where a phase vanishes
`orbit`         existence, enclosures, the Poincare map
`stability`     multipliers against the unit circle
`vanishing`     functions of the state that vanish because an orbit closes
`motion`        admissibility
`derivatives`   derivatives of an orbit by its parameters
`points`        a certificate at one parameter point
`tiles`         a map of tiles in a box of parameters
`branch_curve`  the equations along a branch, its roots and derivatives
`divided`       a tile that the curve of an event divides
`edges`         which tiles of a plane have an edge in common
`folded`        a tile with the curve at which two orbits meet
`events`        bifurcations and limits of admissibility
`branch_tile`   one tile of a branch: a verdict, or an event
`branch`        a branch: tiles that follow each other
`beyond`        what begins at a branch's borders; the file of a branch
`doubling`      orbits of twice the period that begin at flips
`census`        orbits that were counted
`sets`          sets of states through the phases of a motion
`chaos`         sets that cover each other, and the entropy of their graph
`basin`         a set that is contracted, and boxes of starts that lead to it
`graph`         boxes, where their images lie, and what motions do not leave
`grids`         grids of boxes, and numbers that are stated of each box
`cones`         cone conditions along coverings: exponents from below
`switching`     a system whose sets may divide, and its sections
`exits`         where many sets of states leave one configuration
`portions`      portions of many sets, and how they leave a phase
`many_sets`     many sets of states, whatever ways their states go
==============  ===========================================================
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
