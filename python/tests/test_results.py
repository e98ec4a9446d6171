"""Results are frozen objects with arrays that are not copies; reports are as the command's."""

from __future__ import annotations

import copy
import dataclasses
import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import PROGRAM, REPOSITORY
from translated import call_of

import lacuna


def test_points_are_the_librarys_own_numbers() -> None:
    points = lacuna.sample(0.05, seed=1).points
    assert points.dtype == np.float64 and points.ndim == 2 and points.shape[1] == 2
    assert points.flags.c_contiguous and not points.flags.owndata
    assert points.base is not None and not isinstance(points.base, np.ndarray)


def test_points_outlive_the_result() -> None:
    made = lacuna.sample(0.02, seed=1)
    points, digest = made.points, made.sha256
    del made
    again = lacuna.sample(0.02, seed=1)
    assert again.sha256 == digest and (again.points == points).all()


def test_a_result_is_an_array_to_numpy() -> None:
    made = lacuna.sample(0.1, seed=1)
    assert np.asarray(made) is made.points
    assert np.array(made, dtype=np.float32).dtype == np.float32
    assert len(made) == len(made.points)


def test_a_result_cannot_be_changed() -> None:
    made = lacuna.sample(0.2, seed=1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        made.radius = 1.0  # type: ignore[misc]


def test_the_arrays_of_a_result_are_read_only() -> None:
    made = lacuna.stipple(np.eye(8), 30, seed=1)
    relaxed = lacuna.relax(made)
    found = lacuna.analyze(made)
    arrays = [made.points, made.radii, relaxed.points, found.power]
    arrays += [copy.deepcopy(made).points, pickle.loads(pickle.dumps(made)).radii]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    own = np.array(made)
    own[0] = 0
    given = np.random.default_rng(1).random((30, 2))
    lacuna.verify(given, 0.1)
    given[0] = 0


def test_a_set_has_the_length_rows_and_indices_of_its_points() -> None:
    made = lacuna.sample(0.2, seed=1)
    assert len(made) == len(list(made)) == len(made[:]) == len(made.points)
    assert (np.array([row for row in made]) == made.points).all()
    assert (made[0] == made.points[0]).all() and (made[1:, 0] == made.points[1:, 0]).all()
    assert repr(made).startswith(f"PointSet({len(made)} points, domain=")


FORMATS = ["txt", "csv", "npy", "ply", "geojson", "json", "svg", "pdf", "png"]


@pytest.mark.parametrize("extension", FORMATS)
def test_a_set_is_saved_as_the_command_writes_it(extension: str, tmp_path: Path) -> None:
    made = lacuna.sample(0.05, domain=(2, 1), seed=3)
    written = tmp_path / f"made.{extension}"
    made.save(written)
    assert written.stat().st_size > 1000
    expected = tmp_path / f"expected.{extension}"
    options = ["--radius", "0.05", "--domain", "2x1", "--seed", "3", "--quiet"]
    subprocess.run([PROGRAM, "sample", *options, "-o", expected], check=True)
    if extension in ("txt", "csv", "npy", "ply", "geojson", "png"):  # the others tell how the set was made
        assert written.read_bytes() == expected.read_bytes()
    if extension == "json":
        assert json.loads(written.read_text())["points"] == made.points.tolist()
    if extension == "svg":
        dots = [file.read_text().split("</metadata>")[-1].count("M") for file in (written, expected)]
        assert dots[0] == dots[1] >= len(made)


def test_what_cannot_be_saved_is_an_error_and_leaves_no_file(tmp_path: Path) -> None:
    made = lacuna.sample(0.2, seed=1)
    for name in ("made.tiff", "made", "-"):
        with pytest.raises(lacuna.BadRequest, match="^path ") as caught:
            made.save(tmp_path / name)
        assert caught.value.argument == "path"
    with pytest.raises(OSError, match="none"):
        made.save(tmp_path / "none" / "made.csv")
    assert not list(tmp_path.iterdir())


def test_results_are_drawn_where_one_says_or_in_a_new_figure(tmp_path: Path) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    made = lacuna.sample(0.1, seed=1)
    gap = np.delete(made.points, 17, axis=0)
    twice = np.vstack([made.points, made.points[3]])
    results: list[Any] = [made, lacuna.relax(made), lacuna.stipple(np.eye(8), 9, seed=1)]
    results += [lacuna.sample(field=np.eye(8), scale=0.1, seed=1), lacuna.analyze(made)]
    results += [lacuna.verify(made), lacuna.verify(gap, 0.1), lacuna.verify(twice, 0.1)]
    results += [lacuna.verify([(0.1, 2.0)], 0.1), lacuna.verify(np.empty((0, 2)), 0.1)]
    results += [lacuna.verify(made.points[:2], 0.1, keep=made.points)]
    figure, (axes, _) = plt.subplots(1, 2)
    for result in results:
        assert result.plot(axes) is axes
        own = result.plot()
        assert own.figure is not figure
        own.figure.savefig(tmp_path / "own.png")
        plt.close(own.figure)
    curve = lacuna.analyze(made).plot(curve="pair_correlation")
    assert curve.get_xlabel() == "distance / mean spacing"
    plt.close(curve.figure)
    with pytest.raises(lacuna.BadRequest, match="^curve 'size': must be one of power"):
        lacuna.analyze(made).plot(curve="size")  # type: ignore[arg-type]
    figure.savefig(tmp_path / "all.png")
    plt.close(figure)


def test_without_matplotlib_the_module_works_and_plot_says_so() -> None:
    program = """
import sys
sys.modules["matplotlib"] = None
import lacuna
made = lacuna.sample(0.2)
try:
    made.plot()
except ImportError as error:
    print(error)
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert run.stdout.startswith("plot needs matplotlib"), run.stderr


@pytest.mark.parametrize(
    "request_",
    ["--radius 0.1 --torus --seed 3", "--count 50 --mode lines --seed 1", "--radius 0.1 --relax 2"],
)
def test_a_report_says_what_the_command_says(request_: str, tmp_path: Path) -> None:
    file, output = tmp_path / "report.json", tmp_path / "points.npy"
    words = [*request_.split(), "--quiet", "-o", output, "--report", file]
    subprocess.run([PROGRAM, "sample", *words], check=True)
    expected = json.loads(file.read_text())
    found = json.loads(json.dumps(call_of(f"sample {request_}", tmp_path)().report()))
    for report in (expected, found):
        assert report.pop("peak_memory_bytes") > 0
        assert report.pop("seconds")["total"] > 0
        report.get("relax", {}).pop("capacity_cv", None)
    assert found == expected


MEMORY = """
import resource, sys, lacuna
made = lacuna.sample(n=int(sys.argv[1]), torus=True, seed=0)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024)
"""


def test_a_million_points_take_no_memory_that_the_command_does_not(tmp_path: Path) -> None:
    """The peak memory is at most 24 bytes per point over the command's, besides numpy itself;
    docs/python.md has figures for ten million points."""
    count = 1_000_000
    report = tmp_path / "report.json"
    subprocess.run(
        [PROGRAM, "sample", "--count", str(count), "--torus", "--quiet"]
        + ["--report", str(report), "-o", "/dev/null"],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    command = json.loads(report.read_text())["peak_memory_bytes"]

    def peak(n: int) -> int:
        run = subprocess.run(
            [sys.executable, "-c", MEMORY, str(n)], check=True, capture_output=True, text=True
        )
        return int(run.stdout)

    assert peak(count) - peak(10) <= command + 24 * count


RESULTS: list[Any] = [
    lacuna.sample(0.2, seed=1),
    lacuna.sample(n=30, seed=1, relax=1),
    lacuna.stipple(np.eye(8), 10, seed=1),
    lacuna.relax(np.random.default_rng(1).random((9, 2)), measure=True),
    lacuna.sample(field=np.ones((2, 2)), scale=0.3, mode="exact", seed=1),
    lacuna.verify([[0.1, 0.2]], 0.1),
    lacuna.read_polygons(REPOSITORY / "examples" / "lakes.svg"),
    lacuna.analyze(np.random.default_rng(1).random((9, 2))),
    lacuna.devices()[0],
]


@pytest.mark.parametrize("result", RESULTS, ids=lambda one: type(one).__name__)
def test_results_can_be_copied_pickled_and_shown(result: Any) -> None:
    for same in (copy.copy(result), copy.deepcopy(result), pickle.loads(pickle.dumps(result))):
        assert type(same) is type(result) and repr(same) == repr(result)
        for name, value in vars(result).items():
            if isinstance(value, np.ndarray):
                assert (getattr(same, name) == value).all()
    said = repr(result)
    assert said.startswith(type(result).__name__) and "\n" not in said and len(said) < 500


def test_errors_can_be_copied_and_pickled() -> None:
    for arguments in ({"n": 0}, {"n": 10**9, "memory_limit": 10**6}):
        with pytest.raises(lacuna.Error) as caught:
            lacuna.sample(**arguments)
        for same in (copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))):
            assert type(same) is type(caught.value) and str(same) == str(caught.value)
            assert same.argument == "n"
