"""Certificates of random orbits against refined orbits, the engine, multipliers and their files."""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from mpmath import mpf, workdps

import nonsmooth as ns
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.check_file import check_certificate
from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch
from nonsmooth.runtime.proof.certificate import Certificate

sys.path.insert(0, str(Path(__file__).parents[2]))

from tests.moved_motions import random_oscillator

PERIODS = 80  # of the forcing, after which most motions have settled
DIGITS = 60  # of the orbit that the enclosures have to hold
NEAR = 1e-6  # of a motion's size: how near it comes back in doubles
TILES = 60  # of a branch
POINTS = 3  # of a branch, at which it is judged


def proofs_chunk(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts on random oscillators, and details of those that are wrong."""
    verdicts: Counter[str] = Counter()
    told = []
    for place in range(count):
        orbits = 0
        for orbit in _orbits(np.random.default_rng([seed, place]), f"random-{seed}-{place}"):
            orbits += 1
            verdict, wrong = judged(orbit)
            verdicts[verdict] += 1
            told += [f"wrong: seed [{seed}, {place}], orbit {orbits}, {what}" for what in wrong]
            verdicts["wrong"] += bool(wrong)
        if not orbits:
            verdicts["no orbit"] += 1
    return verdicts, told


def branches_chunk(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts on parts of random branches, and details of those that are wrong."""
    verdicts: Counter[str] = Counter()
    told = []
    for place in range(count):
        rng = np.random.default_rng([seed, place])
        orbit = next(_orbits(rng, f"random-{seed}-{place}"), None)
        if orbit is None:
            verdicts["no orbit"] += 1
            continue
        parts, wrong = judged_branch(orbit, rng)
        verdicts.update(parts)
        told += [f"wrong: seed [{seed}, {place}], {what}" for what in wrong]
        verdicts["wrong"] += bool(wrong)
    return verdicts, told


def _orbits(rng: np.random.Generator, name: str) -> Iterator[Orbit]:
    """The orbit on which a random oscillator settles, and that of its itinerary beside it."""
    system, data, start = random_oscillator(rng, name)
    data["d"] = rng.uniform(0.1, 0.5)
    given = {key: f"{value:.4f}" for key, value in data.items()}
    try:
        motion = ns.simulate(system, given, start, until=PERIODS * 2 * np.pi / data["w"])
        cycle = ns.itinerary_of(motion, since=motion.end / 2)
    except ns.InputError:
        return
    orbit = ns.solve(system, given, itinerary=cycle, throw=False)
    if not orbit.converged:
        return
    yield orbit
    # beside it the orbit of the same itinerary may be no motion, or unstable
    moved = str(rng.choice([*data]))
    given |= {moved: f"{data[moved] * rng.choice([0.5, 0.8, 1.25, 2.0]):.4f}"}
    guess = [*orbit.dwell_times, *orbit.states[0]]
    try:
        beside = ns.solve(system, given, guess, itinerary=orbit.itinerary, throw=False)
    except ns.InputError:  # beyond a domain
        return
    if beside.converged:
        yield beside


def judged(orbit: Orbit) -> tuple[str, list[str]]:
    """The claims of an orbit's certificate in words, and everything in it that is not so."""
    certificate = ns.certify(orbit)
    claims = certificate.claims
    verdict = ", ".join(f"{name} {claim}" for name, claim in claims.items())
    wrong = [*_unlike_the_file(certificate)]
    if claims["existence"] == "proved":
        refined = ns.refine(orbit, DIGITS)
        with workdps(DIGITS):
            wrong += _outside(certificate, refined)
        if claims["admissibility"] != "undecided":
            follows = _follows(orbit)
            if follows is not None and follows != (claims["admissibility"] == "proved"):
                wrong.append(f"admissibility is {claims['admissibility']}, the motion says no")
        if claims["stability"] != "undecided":
            largest = max(map(abs, refined.multipliers), default=0.0)
            if (largest < 1) != (claims["stability"] == "proved"):
                wrong.append(f"stability is {claims['stability']}, a multiplier is {largest}")
    return verdict, wrong


def judged_branch(orbit: Orbit, rng: np.random.Generator) -> tuple[list[str], list[str]]:
    """Verdicts of the parts of an orbit's certified branch, and all in it that is not so.

    Of a branch that turns only the file: a parameter has several of its orbits.
    """
    parameter = str(rng.choice([*orbit.parameters]))
    value = float(orbit.parameters[parameter])
    away = abs(value) * rng.uniform(0.02, 0.2) + 1e-3
    try:
        branch = ns.continue_orbit(orbit, parameter, (value - away, value + away))
        certified = ns.certify.branch(branch, tiles=TILES)
    except ns.InputError as problem:  # beyond a domain
        return [f"refused: {str(problem)[:40]}"], []
    wrong = [*_unlike_the_file(certified)]
    turns = any(event.kind == "fold" for event in branch.events)
    for place in rng.integers(len(branch), size=0 if turns else POINTS):
        at = branch.parameter_values[place]
        ends = [sorted((part.begin, part.end)) for part in certified.intervals]
        near = NEAR * abs(value)
        if any(abs(at - end) < near for pair in ends for end in pair):
            continue
        held = [low < at < high for low, high in ends]
        verdicts = [p.verdict for p, holds in zip(certified.intervals, held, strict=True) if holds]
        if len(verdicts) == 1 and not _as_stated(verdicts[0], branch.orbit_at(int(place))):
            wrong.append(f"{parameter} = {at} is {verdicts[0]}")
    return [part.verdict for part in certified.intervals], wrong


def _as_stated(verdict: str, orbit: Orbit) -> bool:
    """Whether the engine's motion and the multipliers of an orbit are as is stated."""
    follows, largest = _follows(orbit), max(map(abs, orbit.multipliers), default=0.0)
    if verdict == "not admissible":
        return not follows
    if verdict == "undecided":
        return True
    return follows is not False and (largest < 1) == (verdict == "stable")


def _unlike_the_file(certificate: Certificate | CertifiedBranch) -> Iterator[str]:
    """What the check of a certificate's file says otherwise than the certificate."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "certificate.json"
        certificate.save(file)
        check = check_certificate(file)
    if check.difference is not None:
        yield f"its file is refused: {check.difference}"
    elif check.claims != certificate.claims:
        yield f"its file shows {check.claims}"


def _outside(certificate: Certificate, refined: Orbit) -> Iterator[str]:
    """Enclosures that do not hold the refined orbit's number."""
    numbers = {**refined.unknowns, "period": refined.period}
    for name, ball in certificate.enclosures.items():
        if name in numbers and abs(numbers[name] - mpf(ball.mid)) > mpf(ball.rad):
            yield f"{name} is {numbers[name]}, outside of {ball}"


def _follows(orbit: Orbit) -> bool | None:
    """Whether the engine's motion from the orbit's start goes its way and comes back.

    None where no motion can start there in doubles.
    """
    start = np.array([float(x) for x in orbit.states[0]])
    ways = [configuration for configuration, _ in orbit.itinerary]
    try:
        motion = ns.simulate(
            orbit.system,
            orbit.parameters,
            start.tolist(),
            configuration=ways[0],
            transitions=len(ways),
        )
    except ns.InputError:
        return None
    away = np.abs(motion.states[-1] - start).max() / np.abs(motion.states).max()
    passed = ["+".join(names) for names in motion.boundaries[1:]]
    return (
        list(motion.configurations) == [*ways, ways[0]]
        and passed == [boundary for _, boundary in orbit.itinerary]
        and bool(away < NEAR)
    )
