"""Certify what is beyond flips: the side and verdict of the doubled orbits, flip after flip."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.composed_family import composed_family
from nonsmooth.runtime.proof.branch.certify_branch import MOST_TILES
from nonsmooth.runtime.proof.doubling.cascade_steps import CascadeSteps
from nonsmooth.runtime.proof.doubling.certified_cascade import (
    CertifiedCascade,
)

__all__ = ["certify_cascade"]


def certify_cascade(
    branch: Branch,
    *,
    doublings: int = 1,
    flip: int = 1,
    interval: tuple[object, object] | None = None,
    tiles: int = MOST_TILES,
    seconds: float = math.inf,
    resume: CertifiedCascade | None = None,
    progress: Callable[[float, int], object] = lambda share, doublings: None,
    keep: Callable[[CertifiedCascade], object] | None = None,
) -> CertifiedCascade:
    """Prove what is beyond a flip: the orbits of twice the period, their side and stability.

    Next to the flip, where the equations of the doubled orbit are singular, other equations are
    solved that are not, over an amplitude that begins at zero. From there on the doubled orbits
    are a branch like any other; its own next flip is gone beyond in its turn.

    Parameters
    ----------
    branch : Branch
        Its orbit and its parameter are taken, and where its flips are, about.
    doublings : int, default 1
        How many flips are gone beyond, one after the other.
    flip : int, default 1
        Which flip of the branch is the first, counted from 1.
    interval : tuple of (number or str, number or str), optional
        Ends of the parameter, rational numbers; those of the branch by default.
    tiles : int
        At most so many are proved of each doubled branch, those of `resume` among them.
    seconds : float
        Behind the first tile that ends after this time nothing is begun.
    resume : CertifiedCascade, optional
        What was proved before of the same branch.
    progress : function of a float and an int, optional
        Is told about which share of the time has passed, and how many doublings are proved.
    keep : function of a CertifiedCascade, optional
        Is given the state after each doubling, and every ten seconds along a branch.

    Returns
    -------
    CertifiedCascade
        Its claim is "proved" if there are as many doublings as were asked for, all with a
        verdict; its `ended` and `end` say why there are not so many.

    Raises
    ------
    InputError
        For what is no branch, or has no such flip, or a state of another branch.
    Interrupted
        By Ctrl-C; its `partial` is the state, which `resume` takes.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/symmetric", {"V": "1.05"})
    >>> branch = ns.continue_orbit(orbit, "V", (1, 1.2))
    >>> found = ns.certify_cascade(branch, tiles=2)
    >>> found.kind(0), found.doublings[0].side, found.doublings[0].verdict
    ('subcritical', 'above', 'unstable')
    """
    if not isinstance(branch, Branch):
        raise InputError(f"{branch!r} is no branch, such as continue_orbit gives")
    for name, count in (("doublings", doublings), ("flip", flip), ("tiles", tiles)):
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise InputError(f"{name} = {count!r} is not a positive integer")
    if not seconds > 0:
        raise InputError(f"seconds = {seconds!r} is not a positive number")
    if not isinstance(resume, CertifiedCascade | None):
        raise InputError(f"{resume!r} is no state to resume: load reads one")
    flips = [event for event in branch.events if event.kind == "flip"]
    if len(flips) < flip:
        told = f"{len(flips) or 'no'} {'flip' if len(flips) == 1 else 'flips'}"
        raise InputError(f"the branch has {told}: there is no flip {flip} to go beyond")
    event = flips[flip - 1]
    base, _ = composed_family(branch, round(event.place), None)
    if branch.parameter not in base.parameters:
        raise InputError(f"{branch.parameter} is no parameter of {base.system.name}")
    if interval is None:
        values = branch.parameter_values
        interval = as_value(float(values.min())), as_value(float(values.max()))
    lower, upper = (as_value(end).exact for end in interval)
    if lower is None or upper is None or not lower < upper:
        raise InputError("the interval has no two rational ends, the lower one first")
    # by the tables an orbit has no name of its own; phases that take no time are left out
    name = branch.orbit.name if base.itinerary == branch.orbit.itinerary else base.name
    work = CascadeSteps(
        name,
        base,
        branch.parameter,
        (lower, upper),
        event.value,
        asked=doublings,
        tiles=tiles,
        seconds=seconds,
        progress=progress,
        keep=keep,
    )
    state = work.begun(resume)
    try:
        while state.ended == "unfinished" and not work.over:
            state = work.next(state)
    except KeyboardInterrupt:
        raise Interrupted(state) from None
    if work.stopped:
        raise Interrupted(state)
    if state.ended == "unfinished":
        state = replace(state, end=f"the {seconds:g} s that were given are over")
    progress(1.0, len(state.doublings))
    return state
