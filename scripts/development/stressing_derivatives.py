"""Derivatives of random motions against central differences in fifty digits."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))

from tests.moved_motions import compared_at_random

TRANSITIONS = 200
ALLOWED = 1e-9  # in units of the motion's condition


def derivatives_chunk(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts on random oscillators, and details of those that do not agree."""
    verdicts: Counter[str] = Counter()
    told = []
    for place in range(count):
        random, name = np.random.default_rng([seed, place]), f"random-{seed}-{place}"
        try:
            missed = compared_at_random(random, name, TRANSITIONS)
        except RuntimeError as error:  # the sequence of configurations is another one in digits
            verdicts["set aside"] += 1
            told.append(f"set aside: seed [{seed}, {place}], {error}")
            continue
        verdict = "refused" if missed is None else "agree" if missed < ALLOWED else "wrong"
        verdicts[verdict] += 1
        if verdict == "wrong":
            told.append(f"wrong: seed [{seed}, {place}], off by {missed:.1e} of the condition")
    return verdicts, told
