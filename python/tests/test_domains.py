"""Fields, masks, polygons, borders and kept points: sets fill exactly the allowed part."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import REPOSITORY, Command, refused

import lacuna

FIELD = np.ones((8, 8))
MASK = np.ones((2, 3))
LAKES = REPOSITORY / "examples" / "lakes.svg"


def pixels_under(array: npt.NDArray[Any], made: lacuna.PointSet) -> npt.NDArray[Any]:
    """The value of the pixel under each point."""
    rows, columns = array.shape
    x, y = (made.points / made.domain).T
    found: npt.NDArray[Any] = array[
        rows - 1 - np.floor(y * rows).astype(int), np.floor(x * columns).astype(int)
    ]
    return found


# ----------------------------------------------------------------------- the same as the command


def test_an_exact_set_on_a_field_is_the_commands(
    command: Command, tmp_path: Path, ramp: npt.NDArray[np.float64]
) -> None:
    np.save(tmp_path / "ramp.npy", ramp)
    picture = ["sample", "--field", tmp_path / "ramp.npy", "--invert", "--seed", 4]
    expected = command(*picture, "--scale", 0.04)
    made = lacuna.sample(scale=0.04, field=ramp, mode="exact", seed=4)
    assert made.points.tobytes() == expected.tobytes()
    assert (made.mode, made.metric, made.scale, made.maximal) == ("exact", "min", 0.04, True)
    expected = command(*picture, "--count", 150, "--torus")
    made = lacuna.sample(n=150, field=ramp, mode="exact", seed=4, torus=True)
    assert made.points.tobytes() == expected.tobytes()


def test_a_relaxed_exact_set_is_the_commands(
    command: Command, tmp_path: Path, ramp: npt.NDArray[np.float64]
) -> None:
    np.save(tmp_path / "ramp.npy", ramp)
    expected = command(
        "sample", "--field", tmp_path / "ramp.npy", "--invert", "--count", 150, "--relax", 3
    )
    made = lacuna.sample(n=150, field=ramp, seed=0, relax=3)
    assert made.points.tobytes() == expected.tobytes() and made.mode == "stratified"
    assert made.metric == "min" and made.relaxed is not None


def test_a_set_on_pixels_is_the_commands_and_a_mask(
    command: Command, tmp_path: Path, ramp: npt.NDArray[np.float64]
) -> None:
    np.save(tmp_path / "ramp.npy", ramp)
    np.save(tmp_path / "left.npy", [[1, 0]])
    pixels = ["sample", "--on-pixels", "40x25", "--seed", 4]
    field = ["--field", tmp_path / "ramp.npy", "--invert", "--count", 300, "--torus"]
    made = lacuna.sample(n=300, on_pixels=(40, 25), field=ramp, torus=True, seed=4)
    assert made.points.tobytes() == command(*pixels, *field).tobytes()
    assert (made.mode, made.domain, made.radius, made.scale) == ("pixels", (40, 25), 1, None)
    assert made.pixels.shape == (25, 40) and made.pixels.dtype == bool and made.pixels.sum() == 300
    rows, columns = np.nonzero(made.pixels)
    assert (np.column_stack([columns + 0.5, 24.5 - rows]) == made.points).all()
    assert lacuna.verify(made).kept and made.report()["request"]["on_pixels"] == "40x25"
    expected = command(*pixels, "--count", 90, "--mask", tmp_path / "left.npy", "--domain", "2x1")
    half = lacuna.sample(n=90, on_pixels=(40, 25), mask=[[1, 0]], domain=(2, 1), seed=4)
    assert half.points.tobytes() == expected.tobytes() and not half.pixels[:, 20:].any()
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
    for wrong, told in (
        ({"on_pixels": (40, 25), "radius": 2}, "on_pixels '?40x25'? with radius"),
        ({"on_pixels": (40, 0), "n": 2}, "on_pixels '?40x0"),
        ({"on_pixels": (4, 4), "n": 17}, "n 17: must be at most 16"),
    ):
        with pytest.raises(lacuna.BadRequest, match=told):
            lacuna.sample(**wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="on_pixels must be .columns, rows., not 5"):
        lacuna.sample(n=3, on_pixels=5)  # type: ignore[arg-type]


def test_a_set_on_all_of_a_domain_is_the_commands(command: Command, tmp_path: Path) -> None:
    y, x = np.mgrid[0:30, 0:60]
    lakes = np.hypot(x - 20, y - 12) > 8
    trees = np.array([(0.1, 0.1), (0.9, 0.4)])
    np.save(tmp_path / "lakes.npy", lakes)
    np.save(tmp_path / "trees.npy", trees)
    np.save(tmp_path / "field.npy", x / 59)
    files = ["--mask", tmp_path / "lakes.npy", "--keep", tmp_path / "trees.npy"]
    options = [*files, "--border", 0.02, "--seed", 6]
    where: dict[str, Any] = {"mask": lakes, "keep": trees, "border": 0.02, "seed": 6}
    expected = command("sample", *options, "--radius", 0.03)
    made = lacuna.sample(0.03, **where)
    assert made.points.tobytes() == expected.tobytes()
    assert made.domain == (1, 0.5) and made.maximal and (made.points[:2] == trees).all()
    field = ["--field", tmp_path / "field.npy", "--invert", "--scale", 0.02]
    expected = command("sample", *options, *field)
    made = lacuna.sample(field=x / 59, scale=0.02, **where)
    assert made.points.tobytes() == expected.tobytes()
    assert made.mode == "exact"


def test_polygons_are_the_commands(command: Command) -> None:
    page = lacuna.read_polygons(LAKES)
    assert page.domain is not None and len(page) == len(page.rings) > 1
    mask = lacuna.draw_mask(page, 0.1, border=1)
    expected = command("sample", "--inside", LAKES, "--edge", 0.1, "--radius", 2, "--border", 1)
    made = lacuna.sample(2, mask=mask, domain=page.domain, border=1, seed=0)
    assert made.points.tobytes() == expected.tobytes()
    made = lacuna.sample(2, inside=page, edge=0.1, border=1, seed=0)
    assert made.points.tobytes() == expected.tobytes() and made.domain == page.domain
    made = lacuna.sample(2, inside=page, border=1, seed=0)  # with the command's default edge
    expected = command("sample", "--inside", LAKES, "--radius", 2, "--border", 1)
    assert made.points.tobytes() == expected.tobytes()
    assert lacuna.verify(made, inside=page, edge=2 / 16, border=1).maximal
    with pytest.raises(lacuna.BadRequest, match="^mask missing: the set was made with one"):
        lacuna.verify(made)
    options = ["--inside", LAKES, "--edge", 0.003, "--radius", 0.05, "--domain", "1x2"]
    mask = lacuna.draw_mask(page, 0.003, domain=(1, 2))
    made = lacuna.sample(0.05, mask=mask, domain=(1, 2), seed=0)
    assert made.points.tobytes() == command("sample", *options).tobytes()


# ------------------------------------------------------------------------------ what they promise


def test_a_mask_may_have_any_layout_and_type() -> None:
    mask = (np.arange(48).reshape(6, 8) % 5 != 0) & (np.arange(8) != 3)
    expected = lacuna.sample(0.05, mask=mask, seed=1).points
    padded = np.zeros((12, 24))
    padded[::2, ::3] = mask
    for same in (
        np.asfortranarray(mask),
        mask[::-1].copy()[::-1],
        padded[::2, ::3],
        mask * np.uint8(7),
        mask * -1e-300,
        mask.astype(">i2"),
        mask.astype(np.longdouble),
        mask.tolist(),
    ):
        assert (lacuna.sample(0.05, mask=same, seed=1).points == expected).all()


def test_a_mask_may_have_more_pixels_a_side_than_a_picture() -> None:
    mask = np.arange(2**20 + 10) % 5 == np.array([[0], [2], [4]])
    made = lacuna.sample(0.1, mask=mask, domain=(1, 1), seed=1)
    assert made.maximal and len(made) > 70 and pixels_under(mask, made).all()


def test_a_set_that_was_stopped_is_carried_on() -> None:
    begun = lacuna.sample(0.05, limit=100, seed=1)
    for keep in (begun, begun.points.astype(">f8"), np.asfortranarray(begun.points)):
        made = lacuna.sample(0.05, keep=keep, seed=2)
        assert not begun.maximal and made.maximal
        assert (made.points[:100] == begun.points).all()
        assert lacuna.verify(made).maximal
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
    mask = lacuna.draw_mask(rings, 0.1, domain=(15, 15))
    assert (mask == lacuna.draw_mask(lacuna.read_polygons(path), 0.1, domain=(15, 15))).all()
    side = len(mask) / 15
    for spot, is_inside in ((5.5, True), (6.5, False), (7.5, True), (8.5, False), (9.5, True)):
        assert mask[int((15 - spot) * side), int(spot * side)] == is_inside
    for places in ({"inside": rings}, {"outside": rings}, {"avoid": [(rings, 0.5)]}):
        made = lacuna.sample(0.5, domain=(15, 15), seed=1, **places)  # type: ignore[arg-type]
        proof = lacuna.verify(
            made.points, 0.5, domain=(15, 15), edge=0.5 / 16, **places  # type: ignore[arg-type]
        )
        assert proof.maximal, proof
        middle = (abs(made.points - 5.5) < 0.5).all(axis=1)
        assert middle.any() == ("inside" in places)


def test_polygons_of_geojson_have_no_page(tmp_path: Path) -> None:
    path = tmp_path / "half.geojson"
    path.write_text(
        '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 0.5], [0, 0.5], [0, 0]]]}'
    )
    half = lacuna.read_polygons(str(path))
    assert half.domain is None
    mask = lacuna.draw_mask(half, 0.1)
    assert not mask[0].any() and mask[-2, 1:-1].all()
    assert lacuna.domain_around(half) == (1, 1)


# ------------------------------------------------------------------------------------- corners


MAP = (448000.0, 5411000.0, 450000.0, 5412500.0)


def test_a_domain_may_have_any_corner(command: Command) -> None:
    made = lacuna.sample(90, domain=MAP, seed=3)
    expected = command("sample", "--radius", 90, "--domain", "448000,5411000+2000x1500", "--seed", 3)
    assert made.points.tobytes() == expected.tobytes()
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


def test_outlines_have_points_where_they_lie(command: Command, tmp_path: Path) -> None:
    parcel = [(448251, 5411932), (448900, 5411950), (448800, 5412400)]
    assert lacuna.domain_around([parcel]) == (448251, 5411932, 448900, 5412400)
    rock = [(448700.5, 5412000)]
    made = lacuna.sample(20, inside=[parcel], avoid=[([rock], 60)], border=5, seed=0)
    assert made.domain == (448251, 5411932, 448900, 5412400)
    np.savetxt(tmp_path / "parcel.txt", parcel)
    np.savetxt(tmp_path / "rock.txt", rock)
    expected = command(
        "sample", "--inside", tmp_path / "parcel.txt", "--avoid", f"{tmp_path / 'rock.txt'}:60",
        "--border", 5, "--radius", 20,
    )  # fmt: skip
    assert made.points.tobytes() == expected.tobytes()
    where: Any = {"inside": [parcel], "avoid": [([rock], 60)], "border": 5}
    assert lacuna.verify(made, edge=20 / 16, **where).maximal
    page = lacuna.read_polygons(LAKES)  # a page is stretched over the domain
    made = lacuna.sample(20, inside=page, domain=MAP, seed=0)
    expected = command(
        "sample", "--inside", LAKES, "--radius", 20, "--domain", "448000,5411000+2000x1500"
    )
    assert made.points.tobytes() == expected.tobytes()
    with pytest.raises(lacuna.BadRequest, match="has no area: give a domain"):
        lacuna.sample(20, avoid=[([[(448000, 5), (448900, 5)]], 3)])


# ------------------------------------------------------------------------------------- judging


def test_what_breaks_a_set_is_told() -> None:
    y, x = np.mgrid[0:20, 0:40]
    mask, field = np.hypot(x - 15, y - 9) > 6, 0.1 + x / 39
    keep = [(0.1, 0.1), (0.9, 0.4)]
    where: dict[str, Any] = {"field": field, "mask": mask, "border": 0.03, "keep": keep}
    made = lacuna.sample(scale=0.02, seed=3, **where)
    assert lacuna.verify(made, **where).maximal
    without_mask = {other: value for other, value in where.items() if other != "mask"}
    with pytest.raises(lacuna.BadRequest, match="^mask missing"):  # the set knows that it had one
        lacuna.verify(made, **without_mask)
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


# ------------------------------------------------------------------------------------- refused


@pytest.mark.parametrize(
    ("error", "argument", "arguments"),
    [
        (ValueError, "mask", {"mask": np.ones(3)}),
        (ValueError, "mask", {"mask": np.ones((0, 3))}),
        (ValueError, "mask", {"mask": [[1], [1, 2]]}),
        (ValueError, "mask", {"mask": np.broadcast_to(True, (10**6, 10**6))}),
        (TypeError, "mask", {"mask": "black"}),
        (TypeError, "mask", {"mask": MASK * 1j}),
        (TypeError, "mask", {"mask": np.ma.masked_array(MASK, mask=MASK > 0)}),
        (TypeError, "mask", {"mask": object()}),
        (TypeError, "border", {"border": "wide"}),
        (TypeError, "border", {"border": None}),
        (ValueError, "keep", {"keep": [0.1, 0.2, 0.3]}),
        (TypeError, "keep", {"keep": "points.txt"}),
        (TypeError, "keep", {"keep": {"x": 1}}),
    ],
    ids=lambda value: f"{value!r:.60}",
)
def test_sample_refuses(
    error: type[Exception], argument: str, arguments: dict[str, Any]
) -> None:
    refused(error, argument, lacuna.sample, 0.1, **arguments)


RING = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]


@pytest.mark.parametrize(
    ("error", "argument", "arguments"),
    [
        (ValueError, "edge", {"memory_limit": 100}),
        (ValueError, "memory_limit", {"memory_limit": 0}),
        (TypeError, "edge", {"edge": "fine"}),
        (TypeError, "domain", {"domain": 3}),
        (ValueError, "rings", {"rings": RING}),  # one ring is a list of one
        (ValueError, "rings", {"rings": [np.ones((3, 3))]}),
        (TypeError, "rings", {"rings": [RING, None]}),
        (TypeError, "rings", {"rings": "lakes.svg"}),
        (TypeError, "rings", {"rings": 3}),
    ],
    ids=lambda value: f"{value!r:.60}",
)
def test_draw_mask_refuses(
    error: type[Exception], argument: str, arguments: dict[str, Any]
) -> None:
    refused(error, argument, lacuna.draw_mask, **{"rings": [RING], "edge": 0.01, **arguments})


def test_files_of_polygons_that_are_none_are_refused(tmp_path: Path) -> None:
    refused(ValueError, "path", lacuna.read_polygons, tmp_path / "a\nb.png")
    refused(TypeError, "path", lacuna.read_polygons, 3)
    (tmp_path / "broken.svg").write_text("<svg")
    (tmp_path / "line.txt").write_text("0 0\n1 1\n")
    for name in ("none.svg", "broken.svg", "line.txt"):
        with pytest.raises(OSError, match=f"^[^\n]*{name}[^\n]*$") as caught:
            lacuna.read_polygons(tmp_path / name)
        assert isinstance(caught.value, lacuna.FileError)


def test_several_polygons_are_joined_and_others_left_out(
    command: Command, tmp_path: Path
) -> None:
    paths = {}
    for name, low, high in (("low", 0, 0.6), ("high", 0.4, 1), ("pond", 0.3, 0.45)):
        corners = [(low, low), (high, low), (high, high), (low, high)]
        paths[name] = tmp_path / f"{name}.txt"
        np.savetxt(paths[name], corners)
    low, high, pond = (lacuna.read_polygons(path) for path in paths.values())
    expected = command(
        "sample", "--inside", paths["low"], "--inside", paths["high"], "--outside", paths["pond"],
        "--radius", 0.05, "--edge", 0.01,
    )  # fmt: skip
    mask = lacuna.draw_mask([low, high], 0.01, outside=pond)
    made = lacuna.sample(0.05, mask=mask, seed=0)
    assert (made.points == expected).all()
    made = lacuna.sample(0.05, inside=[low, high], outside=pond, edge=0.01, seed=0)
    assert (made.points == expected).all()
    assert lacuna.verify(made.points, 0.05, inside=[low, high], outside=pond, edge=0.01).maximal
    assert not lacuna.verify(made.points, 0.05, inside=low, edge=0.01)
    assert not lacuna.verify(made.points, 0.05, inside=[low, high], edge=0.01).covered
    everywhere = lacuna.draw_mask(None, 0.01, outside=pond)
    assert 0.97 < everywhere.mean() < 0.98


def test_obstacles_and_borders_keep_their_distance(tmp_path: Path) -> None:
    path = tmp_path / "fence.txt"
    path.write_text("0.2 0.5\n0.8 0.5\n")
    fence = lacuna.read_lines(path)
    assert [ring.tolist() for ring in fence.rings] == [[[0.2, 0.5], [0.8, 0.5]]]
    rock = [np.array([[0.5, 0.02]])]
    avoid = [(fence, 0.05), (rock, 0.1)]
    square = [np.array([(0.05, 0.0), (0.95, 0.0), (0.95, 1.0), (0.05, 1.0)])]
    made = lacuna.sample(0.02, inside=square, avoid=avoid, border=0.03, edge=0.001, seed=1)
    assert lacuna.verify(made, inside=square, avoid=avoid, border=0.03, edge=0.001).maximal
    x, y = made.points.T
    assert x.min() >= 0.08 and np.hypot(x - 0.5, y - 0.02).min() >= 0.1
    assert (abs(y - 0.5)[(x > 0.2) & (x < 0.8)]).min() >= 0.05
    with pytest.raises(TypeError, match="avoid must be a list of pairs"):
        lacuna.draw_mask(square, 0.01, avoid=fence)  # type: ignore[arg-type]
    with pytest.raises(lacuna.BadRequest, match="avoid -1.0: a distance must be a finite number"):
        lacuna.draw_mask(square, 0.01, avoid=[(fence, -1)])


def test_points_lie_near_lines() -> None:
    road = [[(0.1, 0.5), (0.9, 0.5)]]
    near = [(road, 0.1), ([[(0.5, 0.95)]], 0.03)]
    made = lacuna.sample(0.02, near=near, avoid=[(road, 0.03)], seed=1)
    x, y = made.points.T
    by_road = y < 0.7
    to_road = np.hypot(x - x.clip(0.1, 0.9), y - 0.5)[by_road]
    assert 0.03 <= to_road.min() and to_road.max() <= 0.1
    assert (~by_road).sum() >= 3 and np.hypot(*(made.points[~by_road] - (0.5, 0.95)).T).max() <= 0.03
    assert lacuna.verify(made, near=near, avoid=[(road, 0.03)]).maximal
    assert lacuna.verify(made, near=[(road, 0.1)]).forbidden_by == "inside"
    mask = lacuna.draw_mask(None, 0.01, near=near, domain=(1, 1))
    assert 0.1 < mask.mean() < 0.2 * 0.8 + np.pi * (0.1**2 + 0.03**2)
    with pytest.raises(lacuna.BadRequest, match="near 0.0: a distance must be a finite number"):
        lacuna.sample(0.02, near=[(road, 0)])
    with pytest.raises(TypeError, match="near must be a list of pairs"):
        lacuna.sample(0.02, near=[road])  # type: ignore[arg-type]
