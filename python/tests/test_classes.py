"""Classes of points: what sample, sample_many, verify and save make of them."""

from __future__ import annotations

import csv
import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lacuna

KINDS: dict[str, float | tuple[float, float]] = {"trees": 0.06, "bushes": (0.025, 2.0), "grass": 0.01}


def test_classes_have_names_places_and_distances() -> None:
    made = lacuna.sample(classes=KINDS, between="union", torus=True, seed=1)
    assert made.classes == ("trees", "bushes", "grass")
    assert made.class_of is not None and made.class_of.dtype == np.uint8
    assert made.class_of.shape == (len(made),) and not made.class_of.flags.writeable
    assert made.distances is not None
    assert np.allclose(np.diag(made.distances), [0.06, 0.025, 0.01])
    assert np.isclose(made.distances[0, 1], (0.06**-2 + 0.025**-2) ** -0.5)
    counts = np.bincount(made.class_of)
    assert counts[0] < counts[1] < counts[2]


def test_a_class_may_have_a_number_of_points(tmp_path: Path) -> None:
    kinds = {"trees": (0.05, 1, 20), "grass": 0.01}
    made = lacuna.sample(classes=kinds, seed=2)
    assert (made.class_of == 0).sum() == 20 and made.maximal
    assert lacuna.verify(made).maximal
    assert lacuna.verify(made.points, classes=kinds, class_of=made.class_of).maximal
    wrong = lacuna.verify(
        made.points, classes={"trees": (0.05, 1, 21), "grass": 0.01}, class_of=made.class_of
    )
    assert not wrong and wrong.miscounted == "trees" and "number of points" in wrong.reason
    made.save(tmp_path / "set.json")
    options = json.loads((tmp_path / "set.json").read_text())["options"]
    assert options["counts"] == [20, None] and options["weights"] == [1, 1]
    with pytest.raises(lacuna.BadRequest, match="only [0-9]+ of its 400 points found room"):
        lacuna.sample(classes={"trees": (0.05, 1, 400), "grass": 0.01})
    with pytest.raises(TypeError, match="classes must be a whole number"):
        lacuna.sample(classes={"trees": (0.05, 1, 2.5), "grass": 0.01})  # type: ignore[dict-item]


def test_a_class_may_have_a_mask_of_its_own() -> None:
    left = np.arange(32) < 16
    kinds = {"trees": 0.05, "grass": 0.01}
    mask: dict[str | None, Any] = {"trees": left * np.ones((32, 1))}
    made = lacuna.sample(classes=kinds, mask=mask, seed=2)
    trees = made.points[made.class_of == 0]
    assert len(trees) > 15 and trees[:, 0].max() < 0.5 < made.points[:, 0].max()
    assert lacuna.verify(made, mask=mask).maximal
    wrong = lacuna.verify(made, mask={"grass": mask["trees"]})
    assert wrong.forbidden_by == "mask"
    both = lacuna.sample(classes=kinds, mask={**mask, None: mask["trees"].T}, seed=2)
    grass = both.points[both.class_of == 1]
    assert len(grass) > 100 and grass[:, 1].min() > 0.5
    wide, tall = np.ones((10, 20)), np.ones((20, 10))
    assert lacuna.sample(classes=kinds, mask={"grass": wide, "trees": tall}).domain == (1, 0.5)
    assert lacuna.sample(classes=kinds, mask={"trees": tall, None: wide}).domain == (0.5, 1)
    with pytest.raises(lacuna.BadRequest, match="mask 'tree': must be the name of a class"):
        lacuna.sample(classes=kinds, mask={"tree": left * np.ones((32, 1))})
    with pytest.raises(lacuna.BadRequest, match="mask missing"):
        lacuna.verify(made)


def test_a_set_without_classes_has_none() -> None:
    made = lacuna.sample(0.1, seed=1)
    assert made.classes == () and made.class_of is None and made.distances is None
    one = lacuna.sample(classes={"all": 0.1}, between="union", seed=1)
    assert (one.points == made.points).all()
    assert one.class_of is not None and not one.class_of.any()


def test_verify_proves_a_set_from_its_own_classes_or_those_given() -> None:
    made = lacuna.sample(classes=KINDS, between="union", torus=True, seed=3)
    assert lacuna.verify(made).maximal
    assert made.class_of is not None
    names = [made.classes[one] for one in made.class_of]
    given = lacuna.verify(
        made.points, classes=KINDS, between="union", class_of=names, torus=True
    )
    assert given.maximal and given.largest_gap_class is not None
    less = lacuna.verify(
        made.points[:-1], classes=KINDS, between="union", class_of=names[:-1], torus=True
    )
    assert less.kept and not less.covered and less.largest_gap_class == names[-1]
    changed = made.class_of.copy()
    changed[changed == 2] = 0
    assert not lacuna.verify(
        made.points, classes=KINDS, between="union", class_of=changed, torus=True
    ).kept


def test_a_matrix_says_all_distances() -> None:
    matrix = [[0.1, 0.0], [0.0, 0.05]]
    made = lacuna.sample(classes={"a": None, "b": (None, 2)}, between=matrix, torus=True, seed=1)
    alone = lacuna.sample(0.05, torus=True, seed=1)
    assert made.class_of is not None
    assert 0.8 < (made.class_of == 1).sum() / len(alone) < 1.2
    assert lacuna.verify(made).maximal


def test_kept_points_have_classes_by_name_or_place() -> None:
    keep = [(0.2, 0.2), (0.8, 0.8)]
    by_name = lacuna.sample(
        classes=KINDS, keep=keep, keep_classes=["trees", "grass"], seed=5
    )
    by_place = lacuna.sample(classes=KINDS, keep=keep, keep_classes=[0, 2], seed=5)
    assert (by_name.points == by_place.points).all()
    assert by_name.class_of is not None and by_name.class_of[:2].tolist() == [0, 2]


def test_a_kept_set_brings_its_classes() -> None:
    wood = lacuna.sample(classes={"grass": 0.04, "trees": 0.2}, seed=1, limit=20)
    more = lacuna.sample(classes={"trees": 0.2, "grass": 0.04}, keep=wood, seed=2)
    assert wood.class_of is not None and more.class_of is not None
    assert (more.class_of[: len(wood)] == 1 - wood.class_of).all()
    with pytest.raises(lacuna.BadRequest, match="keep_classes 'grass': must be one of trees"):
        lacuna.sample(classes={"trees": 0.2}, keep=wood, seed=2)


def test_a_report_has_the_distances_that_the_set_keeps() -> None:
    made = lacuna.sample(classes={"a": 0.4, "b": 0.1}, between="union", n=300, seed=1)
    assert made.distances is not None
    assert made.report()["request"]["distances"] == made.distances.tolist()
    assert made.distances[1, 1] < 0.1


def test_many_sets_have_classes() -> None:
    sets = lacuna.sample_many(range(3), classes=KINDS, between="union")
    one = lacuna.sample(classes=KINDS, between="union", seed=2)
    assert (sets[2].points == one.points).all()
    assert sets[2].class_of is not None and (sets[2].class_of == one.class_of).all()


def test_files_are_those_of_the_command(tmp_path: Path) -> None:
    made = lacuna.sample(classes=KINDS, torus=True, seed=6)
    for extension in ("csv", "npy", "ply", "png"):
        made.save(tmp_path / f"own.{extension}")
    command = ["build/lacuna", "sample", "--class", "trees:0.06", "--class", "bushes:0.025:2"]
    command += ["--class", "grass:0.01", "--torus", "--seed", "6", "--quiet"]
    for extension in ("csv", "npy", "ply", "png"):
        command += ["-o", str(tmp_path / f"its.{extension}")]
    subprocess.run(command, check=True)
    for extension in ("csv", "npy", "ply", "png"):
        own, its = tmp_path / f"own.{extension}", tmp_path / f"its.{extension}"
        assert own.read_bytes() == its.read_bytes(), extension
    with open(tmp_path / "own.csv", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    assert made.class_of is not None
    assert [row["class"] for row in rows] == [made.classes[one] for one in made.class_of]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"classes": {"a": 0}}, "classes 0: a radius must be a finite number greater than 0"),
        ({"classes": {"a": None}}, "classes: each needs a radius unless between is a matrix"),
        ({"classes": {"a": 1, "b": 1}, "between": "near"}, "between 'near': must be 'sum', "),
        ({"classes": {"a": 1}, "between": [[1]]}, "classes: need no radius, for between has all"),
        ({"classes": {"a": None}, "between": [1]}, r"between of shape \(1,\): must be 1 x 1"),
        ({"classes": {"a": 1}, "radius": 1}, "radius 1 with classes: each class has a radius of its own"),
        ({"radius": 1, "between": "union"}, "between 'union': is for classes"),
        ({"radius": 1, "keep_classes": [0]}, "keep_classes: is for points with classes"),
        ({"classes": KINDS, "relax": 1}, "relax 1 with classes: it keeps no distances"),
        (
            {"classes": KINDS, "keep": [(0.5, 0.5)], "keep_classes": ["rocks"]},
            "keep_classes 'rocks': must be one of trees, bushes, grass",
        ),
        (
            {"classes": KINDS, "keep": [(0.5, 0.5)], "keep_classes": []},
            "keep 1 points: with classes each needs a class, but 0 have one",
        ),
    ],
)
def test_what_is_wrong_is_named(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(lacuna.BadRequest, match=message):
        lacuna.sample(**arguments)  # type: ignore[arg-type]


def test_points_of_classes_need_a_class_to_be_verified() -> None:
    with pytest.raises(lacuna.BadRequest, match="class_of missing: give the class of each point"):
        lacuna.verify([(0.5, 0.5)], classes=KINDS)
    with pytest.raises(TypeError, match="classes must be a dict of names and radii"):
        lacuna.sample(classes=["trees"])  # type: ignore[arg-type]


PARCEL = [[(0.1, 0.1), (0.9, 0.2), (0.6, 0.9)]]


def test_borders_of_classes_are_those_of_the_command(tmp_path: Path) -> None:
    path = tmp_path / "parcel.txt"
    path.write_text("0.1 0.1\n0.9 0.2\n0.6 0.9\n", encoding="ascii")
    kinds: Any = {"classes": {"trees": 0.06, "grass": 0.01}, "inside": PARCEL, "seed": 6}
    command = ["build/lacuna", "sample", "--class", "trees:0.06", "--class", "grass:0.01"]
    command += ["--inside", str(path), "--seed", "6", "--quiet", "-o", str(tmp_path / "its.npy")]
    for options, where in (
        (["--inside-by-radius"], {"inside_by_radius": True}),
        (["--border", "trees:0.1"], {"border": {"trees": 0.1}}),
        (["--border", "trees:0.06", "--border", "0.01"], {"border": {"trees": 0.06, "grass": 0.01}}),
    ):
        made = lacuna.sample(**kinds, **where)
        made.save(tmp_path / "own.npy")
        subprocess.run([*command, *options], check=True)
        assert (tmp_path / "own.npy").read_bytes() == (tmp_path / "its.npy").read_bytes()
        assert lacuna.verify(made, inside=PARCEL, edge=0.02 / 16).maximal
        again = lacuna.verify(
            made.points, classes=kinds["classes"], class_of=made.class_of, inside=PARCEL,
            edge=0.02 / 16, domain=made.domain, **where,
        )  # fmt: skip
        assert again.maximal


def test_no_object_overhangs_and_one_that_does_is_refuted() -> None:
    radii = {"trees": 0.06, "grass": 0.01}
    made = lacuna.sample(classes=radii, inside_by_radius=True, avoid=[([[(0.5, 0.5)]], 0.1)], seed=1)
    own = np.array(list(radii.values()))[made.class_of]
    assert (np.minimum(made.points, 1 - made.points).min(axis=1) >= own).all()
    assert (np.hypot(*(made.points - 0.5).T) >= 0.1 + own).all()
    assert made.report()["request"]["borders"] == [0.06, 0.01]
    avoid = [([[(0.5, 0.5)]], 0.1)]
    assert lacuna.verify(made, avoid=avoid, edge=0.02 / 16).maximal
    points = made.points.copy()
    nearest = points[:, 0].argmin()
    points[nearest, 0] = own[nearest] - 1e-3
    found = lacuna.verify(
        points, classes=radii, class_of=made.class_of, inside_by_radius=True, avoid=avoid
    )
    assert found.forbidden == nearest and found.forbidden_by == "border"


def test_without_classes_an_object_is_as_wide_as_the_distance_of_two() -> None:
    made = lacuna.sample(0.1, inside_by_radius=True, seed=1)
    assert (made.points == lacuna.sample(0.1, border=0.05, seed=1).points).all()
    assert lacuna.verify(made).maximal
    assert lacuna.verify(made.points, 0.1, inside_by_radius=True).maximal


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"border": {"rocks": 1}}, "border 'rocks': must be the name of a class"),
        ({"border": 0.1, "inside_by_radius": True}, "border with inside_by_radius: both say"),
        (
            {"classes": {"a": 0.6, "b": 0.1}, "inside_by_radius": True},
            "inside_by_radius with objects of class a: their radius is 0.6: must be under half",
        ),
        ({"torus": True, "inside_by_radius": True}, "inside_by_radius with torus: a torus has no"),
        ({"mask": [[1]], "inside_by_radius": True}, "inside_by_radius with mask: its pixels"),
        ({"n": 9, "inside_by_radius": True}, "inside_by_radius with n: the radius must be known"),
        ({"border": {"trees": 0.6}}, "border trees:0.6: must be at least 0 and under half"),
    ],
)
def test_what_is_wrong_with_a_border_is_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(lacuna.BadRequest, match=message):
        lacuna.sample(**{"classes": KINDS, **arguments})


def test_polygons_of_classes_hold_their_points_alone(tmp_path: Path) -> None:
    wet = [[(0.2, 0.2), (0.8, 0.3), (0.6, 0.7)]]
    path = tmp_path / "wet.txt"
    path.write_text("0.2 0.2\n0.8 0.3\n0.6 0.7\n", encoding="ascii")
    kinds = {"trees": 0.05, "reeds": 0.01}
    made = lacuna.sample(classes=kinds, inside={"reeds": wet}, domain=(1, 1), seed=2)
    command = ["build/lacuna", "sample", "--class", "trees:0.05", "--class", "reeds:0.01"]
    command += ["--inside", f"reeds:{path}", "--seed", "2", "--domain", "1x1", "--quiet"]
    subprocess.run([*command, "-o", str(tmp_path / "its.npy")], check=True)
    made.save(tmp_path / "own.npy")
    assert (tmp_path / "own.npy").read_bytes() == (tmp_path / "its.npy").read_bytes()
    assert lacuna.verify(made, inside={"reeds": wet}, edge=0.02 / 16).maximal
    found = lacuna.verify(made, inside={"trees": wet}, edge=0.02 / 16)
    assert found.forbidden_by == "inside" and made.class_of is not None
    assert made.classes[made.class_of[found.forbidden or 0]] == "trees"
    with pytest.raises(lacuna.BadRequest, match="inside 'rocks': must be the name of a class"):
        lacuna.sample(classes=kinds, inside={"rocks": wet})
    of_all = lacuna.sample(classes=kinds, inside={None: wet}, domain=(1, 1), seed=2)
    assert (of_all.points == lacuna.sample(classes=kinds, inside=wet, domain=(1, 1), seed=2).points).all()
