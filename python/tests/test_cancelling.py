"""Ctrl-C at a random moment of every function raises KeyboardInterrupt, whatever the function does.

The moment is measured in processor time, so that other work of the machine does not matter. What
passes after it is printed, not judged: pytest -s python/tests/test_cancelling.py
"""

from __future__ import annotations

import random
import signal
import time
from pathlib import Path
from typing import Callable

import numpy as np
import pytest

import lacuna

SIDE = 1200
Call = Callable[[], object]


@pytest.fixture(scope="module")
def calls(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Call]:
    """Calls of all functions, by name; what follows a blank says what is special."""
    folder: Path = tmp_path_factory.mktemp("cancelling")
    rng = np.random.default_rng(18)
    noise = rng.random((SIDE, SIDE))
    colours = rng.random((SIDE // 2, SIDE // 2, 3))
    np.save(folder / "noise.npy", noise)
    made = lacuna.sample(0.0012, seed=1)
    around = 2 * np.pi * np.arange(12) / 12
    disk = 0.0004 * np.stack([np.cos(around), np.sin(around)], axis=1)
    rings = [point + disk for point in made.points[:40_000]]
    lines = "\n\n".join("\n".join(f"{x} {y}" for x, y in ring) for ring in rings)
    (folder / "rings.txt").write_text(lines)
    coordinates = [[np.vstack([ring, ring[:1]]).tolist()] for ring in rings[:8000]]
    geojson = str({"type": "MultiPolygon", "coordinates": coordinates}).replace("'", '"')
    (folder / "rings.geojson").write_text(geojson)
    corners, sides = np.vstack([np.eye(3), np.zeros(3)]), [(0, 1, 2), (0, 1, 3), (1, 2, 3)]
    on_sides = lacuna.sample_surface(corners, sides, 0.008, seed=1)
    in_space = lacuna.sample_volume(0.06, seed=1)

    return {
        "sample": lambda: lacuna.sample(0.0008, seed=1),
        "sample on reference": lambda: lacuna.sample(0.004, backend="reference", seed=1),
        "sample of classes": lambda: lacuna.sample(classes={"a": 0.1, "b": 0.0008}, seed=1),
        "sample on a field": lambda: lacuna.sample(n=100_000, field=noise, seed=1),
        "sample_many": lambda: lacuna.sample_many(range(400), radius=0.02),
        "sample_many of tiles": lambda: lacuna.sample_many(
            range(400), radius=0.02, torus=True, frame=0.03
        ),
        "relax": lambda: lacuna.relax(made, iterations=3),
        "order": lambda: lacuna.order(made),
        "threshold_mask": lambda: lacuna.threshold_mask(256, 256),
        "verify": lambda: lacuna.verify(made),
        "analyze": lambda: lacuna.analyze(made),
        "stipple": lambda: lacuna.stipple(noise, 20_000, relax=2, seed=1),
        "stipple of a file": lambda: lacuna.stipple(folder / "noise.npy", 2000, relax=1, seed=1),
        "stipple in inks": lambda: lacuna.stipple(colours, 4000, inks="cmyk", relax=1, seed=1),
        "draw_mask": lambda: lacuna.draw_mask(rings, 0.0003, domain=(1, 1)),
        "draw_mask with a distance": lambda: lacuna.draw_mask(
            None, 0.0004, avoid=[(rings[:20_000], 0.0002)], domain=(1, 1)
        ),
        "read_polygons": lambda: lacuna.read_polygons(folder / "rings.txt"),
        "read_polygons of geojson": lambda: lacuna.read_polygons(folder / "rings.geojson"),
        "read_lines": lambda: lacuna.read_lines(folder / "rings.txt"),
        "sample_surface": lambda: lacuna.sample_surface(corners, sides, 0.004, seed=1),
        "sample_volume": lambda: lacuna.sample_volume(0.03, seed=1),
        "verify_surface": lambda: lacuna.verify_surface(on_sides, corners, sides, 0.008),
        "verify_volume": lambda: lacuna.verify_volume(in_space, 0.06),
        "save as csv": lambda: made.save(folder / "made.csv"),
        "save as json": lambda: made.save(folder / "made.json"),
        "save as svg": lambda: made.save(folder / "made.svg"),
    }


def seconds_after(moment: float, call: Call) -> float | None:
    """The processor time from the moment to the KeyboardInterrupt; None: the call had ended."""
    begun = time.process_time()
    signal.setitimer(signal.ITIMER_PROF, moment)
    try:
        call()
        signal.setitimer(signal.ITIMER_PROF, 0)
    except KeyboardInterrupt:
        return time.process_time() - begun - moment
    return None


def test_every_function_answers_at_a_random_moment(calls: dict[str, Call]) -> None:
    functions = {name for name in lacuna.__all__ if not isinstance(getattr(lacuna, name), type)}
    assert {name.split()[0] for name in calls} >= functions - {"devices", "domain_around"}
    chance = random.Random(18)
    before = signal.signal(signal.SIGPROF, signal.default_int_handler)
    try:
        for name, call in calls.items():
            begun = time.process_time()
            call()
            taken = time.process_time() - begun
            for _ in range(8):
                moment = chance.uniform(0.1, 0.8) * taken
                late = seconds_after(moment, call)
                if late is not None:
                    print(f"{name:30} {taken:7.3f} s, after {moment:.3f} s: {late:.4f} s")
                    break
            assert late is not None, f"{name} was never interrupted within {taken} s"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
    assert lacuna.sample(0.1, seed=1).maximal
