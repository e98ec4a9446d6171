"""Bad arguments cause an exception that names the argument, never a crash."""

from __future__ import annotations

import os
from decimal import Decimal
from functools import partial
from typing import Any, Callable

import numpy as np
import pytest
from conftest import refused

import lacuna

POINTS = np.random.default_rng(1).random((50, 2))
FIELD = np.ones((8, 8))
MASK = np.ones((2, 3))
TRIANGLE = [(0, 0), (1, 0), (0, 1)]


# What each function is called with, and then what is refused.
REFUSED: list[tuple[Callable[..., object], list[tuple[type[Exception], str, dict[str, Any]]]]] = [
    (
        lacuna.sample,
        [
            (ValueError, "n", {"n": 2**64}),
            (TypeError, "n", {"n": 99.5}),
            (TypeError, "n", {"n": np.array([3, 4])}),
            (MemoryError, "n", {"n": 10**9, "memory_limit": 10**9}),
            (ValueError, "radius", {"radius": 10**400}),
            (TypeError, "radius", {"radius": "0.1"}),
            (TypeError, "metric", {"n": 10, "field": FIELD, "metric": 3}),
            (TypeError, "domain", {"radius": 0.1, "domain": (1, 2, 3)}),
            (TypeError, "domain", {"radius": 0.1, "domain": (0, 0, 1, 1, 1)}),
            (ValueError, "domain", {"radius": 0.1, "domain": (1, 0, 1, 2)}),
            (ValueError, "domain", {"radius": 0.1, "domain": (0, 0, np.nan, 1)}),
            (TypeError, "torus", {"radius": 0.1, "torus": "yes"}),
            (TypeError, "torus", {"radius": 0.1, "torus": None}),
            (ValueError, "seed", {"radius": 0.1, "seed": 2**64}),
            (TypeError, "seed", {"radius": 0.1, "seed": 1.5}),
            (TypeError, "seed", {"radius": 0.1, "seed": np.random.RandomState(1)}),
            (ValueError, "backend", {"radius": 0.1, "backend": "c\0pu"}),
            (ValueError, "backend", {"radius": 0.1, "backend": "\udcff"}),
            (ValueError, "device", {"radius": 0.1, "backend": "opencl", "device": "\udcff"}),
            (TypeError, "backend", {"radius": 0.1, "backend": None}),
            (TypeError, "device", {"radius": 0.1, "device": 1.5}),
            (ValueError, "memory_limit", {"radius": 0.1, "memory_limit": 0}),
            (TypeError, "progress", {"radius": 0.1, "progress": 3}),
            (TypeError, "inside", {"radius": 0.1, "inside": "lakes.svg"}),
            (TypeError, "avoid", {"radius": 0.1, "avoid": [TRIANGLE]}),
            (ValueError, "mask", {"radius": 0.1, "mask": np.ones(3)}),
            (ValueError, "mask", {"radius": 0.1, "mask": np.ones((0, 3))}),
            (ValueError, "mask", {"radius": 0.1, "mask": [[1], [1, 2]]}),
            (ValueError, "mask", {"radius": 0.1, "mask": np.broadcast_to(True, (10**6, 10**6))}),
            (TypeError, "mask", {"radius": 0.1, "mask": "black"}),
            (TypeError, "mask", {"radius": 0.1, "mask": MASK * 1j}),
            (TypeError, "mask", {"radius": 0.1, "mask": np.ma.masked_array(MASK, mask=MASK > 0)}),
            (TypeError, "mask", {"radius": 0.1, "mask": object()}),
            (TypeError, "border", {"radius": 0.1, "border": "wide"}),
            (TypeError, "border", {"radius": 0.1, "border": None}),
            (ValueError, "keep", {"radius": 0.1, "keep": [0.1, 0.2, 0.3]}),
            (TypeError, "keep", {"radius": 0.1, "keep": "points.txt"}),
            (TypeError, "keep", {"radius": 0.1, "keep": {"x": 1}}),
        ],
    ),
    (
        partial(lacuna.verify, POINTS),
        [
            (ValueError, "radius", {}),
            (TypeError, "radius", {"radius": "a"}),
            (ValueError, "scale", {"radius": 0.1, "scale": 0.1}),
            (ValueError, "scale", {"field": FIELD}),
            (TypeError, "scale", {"field": FIELD, "scale": "wide"}),
            (ValueError, "field", {"field": np.ones(8), "scale": 0.1}),
            (ValueError, "mask", {"radius": 0.1, "mask": np.ones(8)}),
            (ValueError, "inside", {"radius": 0.1, "inside": [[(0, 0), (1, 0)]]}),
            (TypeError, "inside", {"radius": 0.1, "inside": "lakes.svg"}),
            (ValueError, "keep", {"radius": 0.1, "keep": [0.1, 0.2, 0.3]}),
            (TypeError, "keep", {"radius": 0.1, "keep": "trees.csv"}),
            (TypeError, "torus", {"radius": 0.1, "torus": 2}),
            (TypeError, "distances_only", {"radius": 0.1, "distances_only": "no"}),
        ],
    ),
    (
        partial(lacuna.relax, POINTS),
        [
            (TypeError, "iterations", {"iterations": 1.5}),
            (TypeError, "measure", {"measure": None}),
            (TypeError, "progress", {"progress": "often"}),
        ],
    ),
    (
        lacuna.stipple,
        [
            (ValueError, "image", {"image": np.ones(3), "n": 10}),
            (ValueError, "image", {"image": np.ones((3, 3)), "n": 10}),  # white all over
            (ValueError, "image", {"image": np.empty((0, 3)), "n": 10}),
            (TypeError, "image", {"image": np.full((3, 3), "a"), "n": 10}),
            (TypeError, "image", {"image": np.full((3, 3), 1j), "n": 10}),
            (ValueError, "image", {"image": "a\0b.png", "n": 10}),
            (TypeError, "mode", {"image": np.eye(3), "n": 5, "mode": 1}),
        ],
    ),
    (
        partial(lacuna.draw_mask, rings=[TRIANGLE], edge=0.01),
        [
            (ValueError, "edge", {"memory_limit": 100}),
            (ValueError, "memory_limit", {"memory_limit": 0}),
            (TypeError, "edge", {"edge": "fine"}),
            (TypeError, "domain", {"domain": 3}),
            (ValueError, "rings", {"rings": TRIANGLE}),  # one ring is a list of one
            (ValueError, "rings", {"rings": [np.ones((3, 3))]}),
            (TypeError, "rings", {"rings": [TRIANGLE, None]}),
            (TypeError, "rings", {"rings": "lakes.svg"}),
            (TypeError, "rings", {"rings": 3}),
        ],
    ),
]


@pytest.mark.parametrize(
    ("call", "error", "argument", "arguments"),
    [(call, *row) for call, rows in REFUSED for row in rows],
    ids=lambda value: f"{value!r:.60}",
)
def test_what_is_refused(
    call: Callable[..., object], error: type[Exception], argument: str, arguments: dict[str, Any]
) -> None:
    refused(error, argument, call, **arguments)


def test_a_file_that_is_not_there_or_no_picture_is_an_oserror(tmp_path: Any) -> None:
    (tmp_path / "text.png").write_text("no picture")
    for path in (tmp_path / "none.png", tmp_path / "text.png", tmp_path, "-"):
        with pytest.raises(OSError) as caught:
            lacuna.stipple(path, 10)
        assert isinstance(caught.value, lacuna.FileError) and str(path) in str(caught.value)


def test_a_path_is_any_bytes_and_its_error_one_line(tmp_path: Any) -> None:
    folder = os.fsencode(tmp_path)
    np.save(tmp_path / "eye.npy", np.eye(4))
    os.rename(tmp_path / "eye.npy", folder + b"/\xff\xfe.npy")
    assert len(lacuna.stipple(folder + b"/\xff\xfe.npy", 7)) == 7
    assert len(lacuna.stipple(os.fsdecode(folder + b"/\xff\xfe.npy"), 7)) == 7
    with pytest.raises(lacuna.FileError, match=r"^[^\n]*a\\x0ab\.png: [^\n]*$"):
        lacuna.stipple(tmp_path / "a\nb.png", 7)


LONG: list[object] = [10**401, 10**10_000, "a" * 10_000, [1] * 1000, np.ones((9, 9)), [10**9999]]


@pytest.mark.parametrize("value", LONG, ids=lambda value: type(value).__name__)
def test_a_long_value_is_shortened_in_messages(value: Any) -> None:
    calls: list[tuple[str, Any]] = [
        (name, lambda name=name: lacuna.sample(**{"radius": 0.1, name: value}))
        for name in ("seed", "limit", "threads", "memory_limit", "backend", "device", "mode")
        + ("torus", "progress", "domain", "scale")
    ]
    calls += [
        ("n", lambda: lacuna.sample(n=value)),
        ("seeds", lambda: lacuna.sample_many([value], n=9)),
        ("radius", lambda: lacuna.verify(POINTS, value)),
        ("iterations", lambda: lacuna.relax(POINTS, iterations=value)),
        ("gamma", lambda: lacuna.stipple(FIELD / 2, gamma=value)),
    ]
    for name, call in calls:
        with pytest.raises((ValueError, TypeError)) as caught:
            call()
        message = str(caught.value)
        assert message.startswith(name) and len(message) < 200 and "\n" not in message


def test_a_path_with_a_lone_surrogate_is_refused() -> None:
    for call in (lacuna.stipple, lacuna.read_polygons, lacuna.sample(0.2, seed=1).save):
        name = "image" if call is lacuna.stipple else "path"
        refused(lacuna.BadRequest, name, call, "pic\ud800ture.svg")  # type: ignore[arg-type]


def test_messages_name_arguments_of_python() -> None:
    for image, arguments, named in (
        (np.ones((3, 3)), {}, "give invert=True or a min_importance over 0"),
        (np.zeros((3, 3)), {"invert": True}, "with invert=True no sample"),
        (np.eye(3), {"black": 0.5, "white": 0.2}, "must be over black"),
        (np.eye(3), {"black": 0.1, "auto_levels": True}, "with black or white"),
    ):
        with pytest.raises(lacuna.BadRequest) as caught:
            lacuna.stipple(image, **arguments)
        assert named in str(caught.value) and "--" not in str(caught.value)


def test_numbers_of_other_kinds_are_numbers() -> None:
    expected = lacuna.sample(0.25, seed=1).points
    for radius in (np.float32(0.25), Decimal("0.25"), np.array(0.25)):
        assert (lacuna.sample(radius, seed=np.uint8(1)).points == expected).all()


def test_whole_floats_are_whole_numbers() -> None:
    expected = lacuna.sample(n=100, seed=3, threads=1).points
    for n, seed in ((1e2, 3.0), (np.float32(100), np.float64(3))):
        assert (lacuna.sample(n=n, seed=seed, threads=1.0).points == expected).all()
    for n in (99.5, float("nan"), float("inf")):
        refused(TypeError, "n", lacuna.sample, n=n)


def test_a_generator_and_none_give_seeds_that_are_told() -> None:
    first = lacuna.sample(0.2, seed=np.random.default_rng(5))
    again = lacuna.sample(0.2, seed=np.random.default_rng(5))
    assert first.seed == again.seed and (first.points == again.points).all()
    entropy = lacuna.sample(0.2)
    assert (lacuna.sample(0.2, seed=entropy.seed).points == entropy.points).all()
    assert entropy.seed != lacuna.sample(0.2).seed


def test_a_backend_or_device_that_is_not_there_is_a_runtimeerror() -> None:
    for backend in ("opencl", "vulkan"):
        with pytest.raises(RuntimeError) as caught:
            lacuna.sample(0.1, backend=backend, device="no such device")
        assert isinstance(caught.value, lacuna.Unavailable)
