"""Progressive orders: new sequences, and points that are there already."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

import lacuna


def test_a_sequence_may_be_cut_anywhere() -> None:
    all_points = lacuna.sample(n=500, torus=True, progressive=True, seed=3)
    some = lacuna.sample(n=123, torus=True, progressive=True, seed=3)
    assert (some.points == all_points.points[:123]).all()
    assert not all_points.maximal and len(all_points.levels) > 60
    radius, count = all_points.levels[40]
    assert lacuna.verify(all_points.points[:count], radius, torus=True).maximal
    assert not lacuna.verify(all_points.points[: count - 1], radius, torus=True).maximal


def test_many_sequences_are_those_of_sample() -> None:
    made = lacuna.sample_many(range(3), n=60, torus=True, progressive=True)
    for seed, one in enumerate(made):
        expected = lacuna.sample(n=60, torus=True, progressive=True, seed=seed)
        assert (one.points == expected.points).all() and one.levels == expected.levels


@pytest.mark.parametrize("has_field", [False, True])
def test_an_order_is_the_commands(
    command: Callable[..., Any], tmp_path: Path, has_field: bool
) -> None:
    made = lacuna.sample(n=300, seed=1)
    made.save(tmp_path / "a.npy")
    field = np.linspace(0.1, 1, 12) * np.ones((12, 1)) if has_field else None
    more: list[object] = []
    if field is not None:
        np.save(tmp_path / "field.npy", field)
        more = [tmp_path / "field.npy", "--invert"]
    expected = command("order", tmp_path / "a.npy", *more, "--seed", 5)
    order = lacuna.order(made, field, seed=5)
    assert sorted(order) == list(range(300))
    assert (made.points[order] == expected[:, :2]).all()


def test_an_order_refuses_points_outside() -> None:
    with pytest.raises(lacuna.BadRequest, match=r"points point 1 at \(2, 0.5\): must lie in"):
        lacuna.order([(0.5, 0.5), (2, 0.5)])
    assert len(lacuna.order(np.empty((0, 2)))) == 0
