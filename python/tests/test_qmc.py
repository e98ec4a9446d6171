"""lacuna's engine in comparison with scipy's."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

import lacuna

qmc = pytest.importorskip("lacuna.qmc")
scipy_qmc = pytest.importorskip("scipy.stats.qmc")
spatial = pytest.importorskip("scipy.spatial")


def test_points_come_in_the_order_of_the_set() -> None:
    expected = lacuna.sample(0.02, seed=5).points
    engine = qmc.PoissonDisk(2, radius=0.02, rng=5)
    parts = [engine.random(n) for n in (0, 1, 10, 100, 700)] + [engine.fill_space()]
    assert (np.concatenate(parts) == expected).all()
    assert engine.num_generated == len(expected)
    assert engine.random(5).shape == (0, 2) and engine.fill_space().shape == (0, 2)


def test_reset_and_fast_forward() -> None:
    engine = qmc.PoissonDisk(2, radius=0.05, rng=np.random.default_rng(1))
    first = engine.random(50)
    assert engine.reset() is engine and engine.num_generated == 0
    assert (engine.fast_forward(20).random(30) == first[20:]).all()
    assert isinstance(engine, scipy_qmc.QMCEngine)


@pytest.mark.parametrize(
    ("low", "high", "radius"),
    [
        ((-1, 0), (1, 1), 0.05),
        ((1e6, -1e6), (1e6 + 1, -1e6 + 2), 0.03),
        ((-3e-5, 4e-5), (1e-5, 6e-5), 1e-6),
        ((1e12, 0), (1e12 + 100, 100), 3.0),
        (5, 7, 0.1),
    ],
)
@pytest.mark.parametrize("torus", [False, True])
def test_points_keep_their_distance_with_bounds(
    low: object, high: object, radius: float, torus: bool
) -> None:
    engine = qmc.PoissonDisk(2, radius=radius, l_bounds=low, u_bounds=high, torus=torus, rng=3)
    points = engine.fill_space()
    assert (points >= low).all() and (points < high).all()
    pairs = spatial.KDTree(points).query_pairs(1.5 * radius, output_type="ndarray")
    assert len(pairs) > 100
    between = points[pairs[:, 0]] - points[pairs[:, 1]]
    assert np.sqrt((between**2).sum(axis=1)).min() >= radius


@pytest.mark.parametrize(
    ("argument", "arguments"),
    [
        ("d", {"d": 4}),
        ("radius", {"radius": 0}),
        ("radius", {"radius": float("nan")}),
        ("l_bounds", {"l_bounds": (0, 2)}),
        ("l_bounds", {"l_bounds": (0, float("nan"))}),
        ("u_bounds", {"l_bounds": -1e308, "u_bounds": 1.7e308}),
        ("u_bounds", {"u_bounds": (1, 1e5)}),
        ("u_bounds", {"u_bounds": 1e201, "radius": 1e200}),
        ("u_bounds", {"u_bounds": (1, 2, 3)}),
        ("seed", {"rng": 1, "seed": 2}),
        ("hypersphere", {"hypersphere": "ball"}),
        ("ncandidates", {"ncandidates": 0}),
        ("optimization", {"optimization": "lloyd"}),
        ("backend", {"backend": "none"}),
    ],
)
def test_the_engine_refuses(argument: str, arguments: dict[str, object]) -> None:
    with pytest.raises(ValueError) as caught:
        qmc.PoissonDisk(**arguments)
    assert str(caught.value).startswith(argument)


def test_scipys_arguments_are_taken_or_refused_by_name() -> None:
    expected = qmc.PoissonDisk(2, radius=0.1, rng=1).random(50)
    engine = qmc.PoissonDisk(
        2, radius=0.1, hypersphere="surface", ncandidates=5, optimization=None, rng=1
    )
    assert (engine.random(50) == expected).all()
    # The module is imported when it is first used.
    alone = "import lacuna; print(len(lacuna.qmc.PoissonDisk(2, radius=0.1, rng=1).random(9)))"
    told = subprocess.run([sys.executable, "-c", alone], check=True, capture_output=True)
    assert told.stdout == b"9\n"


def test_more_points_fit_than_scipy_finds() -> None:
    theirs = scipy_qmc.PoissonDisk(2, radius=0.04, rng=np.random.default_rng(1)).fill_space()
    ours = qmc.PoissonDisk(2, radius=0.04, rng=1).fill_space()
    assert len(ours) > 1.05 * len(theirs)
    assert lacuna.verify(ours, 0.04).maximal and not lacuna.verify(theirs, 0.04)
