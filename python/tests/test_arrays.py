"""Bad arrays cause an exception that names the argument, never a crash."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest
from conftest import refused

import lacuna

POINTS = np.random.default_rng(1).random((50, 2))


FIELDS: list[tuple[type[Exception], object]] = [
    (ValueError, []),
    (ValueError, 3.0),
    (ValueError, np.ones(8)),
    (ValueError, np.ones((4, 4, 3))),
    (ValueError, np.ones((0, 8))),
    (ValueError, np.full((8, 8), np.nan)),
    (ValueError, np.broadcast_to(1.0, (10**6, 10**6))),
    (ValueError, np.broadcast_to(1.0, (1, 2**21))),
    (TypeError, np.ones((8, 8), complex)),
    (TypeError, np.full((8, 8), "a")),
    (TypeError, np.full((8, 8), None)),
    (TypeError, np.zeros((8, 8), [("a", float)])),
    (TypeError, np.zeros((8, 8), "datetime64[s]")),
    (TypeError, object()),
    (TypeError, np.ma.masked_array(np.ones((3, 3)), mask=np.eye(3))),
    (ValueError, [[1, 2], [3]]),
]


@pytest.mark.parametrize(("error", "field"), FIELDS, ids=lambda value: f"{value!r:.30}")
def test_a_field_that_is_none_is_refused(error: type[Exception], field: object) -> None:
    refused(error, "field", lacuna.sample, n=10, field=field)
    refused(error, "field", lacuna.relax, POINTS, field)


def others_of(array: np.ndarray[Any, Any]) -> list[Any]:
    """The same whole numbers, up to 255, in other layouts and types."""
    rows, columns = array.shape
    padded = np.zeros((2 * rows, 3 * columns))
    padded[::2, ::3] = array
    read_only = array.copy()
    read_only.flags.writeable = False
    types = (">f8", "<f4", np.float16, np.longdouble, np.uint8, ">i2")
    same: list[Any] = [array.astype(one) for one in types]
    same += [np.asfortranarray(array), array[::-1].copy()[::-1], padded[::2, ::3]]
    return [*same, array.tolist(), read_only]


CALLS: list[Any] = [
    (np.arange(1.0, 49).reshape(6, 8), lambda field: lacuna.sample(n=100, field=field, seed=1)),
    (np.arange(48).reshape(6, 8) % 5 != 0, lambda mask: lacuna.sample(0.05, mask=mask, seed=1)),
    ((POINTS * 255).round(), lambda points: lacuna.relax(points, iterations=2, domain=(256, 256))),
]


@pytest.mark.parametrize(("array", "call"), CALLS, ids=["field", "mask", "points"])
def test_an_array_may_have_any_layout_and_type(array: np.ndarray[Any, Any], call: Any) -> None:
    expected = call(array).points
    for one in others_of(array):
        assert (call(one).points == expected).all()


def test_a_field_that_another_thread_changes_is_read_once() -> None:
    field = np.ones((300, 300))
    done = threading.Event()

    def change() -> None:
        value = 0
        while not done.is_set():
            field[:] = (np.nan, 1e-300, -1.0, 1e300, 0.0, 1.0)[value % 6]
            value += 1

    thread = threading.Thread(target=change)
    thread.start()
    try:
        for seed in range(20):
            try:
                made = lacuna.sample(n=500, field=field, seed=seed)
            except (lacuna.BadRequest, lacuna.MemoryRefused):
                continue
            assert made.points.shape == (500, 2)
    finally:
        done.set()
        thread.join()


def test_a_mask_of_numbers_that_are_not_finite_is_refused() -> None:
    for wrong in (np.inf, -np.inf, np.nan):
        mask = np.ones((4, 4))
        mask[2, 1] = wrong
        refused(lacuna.BadRequest, "mask", lacuna.sample, 0.1, mask=mask)
        refused(lacuna.BadRequest, "mask", lacuna.verify, POINTS, 0.1, mask=mask)


SETS: list[tuple[type[Exception], object]] = [
    (ValueError, np.ones((5, 3))),
    (ValueError, np.ones((2, 2, 2, 2))),
    (ValueError, np.ones(4)),
    (ValueError, 1.0),
    (ValueError, np.broadcast_to(0.5, (10**11, 2))),
    (TypeError, np.ones((5, 2), complex)),
    (TypeError, [["a", "b"]]),
    (TypeError, None),
    (TypeError, np.ma.masked_array(POINTS, mask=POINTS > 0.5)),
    (ValueError, [[0.1, 0.2], [0.3]]),
]


@pytest.mark.parametrize(("error", "points"), SETS, ids=lambda value: f"{value!r:.30}")
def test_points_that_are_none_are_refused(error: type[Exception], points: object) -> None:
    refused(error, "points", lacuna.verify, points, 0.1)
    refused(error, "points", lacuna.relax, points)
    refused(error, "points", lacuna.analyze, points)


@pytest.mark.parametrize("place", [(np.nan, 0.5), (0.5, np.inf), (-0.1, 0.5), (0.5, 1.5)])
def test_points_outside_the_domain_are_told(place: tuple[float, float]) -> None:
    points = np.vstack([POINTS, place])
    assert lacuna.verify(points, 1e-6).outside == 50
    assert not lacuna.verify(points, 1e-6)
    refused(ValueError, "points", lacuna.relax, points)
    refused(ValueError, "points", lacuna.analyze, points)


def test_no_points_are_a_set() -> None:
    sets: list[Any] = [np.empty((0, 2)), []]
    for empty in sets:
        assert len(lacuna.relax(empty)) == 0
        verdict = lacuna.verify(empty, 0.1)
        assert not verdict and verdict.closest_pair is None and verdict.largest_gap is None
        refused(ValueError, "points", lacuna.analyze, empty)
