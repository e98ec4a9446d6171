"""Pictures in several inks: the command's bytes, their files, and refusals."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import REPOSITORY, Command
from translated import call_of

import lacuna

HOPPER = "examples/hopper.jpg"
# Red at the left, blue at the right, and white between.
COLOURS = np.ones((30, 40, 3))
COLOURS[:, :10] = (0.9, 0.1, 0.1)
COLOURS[:, 30:] = (0.1, 0.2, 0.9)


OPTIONS = """--count 400 --inks cmyk
--count 300 --inks red,black,sea=#0083b8 --black-ink 0 --relax 2
--inks black,red --ink-counts 200,30 --gamma 2
--count 300 --inks cmyk --size-by-tone 0.5 --sharpen 3:2
--count 200 --inks cmyk --torus --auto-levels
--count 200 --inks white,gold=#d4af37 --paper-colour black
--count 200 --inks cmyk --keep-inside"""


@pytest.mark.parametrize("options", OPTIONS.splitlines())
def test_dots_are_the_commands(command: Command, options: str) -> None:
    expected = command("stipple", REPOSITORY / HOPPER, "--seed", 3, *options.split())
    made = call_of(f"stipple {HOPPER} --seed 3 {options}", REPOSITORY)()
    assert made.points.tobytes() == np.ascontiguousarray(expected[:, :2]).tobytes()
    assert made.ink is not None and (made.ink == expected[:, 2]).all()
    assert made.mode == "stratified" and made.radius > 0 and len(made.radii) == len(made)


def test_files_have_layers_and_plots_have_colours(tmp_path: Path) -> None:
    made = lacuna.stipple(COLOURS, 100, inks="red,blue", seed=1)
    made.save(tmp_path / "a.svg")
    svg = (tmp_path / "a.svg").read_text()
    black = lacuna.stipple(COLOURS, 100, inks="white", paper_colour="black", seed=1)
    black.save(tmp_path / "b.svg")
    assert 'fill="#000000"' in (tmp_path / "b.svg").read_text()
    assert 'inkscape:label="1 red"' in svg and 'inkscape:label="2 blue"' in svg
    made.save(tmp_path / "a.csv")
    lines = (tmp_path / "a.csv").read_text().splitlines()
    assert lines[0] == "x,y,ink" and lines[1].endswith(",red") and lines[-1].endswith(",blue")
    faces = made.plot().collections[0].get_facecolor()
    assert len(faces) == 100 and tuple(faces[0]) != tuple(faces[-1])
