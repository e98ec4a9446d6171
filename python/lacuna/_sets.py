"""Results with points: small frozen objects, which numpy accepts as arrays."""

from __future__ import annotations

import hashlib
import json
import os
import resource
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Mapping

import numpy as np

from . import _core, _plots
from ._arguments import corner_and_sides, path_bytes
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._arguments import Extent, Metric, Mode

    Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class HasPoints:
    """Points of a domain. numpy accepts the object as an array of N x 2 float64."""

    points: Floats = field(repr=False)
    domain: Extent
    torus: bool

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Floats]:
        return iter(self.points)

    def __getitem__(self, key: Any) -> Any:
        return self.points[key]

    def __repr__(self) -> str:
        shown = [f"{one.name}={getattr(self, one.name)!r}" for one in fields(self) if one.repr]
        return f"{type(self).__name__}({', '.join([f'{len(self)} points', *shown])})"

    def __setstate__(self, state: dict[str, Any]) -> None:
        # Arrays that were copied or pickled are writable again.
        self.__dict__.update(state)
        for value in state.values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        if copy is None:
            return np.asarray(self.points, dtype=dtype)
        if not copy and dtype is not None and np.dtype(dtype) != self.points.dtype:
            raise ValueError(f"points are float64: an array of {np.dtype(dtype)} is a copy")
        return np.array(self.points, dtype=dtype, copy=copy)

    def _saved(self) -> dict[str, Any]:
        """What a file holds besides the points, and the radius of dots that are all equal."""
        return {"domain": self.domain, "torus": self.torus}

    def _radii(self) -> Floats | None:
        """The radius of each dot; None if all dots are equal."""
        return None

    def save(self, path: str | bytes | os.PathLike[Any]) -> None:
        """Write the points to a file, whose extension names the format, as the command does.

        ``.txt``, ``.csv``, ``.npy``, ``.ply``, ``.geojson`` and ``.json`` hold every coordinate to the
        last bit. All of these but ``.txt`` hold the class, ink and ellipse of each point, and
        ``.json`` says how the set was made, so that ``lacuna verify`` can prove it.
        ``.svg``, ``.pdf`` and ``.png`` are pictures of dots on white, with the radii of ``radii``
        if the result has it, and black unless it has inks. The file appears whole or not at all.

        Parameters
        ----------
        path : path
            An older file of this name is replaced.

        Raises
        ------
        FileError
            An OSError: the file cannot be written.
        BadRequest
            The extension is not one of these, or ``.txt`` for points with classes, inks or
            ellipses.
        TypeError
            The argument is not a path.
        """
        name, saved, radii = path_bytes("path", path), self._saved(), self._radii()
        class_of, ellipses = getattr(self, "class_of", None), getattr(self, "ellipses", None)
        try:
            _core.write_points(name, self.points, saved, radii, class_of, ellipses)
        except BadRequest as error:
            raise error.called("path") from None

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the points with matplotlib, as ``save`` draws them.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ImportError
            matplotlib is not installed.
        """
        saved = self._saved()
        layers = saved.get("layers", [])
        colours = np.repeat([ink.hex for ink, _ in layers], [dots for _, dots in layers])
        color = colours if layers else "black"
        return _plots.dots(
            ax, self.points, self.domain, saved.get("radius", 0.0), self._radii(), color
        )

    @property
    def sha256(self) -> str:
        """The SHA-256 of the points as little-endian float64, as in the command's --report."""
        return hashlib.sha256(np.ascontiguousarray(self.points, "<f8").data).hexdigest()


@dataclass(frozen=True, eq=False)
class Evenness:
    """How equal the importance in the points' cells is: standard deviation over mean.

    Attributes
    ----------
    before : float
        In the Voronoi cells of the points given.
    after : float
        In the final power cells.
    after_voronoi : float
        In the Voronoi cells of the moved points.
    """

    before: float
    after: float
    after_voronoi: float


@dataclass(frozen=True, eq=False, repr=False)
class Relaxed(HasPoints):
    """Points that ``relax`` has moved, in the order given.

    Attributes
    ----------
    points : ndarray, shape (N, 2), float64
        The moved points.
    iterations : int
        How often they were moved.
    gaussian : int
        How many steps of descent on the Gaussian energy followed.
    lattice : tuple of int
        Columns and rows of the lattice that cells were computed on; (0, 0) without points.
    evenness : Evenness or None
        Only with ``measure=True``.
    seconds : mapping of str to float
        Seconds by step, and "total".
    backend, device : str
        The backend and device that did the work.
    """

    iterations: int
    lattice: tuple[int, int]
    evenness: Evenness | None
    seconds: Mapping[str, float] = field(repr=False)
    backend: str
    device: str
    gaussian: int = 0

    def _saved(self) -> dict[str, Any]:
        return {**super()._saved(), "is_relaxed": True}


def relaxed_of(made: dict[str, Any], **asked: Any) -> Relaxed:
    """The result of attributes that the library has found, and of what was asked for."""
    if made["evenness"] is not None:
        made["evenness"] = Evenness(*made["evenness"])
    return Relaxed(**made, **asked)


@dataclass(frozen=True, eq=False, repr=False)
class PointSet(HasPoints):
    """A point set, and how it was made. Has the length, rows and indices of ``points``.

    Attributes
    ----------
    points : ndarray, shape (N, 2), float64
        Points in the order in which they were admitted: any prefix is a Poisson-disk set of the
        same radius. But a prefix is not maximal: it leaves gaps.
        The array is read-only and uses the library's memory, without a copy.
    domain : tuple of float
        (width, height): points lie in [0, width) x [0, height). If the lower left corner is not
        (0, 0), then (x0, y0, x1, y1): points lie in [x0, x1) x [y0, y1). Functions take either as
        their ``domain``.
    torus : bool
        Whether the edges wrap.
    radius : float
        The least distance asked for, or chosen for ``n``; with a field the least of all radii;
        after relaxing the least distance of the moved points.
    scale : float or None
        With a field the radius where importance is 1, asked for or chosen.
    mode, metric : str
        As asked for; metric matters with a field.
    pixels : ndarray, shape (rows, columns), bool
        Only of a set ``on_pixels``: whether each pixel has a point. Row 0 is the top.
    seed : int
        With this seed the same call gives the same points.
    maximal : bool
        Whether no room is left. False if ``n`` or ``limit`` ended the run, and after relaxing.
    levels : tuple of (float, int)
        Of a progressive order: pairs (radius, k), or (scale, k) with a field: the first k points
        are a maximal set of this radius or scale. Else empty.
    classes : tuple of str
        The names of the classes, if there are any.
    class_of : ndarray, shape (N,), uint8, or None
        With classes: the place of each point's class in ``classes``.
    distances : ndarray, shape (K, K), or None
        With classes: the least distance of each two; with a field where importance is 1.
    ellipses : ndarray, shape (N, 3), or None
        Of a set of ellipses: two radii of each point, the longer one first, and the angle of that
        one in radians from the x axis.
    rounds, draws : int
        Number of rounds, and of draws in all rounds.
    lines_per_radius : int
        As asked for, or the mode's default.
    relaxed : Relaxed or None
        The result of relaxing, with ``relax``.
    seconds : mapping of str to float
        Seconds by step, and "total".
    backend, device : str
        The backend and device that did the work.
    """

    radius: float
    scale: float | None
    mode: Mode
    metric: Metric
    seed: int
    maximal: bool
    levels: tuple[tuple[float, int], ...] = field(repr=False)
    rounds: int
    draws: int
    lines_per_radius: int
    relaxed: Relaxed | None = field(repr=False)
    seconds: Mapping[str, float] = field(repr=False)
    backend: str
    device: str
    _request: Mapping[str, Any] = field(repr=False)
    _promised: Mapping[str, Any] = field(repr=False)
    classes: tuple[str, ...] = field(kw_only=True)
    class_of: npt.NDArray[np.uint8] | None = field(repr=False, kw_only=True)
    distances: Floats | None = field(repr=False, kw_only=True)
    ellipses: Floats | None = field(repr=False, kw_only=True)

    @property
    def pixels(self) -> npt.NDArray[np.bool_]:
        """Of a set ``on_pixels``: whether each pixel has a point, row 0 on top."""
        if "on_pixels" not in self._request:
            raise AttributeError("pixels: the set was made without on_pixels")
        columns, rows = map(int, self._request["on_pixels"].split("x"))
        x0, y0, width, height = corner_and_sides(self.domain)
        taken = np.zeros((rows, columns), bool)
        x, y = self.points.T
        # Points are centres, which lie half a pixel from where rounding would matter.
        taken[rows - 1 - ((y - y0) / height * rows).astype(int),
              ((x - x0) / width * columns).astype(int)] = True  # fmt: skip
        return taken

    def _names_of_points(self, classes: dict[str, Any]) -> Iterable[object] | None:
        """The name of each point's class, or its place among these classes if they are its own."""
        if self.class_of is None or list(self.classes) == classes["class_names"]:
            return self.class_of
        return [self.classes[place] for place in self.class_of]

    @property
    def radii_of_classes(self) -> Floats | None:
        """With classes: the radius of each point's object, half the distance that two of its class
        keep; with a field where importance is 1. Otherwise None."""
        if self.class_of is None or self.distances is None:
            return None
        radii: Floats = (np.diag(self.distances) / 2)[self.class_of]
        return radii

    def _saved(self) -> dict[str, Any]:
        return {
            **super()._saved(),
            # With a field the least of all radii would make dots that are too small to be seen.
            "radius": self.radius if self.scale is None else 0.0,
            "least_radius": self.radius,
            "scale": self.scale or 0.0,
            "classes": list(self.classes),
            "radii_of_classes": [] if self.distances is None
            else (np.diag(self.distances) / 2).tolist(),
            # A relaxed set has kept no distance: mode stratified says so.
            "mode": self.mode if self.relaxed is None else "stratified",
            "seed": self.seed,
            "maximal": self.maximal,
            "levels": list(self.levels),
            "options": json.dumps(self._request),
            **{name: self._request[name] for name in ("on_pixels",) if name in self._request},
        }

    def _radii(self) -> Floats | None:
        # Two thirds of the distance that two of a class keep is a dot's width.
        if self.class_of is None or self.distances is None or self.scale is not None:
            return None
        radii: Floats = (np.diag(self.distances) / 3)[self.class_of]
        return radii

    def report(self) -> dict[str, Any]:
        """The command's --report, as a dict that json can write."""
        report: dict[str, Any] = {
            "program": "lacuna",
            "version": _core.version,
            "request": dict(self._request),
            "count": len(self),
        }
        if self.class_of is not None:
            counts = np.bincount(self.class_of, minlength=len(self.classes)).tolist()
            report["classes"] = [
                {"name": name, "count": count} for name, count in zip(self.classes, counts)
            ]
        report["radius"] = self.radius
        if self.scale is not None:
            report["scale"] = self.scale
        report.update(
            maximal=self.maximal,
            rounds=self.rounds,
            draws=self.draws,
            seconds=dict(self.seconds),
            backend=self.backend,
            device=self.device,
            peak_memory_bytes=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024,
            points_sha256=self.sha256,
        )
        if self.relaxed is not None:
            report["relax"] = {
                "lattice": list(self.relaxed.lattice),
                "least_distance": self.radius,
                "backend": self.relaxed.backend,
                "device": self.relaxed.device,
            }
        return report


@dataclass(frozen=True, eq=False, repr=False)
class Stippling(PointSet):
    """Dots that show a picture: a PointSet with the dots' radii.

    Attributes
    ----------
    radii : ndarray, shape (N,), float64
        Radii of the dots to draw, in the domain's unit. Dots have as much ink as the picture. Empty
        with ``path_line``, which draws no dots.
    ink : ndarray, shape (N,), uint8, or None
        With ``inks``: the index of each dot's ink, in ascending order.
    inks : dict of str to str, or None
        With ``inks``: the colour of each ink, such as '#009ee3', by its name, in their order.
    paper_colour : str
        Of the paper that saved pictures show.
    pens : dict of str to float, or None
        The width in mm of the pen of each ink, by the ink's name; 0 for an ink without one. With
        ``pens`` each pen is an ink of its own, such as '0.3mm', in ``ink`` and ``inks`` too.
    paper : tuple of three floats, or None
        Width, height and margin in mm, turned as the picture lies. The margin is wider than the one
        asked for by as much as ink reaches over the picture's edges, such as half of a pen's width.
    are_strokes : bool
        Whether pens draw ``.ellipses`` as strokes: 2 a long with their round ends, 2 b wide.
    pen_mm : float
        With ``pen``: its width. Otherwise 0.
    circles : bool
        Whether that pen draws wider dots as circles, not as spirals.
    line_width : float
        With ``path_line``: the width of the line, in the domain's unit. Otherwise 0.
    path_length : float
        Of the pen's path, in the domain's unit; 0 without pens and path.
    plot_seconds : float
        How long a plotter takes; 0 without pens and path.
    layer_plots : tuple of pairs of floats
        The path's length and the time of each ink or pen, or of all dots.
    for_a_pen : bool
        Whether the points come in the order of the pen's path.
    """

    radii: Floats = field(repr=False)
    ink: npt.NDArray[np.uint8] | None = field(repr=False, default=None)
    inks: Mapping[str, str] | None = None
    paper_colour: str = "white"
    pens: Mapping[str, float] | None = None
    paper: tuple[float, float, float] | None = None
    are_strokes: bool = False
    pen_mm: float = 0.0
    circles: bool = False
    line_width: float = 0.0
    path_length: float = 0.0
    plot_seconds: float = 0.0
    layer_plots: tuple[tuple[float, float], ...] = ()
    for_a_pen: bool = False

    def _saved(self) -> dict[str, Any]:
        self._check()
        drawn = (
            "paper_colour are_strokes pen_mm circles line_width for_a_pen layer_plots".split()
        )
        saved = {**super()._saved(), **{name: getattr(self, name) for name in drawn}}
        if self.paper is not None:
            saved["paper"] = self.paper
        if self.ink is None or self.inks is None:
            return saved
        dots = np.bincount(self.ink, minlength=len(self.inks))
        inks = [
            _core.Ink(name, list(bytes.fromhex(colour[1:])), (self.pens or {}).get(name, 0.0))
            for name, colour in self.inks.items()
        ]
        return {**saved, "layers": list(zip(inks, dots.tolist()))}

    def _check(self) -> None:
        """Refuses attributes that do not agree, as ``dataclasses.replace`` may leave them."""
        ellipses = getattr(self, "ellipses", None)
        radii = None if self.line_width else self.radii
        for name, array in (("radii", radii), ("ink", self.ink), ("ellipses", ellipses)):
            if array is not None and len(array) != len(self.points):
                count = len(self.points)
                raise BadRequest(name, "", f"must be {count}, as points are, not {len(array)}")
        if self.are_strokes and ellipses is None:
            raise BadRequest("ellipses", "None", "must be there with are_strokes")
        if self.ink is not None and len(self.ink) and int(self.ink.max()) >= len(self.inks or ()):
            most = len(self.inks or ())
            raise BadRequest("ink", f"{self.ink.max()}", f"must be under {most}, the inks")
        for name, width in (("line_width", self.line_width), ("pen_mm", self.pen_mm)):
            if not 0 <= width < np.inf:
                raise BadRequest(name, f"{width}", "must be at least 0")
        if self.paper is None:
            return
        if len(self.paper) != 3:
            raise BadRequest("paper", f"{self.paper}", "must be width, height and margin")
        width, height, margin = self.paper
        if not (0 <= margin and 2 * margin < min(width, height) and max(width, height) < np.inf):
            raise BadRequest("paper", f"{self.paper}", "must have room between its margins")

    def _radii(self) -> Floats:
        return self.radii


def set_attributes(made: dict[str, Any], **more: object) -> dict[str, Any]:
    """The attributes of a PointSet: what the library has made, and the request, as reports have it.

    ``more`` is said of the request besides.
    """
    request, promised = made["_request"], made["_promised"]
    if made["distances"] is not None:  # those that the set keeps, not those given
        count = len(made["classes"])
        made["distances"] = made["distances"].reshape(count, count)
        request["class_names"] = list(made["classes"])
        request |= {"distances": made["distances"].tolist(), "weights": promised["weights"]}
    for name in ("border", "borders", "counts", "priority"):
        if promised[name]:
            request[name] = promised[name]
    if made["relaxed"] is not None:
        moves = {"iterations": more["relax"], "gaussian": more.get("gaussian", 0)}
        place = {name: made[name] for name in ("points", "domain", "torus", "seconds")}
        made["relaxed"] = relaxed_of(made["relaxed"], **place, **moves)
    return {**made, "_request": {**request, **more}}


def domain_of(
    points: object, domain: object, torus: object, shape: Extent | None = None
) -> dict[str, object]:
    """Options: domain and torus as given, or else the points' own, or else ``shape`` or (1, 1)."""
    if isinstance(points, HasPoints):
        shape = points.domain
        torus = points.torus if torus is None else torus
    return {
        "domain": (shape or (1.0, 1.0)) if domain is None else domain,
        "torus": False if torus is None else torus,
    }
