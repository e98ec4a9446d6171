"""Files that save writes: the command proves them, or asks for what they lack."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import PROGRAM

import lacuna

RAMP = np.linspace(0.2, 1, 16) * np.ones((16, 1))
SWIRL = np.dstack([np.full((1, 1), 0.1), np.full((1, 1), 0.04), np.full((1, 1), 0.5)])

# What a set is made with, and the option that verify asks for, if any.
KINDS: list[tuple[dict[str, Any], str]] = [
    ({"radius": 0.05}, ""),
    ({"radius": 0.05, "torus": True, "domain": (2, 1)}, ""),
    ({"radius": 0.05, "border": 0.1}, ""),
    ({"radius": 0.05, "keep": [(0.5, 0.5), (1, 1)]}, ""),
    ({"n": 300, "progressive": True}, ""),
    ({"classes": {"oak": 0.06, "elm": (0.02, 3)}}, ""),
    ({"classes": {"oak": 0.06, "elm": 0.02}, "between": "union", "torus": True}, ""),
    ({"radius": 0.05, "mask": [[1, 0], [1, 1]]}, "mask"),
    ({"field": RAMP, "scale": 0.03}, "field"),
    ({"ellipses": SWIRL}, "ellipses"),
]


def verify(path: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAM, "verify", path, *options], capture_output=True, text=True)


@pytest.mark.parametrize(("arguments", "asked"), KINDS)
def test_a_json_is_proven_or_asks_for_what_it_lacks(
    arguments: dict[str, Any], asked: str, tmp_path: Path
) -> None:
    made = lacuna.sample(**arguments, seed=3)
    path = tmp_path / "made.json"
    made.save(path)
    assert json.loads(path.read_text())["radius"] == made.radius
    found = verify(path)
    if asked:
        assert found.returncode == 2 and f"made with --{asked}" in found.stderr
        with pytest.raises(lacuna.BadRequest, match=f"^{asked} missing"):
            lacuna.verify(made)
    else:
        assert found.returncode == 0, found.stdout + found.stderr
        if made.maximal:
            assert lacuna.verify(made)


def test_a_json_of_a_count_holds_its_distances(tmp_path: Path) -> None:
    path = tmp_path / "made.json"
    for arguments in ({}, {"classes": {"oak": 0.06, "elm": 0.02}}):
        lacuna.sample(n=200, seed=3, **arguments).save(path)  # type: ignore[arg-type]
        found = verify(path, "--distances-only")
        assert found.returncode == 0, found.stdout + found.stderr


def test_a_relaxed_set_says_that_it_keeps_no_distance(tmp_path: Path) -> None:
    path = tmp_path / "made.json"
    made = lacuna.sample(n=200, relax=3, seed=3)
    for one in (made, lacuna.relax(made, iterations=2)):
        one.save(path)
        found = verify(path)
        assert found.returncode == 2 and "relaxed" in found.stderr


def test_columns_are_kept_or_refused(tmp_path: Path) -> None:
    ellipses = lacuna.sample(ellipses=SWIRL, seed=3)
    ellipses.save(tmp_path / "e.csv")
    assert (tmp_path / "e.csv").read_text().startswith("x,y,a,b,angle\n")
    classes = lacuna.sample(classes={"oak": 0.1, "elm": 0.05}, seed=3)
    classes.save(tmp_path / "c.csv")
    rows = (tmp_path / "c.csv").read_text().splitlines()
    named = [classes.classes[one] for one in classes.class_of]  # type: ignore[union-attr]
    assert rows[0] == "x,y,class" and [row.split(",")[2] for row in rows[1:]] == named
    inks = lacuna.stipple(np.ones((4, 4, 3)) * (0.5, 0.7, 1), n=40, inks="red,blue", seed=3)
    for made, what in ((ellipses, "ellipse"), (classes, "class"), (inks, "ink")):
        with pytest.raises(lacuna.BadRequest, match=f"^path .*has no place for the {what}"):
            made.save(tmp_path / "a.txt")
        for extension in ("csv", "npy", "ply", "json", "svg"):
            made.save(tmp_path / f"a.{extension}")
