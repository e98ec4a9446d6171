"""Classes of points: what sample, sample_many, verify and save make of them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import refused

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
    assert made.report()["request"]["distances"] == made.distances.tolist()
    counts = np.bincount(made.class_of)
    assert counts[0] < counts[1] < counts[2]


def test_a_class_may_have_a_number_of_points(tmp_path: Path) -> None:
    kinds = {"trees": (0.05, 1, 20), "grass": 0.01}
    made = lacuna.sample(classes=kinds, seed=2)
    assert (made.class_of == 0).sum() == 20 and lacuna.verify(made).maximal
    wrong = lacuna.verify(
        made.points, classes={"trees": (0.05, 1, 21), "grass": 0.01}, class_of=made.class_of
    )
    assert not wrong and wrong.miscounted == "trees" and "number of points" in wrong.reason
    made.save(tmp_path / "set.json")
    options = json.loads((tmp_path / "set.json").read_text())["options"]
    assert options["counts"] == [20, None] and options["weights"] == [1, 1]
    refused(TypeError, "classes", lacuna.sample, classes={"trees": (0.05, 1, 2.5), "grass": 0.01})


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
    wide, tall = np.ones((10, 20)), np.ones((20, 10))
    assert lacuna.sample(classes=kinds, mask={"grass": wide, "trees": tall}).domain == (1, 0.5)
    assert lacuna.sample(classes=kinds, mask={"trees": tall, None: wide}).domain == (0.5, 1)
    with pytest.raises(lacuna.BadRequest, match="mask 'tree': must be the name of a class"):
        lacuna.sample(classes=kinds, mask={"tree": left * np.ones((32, 1))})


def test_a_set_without_classes_has_none() -> None:
    made = lacuna.sample(0.1, seed=1)
    assert made.classes == () and made.class_of is None and made.distances is None
    one = lacuna.sample(classes={"all": 0.1}, between="union", seed=1)
    assert (one.points == made.points).all()
    assert one.class_of is not None and not one.class_of.any()


def test_verify_proves_a_set_from_its_own_classes_or_those_given() -> None:
    made = lacuna.sample(classes=KINDS, between="union", torus=True, seed=3)
    assert lacuna.verify(made).maximal and made.class_of is not None
    names = [made.classes[one] for one in made.class_of]
    given = lacuna.verify(
        made.points, classes=KINDS, between="union", class_of=names, torus=True
    )
    assert given.maximal and given.largest_gap_class is not None
    changed = made.class_of.copy()
    changed[changed == 2] = 0
    assert not lacuna.verify(
        made.points, classes=KINDS, between="union", class_of=changed, torus=True
    ).kept


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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"classes": {"a": 0}}, "classes 0: a radius must be a finite number greater than 0"),
        ({"classes": {"a": None}}, "classes: each needs a radius unless between is a matrix"),
        ({"classes": {"a": 1, "b": 1}, "between": "near"}, "between 'near': must be 'sum', "),
        ({"classes": {"a": 1}, "between": [[1]]}, "classes: need no radius, for between has all"),
        ({"classes": {"a": None}, "between": [1]}, r"between of shape \(1,\): must be 1 x 1"),
        ({"classes": KINDS, "border": {"rocks": 1}}, "border 'rocks': must be the name of a class"),
        ({"radius": 1, "between": "union"}, "between 'union': is for classes"),
        ({"radius": 1, "keep_classes": [0]}, "keep_classes: is for points with classes"),
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


def test_borders_of_classes_are_those_of_each() -> None:
    kinds: Any = {"trees": 0.06, "grass": 0.01}
    parcel = [[(0.1, 0.1), (0.9, 0.2), (0.6, 0.9)]]
    for where in ({"inside_by_radius": True}, {"border": {"trees": 0.1}}):
        made = lacuna.sample(classes=kinds, inside=parcel, seed=6, **where)
        assert lacuna.verify(made, inside=parcel, edge=0.02 / 16).maximal
        assert lacuna.verify(
            made.points, classes=kinds, class_of=made.class_of, inside=parcel, edge=0.02 / 16,
            domain=made.domain, **where,
        ).maximal  # fmt: skip
    assert made.report()["request"]["borders"] == [0.1, 0]
    points = made.points.copy()
    nearest = np.flatnonzero(made.class_of == 0)[0]
    points[nearest] = (0.11, 0.12)
    found = lacuna.verify(
        points, classes=kinds, class_of=made.class_of, domain=made.domain, inside=parcel, **where
    )
    assert found.forbidden == nearest and found.forbidden_by == "inside"


def test_polygons_of_classes_hold_their_points_alone() -> None:
    wet = [[(0.2, 0.2), (0.8, 0.3), (0.6, 0.7)]]
    kinds = {"trees": 0.05, "reeds": 0.01}
    made = lacuna.sample(classes=kinds, inside={"reeds": wet}, domain=(1, 1), seed=2)
    assert lacuna.verify(made, inside={"reeds": wet}, edge=0.02 / 16).maximal
    found = lacuna.verify(made, inside={"trees": wet}, edge=0.02 / 16)
    assert found.forbidden_by == "inside" and made.class_of is not None
    assert made.classes[made.class_of[found.forbidden or 0]] == "trees"
    with pytest.raises(lacuna.BadRequest, match="inside rocks: is no class of this set"):
        lacuna.sample(classes=kinds, inside={"rocks": wet})
    of_all = lacuna.sample(classes=kinds, inside={None: wet}, domain=(1, 1), seed=2)
    same = lacuna.sample(classes=kinds, inside=wet, domain=(1, 1), seed=2)
    assert (of_all.points == same.points).all()


def test_a_range_of_radii_is_a_kind_of_several_sizes(tmp_path):
    kinds = {"trees": ("0.04..0.08/5", 2), "grass": 0.01}
    made = lacuna.sample(classes=kinds, seed=3)
    assert made.classes == ("trees",) * 5 + ("grass",)
    sizes = np.array([0.04, 0.05, 0.06, 0.07, 0.08, 0.01])
    assert np.allclose(made.radii_of_classes, sizes[made.class_of])
    assert lacuna.verify(made)
    assert lacuna.verify(made.points, classes=kinds, class_of=made.class_of)
    kept = lacuna.sample(classes=kinds, keep=made, seed=4)
    assert np.array_equal(kept.class_of, made.class_of)
    made.save(tmp_path / "a.csv")
    with open(tmp_path / "a.csv") as file:
        assert file.readline() == "x,y,radius,class\n"
    refused(lacuna.BadRequest, "keep_classes", lacuna.sample, classes=kinds, keep=[(0.5, 0.5)], keep_classes=["trees"])
    refused(lacuna.BadRequest, "classes", lacuna.sample, classes={"a": "3..1"})
    refused(lacuna.BadRequest, "classes", lacuna.sample, classes={"a": "1..3"}, between=[[1]])


def test_a_mask_beside_polygons_allows_what_both_allow():
    left = np.array([[True, False]])
    hole = [(0.2, 0.4), (0.4, 0.4), (0.4, 0.6), (0.2, 0.6)]
    made = lacuna.sample(0.03, mask=left, outside=[hole], domain=(1, 1), seed=1)
    x, y = made.points.T
    assert (x < 0.5).all()
    assert not ((x > 0.2) & (x < 0.4) & (y > 0.4) & (y < 0.6)).any()
    assert lacuna.verify(made, mask=left, outside=[hole])
    assert not lacuna.verify(made, outside=[hole])
