"""Surfaces and volumes: maximal by scipy's account, the same sets at each number of threads."""

import lacuna
import numpy as np
import pytest
from scipy.spatial import cKDTree


def hills(sides=40):
    """A height field over the unit square."""
    x, y = np.meshgrid(np.linspace(0, 1, sides), np.linspace(0, 1, sides))
    vertices = np.column_stack([x.ravel(), y.ravel(), (0.1 * np.sin(7 * x) * np.cos(5 * y)).ravel()])
    i = np.arange(sides * sides).reshape(sides, sides)
    first = np.column_stack([i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel()])
    second = np.column_stack([i[:-1, :-1].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()])
    return vertices, np.vstack([first, second])


def spots_on(vertices, faces, count):
    random = np.random.default_rng(1)
    u, v = random.random((2, count))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    which = random.integers(0, len(faces), count)
    a, b, c = (vertices[faces[which, k]] for k in range(3))
    return a + u[:, None] * (b - a) + v[:, None] * (c - a)


def test_a_surface_is_covered_and_no_pair_is_closer():
    vertices, faces = hills()
    made = lacuna.sample_surface(vertices, faces, 0.03, seed=2, threads=1)
    again = lacuna.sample_surface(vertices.tolist(), faces.tolist(), 0.03, seed=2, threads=3)
    assert np.array_equal(made.points, again.points) and made.maximal
    tree = cKDTree(made.points)
    assert not tree.query_pairs(0.03 * (1 - 1e-12))
    assert tree.query(spots_on(vertices, faces, 200_000))[0].max() <= 0.03 * (1 + 1e-7)
    assert lacuna.verify_surface(made, vertices, faces, 0.03).maximal
    wrong = lacuna.verify_surface(made.points[1:], vertices, faces, 0.03)
    assert not wrong and wrong.largest_gap is not None
    at = (vertices[faces[made.triangles]] * made.shares[:, :, None]).sum(axis=1)
    assert np.abs(at - made.points).max() < 1e-8
    assert np.allclose(np.linalg.norm(made.normals, axis=1), 1)


def test_a_volume_is_covered_and_no_pair_is_closer():
    made = lacuna.sample_volume(0.08, domain=(1, 1, 0.5), torus=True, seed=3)
    tree = cKDTree(made.points, boxsize=(1, 1, 0.5))
    assert not tree.query_pairs(0.08 * (1 - 1e-12))
    spots = np.random.default_rng(1).random((200_000, 3)) * (1, 1, 0.5)
    assert tree.query(spots)[0].max() <= 0.08 * (1 + 1e-7)
    assert lacuna.verify_volume(made, 0.08, domain=(1, 1, 0.5), torus=True)
    more = lacuna.sample_volume(n=500, keep=made.points[:9], seed=1)
    assert len(more) == 500 and np.array_equal(np.asarray(more)[:9], made.points[:9])


def test_the_engine_of_scipys_kind_has_three_dimensions() -> None:
    from lacuna import qmc

    engine = qmc.PoissonDisk(d=3, radius=0.1, rng=4, l_bounds=-1, u_bounds=(1, 0, 0))
    points = np.concatenate([engine.random(10), engine.fill_space()])
    assert points.shape[1] == 3 and (points >= -1).all() and (points < (1, 0, 0)).all()
    assert lacuna.verify_volume(points + 1, 0.1, domain=(2, 1, 1), tolerance=1e-8)
    with pytest.raises(lacuna.BadRequest, match="d 4: must be 2 or 3"):
        qmc.PoissonDisk(4)


@pytest.mark.parametrize(
    "argument, change",
    [
        ("radius", {"radius": None}),
        ("vertices", {"vertices": [(0, 0)]}),
        ("faces", {"faces": [(0, 1, 2.5)]}),
        ("faces", {"faces": [(0, 1, -1)]}),
        ("mesh", {"faces": [(0, 1, 5)]}),
        ("keep", {"keep": [(0, 0, np.nan)]}),
        ("allowed", {"allowed": [True, False]}),
    ],
)
def test_what_makes_no_sense_is_refused(argument, change):
    given = {"vertices": [(0, 0, 0), (1, 0, 0), (0, 1, 0)], "faces": [(0, 1, 2)], "radius": 0.1}
    with pytest.raises(lacuna.BadRequest) as refused:
        lacuna.sample_surface(**given | change)
    assert refused.value.argument == argument
    with pytest.raises(lacuna.BadRequest, match="must be .width, height, depth"):
        lacuna.sample_volume(0.1, domain=(1, 1))
