"""Try to break engines and proofs by random searches, motions, starts, fits and orbits.

Fits to synthetic measurements are judged by how often their intervals hold the truth.

Exit status 1 if an engine is wrong anywhere. Wrong motions are printed with all their digits.
"""

from __future__ import annotations

import argparse
import multiprocessing
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from multiprocessing.pool import Pool

import numpy as np
from rich.console import Console
from rich.progress import Progress
from stressing_chains import chains_chunk
from stressing_derivatives import derivatives_chunk
from stressing_fits import fits_chunk
from stressing_motions import (
    ELASTIC,
    FRICTION,
    RIGID,
    Motion,
    against_integrator,
    against_proof,
    against_reference,
    random_motion,
)
from stressing_proofs import branches_chunk, proofs_chunk
from stressing_search import FAMILIES, search_chunk

TRANSITIONS = 40


@dataclass(frozen=True)
class Section:
    """A part of the stress: the task, the trials that it makes, and their usual number."""

    work: Callable[[int, int], tuple[Counter[str], list[str]]]
    chunk: int
    usual: int


def main() -> int:
    """Run the chosen sections and show what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sections", nargs="*", metavar="section", help=", ".join(SECTIONS))
    parser.add_argument("--count", type=int, help="trials of each section")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=1)
    given = parser.parse_args()
    chosen = given.sections or list(SECTIONS)
    unknown = [name for name in chosen if name not in SECTIONS]
    if unknown:
        parser.error(f"no section {', '.join(unknown)}; there are {', '.join(SECTIONS)}")
    wrong = 0
    with multiprocessing.get_context("spawn").Pool(given.processes) as pool:
        for name in chosen:
            begin = time.perf_counter()
            found, told = _run(pool, name, given.count or SECTIONS[name].usual, given.seed)
            seconds = time.perf_counter() - begin
            bad = sum(n for what, n in found.items() if what.startswith("wrong"))
            wrong += bad
            print(f"{name}: {bad} wrong; {seconds:.0f} s")
            for what, number in sorted(found.items()):
                print(f"  {number:>9}  {what}")
            for line in told[:40]:
                print(f"  {line}")
            sys.stdout.flush()
    return 1 if wrong else 0


def _run(pool: Pool, name: str, count: int, seed: int) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts and details of one section, run in chunks over the processes."""
    section = SECTIONS[name]
    tasks = [
        (name, seed, start, min(section.chunk, count - start))
        for start in range(0, count, section.chunk)
    ]
    total: Counter[str] = Counter()
    told: list[str] = []
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task(name, total=count)
        for found, lines in pool.imap_unordered(_task, tasks):
            total += found
            told += lines
            for line in lines[:5]:
                progress.console.print(line, highlight=False, soft_wrap=True)
            progress.advance(bar, section.chunk)
    return total, told


def _task(task: tuple[str, int, int, int]) -> tuple[Counter[str], list[str]]:
    name, seed, start, count = task
    return SECTIONS[name].work(hash_free_seed(name, seed, start), count)


def hash_free_seed(name: str, seed: int, start: int) -> int:
    """A seed that is the same in every process."""
    return int(np.random.SeedSequence([*name.encode(), seed, start]).generate_state(1)[0])


def _motions(seed: int, count: int, kinds: tuple[str, ...]) -> Iterator[Motion]:
    rng = np.random.default_rng(seed)
    for i in range(count):
        yield random_motion(rng, kinds[i % len(kinds)])


def _judged(
    judge: Callable[[Motion, int], tuple[str, str]], kinds: tuple[str, ...], transitions: int
) -> Callable[[int, int], tuple[Counter[str], list[str]]]:
    """A task that counts verdicts on random motions by their kind."""

    def work(seed: int, count: int) -> tuple[Counter[str], list[str]]:
        found: Counter[str] = Counter()
        told = []
        for motion in _motions(seed, count, kinds):
            verdict, detail = judge(motion, transitions)
            found[f"{verdict} ({motion.kind})"] += 1
            if verdict.startswith("wrong") or detail:
                told.append(f"{verdict}: {detail} {motion}")
        return found, told

    return work


def _searches(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Crossing searches of every family, half of them with boundaries that act when reached."""
    rng = np.random.default_rng(seed)
    found: Counter[str] = Counter()
    told: list[str] = []
    share = -(-count // (2 * len(FAMILIES)))
    for family in FAMILIES:
        for reached in (False, True):
            verdicts, lines = search_chunk(rng, family, share, reached)
            found += verdicts
            told += lines
    return found, told


SECTIONS = {
    "search": Section(_searches, 20_000, 1_000_000),
    "sequences": Section(
        _judged(against_reference, (*FRICTION, *RIGID, *ELASTIC), TRANSITIONS), 100, 20_000
    ),
    "validated": Section(
        _judged(against_proof, (*FRICTION, *RIGID, *ELASTIC), TRANSITIONS), 20, 2_000
    ),
    "integrator": Section(_judged(against_integrator, ("plain", "elastic"), 20), 5, 50),
    "chains": Section(chains_chunk, 10, 1_000),
    "fit": Section(fits_chunk, 100, 100),
    "derivatives": Section(derivatives_chunk, 5, 200),
    "certificates": Section(proofs_chunk, 20, 10_000),
    "branches": Section(branches_chunk, 5, 1_000),
}

if __name__ == "__main__":
    sys.exit(main())
