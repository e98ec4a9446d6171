"""Times scipy.stats.qmc.PoissonDisk and lacuna side by side: beside_scipy.py [RADIUS] [SETS OF SCIPY]

Prints the median wall-clock time of a set; each set has another seed. The libraries take turns, so
that a busy machine slows both. Run it on a machine that does nothing else.
"""

from __future__ import annotations

import statistics
import sys
import time
from typing import Callable

import numpy as np
import numpy.typing as npt
from scipy.stats import qmc as scipy_qmc

import lacuna
from lacuna import qmc

Points = npt.NDArray[np.float64]
OURS_TO_ONE_OF_THEIRS = 40
CALLS_FOR_OVERHEAD = 2000


def timed(make: Callable[[int], Points], seed: int) -> tuple[float, Points]:
    begun = time.perf_counter()
    points = make(seed)
    return time.perf_counter() - begun, points


def many(radius: float, first: int) -> tuple[float, Points]:
    """The seconds per set of one call that makes all sets of a turn."""
    begun = time.perf_counter()
    made = lacuna.sample_many(range(first, first + OURS_TO_ONE_OF_THEIRS), radius)
    return (time.perf_counter() - begun) / len(made), made[-1].points


def overhead() -> float:
    """The time that a call of about 300 points takes in addition to the C++ call in it."""
    spent = []
    for seed in range(CALLS_FOR_OVERHEAD):
        begun = time.perf_counter()
        made = lacuna.sample(0.048, seed=seed, threads=1)
        spent.append(time.perf_counter() - begun - made.seconds["total"])
    return statistics.median(spent)


def main() -> None:
    radius = float(sys.argv[1]) if len(sys.argv) > 1 else 0.01
    sets = int(sys.argv[2]) if len(sys.argv) > 2 else 5

    def theirs(seed: int) -> Points:
        engine = scipy_qmc.PoissonDisk(2, radius=radius, rng=np.random.default_rng(seed))
        filled: Points = engine.fill_space()
        return filled

    ours: dict[str, Callable[[int], Points]] = {
        "lacuna.sample": lambda seed: lacuna.sample(radius, seed=seed).points,
        "lacuna.sample, threads=1": lambda seed: lacuna.sample(radius, seed=seed, threads=1).points,
        "lacuna.qmc.PoissonDisk": lambda seed: qmc.PoissonDisk(
            2, radius=radius, rng=seed
        ).fill_space(),
    }
    everybody = {"scipy.stats.qmc.PoissonDisk": theirs, **ours}
    names = [*everybody, "lacuna.sample_many, a set"]
    seconds: dict[str, list[float]] = {name: [] for name in names}
    counts: dict[str, list[int]] = {name: [] for name in names}
    last: dict[str, Points] = {}
    for name, make in ours.items():
        make(sets * OURS_TO_ONE_OF_THEIRS)  # not timed: the first call starts the threads
    for turn in range(sets):
        for name, make in everybody.items():
            for again in range(1 if make is theirs else OURS_TO_ONE_OF_THEIRS):
                spent, last[name] = timed(make, turn * OURS_TO_ONE_OF_THEIRS + again)
                seconds[name].append(spent)
                counts[name].append(len(last[name]))
        spent, last[names[-1]] = many(radius, turn * OURS_TO_ONE_OF_THEIRS)
        seconds[names[-1]].append(spent)
        counts[names[-1]].append(len(last[names[-1]]))

    slowest = statistics.median(seconds["scipy.stats.qmc.PoissonDisk"])
    print(f"radius {radius}, median of a set: seconds, least, times faster; points; verify")
    for name in names:
        middle, least = statistics.median(seconds[name]), min(seconds[name])
        verdict = lacuna.verify(last[name], radius)
        said = "maximal" if verdict.maximal else f"a spot {verdict.largest_gap_distance:.4f} from all"
        print(
            f"{name:28} {middle:9.5f} {least:9.5f} {slowest / middle:7.0f}"
            f" {statistics.mean(counts[name]):8.0f}   {said}"
        )
    print(f"a call of some 300 points takes {1000 * overhead():.3f} ms besides the C++ call in it")


main()
