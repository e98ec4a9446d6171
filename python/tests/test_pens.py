"""Pens, paper, strokes and lines: the dots and the drawings of the command."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import REPOSITORY, Command, refused
from translated import call_of

import lacuna

HOPPER = "examples/hopper.jpg"

A6 = {"paper_size": "A6", "margin": "5mm"}

OPTIONS = """--dot-size 1mm
--dot-size 0.8mm..1.5mm --relax 2
--count 500 --pens 0.5mm,1mm
--count 300 --inks black:0.5mm,red:1mm --pen-path
--count 300 --dot-size 1mm --no-pen-path
--along 4 --dot-size 1mm
--dot-size 0.8mm..2mm --pen 0.5mm
--count 200 --size-by-tone 0.5 --pen 0.6mm --dot-style circle --turn 90 --crop 20,30,100,120
--path-line --dot-size 1mm --plot-time 2min --seconds-per-metre-down 30 --seconds-per-corner 0.1
--plot-time 10min --dot-size 1mm --seconds-per-dot 0.5 --seconds-per-metre-up 10"""


@pytest.mark.parametrize("options", OPTIONS.splitlines())
def test_dots_and_drawings_are_the_commands(
    command: Command, tmp_path: Path, options: str
) -> None:
    options = f"--seed 3 --paper-size A6 --margin 5mm {options}"
    made = call_of(f"stipple {HOPPER} {options}", REPOSITORY)()
    svg = tmp_path / "expected.svg"
    expected = command("stipple", REPOSITORY / HOPPER, *options.split(), more=svg)
    assert made.points.tobytes() == np.ascontiguousarray(expected[:, :2]).tobytes()
    assert made.paper is not None and made.paper[2] > 5
    made.save(tmp_path / "made.svg")
    files = [(tmp_path / name).read_text() for name in ("made.svg", "expected.svg")]
    drawings = [file[file.index("<g") :] for file in files]  # the command's also has metadata
    assert drawings[0] == drawings[1] and 'width="105mm" height="148mm"' in files[0]


def test_each_pen_is_a_layer_and_the_time_is_known() -> None:
    ramp = np.linspace(0, 1, 40) * np.ones((20, 1))
    made = lacuna.stipple(ramp, 300, seed=1, pens="0.3mm,0.5mm", **A6)
    assert made.pens == {"0.3mm": 0.3, "0.5mm": 0.5} and list(made.inks or ()) == list(made.pens)
    assert made.ink is not None and set(made.ink) == {0, 1} and (np.diff(made.ink) >= 0).all()
    assert 120 < made.plot_seconds < 130 and made.path_length > 0 and made.for_a_pen
    line = lacuna.stipple(ramp, 300, seed=1, path_line=True)
    assert line.line_width > 0 and line.for_a_pen and line.pens is None and line.paper is None
    strokes = lacuna.stipple(ramp, seed=1, along=3, dot_size="0.5mm", **A6)
    assert strokes.are_strokes and strokes.ellipses is not None and strokes.plot_seconds > 0


@pytest.mark.parametrize(
    ("argument", "value"),
    [("dot_size", "0.4"), ("pens", "1mm,0"), ("pen", "0"), ("crop", "1,2"), ("paper_size", "A77"), ("plot_time", "soon")],
)
def test_what_is_not_understood_is_refused(argument: str, value: str) -> None:
    refused(lacuna.BadRequest, argument, lacuna.stipple, np.eye(8), **{argument: value})


def test_dots_of_the_next_picture_begin_where_those_of_the_last_lie() -> None:
    x = np.arange(60) * np.ones((40, 1))
    first = lacuna.stipple(x, 200, seed=1)
    second = lacuna.stipple(x + 1, start_points=first, seed=1)
    moves = np.hypot(*(second.points - first.points).T)
    assert 0 < np.median(moves) < 0.01 and np.quantile(moves, 0.9) < 0.05
    again = lacuna.stipple(x + 1, 200, start_points=first.points, seed=1)
    assert again.points.tobytes() == second.points.tobytes()
    start = "start_points"
    for argument, wrong in (
        ("n", {"n": 199}), (start, {"relax": 0}), (start, {"inks": "red"}),
        (start, {start: np.zeros((0, 2))}), (start, {start: [[0.5, 2.0]]}),
        (start, {"mode": "stratified"}), (start, {"plot_time": "1h"}),
    ):  # fmt: skip
        with pytest.raises(lacuna.BadRequest) as caught:
            lacuna.stipple(x, **{start: first, **wrong})
        assert caught.value.argument == argument, str(caught.value)


@pytest.mark.parametrize(
    ("argument", "wrong"),
    [
        ("radii", {"radii": np.ones(9)}),
        ("ink", {"ink": np.full(60, 7, np.uint8)}),
        ("ellipses", {"are_strokes": True}),
        ("paper", {"paper": (100, 3)}),
        ("paper", {"paper": (100.0, 0.0, 0.0)}),
        ("paper", {"paper": (100.0, 100.0, 60.0)}),
        ("line_width", {"line_width": float("nan")}),
        ("pen_mm", {"pen_mm": -1.0}),
    ],
)
def test_what_cannot_be_drawn_is_refused_when_saved(
    tmp_path: Path, argument: str, wrong: dict[str, Any]
) -> None:
    ramp = np.linspace(0, 1, 40) * np.ones((20, 1))
    made = lacuna.stipple(ramp, 60, seed=1, pens="0.5mm,1mm", **A6)
    with pytest.raises(lacuna.BadRequest) as caught:
        dataclasses.replace(made, **wrong).save(tmp_path / "a.svg")
    assert caught.value.argument == argument, str(caught.value)
    assert not list(tmp_path.iterdir())
