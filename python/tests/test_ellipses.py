"""Ellipses in Python: proofs, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np

import lacuna
from conftest import refused


def swirl(pixels: int = 16, a: float = 0.08, b: float = 0.02) -> np.ndarray[Any, Any]:
    y, x = np.mgrid[1 : -1 : pixels * 1j, -1 : 1 : pixels * 1j]
    return np.dstack([np.full_like(x, a), np.full_like(x, b), np.arctan2(x, -y)])


def test_sets_are_proven_and_refuted() -> None:
    made = lacuna.sample(ellipses=swirl(), seed=3)
    assert made.maximal and made.scale == 1
    assert lacuna.verify(made, ellipses=swirl())
    assert lacuna.verify(made.points, ellipses=swirl())
    assert not lacuna.verify(made.points[1:], ellipses=swirl())
    assert not lacuna.verify(made.points, ellipses=swirl(), scale=2)


def test_each_point_has_the_ellipse_of_its_pixel() -> None:
    ellipses = swirl(2)
    ellipses[0, 0] = (0.01, 0.04, 0.25)  # its second radius is the longer one
    made = lacuna.sample(ellipses=ellipses, scale=0.5, seed=3)
    assert made.ellipses is not None and made.ellipses.shape == (len(made), 3)
    upper_left = (made.points[:, 0] < 0.5) & (made.points[:, 1] > 0.5)
    own = made.ellipses[upper_left]
    assert len(own) > 10
    np.testing.assert_allclose(own[:, 0], 0.02)
    np.testing.assert_allclose(own[:, 1], 0.005)
    np.testing.assert_allclose(np.sin(own[:, 2] - 0.25 - np.pi / 2), 0, atol=1e-12)
    assert lacuna.sample(0.1, seed=1).ellipses is None


def test_any_dtype_and_strides_give_the_same_set() -> None:
    ellipses = swirl()
    points = lacuna.sample(ellipses=ellipses, seed=3).points
    for same in (np.asfortranarray(ellipses), ellipses.astype(">f8"), ellipses.tolist()):
        np.testing.assert_array_equal(lacuna.sample(ellipses=same, seed=3).points, points)


def test_what_is_refused() -> None:
    flat = swirl()[:, :, 0]
    refused(lacuna.BadRequest, "ellipses", lacuna.sample, ellipses=flat)
    refused(lacuna.BadRequest, "ellipses", lacuna.sample, ellipses=swirl(), field=np.ones((2, 2)))
    refused(lacuna.BadRequest, "classes", lacuna.sample, ellipses=swirl(), classes={"a": 0.1})
    refused(lacuna.BadRequest, "relax", lacuna.sample, ellipses=swirl(), n=9, relax=3)


def test_dots_lie_along_the_edges_of_a_picture() -> None:
    stripes = np.tile(0.5 + 0.4 * np.sin(np.arange(96) * (2 * np.pi / 12)), (96, 1))
    dots = lacuna.stipple(stripes, 300, seed=1, along=5)
    assert dots.ellipses is not None and len(dots) == 300
    a, b, angle = dots.ellipses.T
    assert (a / b > 4).all() and np.abs(np.cos(angle)).max() < 0.05
