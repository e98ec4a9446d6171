"""The same request gives the same bytes as the command, on every backend."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt
import pytest
from conftest import REPOSITORY, Command

import lacuna

RACCOON = REPOSITORY / "examples" / "raccoon.png"

# Arguments of Python, and the same request as arguments of the command.
Case = tuple[dict[str, Any], list[object]]


def uniform_cases() -> list[Case]:
    cases: list[Case] = []
    sizes: list[Case] = [({"radius": 0.06}, ["--radius", 0.06]), ({"n": 300}, ["--count", 300])]
    domains: list[Case] = [
        ({}, []),
        ({"torus": True}, ["--torus"]),
        ({"domain": (2, 1)}, ["--domain", "2x1"]),
        ({"domain": (0.5, 3), "torus": True}, ["--domain", "0.5x3", "--torus"]),
    ]
    modes: list[Case] = [
        ({"seed": 3}, ["--seed", 3]),
        ({"mode": "lines", "seed": 2**64 - 1}, ["--mode", "lines", "--seed", 2**64 - 1]),
    ]
    for (a, b), (c, d), (e, f) in itertools.product(sizes, domains, modes):
        cases.append(({**a, **c, **e}, [*b, *d, *f]))
    base: Case = ({"radius": 0.07, "seed": 5}, ["--radius", 0.07, "--seed", 5])
    for more, options in (
        ({"limit": 20}, ["--limit", 20]),
        ({"round_size": 1}, ["--round-size", 1]),
        ({"round_size": 50, "torus": True}, ["--round-size", 50, "--torus"]),
        ({"lines_per_radius": 3}, ["--lines-per-radius", 3]),
        ({"mode": "lines", "snap": True}, ["--mode", "lines", "--snap"]),
        ({"mode": "lines", "uniform_x": True}, ["--mode", "lines", "--uniform-x"]),
        ({"threads": 1}, ["--threads", 1]),
        ({"progressive": True, "torus": True}, ["--progressive", "--torus"]),
        ({"relax": 5, "torus": True}, ["--relax", 5, "--torus"]),
        ({"gaussian": 9, "gaussian_distance": 0.8}, ["--gaussian", 9, "--gaussian-distance", 0.8]),
        ({"relax": 3, "domain": (1, 2)}, ["--relax", 3, "--domain", "1x2"]),
    ):
        cases.append(({**base[0], **more}, [*base[1], *options]))
    return cases


def picture_cases() -> list[Case]:
    base: Case = ({"seed": 1}, ["--seed", 1])
    cases: list[Case] = []
    random: list[object] = ["--count", 300, "--relax", 0]
    for more, options in (
        ({"n": 400}, ["--count", 400]),
        ({"n": 300, "mode": "cells"}, ["--count", 300, "--start", "cells"]),
        ({"n": 400, "relax": 0}, ["--count", 400, "--relax", 0]),
        ({"scale": 0.03, "relax": 0}, ["--scale", 0.03, "--relax", 0]),
        ({"scale": 0.03, "relax": 4}, ["--scale", 0.03, "--relax", 4]),
        ({"n": 300, "relax": 0, "metric": "mean"}, [*random, "--metric", "mean"]),
        ({"n": 300, "relax": 0, "metric": "max"}, [*random, "--metric", "max"]),
        ({"n": 300, "relax": 2, "metric": "min"}, ["--count", 300, "--relax", 2, "--metric=min"]),
        ({"n": 200, "invert": True}, ["--count", 200, "--invert"]),
        ({"n": 200, "gamma": 2.0}, ["--count", 200, "--gamma", 2]),
        ({"n": 200, "black": 0.2, "white": 0.8}, ["--count", 200, "--black", 0.2, "--white", 0.8]),
        ({"n": 200, "auto_levels": True}, ["--count", 200, "--auto-levels"]),
        ({"n": 200, "light": True}, ["--count", 200, "--light"]),
        ({"n": 200, "min_importance": 0.1}, ["--count", 200, "--min-importance", 0.1]),
        ({"n": 200, "size_by_tone": 0.7}, ["--count", 200, "--size-by-tone", 0.7]),
        ({"n": 200, "keep_inside": True}, ["--count", 200, "--keep-inside"]),
        ({"n": 200, "sharpen": 2}, ["--count", 200, "--sharpen", 2]),
        ({"n": 200, "torus": True, "limit": 100}, ["--count", 200, "--torus", "--limit", 100]),
        ({"n": 200, "lines_per_radius": 5}, ["--count", 200, "--lines-per-radius", 5]),
        ({"scale": 0.05, "round_size": 1}, ["--scale", 0.05, "--round-size", 1]),
    ):
        cases.append(({**base[0], **more}, [*base[1], *options]))
    return cases


@pytest.mark.parametrize("case", uniform_cases(), ids=lambda case: " ".join(map(str, case[1])))
def test_of_a_uniform_set(case: Case, command: Command) -> None:
    arguments, options = case
    assert lacuna.sample(**arguments).points.tobytes() == command("sample", *options).tobytes()


def test_on_each_backend(command: Command, backend: str, small: Path) -> None:
    made = lacuna.sample(0.06, seed=3, backend=backend)
    assert made.backend == backend
    assert made.points.tobytes() == command("sample", "--radius", 0.06, "--seed", 3).tobytes()
    dots = lacuna.stipple(small, 100, relax=2, seed=3, backend=backend)
    options = ["--count", 100, "--relax", 2, "--seed", 3]
    assert dots.backend == backend
    assert dots.points.tobytes() == command("stipple", small, *options).tobytes()


@pytest.fixture(scope="session")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A picture with few pixels, so that the reference backend is fast enough."""
    y, x = np.mgrid[0:60, 0:90]
    picture = (127.5 + 127.5 * np.sin(x / 9.0) * np.cos(y / 11.0)).astype(np.uint8)
    path = tmp_path_factory.mktemp("picture") / "small.npy"
    np.save(path, picture)
    return path


@pytest.mark.parametrize("case", picture_cases(), ids=lambda case: " ".join(map(str, case[1])))
def test_of_a_picture(case: Case, command: Command, small: Path) -> None:
    arguments, options = case
    expected = command("stipple", small, *options)
    from_path = lacuna.stipple(small, **arguments)
    from_array = lacuna.stipple(np.load(small), **arguments)
    assert from_path.points.tobytes() == expected.tobytes()
    assert from_array.points.tobytes() == expected.tobytes()


def test_of_a_photograph(command: Command) -> None:
    expected = command("stipple", RACCOON, "--count", 2000)
    assert lacuna.stipple(RACCOON, 2000, seed=0).points.tobytes() == expected.tobytes()


def test_of_as_many_dots_as_suit_the_picture(command: Command, small: Path) -> None:
    expected = command("stipple", small, "--relax", 0)
    made = lacuna.stipple(small, relax=0, seed=0)
    assert made.report()["request"]["count"] == len(expected)  # type: ignore[index]
    assert made.points.tobytes() == expected.tobytes()


def test_of_a_field_in_the_default_mode(
    command: Command, tmp_path: Path, ramp: npt.ArrayLike
) -> None:
    np.save(tmp_path / "ramp.npy", ramp)
    field = ["--field", tmp_path / "ramp.npy", "--invert"]
    expected = command("sample", *field, "--count", 250, "--seed", 4)
    made = lacuna.sample(n=250, field=ramp, seed=4)
    assert (made.mode, made.metric) == ("exact", "min")
    assert made.points.tobytes() == expected.tobytes()


def test_of_a_field_in_cells(command: Command, tmp_path: Path, ramp: npt.ArrayLike) -> None:
    np.save(tmp_path / "ramp.npy", ramp)
    expected = command(
        "stipple", tmp_path / "ramp.npy", "--invert", "--count", 250, "--relax", 0, "--seed", 4
    )
    made = lacuna.sample(n=250, field=ramp, seed=4, mode="cells")
    assert made.points.tobytes() == expected.tobytes()


@pytest.mark.parametrize("with_field", [False, True])
def test_of_relaxed_points(
    command: Command, tmp_path: Path, ramp: npt.ArrayLike, with_field: bool
) -> None:
    given = np.random.default_rng(8).random((200, 2)) * (1, 2 / 3)
    np.save(tmp_path / "given.npy", given)
    np.save(tmp_path / "ramp.npy", ramp)
    options: list[object] = ["--iterations", 4, "--domain", "1x0.75"]
    picture = [tmp_path / "ramp.npy", "--invert"] if with_field else []
    expected = command("relax", tmp_path / "given.npy", *picture, *options)
    relaxed = lacuna.relax(
        given,
        ramp if with_field else None,
        iterations=4,
        domain=(1, 0.75),
    )
    assert relaxed.points.tobytes() == expected.tobytes()


def test_many_seeds_give_the_sets_of_each_alone() -> None:
    told: list[tuple[int, int]] = []
    made = lacuna.sample_many(
        range(5, 200), radius=0.1, torus=True, progress=lambda *done: told.append(done)
    )
    assert [one.seed for one in made] == list(range(5, 200))
    for one in made[::20]:
        alone = lacuna.sample(0.1, torus=True, seed=one.seed)
        assert one.sha256 == alone.sha256 and one.rounds == alone.rounds
        assert one.report()["request"]["seed"] == one.seed
    assert all(expected == 195 for _, expected in told)
    assert lacuna.sample_many([], n=10) == []


def test_seeds_of_an_iterator_are_read_as_sets_are_taken() -> None:
    read: list[int] = []

    def seeds() -> Iterator[int]:
        for seed in itertools.count():
            read.append(seed)
            yield seed

    for made in lacuna.sample_many(seeds(), n=1000):
        assert made.sha256 == lacuna.sample(n=1000, seed=made.seed).sha256
        assert len(read) <= 2 * made.seed + 1
        if made.seed == 40:
            break
    large = lacuna.sample_many(itertools.count(), n=300_000)
    assert next(large).seed == 0 and next(large).seed == 1
    with pytest.raises(lacuna.BadRequest, match="seeds"):
        list(lacuna.sample_many(iter([1, -1]), n=10))
    with pytest.raises(lacuna.BadRequest, match="torus|radius"):
        lacuna.sample_many(itertools.count())
    with pytest.raises(lacuna.BadRequest, match="mode stratified: is a start for relax"):
        lacuna.sample_many([1], n=10, mode="stratified")


ENDLESS = """
import itertools, resource, sys, lacuna
for made in lacuna.sample_many(itertools.count(), n=5):
    if made.seed == int(sys.argv[1]):
        break
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024)
"""


def test_endless_seeds_take_no_more_memory_the_longer_one_takes_sets() -> None:
    def peak(sets: int) -> int:
        run = subprocess.run(
            [sys.executable, "-c", ENDLESS, str(sets)], check=True, capture_output=True, text=True
        )
        return int(run.stdout)

    # 20,000 sets that were kept would take over 20 MB.
    assert peak(40_000) - peak(20_000) < 4_000_000


def test_more_seeds_than_a_list_of_sets_has_room_for_are_refused() -> None:
    for many in (10**12, 10**20):
        with pytest.raises(lacuna.MemoryRefused, match=r"^seeds of \d+ sets.*iter\(seeds\)"):
            lacuna.sample_many(range(many), n=5)
        assert next(lacuna.sample_many(iter(range(many)), n=5)).seed == 0


def test_seeds_that_make_no_sense_are_refused() -> None:
    for wrong, error in (([-1], ValueError), ([1.5], TypeError), (7, TypeError), ("12", TypeError)):
        with pytest.raises(error, match="seeds"):
            lacuna.sample_many(wrong, n=10)  # type: ignore[arg-type]
