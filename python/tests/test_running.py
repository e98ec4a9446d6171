"""Progress, threads and Ctrl-C during a run."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import types
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import lacuna


def test_progress_is_told_and_rises() -> None:
    told: list[tuple[int, int]] = []
    made = lacuna.sample(0.0008, seed=1, threads=1, progress=lambda *now: told.append(now))
    assert told and all(0 <= done <= expected for done, expected in told)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert told[-1][0] <= len(made)


class Bar:
    """Stands for a bar of tqdm."""

    n, total = 0, None
    bars: list[Bar] = []

    def __init__(self, **options: object) -> None:
        assert options == {"disable": None}
        self.bars.append(self)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        self.is_closed = True

    def refresh(self) -> None: ...


def test_true_shows_a_bar_if_tqdm_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    tqdm = types.ModuleType("tqdm.auto")
    tqdm.tqdm = Bar  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "tqdm.auto", tqdm)
    made = lacuna.sample(0.0015, seed=1, threads=1, progress=True)
    assert len(lacuna.sample_many(range(40), 0.02, progress=True)) == 40
    assert len(Bar.bars) == 2 and all(bar.is_closed and bar.n == bar.total for bar in Bar.bars)
    assert abs(Bar.bars[0].n - len(made)) < 0.1 * len(made)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    assert lacuna.relax(made.points[:50], iterations=1, progress=True).iterations == 1


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


# A thread that waits for the gate runs only when a call gives way: Python itself does not switch.
PROGRAM = """
import os, signal, sys, tempfile, threading, time
import numpy as np, lacuna
folder = tempfile.TemporaryDirectory()
path, saved = os.path.join(folder.name, "square.txt"), os.path.join(folder.name, "saved.csv")
with open(path, "w") as file:
    file.write("0 0\\n1 0\\n1 1\\n")
square, made = lacuna.read_polygons(path), lacuna.sample(0.1, seed=1)
few, many = (np.random.default_rng(1).random((n, 2)) for n in (50, 10_001))
ramp = np.linspace(0, 1, 16) * np.ones((16, 1))
corners, sides = np.vstack([np.eye(3), np.zeros(3)]), [(0, 1, 2), (0, 1, 3), (1, 2, 3)]
CALLS = {
    "sample": lambda: lacuna.sample(0.01, seed=1),
    "threads": lambda: lacuna.sample(0.01, seed=1, threads=5),
    "field": lambda: lacuna.sample(n=600, field=ramp, seed=1),
    "cells": lambda: lacuna.sample(n=600, field=ramp, mode="cells", seed=1),
    "sample_many": lambda: lacuna.sample_many(range(4), n=20),
    "sample_many of tiles": lambda: lacuna.sample_many([1], radius=0.1, torus=True, frame=0.2),
    "relax": lambda: lacuna.relax(few, iterations=1),
    "verify": lambda: lacuna.verify(many, 0.01, distances_only=True),
    "analyze": lambda: lacuna.analyze(few, max_frequency=0.5),
    "order": lambda: lacuna.order(few),
    "stipple": lambda: lacuna.stipple(np.eye(8), 10, relax=1, seed=1),
    "threshold_mask": lambda: lacuna.threshold_mask(32, 32),
    "domain_around": lambda: lacuna.domain_around(square),
    "draw_mask": lambda: lacuna.draw_mask(square, 0.1, domain=(1, 1)),
    "read_polygons": lambda: lacuna.read_polygons(path),
    "read_lines": lambda: lacuna.read_lines(path),
    "save": lambda: made.save(saved),
    "sample_surface": lambda: lacuna.sample_surface(corners, sides, 0.01, seed=1),
    "sample_volume": lambda: lacuna.sample_volume(0.05, seed=1),
    "verify_surface": lambda: lacuna.verify_surface(corners, corners, sides, 0.7),
    "verify_volume": lambda: lacuna.verify_volume(corners, 0.7),
    "devices": lambda: lacuna.devices(),
    "opencl": lambda: lacuna.sample(0.1, seed=1, backend="opencl"),
    "vulkan": lambda: lacuna.sample(0.1, seed=1, backend="vulkan"),
    "relax on opencl": lambda: lacuna.relax(few, iterations=1, backend="opencl"),
    "relax on vulkan": lambda: lacuna.relax(few, iterations=1, backend="vulkan"),
}
gate = threading.Lock()

def meanwhile(act):
    gate.acquire()

    def wait():
        with gate:
            act()

    thread = threading.Thread(target=wait)
    thread.start()
    sys.setswitchinterval(10**6)
    gate.release()
    return thread
"""
KINDS = re.findall(r'"([\w ]+)": lambda', PROGRAM)


def said_by(program: str, *arguments: object) -> str:
    """What the program prints after PROGRAM, in a process of its own."""
    words = [sys.executable, "-c", PROGRAM + program, *map(str, arguments)]
    run = subprocess.run(words, capture_output=True, text=True, timeout=600)
    assert run.returncode == 0, run.stderr
    return run.stdout


def skip_without(kind: str) -> None:
    name = kind.split()[-1]
    usable = {one.backend for one in lacuna.devices() if one.usable}
    if name in ("opencl", "vulkan") and name not in usable:
        pytest.skip(f"backend {name} is not there")


YIELDS = """
ran = threading.Event()
meanwhile(ran.set)
begun = time.monotonic()
while not ran.is_set() and time.monotonic() - begun < 100:  # on a busy machine it wakes up late
    CALLS[sys.argv[1]]()
print(ran.is_set())
"""


def test_calls_are_of_all_functions() -> None:
    functions = {name for name in lacuna.__all__ if not isinstance(getattr(lacuna, name), type)}
    assert {kind.split()[0] for kind in KINDS} >= functions


@pytest.mark.parametrize("kind", KINDS)
def test_other_threads_run_meanwhile(kind: str) -> None:
    skip_without(kind)
    assert said_by(YIELDS, kind) == "True\n"


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


THREADS = """
def threads():
    with open("/proc/self/status") as status:
        return int(next(line for line in status if line.startswith("Threads")).split()[1])

for _ in range(10):
    CALLS[sys.argv[1]]()
before = threads()
for _ in range(int(sys.argv[2])):
    CALLS[sys.argv[1]]()
print(threads() - before)
"""


@pytest.mark.parametrize("kind", KINDS)
def test_calls_leave_no_threads_behind(kind: str) -> None:
    skip_without(kind)
    calls = 100 if kind.endswith(("opencl", "vulkan")) else 300
    # Those of TBB and of drivers are as many as the machine has cores, at most.
    assert int(said_by(THREADS, kind, calls)) < calls / 2


REFUSED = """
import resource
with open("/proc/self/statm") as sizes:
    size = int(sizes.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 2**22, resource.RLIM_INFINITY))
try:
    lacuna.verify(many, 0.01)
except lacuna.Error as error:
    print(type(error).__name__, str(error).count("\\n"))
"""


def test_a_thread_that_the_system_refuses_is_told_in_a_line() -> None:
    assert said_by(REFUSED) in ("Unavailable 0\n", "MemoryRefused 0\n")


INTERRUPTED = """
many = np.random.default_rng(1).random((3_000_000, 2))
call = {
    "sample": lambda: lacuna.sample(0.0002, seed=1),
    "lines": lambda: lacuna.sample(0.0003, mode="lines", seed=1),
    "count": lambda: lacuna.sample(n=10_000_000, seed=1),
    "field": lambda: lacuna.sample(n=3_000_000, field=many[:1000, :1] + np.ones((1000, 1000)), seed=1),
    "relax": lambda: lacuna.relax(many[:1_000_000], iterations=1000),
    "verify": lambda: lacuna.verify(many, 1e-4),
    "analyze": lambda: lacuna.analyze(many),
}[sys.argv[1]]
lacuna.sample(0.1)
threads = threading.active_count()
thread = meanwhile(lambda: os.kill(os.getpid(), signal.SIGINT))
try:
    call()
except KeyboardInterrupt:
    print("answered")
thread.join()
assert threading.active_count() == threads
assert lacuna.sample(0.1, seed=1).maximal
"""


@pytest.mark.parametrize("kind", re.findall(r'"(\w+)": lambda', INTERRUPTED))
def test_an_interrupt_is_answered_and_leaves_nothing_behind(kind: str) -> None:
    assert said_by(INTERRUPTED, kind) == "answered\n"


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
