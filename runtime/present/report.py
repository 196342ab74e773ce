"""Orbits as JSON and as what commands tell: numbers with the digits they have."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.core.values import Value, decimal_string, flint_precision
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.refine import enclosed_trace
from nonsmooth.runtime.present.told import Listing, Rows, Told
from nonsmooth.runtime.shooting.multipliers import Stability

_LONGEST_NUMBER = 64  # beside the labels
_GROUP, _GROUPS_IN_LINE = 10, 5
_RANKS = {1: "one", 2: "two", 3: "three"}


def derivatives_json(
    orbit: Orbit, by: Sequence[str], digits: int | None = None
) -> dict[str, dict[str, str]]:
    """Derivatives of an orbit's results by some of its given numbers, as decimal strings.

    The results are the unknowns, ``period``, ``trace``, ``determinant`` and
    ``spectral_radius``; derivatives that do not exist are left out. At a border collision
    they are those on the side that the report names. `digits` may be fewer than the orbit
    has. `InputError` is raised as by `Orbit.derivatives`.
    """
    shown = orbit.digits if digits is None else min(digits, orbit.digits)
    found = orbit.derivatives(by, one_sided=True)
    told: dict[str, dict[str, str]] = {}
    for name in (*found.unknowns, "period", "trace", "determinant", "spectral_radius"):
        rates = found.quantity(name)[1].tolist()
        if all(rate == rate for rate in rates):
            told[name] = {
                parameter: decimal_string(rate, shown)
                for parameter, rate in zip(found.by, rates, strict=True)
            }
    return told


def orbit_json(orbit: Orbit, digits: int | None = None) -> dict[str, Any]:
    """An orbit with stability and admissibility as JSON; numbers are decimal strings.

    `unknowns` are what was solved for and `parameters` what was given, with three digits
    more than the error bound 10^-digits max(1, |x|) needs. `digits` may be fewer than the
    orbit has. `InputError` is raised if there is no orbit.
    """
    shown = orbit.digits if digits is None else min(digits, orbit.digits)

    def text(number: Any) -> str:
        return decimal_string(number, shown)

    stability = orbit.stability
    shift = {name: text(orbit.shift[name]) for name in orbit.evaluation.free_states}
    found = {
        "orbit": orbit.name,
        "parameters": {name: text(orbit.values[name]) for name in orbit.given}
        | dict(orbit.problem.required)
        | {name: text(float(value)) for name, value in orbit.opened.items()},
        "unknowns": {name: text(value) for name, value in orbit.unknowns.items()},
        "period": text(orbit.period),
        **({"shift": shift} if shift else {}),
        "residual": short(orbit.residual),
        "digits": shown,
        "multipliers": multipliers_json(stability, text),
        "trace": text(stability.trace),
        "margin": text(stability.margin),
        "stability": stability.verdict,
        **({"one_sided": stability.one_sided} if stability.one_sided else {}),
        **admissibility_json(orbit),
    }
    if orbit.symmetry is not None:
        found["part_multipliers"] = multipliers_json(orbit.part_stability, text)
    phases = zip(orbit.itinerary, orbit.dwell_time_names, strict=True)
    found["phases"] = [
        {"configuration": configuration, "boundary": boundary, "dwell_time": name}
        for (configuration, boundary), name in phases
    ]
    return found


def multipliers_json(stability: Stability, text: Callable[[Any], str]) -> list[dict[str, Any]]:
    """Multipliers as JSON, whose parts are spelled by a function."""
    return [
        {"re": text(m.real), "im": text(m.imaginary), "trivial": m.trivial}
        for m in stability.multipliers
    ]


def trace_proof_json(orbit: Orbit) -> dict[str, Any]:
    """What is proved of the trace of a refined orbit, as JSON.

    `trace` is its enclosure, ``{"mid", "rad"}``, over a box around the orbit that holds exactly
    one, or None. `statement` is the criterion of stability: |trace| < 1 if the map has rank one
    and keeps no energy, |trace - 1| < 2 if its multipliers are 1, mu and 1/mu by the
    derivation (then it is neutral); of an orbit by tables that every
    nontrivial multiplier is inside the unit circle, or on it where the orbit is neutral.
    `verdict` says whether it is "proved", "refuted" or "undecided"; both are None where
    there is no criterion. `one_sided` says whether all of it is about one side of a border
    collision. `reason` is there where something is left open: why there is no enclosure or no
    certificate, or why a certificate does not prove existence or stability.
    """
    from nonsmooth.runtime.proof.certify_orbit import MOST_BITS

    bits = min(math.ceil(orbit.digits * math.log2(10)) + 16, MOST_BITS)
    return (_proof_by_kernels if orbit.problem.derived else _proof_by_certificate)(orbit, bits)


def _proof_by_kernels(orbit: Orbit, bits: int) -> dict[str, Any]:
    """What the trace of the kernels decides over the box that Krawczyk's test proves."""
    from nonsmooth.runtime.checker.orbits.stability import TANGENTIAL
    from nonsmooth.runtime.proof.certificate import Stated

    table, ball, reason = orbit.kernels.table, enclosed_trace(orbit), ""
    if ball is None:
        reason = "no box around it is shown to hold exactly one orbit"
    elif not ball.is_finite():
        reason = TANGENTIAL
    statement, verdict, centre, radius = None, None, 0, 1
    if table["rank"] == 1 and not table["conservative"]:
        statement = "|trace| < 1"
    elif table["reciprocal_pair"]:
        statement, centre, radius = "|trace - 1| < 2", 1, 2
    if statement is not None:
        verdict = "undecided"
        with flint_precision(bits):
            distance = None if reason else abs(ball - centre)
            if distance is not None and distance < radius:
                verdict = "proved"
            elif distance is not None and distance > radius:
                verdict = "refuted"
    return {
        "trace": None if reason else Stated.around(ball, bits).to_json(),
        "statement": statement,
        "verdict": verdict,
        "one_sided": bool(orbit.stability.one_sided),
        **({"reason": reason} if reason else {}),
    }


def _proof_by_certificate(orbit: Orbit, bits: int) -> dict[str, Any]:
    """What a certificate claims of trace and multipliers; there the rank is not used."""
    from nonsmooth.runtime.checker.orbits.stability import CORNER
    from nonsmooth.runtime.proof.certify_orbit import certify

    proof: dict[str, Any] = {"trace": None, "statement": None, "verdict": None, "one_sided": False}
    try:
        certificate = certify(orbit, bits)
    except InputError as problem:  # the system is not stated exactly
        return proof | {"reason": str(problem)}
    trace, reasons = certificate.enclosures.get("trace"), certificate.reasons
    reason = reasons.get("existence") or reasons.get("stability")
    if trace is not None:
        proof["trace"] = trace.to_json()
    if reason == CORNER:
        proof["one_sided"] = True
    elif certificate.claims["existence"] == "proved":
        side = {"stable": "inside", "neutral": "on"}[certificate.stability]
        proof["statement"] = f"every nontrivial multiplier is {side} the unit circle"
        proof["verdict"] = certificate.claims["stability"]
    return proof | ({"reason": reason} if reason else {})


def admissibility_json(orbit: Orbit) -> dict[str, Any]:
    """The verdict on a converged orbit as JSON, with violations, or bounds on open parameters.

    Phases are counted from 1.
    """
    admissibility = orbit.admissibility
    verdict = admissibility.verdict
    parts: dict[str, Sequence[Any]] = {
        "violations": admissibility.violations if verdict is False else (),
        "requires": admissibility.requires if verdict == "conditional" else (),
        "coincidences": admissibility.coincidences,
    }
    told = {name: [encode(each) for each in found] for name, found in parts.items() if found}
    return {"admissible": verdict, **told}


def short(number: Any) -> str:
    """Decimal text of a small number to three digits, of which the size is what counts."""
    from mpmath import mp

    return str(mp.nstr(mp.mpf(number), 3))


def tell_report(
    orbit: Orbit, found: Mapping[str, Any], assigned: Mapping[str, Value], absent: str
) -> Told:
    """An orbit as `solve` and `verify` tell it: what is given, unknowns, stability, admissibility.

    `found` is the orbit as JSON, `assigned` has the parameters as the user gave them, and
    `absent` says where the others come from, such as "default". Where something is proved of
    the trace the criterion of stability comes before the orbit.
    """
    numbers = {**found["unknowns"], **_forcing_phases(orbit, found["digits"])}
    numbers |= {"period": found["period"], "residual": found["residual"]}
    numbers |= {f"{name} moves by": text for name, text in found.get("shift", {}).items()}
    rates = found.get("derivatives", {})
    by = list(next(iter(rates.values()), ()))
    rows = [(quantity, *(own[name] for name in by)) for quantity, own in rates.items()]
    parts: list[tuple[str, Sequence[str] | Listing]] = [
        ("given", Listing(("Given", "", ""), [*_sources(orbit, found, assigned, absent)])),
        ("orbit", Listing(("Orbit", ""), [(name, _digits(x)) for name, x in numbers.items()])),
    ]
    parts.insert(0 if "proof" in found else 2, ("stability", _criterion(orbit, found)))
    way = [*(configuration for configuration, _ in orbit.itinerary), "..."]
    return f"{shown_name(found['orbit'])}, {found['digits']} digits", [
        ("itinerary", [" -> ".join(way)]),
        *parts,
        ("derivatives", Listing(("Derivatives", *(f"by {name}" for name in by)), rows)),
        *admissibility_rows(found),
    ]


def admissibility_rows(found: Mapping[str, Any]) -> Rows:
    """Rows with a verdict, what it requires, and what violates it; `found` is as JSON."""
    answer = {True: "yes", False: "no"}.get(found["admissible"], str(found["admissible"]))
    wanted = [
        f"{bound['parameter']} > {float(bound['greater_than']):.10g}"
        for bound in found.get("requires", ())
    ]
    violations = [
        (
            *(str(each[name]) for name in ("phase", "configuration", "boundary")),
            *(f"{float(each[name]):.6g}" for name in ("time", "excess")),
        )
        for each in found.get("violations", ())
    ]
    meetings = [
        f"{' and '.join(each['boundaries'])} at t = {float(each['time']):.10g}"
        for each in found.get("coincidences", ())
    ]
    titles = ("phase", "configuration", "boundary", "crossed at", "excess")
    return [
        ("admissible", [answer]),
        ("it takes", wanted),
        ("violations", Listing(titles, violations)),
        ("coincide", meetings),
    ]


def _forcing_phases(orbit: Orbit, digits: int) -> dict[str, str]:
    """Text of the phase of each forcing at the start."""
    start = orbit.states[0]
    return {
        "forcing phase" if number == 1 else f"forcing phase {number}": decimal_string(
            orbit.arithmetic.mp.atan2(start[sine], start[cosine]), digits
        )
        for number, (cosine, sine) in enumerate(orbit.problem.forcing, 1)
    }


def _sources(
    orbit: Orbit, found: Mapping[str, Any], assigned: Mapping[str, Value], absent: str
) -> Iterator[tuple[str, str, str]]:
    """Give name and text of each given parameter, and where its value comes from."""
    for name, value in assigned.items():
        yield name, str(value), ""
    following = orbit.problem.followers(assigned)
    for name, value in {**orbit.given, **orbit.opened}.items():
        if name in assigned:
            continue
        if name in following:
            yield name, found["parameters"][name], "follows"
        elif name in orbit.problem.unknown_names:
            yield name, str(value), "in place of an unknown"
        else:
            yield name, str(value), "given" if name == PERIOD else absent


def _criterion(orbit: Orbit, found: Mapping[str, Any]) -> Listing:
    """Trace, multipliers and verdict: the trace's alone where the map has rank one."""
    derived, rank, verdict = orbit.problem.derived, orbit.stability.rank, found["stability"]
    trivial = any(m["trivial"] for m in found["multipliers"])
    rank_one = derived and rank == 1 and not trivial
    exactly = "exactly" if derived else "to these digits"
    zero = f"0 {exactly}: the Poincare map has rank {_RANKS.get(rank, rank)}"
    rows = [("trace", found["trace"])]
    if rank_one:
        rows.append(("|trace| - 1", decimal_string(-orbit.stability.margin, found["digits"])))
    for number, multiplier in enumerate(found["multipliers"], 1):
        label = f"multiplier {number}"
        if number > rank:
            rows.append((label, zero))
        elif not rank_one:
            rows.append((label, multiplier["re"] + " (trivial)" * multiplier["trivial"]))
            if multiplier["im"].strip("-0."):
                rows.append((" + i times", multiplier["im"]))
    if rank_one:
        reasons = {"stable": "|trace| < 1", "unstable": "|trace| > 1"}
    else:
        rows.append(("margin", found["margin"]))
        reasons = {
            "stable": "nontrivial multipliers inside the unit circle",
            "neutral": "nontrivial multipliers on the unit circle",
            "unstable": "a multiplier outside the unit circle",
        }
    told = f"{verdict}: the margin is zero to these digits, ask for more"
    if verdict in reasons:
        told = f"{'conditionally ' * (verdict == 'stable')}{verdict} ({reasons[verdict]})"
    rows.append(("verdict", told))
    if verdict == "stable":
        rows.append(("", "under perturbations that keep the order of the switches"))
    if "proof" in found:
        rows += _proved(found)
    if "one_sided" in found:
        rows.append(("", f"one-sided: a border collision, on the side {found['one_sided']}"))
    title = "Trace criterion" if rank_one else "Stability"
    return Listing((title, ""), [(name, _digits(text)) for name, text in rows])


def _proved(found: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Give what is enclosed and proved of the trace, and how far two arithmetics differ."""
    proof = found["proof"]
    if "difference" in found:
        compared = " and ".join(found["compared"])
        yield "difference", f"{found['difference']} between balls and mpmath, of {compared}"
    if proof["trace"] is None:
        yield "enclosure", f"none: {proof['reason']}"
        return
    yield "enclosure", format(Decimal(proof["trace"]["mid"]), "f")
    yield "      +/-", proof["trace"]["rad"]
    if proof["statement"] is not None:
        yield proof["verdict"], proof["statement"]
        yield "", "for the one orbit in a box around it"
    if "reason" in proof:
        yield "", proof["reason"]
    if proof["one_sided"]:
        yield "", "on one side of a border collision"


def _digits(text: str) -> str:
    """A number in several lines of groups of digits if it is too long for one; words stay."""
    if len(text) <= _LONGEST_NUMBER or " " in text:
        return text
    mantissa, letter, exponent = text.partition("e")
    whole, _, fraction = mantissa.partition(".")
    groups = [fraction[i : i + _GROUP] for i in range(0, len(fraction), _GROUP)]
    lines = [
        " ".join(groups[i : i + _GROUPS_IN_LINE]) for i in range(0, len(groups), _GROUPS_IN_LINE)
    ]
    return "\n".join([f"{whole}.", *lines]) + letter + exponent
