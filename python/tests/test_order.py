"""Progressive orders: new sequences, and points that are there already."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

import lacuna


def test_an_order_is_the_commands(command: Callable[..., Any], tmp_path: Path) -> None:
    made = lacuna.sample(n=300, seed=1)
    made.save(tmp_path / "a.npy")
    field = np.linspace(0.1, 1, 12) * np.ones((12, 1))
    np.save(tmp_path / "field.npy", field)
    more = [tmp_path / "field.npy", "--invert", "--seed", 5]
    expected = command("order", tmp_path / "a.npy", *more)
    order = lacuna.order(made, field, seed=5)
    assert sorted(order) == list(range(300))
    assert (made.points[order] == expected[:, :2]).all()


def test_an_order_refuses_points_outside() -> None:
    with pytest.raises(lacuna.BadRequest, match=r"points point 1 at \(2, 0.5\): must lie in"):
        lacuna.order([(0.5, 0.5), (2, 0.5)])
    assert len(lacuna.order(np.empty((0, 2)))) == 0


def test_a_progressive_set_has_levels() -> None:
    made = lacuna.sample(n=60, torus=True, progressive=True, seed=2)
    (radius, count), *more = made.levels
    assert len(more) > 20 and more[0][0] < radius and count < more[-1][1] <= 60
    many = lacuna.sample_many([2], n=60, torus=True, progressive=True)
    assert many[0].levels == made.levels


def test_a_threshold_mask_has_each_rank_once_and_a_seed() -> None:
    ranks = lacuna.threshold_mask(32, 16, seed=3)
    assert ranks.shape == (16, 32) and ranks.dtype == np.uint32
    assert (np.sort(ranks, axis=None) == np.arange(512)).all()
    assert (ranks == lacuna.threshold_mask(32, 16, seed=3)).all()
    assert (ranks != lacuna.threshold_mask(32, 16, seed=4)).any()
    frames = lacuna.threshold_mask(32, 16, seed=3, frames=4)
    assert frames.shape == (4, 16, 32) and (np.sort(frames.ravel()) == np.arange(2048)).all()
    with pytest.raises(TypeError, match="rows must be a whole number"):
        lacuna.threshold_mask(64, "64")  # type: ignore[arg-type]
