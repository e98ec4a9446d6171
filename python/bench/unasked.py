"""How long work goes on without looking for Ctrl-C: unasked.py [WORD...]

Signals are answered at a look, which is a call of progress. This measures the processor time from
the call to the first look, between looks, and from the last look to the end, on one thread; other
work of the machine does not count. With words, only runs whose name contains one of them are made.
"""

from __future__ import annotations

import sys
import time
from typing import Callable

import numpy as np

import lacuna

Progress = Callable[[int, int], object]

random = np.random.default_rng(1)
million = random.random((1_000_000, 2))
rough = random.random((4000, 4000))
even = np.ones((8000, 8000))
RUNS: dict[str, Callable[[Progress], object]] = {
    "sample(0.001)": lambda told: lacuna.sample(0.001, seed=1, threads=1, progress=told),
    "sample(0.002, lines)": lambda told: lacuna.sample(
        0.002, mode="lines", seed=1, threads=1, progress=told
    ),
    "sample(n=1,000,000)": lambda told: lacuna.sample(
        n=1_000_000, seed=1, threads=1, progress=told
    ),
    "sample of 64 million pixels": lambda told: lacuna.sample(
        n=100_000, field=even, mode="cells", seed=1, threads=1, progress=told
    ),
    "stipple of 16 million pixels": lambda told: lacuna.stipple(
        rough, 100_000, threads=1, relax=1, progress=told
    ),
    "relax of 1,000,000": lambda told: lacuna.relax(
        million, iterations=1, threads=1, progress=told
    ),
    "analyze of 100,000": lambda told: lacuna.analyze(million[:100_000], progress=told),
}


def unasked(run: Callable[[Progress], object]) -> tuple[float, float, float, float]:
    """The first, the longest and the last wait for a look, and the total time."""
    begun = time.process_time()
    looks = [begun]
    run(lambda done, expected: looks.append(time.process_time()))
    ended = time.process_time()
    waits = np.diff(looks)
    return waits[0], waits.max(), ended - looks[-1], ended - begun


print("seconds:                         first  longest   last    all")
for name, run in RUNS.items():
    if len(sys.argv) == 1 or any(word in name for word in sys.argv[1:]):
        print(f"{name:30} {'%7.3f %7.3f %7.3f %7.2f' % unasked(run)}", flush=True)
