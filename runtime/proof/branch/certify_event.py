"""Enclose an event of a branch: the bifurcation or the limit of admissibility near a computed one.

Newton's method proposes a box around it, and the checker judges whether that holds such an event.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from fractions import Fraction
from itertools import zip_longest
from typing import Any

from flint import arb

from nonsmooth.runtime.checker.orbits.events import JudgedEvent
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.errors import InputError, check_integer
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.saved_system import same_system
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.asking import REFUSED, Steps, as_read, proved_by_steps
from nonsmooth.runtime.proof.branch.certified_branch import EventCertificate
from nonsmooth.runtime.proof.certificate import GUARD, Unknown, file_json
from nonsmooth.runtime.proof.certify_orbit import FEWEST_BITS, MOST_BITS, refined, stated
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    Region,
    guess_of,
    region_of,
    stated_orbits,
)
from nonsmooth.runtime.proof.statement import decimals

_NEIGHBOURS = 4
_KNOWN = 1e-6  # residual of the orbit at the computed event
# how far from the computed event it is still that, in units of the unknowns
_NEAR = 1e-6  # the parameter
_ALIKE = 0.05  # the orbit, of which a neighbour may be all that is known
# when in its phase each kind of event happens, if at any; others are no regular roots
_INSTANTS = {
    **dict.fromkeys(("flip", "fold", "neimark-sacker", "vanishing-phase"), ""),
    **{"entry": "start", "tangent": "start", "grazing": "inside"},
    **{"simultaneous": "end", "condition": "end"},
}
_SHARES = (0.6, 0.75, 0.9)  # of the bits: halves of the boxes that are tried


def certify_event(branch: Branch, event: Event, bits: int = 128) -> EventCertificate:
    """Prove that there is an event of a branch near a computed one, and enclose it.

    The orbit's equations in physical coordinates are joined by what holds at the event: a
    multiplier that is -1 or 1, a boundary function that is zero where it is touched, a
    dwell time that is zero. Their unknowns are the orbit and the branch's parameter.

    Parameters
    ----------
    branch : Branch
    event : Event
        One of its events.
    bits : int
        The enclosures have about so many bits.

    Returns
    -------
    EventCertificate

    Raises
    ------
    InputError
        For an event that is not the branch's, or bits outside 53 ... 400000.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    >>> (flip,) = [event for event in branch.events if event.kind == "flip"]
    >>> found = ns.certify.event(branch, flip)
    >>> found.proved, abs(float(found.value) - flip.value) < 1e-9
    (True, True)
    """
    check_integer("bits", bits, FEWEST_BITS, MOST_BITS)
    if event not in branch.events:
        raise InputError(f"{event.text}: this is no event of the branch")
    undecided = _undecided(branch, event, bits)
    try:
        if event.kind not in _INSTANTS:
            raise NotCovered(
                f"{event.kind}: it is no regular root of the equations of the whole orbit"
            )
        orbit = _orbit_near(branch, event)
        region = _region(orbit, event)
        found = _about(undecided, orbit, event, region)
        box, enclosures = _enclosed(found, _guess(region, event))
    except (NotCovered, Failure, ArithmeticError) as reason:
        return replace(undecided, reason=str(reason))
    with flint_precision(bits + GUARD):
        told = {name: stated(x, bits) for name, x in enclosures.items()}
    return replace(found, claim="proved", enclosures=told, box=box)


def certify_events(
    branch: Branch,
    bits: int = 128,
    known: Sequence[EventCertificate] = (),
    progress: Callable[[int], object] = lambda done: None,
) -> tuple[EventCertificate, ...]:
    """Enclose all events of a branch, in their order; `bits` is as for `certify_event`.

    `known` are the certificates of its first events, from a call that was interrupted; those of
    anything else are refused. `progress` is called with the number of events that are done. By
    Ctrl-C `Interrupted` is raised, whose `partial` are the certificates until then.
    """
    for certificate, event in zip_longest(known, branch.events[: len(known)]):
        if event is None or not _is_of(certificate, _undecided(branch, event, bits)):
            raise InputError("the events to resume are not those of this branch, to these bits")
    found = list(known)

    def steps() -> Steps:
        for event in branch.events[len(known) :]:
            found.append(certify_event(branch, event, bits))
            yield (len(found),)

    return proved_by_steps(steps(), lambda: tuple(found), progress)


def _is_of(certificate: EventCertificate, asked: EventCertificate) -> bool:
    if not same_system(load_system(certificate.system), load_system(asked.system)):
        return False
    own, other = (each.orbit.removeprefix(each.system) for each in (asked, certificate))
    names = ("kind", "parameter", "phase", "configuration", "boundary", "bits")
    same = all(getattr(certificate, name) == getattr(asked, name) for name in names)
    given = {**asked.parameters, **certificate.parameters}
    return same and own == other and all(asked.parameters.get(n, v) == v for n, v in given.items())


def _undecided(branch: Branch, event: Event, bits: int) -> EventCertificate:
    orbit = branch.orbit
    ends = event.kind == "tangent" and event.time
    return EventCertificate(
        **stated_orbits(orbit, [event.parameter], (), None) | {"orbit": branch.name},
        kind=event.kind,
        text=event.text,
        parameter=event.parameter,
        phase=event.phase,
        configuration=event.configuration,
        boundary=event.boundary,
        instant="end" if ends else _INSTANTS.get(event.kind, ""),
        claim="undecided",
        reason="",
        enclosures={},
        box=(),
        bits=bits,
    )


def _about(empty: EventCertificate, orbit: Orbit, event: Event, region: Region) -> EventCertificate:
    """Return the certificate with all that the equations are made from."""
    chosen = chosen_parameters(orbit)
    orbit = replace(orbit, opened={**orbit.opened, **chosen})
    told = stated_orbits(orbit, [event.parameter], tuple(chosen), region)
    return replace(empty, **told | {"orbit": empty.orbit})


def _region(orbit: Orbit, event: Event) -> Region:
    """Return the region of the orbit over values of the parameter around the event's."""
    if not float(orbit.residual) < _KNOWN:
        raise NotCovered(f"the orbit at the event is not known well enough: {orbit.message}")
    value, own = Fraction(event.value), orbit.given[event.parameter].exact
    assert own is not None  # a double
    width = (abs(value) or Fraction(1)) / 10**6
    return region_of(orbit, {event.parameter: (min(value, own) - width, max(value, own) + width)})


def _guess(region: Region, event: Event) -> list[arb]:
    """Return about the unknowns of the event's equations."""
    subject, known = region.subject, event.unknowns
    if known.keys() >= {*subject.start_names, *subject.dwell_names}:
        subject = replace(
            subject,
            start=[arb(known[name]) for name in subject.start_names],
            dwell=[arb(known[name]) for name in subject.dwell_names],
        )
    value = arb(event.value)
    guess = guess_of(subject, region.tables, [value])
    time = [arb(float(event.time or 0.0))] if event.kind == "grazing" else []
    return [*guess, value, *time]


def _orbit_near(branch: Branch, event: Event) -> Orbit:
    """Return the orbit at an event, or the nearest one of the branch.

    The orbit at the event may have a phase of no duration, which is none of the branch's.
    """
    places: list[Any] = sorted(range(len(branch)), key=lambda k: abs(k - event.place))
    for place in (event, *places[:_NEIGHBOURS]):
        try:
            return branch.orbit_at(place)
        except InputError:
            continue
    raise NotCovered("no orbit is known near the event")


def _enclosed(
    about: EventCertificate, guess: Sequence[arb]
) -> tuple[tuple[Unknown, ...], dict[str, arb]]:
    """Return a box that the checker proves to hold the event, and enclosures of all unknowns."""
    judge, bits = JudgedEvent(as_read(file_json(about))), about.bits
    sizes = [abs(x).mid() if abs(x) > 2.0**-10 else arb(1) for x in guess]
    point = refined(judge.near, guess, bits + GUARD)
    near = [_ALIKE] * len(sizes)
    near[judge.place] = _NEAR
    if not all(
        abs(x - g) < share * size
        for x, g, share, size in zip(point, guess, near, sizes, strict=True)
    ):
        raise NotCovered("Newton's method leaves the computed event")
    for share in _SHARES:
        with flint_precision(bits + GUARD):
            unit = arb(2) ** -int(bits * share)
            box = tuple(
                Unknown(name, *decimals(x.mid() + arb(0, unit * size), bits + GUARD))
                for name, x, size in zip(judge.names, point, sizes, strict=True)
            )
        try:
            return box, judge.located([asdict(side) for side in box])
        except REFUSED as problem:
            reason = f"the checker refuses it: {problem}"
    raise NotCovered(reason)
