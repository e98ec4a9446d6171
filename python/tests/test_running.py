"""Progress, threads and Ctrl-C during a run."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import lacuna


def test_progress_is_told_and_rises() -> None:
    told: list[tuple[int, int]] = []
    made = lacuna.sample(0.0008, seed=1, threads=1, progress=lambda *now: told.append(now))
    assert told
    assert all(0 <= done <= expected for done, expected in told)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert told[-1][0] <= len(made)


def test_what_progress_raises_ends_the_run() -> None:
    def stop(done: int, expected: int) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        lacuna.sample(0.0008, seed=1, threads=1, progress=stop)
    with pytest.raises(LookupError, match="enough"):
        lacuna.relax(np.random.default_rng(1).random((30_000, 2)), progress=stop)
    with pytest.raises(LookupError, match="enough"):
        lacuna.analyze(np.random.default_rng(1).random((20_000, 2)), progress=stop)
    assert lacuna.sample(0.1, seed=1).maximal


def test_other_threads_run_meanwhile() -> None:
    turns = 0
    done = threading.Event()

    def make() -> None:
        lacuna.sample(0.0008, seed=1, threads=1)
        done.set()

    thread = threading.Thread(target=make)
    thread.start()
    while not done.is_set():
        turns += 1
    thread.join()
    assert turns > 1000


def test_threads_may_call_at_once() -> None:
    expected = [lacuna.sample(0.01, seed=seed).sha256 for seed in range(8)]
    with ThreadPoolExecutor(8) as pool:
        for _ in range(3):
            made = pool.map(lambda seed: lacuna.sample(0.01, seed=seed).sha256, range(8))
            assert list(made) == expected
        points = lacuna.sample(0.01, seed=1)
        assert all(pool.map(lambda _: bool(lacuna.verify(points)), range(8)))
        relaxed = set(pool.map(lambda _: lacuna.relax(points, iterations=2).sha256, range(8)))
        assert len(relaxed) == 1


INTERRUPTED = """
import sys, threading, os, signal, time
import numpy as np, lacuna
kind = sys.argv[1]
many = np.random.default_rng(1).random((3_000_000, 2))
calls = {
    "sample": lambda: lacuna.sample(0.0002, seed=1),
    "lines": lambda: lacuna.sample(0.0003, mode="lines", seed=1),
    "count": lambda: lacuna.sample(n=10_000_000, seed=1),
    "field": lambda: lacuna.sample(n=3_000_000, field=many[:1000, :1] + np.ones((1000, 1000))),
    "relax": lambda: lacuna.relax(many[:1_000_000], iterations=1000),
    "verify": lambda: lacuna.verify(many, 1e-4),
    "analyze": lambda: lacuna.analyze(many),
}
lacuna.sample(0.1)
threads = threading.active_count()
at = []

def interrupt():
    time.sleep(0.4)
    at.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)

thread = threading.Thread(target=interrupt)
thread.start()
try:
    calls[kind]()
except KeyboardInterrupt:
    print("answered", time.monotonic() - at[0])
thread.join()
assert threading.active_count() == threads
assert lacuna.sample(0.1, seed=1).maximal
"""


@pytest.mark.parametrize(
    "kind", ["sample", "lines", "count", "field", "relax", "verify", "analyze"]
)
def test_an_interrupt_is_answered_and_leaves_nothing_behind(kind: str) -> None:
    run = subprocess.run(
        [sys.executable, "-c", INTERRUPTED, kind], capture_output=True, text=True, timeout=120
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith("answered"), f"{kind} was not interrupted: {run.stdout}"
    print(kind, run.stdout)


def test_a_handler_of_ones_own_is_run() -> None:
    seen: list[int] = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: seen.append(number))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        while not seen:
            lacuna.sample(0.0008, seed=1)
        assert seen == [signal.SIGALRM]
    finally:
        signal.signal(signal.SIGALRM, before)
