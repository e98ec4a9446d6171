"""Stippled arrays give the command's bytes, whatever the options; tests/pinned.txt has other sets."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import Command
from translated import call_of

import lacuna

OPTIONS = """--count 300 --start cells
--count 400 --relax 0
--scale 0.03 --relax 4
--count 300 --relax 2 --metric min
--count 200 --invert
--count 200 --black 0.2 --white 0.8
--count 200 --auto-levels
--count 200 --light
--count 200 --min-importance 0.1 --gamma 2
--count 200 --size-by-tone 0.7
--count 200 --keep-inside
--count 200 --sharpen 2:3
--count 200 --torus --limit 100
--count 200 --lines-per-radius 5
--scale 0.05 --round-size 1 --seed 1
--relax 0"""


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With a picture of few pixels, so that the reference backend is fast enough."""
    y, x = np.mgrid[0:60, 0:90]
    made = tmp_path_factory.mktemp("picture")
    np.save(made / "small.npy", (127.5 + 127.5 * np.sin(x / 9) * np.cos(y / 11)).astype(np.uint8))
    return made


@pytest.mark.parametrize("options", OPTIONS.splitlines())
def test_of_a_picture(options: str, command: Command, folder: Path) -> None:
    expected = command("stipple", folder / "small.npy", *options.split())
    made = call_of(f"stipple small.npy {options}", folder)()
    assert made.points.tobytes() == expected.tobytes()


def test_on_each_backend(command: Command, backend: str, folder: Path) -> None:
    made = lacuna.sample(0.06, seed=3, backend=backend)
    assert made.backend == backend
    assert made.points.tobytes() == command("sample", "--radius", 0.06, "--seed", 3).tobytes()
    array = np.load(folder / "small.npy")
    dots = lacuna.stipple(array, 100, relax=2, seed=3, backend=backend)
    options = ["--count", 100, "--relax", 2, "--seed", 3]
    assert dots.backend == backend
    assert dots.points.tobytes() == command("stipple", folder / "small.npy", *options).tobytes()
