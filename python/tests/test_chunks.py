"""Chunks, which keep the points of those beside them, and tiles that share a frame."""

import numpy as np
import pytest
from conftest import refused

import lacuna

EAST = (1, 0, 2, 1)
CLASSES = {"trees": 0.06, "grass": 0.02}


def test_a_chunk_beside_another_is_proven_with_its_points():
    west = lacuna.sample(0.05, seed=1)
    east = lacuna.sample(0.05, domain=EAST, keep=west, seed=2)
    assert east.maximal and (east.points[:, 0] >= 1).all()
    assert lacuna.verify(east)
    assert lacuna.verify(east.points, 0.05, domain=EAST, keep=west).maximal
    both = np.vstack([west.points, east.points])
    assert lacuna.verify(both, 0.05, domain=(2, 1), tolerance=2**-26).maximal
    alone = lacuna.verify(east.points, 0.05, domain=EAST)
    assert alone.kept and not alone.covered
    request = east.report()["request"]
    near = (west.points[:, 0] >= 0.95).sum()
    assert (request["kept"], request["neighbours"]) == (0, near)


def test_a_chunk_has_kept_points_of_its_own_too():
    west = lacuna.sample(0.05, seed=1).points
    kept = np.vstack([[(1.5, 0.5)], west, [(1.2, 0.9)]])
    east = lacuna.sample(0.05, domain=EAST, keep=kept, seed=2)
    assert (east.points[:2] == [(1.5, 0.5), (1.2, 0.9)]).all()
    assert lacuna.verify(east) and lacuna.verify(east, keep=kept)
    assert east.report()["request"]["kept"] == 2


def test_chunks_of_classes_are_proven():
    west = lacuna.sample(classes=CLASSES, seed=1)
    east = lacuna.sample(classes=CLASSES, domain=EAST, keep=west, seed=2)
    assert lacuna.verify(east)
    given = {"classes": CLASSES, "domain": EAST, "class_of": east.class_of}
    assert lacuna.verify(east.points, keep=west, **given)
    assert lacuna.verify(east.points, keep=west.points, keep_classes=west.class_of, **given)
    refused(lacuna.BadRequest, "keep", lacuna.verify, east.points, keep=west.points, **given)


def test_a_neighbour_that_is_too_close_is_named_and_drawn():
    points, keep = [(1.01, 0.5)], [(-3, 0.5), (0.96, 0.5)]
    verdict = lacuna.verify(points, 0.1, domain=EAST, keep=keep)
    assert verdict.closest_pair == (0, 2)
    assert verdict.reason.startswith("points 0 and 1 of keep are 0.05 apart")
    pytest.importorskip("matplotlib")
    line = verdict.plot().lines[-1]
    assert sorted(line.get_xdata()) == [0.96, 1.01]


@pytest.mark.parametrize("as_iterator", [False, True])
def test_tiles_of_one_frame_fit_side_by_side(as_iterator):
    seeds = range(30)
    given = iter(seeds) if as_iterator else seeds
    tiles = list(lacuna.sample_many(given, 0.08, torus=True, frame=0.12))
    assert len(tiles) == 30 and all(lacuna.verify(tile) for tile in tiles[:3])
    kept = tiles[0].report()["request"]["kept"]
    assert (tiles[0].points[:kept] == tiles[7].points[:kept]).all()
    assert not (tiles[0].points[kept] == tiles[7].points[kept]).all()


def test_frames_that_are_too_narrow_are_refused():
    for more in ({"radius": 0.08, "torus": True}, {"radius": 0.08}, {"n": 50, "torus": True}):
        refused(lacuna.BadRequest, "frame", lacuna.sample_many, range(3), frame=0.1, **more)


def test_one_lake_serves_the_chunks_beside_it_and_within_it():
    lake, beside = [100 * np.array([(0, 0), (1, 0), (1, 1), (0, 1)])], (0, 192, 64, 256)
    full = lacuna.sample(3, domain=beside, outside=lake, seed=1)
    assert len(full) > 300 and lacuna.verify(full, outside=lake, edge=3 / 16).maximal
    for where in (
        {"domain": (10, 10, 74, 74), "outside": lake},
        {"domain": beside, "inside": lake},
        {"domain": beside, "near": [(lake, 2)]},
        {"domain": beside, "mask": np.zeros((2, 2))},
    ):
        empty = lacuna.sample(3, seed=1, **where)
        assert len(empty) == 0 and empty.maximal
        assert lacuna.verify(empty.points, 3, **where).maximal
        edge = None if "mask" in where else 0.1
        refused(ValueError, "n", lacuna.sample, n=9, edge=edge, **where)
        # The next chunk keeps the points of this one, which are none.
        assert len(lacuna.sample(3, domain=(74, 10, 138, 74), keep=empty, seed=1)) > 300
    assert not lacuna.draw_mask(lake, 0.5, domain=beside).any()


def test_any_chunk_is_proven_beside_what_it_keeps():
    for place in ((3, -2), (2, -2), (2, -1)):
        one = lacuna.sample(classes=CLASSES, chunk=place, chunk_size=0.5, priority=True, seed=7)
        assert lacuna.verify(one)
        x, y = place
        assert one.domain == (x / 2, y / 2, (x + 1) / 2, (y + 1) / 2)
        assert len(lacuna.sample(classes=CLASSES, chunk=place, chunk_size=0.5, seed=7)) > len(one)
    refused(lacuna.BadRequest, "chunk", lacuna.sample, 0.1, chunk=(1, 2), chunk_size=1, domain=(1, 1))
    refused(TypeError, "chunk", lacuna.sample, 0.1, chunk=3, chunk_size=1)
