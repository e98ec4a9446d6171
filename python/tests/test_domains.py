"""Fields, masks, polygons, borders and kept points: how Python gives them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import REPOSITORY, refused

import lacuna

LAKES = REPOSITORY / "examples" / "lakes.svg"


def pixels_under(array: npt.NDArray[Any], made: lacuna.PointSet) -> npt.NDArray[Any]:
    """The value of the pixel under each point."""
    rows, columns = array.shape
    x, y = (made.points / made.domain).T
    found: npt.NDArray[Any] = array[
        rows - 1 - np.floor(y * rows).astype(int), np.floor(x * columns).astype(int)
    ]
    return found


def test_a_set_on_pixels_is_a_mask(tmp_path: Path, ramp: npt.NDArray[np.float64]) -> None:
    made = lacuna.sample(n=300, on_pixels=(40, 25), field=ramp, torus=True, seed=4)
    assert (made.mode, made.domain, made.radius, made.scale) == ("pixels", (40, 25), 1, None)
    assert made.pixels.shape == (25, 40) and made.pixels.dtype == bool and made.pixels.sum() == 300
    rows, columns = np.nonzero(made.pixels)
    assert (np.column_stack([columns + 0.5, 24.5 - rows]) == made.points).all()
    assert lacuna.verify(made).kept and made.report()["request"]["on_pixels"] == "40x25"
    half = lacuna.sample(n=90, on_pixels=(40, 25), mask=[[1, 0]], domain=(2, 1), seed=4)
    assert not half.pixels[:, 20:].any()
    triangle = [(0, 0), (40, 0), (0, 25)]
    inside = lacuna.sample(n=400, on_pixels=(40, 25), inside=[triangle], seed=4)
    assert inside.pixels.sum() == 400 and not inside.pixels[0, 3:].any()
    one = lacuna.sample_many([4], n=90, on_pixels=(40, 25))[0]
    assert (one.pixels == lacuna.sample(n=90, on_pixels=(40, 25), seed=4).pixels).all()
    made.save(tmp_path / "mask.png")
    as_picture = lacuna.stipple(tmp_path / "mask.png", 30, relax=0, seed=0)
    assert as_picture.domain == (1, 0.625)
    with pytest.raises(AttributeError, match="made without on_pixels"):
        lacuna.sample(0.1).pixels
    refused(TypeError, "on_pixels", lacuna.sample, n=3, on_pixels=5)


def test_a_drawn_mask_is_as_good_as_its_polygons() -> None:
    page = lacuna.read_polygons(LAKES)
    assert page.domain is not None and len(page) == len(page.rings) > 1
    mask = lacuna.draw_mask(page, 0.1, border=1)
    drawn = lacuna.sample(2, mask=mask, domain=page.domain, border=1, seed=0)
    made = lacuna.sample(2, inside=page, edge=0.1, border=1, seed=0)
    assert (made.points == drawn.points).all() and made.domain == page.domain
    assert lacuna.verify(made, inside=page, edge=0.1, border=1).maximal
    with pytest.raises(lacuna.BadRequest, match="^mask missing: the set was made with one"):
        lacuna.verify(made)


def test_a_mask_may_have_more_pixels_a_side_than_a_picture() -> None:
    mask = np.arange(2**20 + 10) % 5 == np.array([[0], [2], [4]])
    made = lacuna.sample(0.1, mask=mask * -1e-300, domain=(1, 1), seed=1)  # all but 0 is allowed
    assert made.maximal and len(made) > 70 and pixels_under(mask, made).all()


def test_a_set_that_was_stopped_is_carried_on() -> None:
    begun = lacuna.sample(0.05, limit=100, seed=1)
    for keep in (begun, begun.points.astype(">f8"), np.asfortranarray(begun.points)):
        made = lacuna.sample(0.05, keep=keep, seed=2)
        assert not begun.maximal and made.maximal
        assert (made.points[:100] == begun.points).all() and lacuna.verify(made).maximal
    assert len(lacuna.sample(n=400, keep=begun, seed=2)) == 400
    report: Any = made.report()["request"]
    assert report["kept"] == 100


def test_rings_of_arrays_and_of_lists_are_drawn_alike() -> None:
    outer, hole = [(0, 0), (2, 0), (2, 1), (0, 1)], [(0.5, 0.25), (1.5, 0.25), (1, 0.75)]
    mask = lacuna.draw_mask([outer, hole], 0.01, domain=(2, 1))
    assert mask.dtype == np.bool_ and mask.ndim == 2
    assert mask.mean() == pytest.approx(1 - 0.25 / 2 - 0.026, abs=0.005)
    assert not mask[mask.shape[0] // 2, mask.shape[1] // 2] and mask[3, 3]
    same = lacuna.draw_mask(
        (np.asarray(ring, ">f4") for ring in (hole[::-1], outer)), 0.01, domain=(2, 1)
    )
    assert (mask == same).all()


def test_rings_of_arrays_enclose_what_the_same_rings_of_a_text_do(tmp_path: Path) -> None:
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    # Two that overlap, a hole within both, and an island that stands there twice.
    rings = [10 * corners, 5 + 10 * corners, 6 + 3 * corners, 7 + corners, 7 + corners]
    path = tmp_path / "rings.txt"
    path.write_text("\n\n".join("\n".join(f"{x} {y}" for x, y in ring) for ring in rings))
    read = lacuna.read_polygons(str(path))
    assert read.domain is None and lacuna.domain_around(read) == (15, 15)
    mask = lacuna.draw_mask(rings, 0.1, domain=(15, 15))
    assert (mask == lacuna.draw_mask(read, 0.1, domain=(15, 15))).all()
    side = len(mask) / 15
    for spot, is_inside in ((5.5, True), (6.5, False), (7.5, True), (8.5, False), (9.5, True)):
        assert mask[int((15 - spot) * side), int(spot * side)] == is_inside
    places: Any
    for places in ({"inside": rings}, {"outside": rings}, {"avoid": [(rings, 0.5)]}):
        made = lacuna.sample(0.5, domain=(15, 15), seed=1, **places)
        assert lacuna.verify(made, edge=0.5 / 16, **places).maximal
        assert (abs(made.points - 5.5) < 0.5).all(axis=1).any() == ("inside" in places)


MAP = (448000.0, 5411000.0, 450000.0, 5412500.0)


def test_a_domain_may_have_any_corner() -> None:
    made = lacuna.sample(90, domain=MAP, seed=3)
    assert made.domain == MAP and lacuna.verify(made).maximal
    assert (made.points == lacuna.sample(90, domain=(2000, 1500), seed=3).points + MAP[:2]).all()
    assert not lacuna.verify(made.points, 90)
    assert lacuna.verify(made.points, 90, domain=made.domain).maximal
    # One at (0, 0) is the same as none.
    assert lacuna.sample(0.5, domain=(0, 0, 2, 1), seed=1).domain == (2, 1)
    odd = (0.1, -1e3, 0.8, -999.7)  # the sides are no exact differences
    assert lacuna.sample(0.05, domain=odd, seed=1).domain == odd
    assert [one.domain for one in lacuna.sample_many(range(2), 90, domain=MAP)] == [MAP, MAP]


def test_results_take_their_corner_along(tmp_path: Path) -> None:
    made = lacuna.sample(90, domain=MAP, torus=True, seed=3)
    moved = lacuna.relax(made, iterations=2)
    assert moved.domain == MAP and (moved.points >= MAP[:2]).all() and (moved.points < MAP[2:]).all()
    assert sorted(lacuna.order(made)) == list(range(len(made)))
    plain = lacuna.sample(90, domain=(2000, 1500), torus=True, seed=3)
    assert lacuna.analyze(made).psi_6 == pytest.approx(lacuna.analyze(plain).psi_6)
    made.save(tmp_path / "a.json")
    assert '"x0":448000.0,"y0":5411000.0' in (tmp_path / "a.json").read_text()
    missing = lacuna.verify(made.points[1:], 90, domain=MAP, torus=True)
    assert missing.largest_gap is not None
    assert np.hypot(*(missing.largest_gap - made.points[0])) < 90
    axes = made.plot()
    assert (axes.get_xlim(), axes.get_ylim()) == ((448000, 450000), (5411000, 5412500))
    relaxed = lacuna.sample(n=50, domain=MAP, relax=2, seed=1)
    assert relaxed.relaxed is not None and relaxed.relaxed.domain == MAP


def test_outlines_have_points_where_they_lie() -> None:
    parcel, rock = [(448251, 5411932), (448900, 5411950), (448800, 5412400)], [(448700.5, 5412000)]
    around = (448251, 5411932, 448900, 5412400)
    assert lacuna.domain_around([parcel]) == around
    where: Any = {"inside": [parcel], "avoid": [([rock], 60)], "border": 5}
    made = lacuna.sample(20, seed=0, **where)
    assert made.domain == around and lacuna.verify(made, edge=20 / 16, **where).maximal
    with pytest.raises(lacuna.BadRequest, match="has no area: give a domain"):
        lacuna.sample(20, avoid=[([[(448000, 5), (448900, 5)]], 3)])


def test_what_breaks_a_set_is_told() -> None:
    y, x = np.mgrid[0:20, 0:40]
    mask, field = np.hypot(x - 15, y - 9) > 6, 0.1 + x / 39
    keep = [(0.1, 0.1), (0.9, 0.4)]
    where: dict[str, Any] = {"field": field, "mask": mask, "border": 0.03, "keep": keep}
    made = lacuna.sample(scale=0.02, seed=3, **where)
    assert lacuna.verify(made, **where).maximal
    turned = lacuna.verify(made.points[[1, 0, *range(2, len(made))]], scale=0.02, **where)
    assert turned.moved == 0 and not turned and turned.covered is None
    for spot, reason in (((0.37, 0.27), "mask"), ((0.5, 0.01), "border")):
        more = lacuna.verify(np.vstack([made.points, spot]), scale=0.02, **where)
        assert (more.forbidden, more.forbidden_by) == (len(made), reason)


def test_a_claim_takes_the_shape_that_it_is_told_of() -> None:
    mask = np.ones((2, 4))
    assert lacuna.verify([(0.5, 0.6)], 2, mask=mask).outside == 0
    assert lacuna.verify([(0.5, 0.6)], 2, mask=mask, domain=(1, 1)).maximal
    assert lacuna.verify([(0.5, 0.6)], mask=mask, field=np.ones((3, 3)), scale=2).maximal


def test_files_of_polygons_that_are_none_are_refused(tmp_path: Path) -> None:
    refused(ValueError, "path", lacuna.read_polygons, tmp_path / "a\nb.png")
    refused(TypeError, "path", lacuna.read_polygons, 3)
    (tmp_path / "broken.svg").write_text("<svg")
    (tmp_path / "line.txt").write_text("0 0\n1 1\n")
    for name in ("none.svg", "broken.svg", "line.txt"):
        with pytest.raises(OSError, match=f"^[^\n]*{name}[^\n]*$") as caught:
            lacuna.read_polygons(tmp_path / name)
        assert isinstance(caught.value, lacuna.FileError)


def test_several_polygons_are_joined_and_others_left_out() -> None:
    def square(low: float, high: float) -> list[tuple[float, float]]:
        return [(low, low), (high, low), (high, high), (low, high)]

    inside, outside = [[square(0, 0.6)], [square(0.4, 1)]], [square(0.3, 0.45)]
    polygons = [lacuna.Polygons(tuple(map(np.array, rings)), None) for rings in inside]
    made = lacuna.sample(0.05, inside=polygons, outside=outside, edge=0.01, seed=0)
    assert lacuna.verify(made.points, 0.05, inside=polygons, outside=outside, edge=0.01).maximal
    assert not lacuna.verify(made.points, 0.05, inside=polygons[0], edge=0.01)
    everywhere = lacuna.draw_mask(None, 0.01, outside=outside)
    assert 0.97 < everywhere.mean() < 0.98


def test_obstacles_and_what_is_near_are_pairs_of_lines_and_a_distance(tmp_path: Path) -> None:
    (tmp_path / "fence.txt").write_text("0.2 0.5\n0.8 0.5\n")
    fence = lacuna.read_lines(tmp_path / "fence.txt")
    assert [ring.tolist() for ring in fence.rings] == [[[0.2, 0.5], [0.8, 0.5]]]
    where: Any = {"near": [(fence, 0.3)], "avoid": [(fence, 0.05), ([np.array([[0.5, 0.7]])], 0.06)]}
    made = lacuna.sample(0.02, seed=1, **where)
    assert lacuna.verify(made, edge=0.02 / 16, **where).maximal
    assert lacuna.verify(made, near=[(fence, 0.2)]).forbidden_by == "inside"
    assert 0.1 < lacuna.draw_mask(None, 0.01, domain=(1, 1), **where).mean() < 0.6
    for name in ("avoid", "near"):
        refused(TypeError, name, lacuna.draw_mask, None, 0.01, **{name: fence})
        refused(lacuna.BadRequest, name, lacuna.draw_mask, None, 0.01, **{name: [(fence, -1)]})
        refused(lacuna.BadRequest, name, lacuna.sample, 0.02, **{name: [(fence, 0)]})
