"""Uses the whole API, for mypy --strict. It can also be run."""

from __future__ import annotations

import itertools
import tempfile
from pathlib import Path
from typing import Iterator, Mapping

import numpy as np
import numpy.typing as npt

import lacuna
from lacuna import qmc

Floats = npt.NDArray[np.float64]


def told(done: int, expected: int) -> None:
    assert done <= expected


made: lacuna.PointSet = lacuna.sample(
    0.1,
    domain=(1, 1),
    torus=True,
    mode="exact",
    seed=1,
    progressive=False,
    limit=10_000,
    lines_per_radius=6,
    round_size=0,
    backend="cpu",
    device=None,
    threads=1,
    memory_limit=10**9,
    progress=told,
)
points: Floats = made.points
numbers: tuple[float, float | None, bool, int] = (made.radius, made.scale, made.maximal, made.seed)
words: tuple[str, str, str, str] = (made.mode, made.metric, made.backend, made.device)
counts: tuple[int, int, int, int] = (made.rounds, made.draws, made.lines_per_radius, len(made))
extent: tuple[float, float] | tuple[float, float, float, float] = made.domain
place: tuple[float, bool] = (extent[-1], made.torus)
elsewhere: lacuna.PointSet = lacuna.sample(90, domain=(448000, 5411000, 450000, 5412500.5))
there: lacuna.Verdict = lacuna.verify(elsewhere.points, 90, domain=elsewhere.domain)
seconds: Mapping[str, float] = made.seconds
levels: tuple[tuple[float, int], ...] = made.levels
indices: npt.NDArray[np.uint32] = lacuna.order(made, torus=True, seed=2)
digest: str = made.sha256
report: dict[str, object] = made.report()
array: npt.NDArray[np.float32] = np.asarray(made, np.float32)
lines: lacuna.PointSet = lacuna.sample(
    n=50, mode="lines", snap=True, uniform_x=True, seed=np.random.default_rng(1)
)

tiles: list[lacuna.PointSet] = lacuna.sample_many(range(3), n=20)
endless: Iterator[lacuna.PointSet] = lacuna.sample_many(itertools.count(), n=20)
tile: lacuna.PointSet = next(endless)
row_by_row: list[Floats] = [row for row in tile]
with tempfile.TemporaryDirectory() as folder:
    tile.save(Path(folder) / "tile.svg")
axes = tile.plot()
axes.set_title("a tile")

field: Floats = np.ones((4, 6))
lake: lacuna.PointSet = lacuna.sample(0.2, mask=field > 0, border=0.1, keep=[(0.5, 0.5)])
wood: lacuna.PointSet = lacuna.sample(
    classes={"trees": 0.2, "grass": (0.05, 2.0)},
    between="union",
    keep=[(0.5, 0.5)],
    keep_classes=["trees"],
)
grove: lacuna.PointSet = lacuna.sample(
    0.2, inside=[[(0, 0), (1, 0), (0, 1)]], avoid=[([[(0.2, 0.2)]], 0.1)], edge=0.01, progress=True
)
kinds: npt.NDArray[np.uint8] | None = wood.class_of
between: Floats | None = wood.distances
names: tuple[str, ...] = wood.classes
rare: str | None = lacuna.verify(wood).largest_gap_class
around: npt.NDArray[np.bool_] = lacuna.draw_mask(
    None, 0.01, avoid=[([[(0.5, 0.5)]], 0.1), ([[(0, 0.2), (1, 0.2)]], 0.05)]
)
again: lacuna.PointSet = lacuna.sample(n=1e3, mode=made.mode, keep=wood)
if made.seed < 0:  # mypy refuses words that are not known
    lacuna.sample(0.1, mode="bogus")  # type: ignore[arg-type]
    lacuna.stipple(field, 9, metric="most")  # type: ignore[arg-type]
on_a_field: lacuna.PointSet = lacuna.sample(field=field, scale=0.2, mode="exact")
dense: lacuna.PointSet = lacuna.sample(
    field=field, scale=0.2, mode="cells", metric="max", relax=1
)
relaxed_or_none: lacuna.Relaxed | None = dense.relaxed

dots: lacuna.Stippling = lacuna.stipple(
    1 - field / 2,
    20,
    relax=1,
    metric="mean",
    mode="cells",
    invert=False,
    black=0.1,
    white=0.9,
    auto_levels=False,
    light=False,
    gamma=1.5,
    min_importance=0.01,
    sharpen=1,
    sharpen_amount=0.5,
    size_by_tone=0.2,
    keep_inside=True,
    seed=None,
)
radii: Floats = dots.radii
photograph = Path(__file__).resolve().parents[2] / "examples" / "raccoon.png"
of_a_path: lacuna.Stippling = lacuna.stipple(photograph, scale=0.05, relax=0)
in_inks: lacuna.Stippling = lacuna.stipple(
    photograph, inks="black,red", ink_counts=[20, 0], black_ink=1
)
ink: npt.NDArray[np.uint8] | None = in_inks.ink
in_pens: lacuna.Stippling = lacuna.stipple(
    photograph, 50, pens="0.3mm,0.5mm", paper_size="A6", margin="5mm", pen_path=True
)
widths: Mapping[str, float] | None = in_pens.pens
paper: tuple[float, float, float] | None = in_pens.paper
plotted_in: float = in_pens.plot_seconds
inks: Mapping[str, str] | None = in_inks.inks

relaxed: lacuna.Relaxed = lacuna.relax(
    made, field, iterations=2, domain=(1, 1), torus=True, measure=True, progress=told
)
evenness: lacuna.Evenness | None = relaxed.evenness
if evenness is not None:
    shares: tuple[float, float, float] = (evenness.before, evenness.after, evenness.after_voronoi)
lattice: tuple[int, int] = relaxed.lattice
iterations: int = relaxed.iterations

judged: Floats = lacuna.verify(made).points
verdict: lacuna.Verdict = lacuna.verify(made, 0.1, domain=(1, 1), torus=True, tolerance=1e-9)
only: lacuna.Verdict = lacuna.verify([[0.1, 0.2], [0.3, 0.4]], 0.1, distances_only=True)
holds: bool = bool(verdict)
said: str = str(verdict)
pair: tuple[int, int] | None = verdict.closest_pair
spot: tuple[float, float] | None = verdict.largest_gap
outside: int | None = verdict.outside
facts: tuple[bool | None, bool | None, bool] = (verdict.kept, verdict.covered, verdict.maximal)
lengths: tuple[float, float | None] = (verdict.least_distance, verdict.largest_gap_distance)

of_a_field: lacuna.Verdict = lacuna.verify(on_a_field, field=field, scale=0.2)
of_a_field.plot(axes).set_title("a verdict")
limits: tuple[float | None, float | None] = (of_a_field.least_limit, of_a_field.largest_gap_limit)
forbidden: tuple[int | None, str | None] = (of_a_field.forbidden, of_a_field.forbidden_by)
moved: int | None = of_a_field.moved
claimed: tuple[float, float | None] = (of_a_field.radius, of_a_field.scale)

page: lacuna.Polygons = lacuna.read_polygons(photograph.with_name("lakes.svg"))
rings: tuple[Floats, ...] = page.rings
size: tuple[float, float] | None = page.domain
mask: npt.NDArray[np.bool_] = lacuna.draw_mask(page, 1.0, domain=size, memory_limit=10**8)
of_a_domain: lacuna.Verdict = lacuna.verify(
    made,
    0.1,
    torus=False,
    mask=field > 0,
    inside=page,
    edge=0.1,
    border=0.01,
    keep=[(0.5, 0.5)],
)
triangle: npt.NDArray[np.bool_] = lacuna.draw_mask([[(0, 0), (1, 0), (0, 1)]], 0.1)

found: lacuna.Analysis = lacuna.analyze([made, made], torus=True, domain=(1, 1), progress=None)
curves: list[Floats] = [found.frequency, found.power, found.anisotropy_db]
curves += [found.distance, found.pair_correlation]
scalars: list[float | None] = [found.psi_6, found.oscillations, found.effective_nyquist]
scalars += [found.relative_radius, found.least_distance, found.mean_distance, found.mean_count]
sets: int = found.sets
found.plot(ax=axes).set_title("power")
found.plot(axes, curve="pair_correlation")

listed: list[lacuna.Device] = lacuna.devices()
usable: list[str] = [f"{one.backend} {one.number} {one.name}" for one in listed if one.usable]

engine = qmc.PoissonDisk(2, radius=0.1, l_bounds=(0, 0), u_bounds=(1, 2), rng=1, torus=True)
first: Floats = engine.random(10)
rest: Floats = engine.reset().fast_forward(10).fill_space()

try:
    lacuna.sample(n=0)
except lacuna.BadRequest as error:
    argument: str = error.argument
for kind in (lacuna.MemoryRefused, lacuna.Unavailable, lacuna.DeviceError, lacuna.FileError):
    base: type[lacuna.Error] = kind
version: str = lacuna.__version__
