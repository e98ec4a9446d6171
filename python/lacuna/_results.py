"""The results of lacuna's functions: small frozen objects."""

from __future__ import annotations

import json
import resource
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np

from . import _core, _plots
from ._points import HasPoints

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._arguments import Metric, Mode

    Floats = npt.NDArray[np.float64]


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

    def _describe(self, saved: _core.Saved) -> None:
        saved.is_relaxed = True


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
        Width and height; points lie in [0, width) x [0, height).
    torus : bool
        Whether the edges wrap.
    radius : float
        The least distance asked for, or chosen for ``n``; with a field the least of all radii;
        after relaxing the least distance of the moved points.
    scale : float or None
        With a field the radius where importance is 1, asked for or chosen.
    mode, metric : str
        As asked for; metric matters with a field.
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
    classes: tuple[str, ...] = field(default=(), kw_only=True)
    class_of: npt.NDArray[np.uint8] | None = field(default=None, repr=False, kw_only=True)
    distances: Floats | None = field(default=None, repr=False, kw_only=True)
    ellipses: Floats | None = field(default=None, repr=False, kw_only=True)

    @property
    def _class_names_of_points(self) -> list[str] | None:
        if self.class_of is None:
            return None
        return [self.classes[place] for place in self.class_of]

    def _classes(self) -> tuple[list[str], npt.NDArray[np.uint8] | None]:
        return list(self.classes), self.class_of

    def _ellipses(self) -> Floats | None:
        return self.ellipses

    def _describe(self, saved: _core.Saved) -> None:
        saved.least_radius, saved.scale = self.radius, self.scale or 0.0
        # A relaxed set has kept no distance: mode stratified says so.
        saved.mode = self.mode if self.relaxed is None else "stratified"
        saved.seed, saved.maximal = self.seed, self.maximal
        saved.levels = list(self.levels)
        saved.options = json.dumps(self._request)

    def _radii(self) -> Floats | None:
        # Two thirds of the distance that two of a class keep is a dot's width.
        if self.class_of is None or self.distances is None or self.scale is not None:
            return None
        radii: Floats = (np.diag(self.distances) / 3)[self.class_of]
        return radii

    def _least_distance(self) -> float:
        # With a field the least of all radii would make dots that are too small to be seen.
        return self.radius if self.scale is None else 0.0

    def report(self) -> dict[str, Any]:
        """The command's --report, as a dict that json can write."""
        report: dict[str, Any] = {
            "program": "lacuna",
            "version": _core.version,
            "request": dict(self._request),
            "count": len(self),
            "radius": self.radius,
        }
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
        Radii of the dots to draw, in the domain's unit. Dots have as much ink as the picture.
    ink : ndarray, shape (N,), uint8, or None
        With ``inks``: the index of each dot's ink, in ascending order.
    inks : dict of str to str, or None
        With ``inks``: the colour of each ink, such as '#009ee3', by its name, in their order.
    """

    radii: Floats = field(repr=False)
    ink: npt.NDArray[np.uint8] | None = field(repr=False, default=None)
    inks: Mapping[str, str] | None = None

    def _radii(self) -> Floats:
        return self.radii

    def _layers(self) -> list[tuple[_core.Ink, int]]:
        if self.ink is None or self.inks is None:
            return []
        dots = np.bincount(self.ink, minlength=len(self.inks))
        inks = _core.inks_of(",".join(f"{name}={colour}" for name, colour in self.inks.items()))
        return list(zip(inks, dots.tolist()))


@dataclass(frozen=True, eq=False)
class Analysis:
    """Spectrum and statistics of point sets. Statistics that do not exist are None.

    Attributes
    ----------
    frequency : ndarray, shape (K,)
        Mean frequency of each ring of the periodogram in units of sqrt(N), up to max_frequency.
    power : ndarray, shape (K,)
        Mean power of each ring: 1 for independent points.
    anisotropy_db : ndarray, shape (K,)
        Variance of the power over its squared mean, in dB; NaN where power is 0.
    distance : ndarray, shape (L,)
        Middles of the bins of distance, in units of the mean spacing, sqrt(area / N).
    pair_correlation : ndarray, shape (L,)
        Mean of g in each bin.
    sets, mean_count : int, float
        Number of sets that were averaged, and their mean number of points.
    least_distance, mean_distance : float or None
        Least distance of two points in all sets; mean distance to the nearest other point.
    relative_radius : float or None
        The least distance over a hexagonal lattice's (Lagae & Dutre 2008).
    effective_nyquist, oscillations : float or None
        As defined by Heck et al. 2013; the first is in units of sqrt(N) / 2.
    psi_6 : float or None
        Mean of abs(psi_6): 1 for a hexagonal lattice.
    """

    frequency: Floats = field(repr=False)
    power: Floats = field(repr=False)
    anisotropy_db: Floats = field(repr=False)
    distance: Floats = field(repr=False)
    pair_correlation: Floats = field(repr=False)
    sets: int
    mean_count: float
    least_distance: float | None
    mean_distance: float | None
    relative_radius: float | None
    effective_nyquist: float | None
    oscillations: float | None
    psi_6: float | None

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the radial power with matplotlib. Arguments and errors are as of ``PointSet.plot``."""
        return _plots.power(ax, self.frequency, self.power)


@dataclass(frozen=True)
class Device:
    """A device that a backend can run on, or a backend that cannot run.

    Attributes
    ----------
    backend : str
        The value for the argument ``backend``.
    number : int
        The value for the argument ``device``, for opencl and vulkan.
    name, kind : str
        The name as the driver gives it; cpu, gpu or other.
    memory_bytes, largest_buffer_bytes : int
        0 if not known.
    unusable : str
        Why it cannot be used; empty if it can.
    """

    backend: str
    number: int
    name: str
    kind: str
    memory_bytes: int
    largest_buffer_bytes: int
    unusable: str

    @property
    def usable(self) -> bool:
        """Whether it can be used."""
        return not self.unusable
