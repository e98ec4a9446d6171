"""analyze: measures point sets."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, Sequence, SupportsFloat

import numpy as np

from . import _core, _plots
from ._arguments import options, points_array, shown, watched
from ._errors import BadRequest
from ._sets import HasPoints, domain_of

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._arguments import Domain, Progress, Whole

    Floats = npt.NDArray[np.float64]

_BINS_OF_A_SPACING = 20  # bins of the pair correlation per mean spacing


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

    def __str__(self) -> str:
        def number(name: str, value: float | None) -> str:
            return "" if value is None else f", {name} {value:.3g}"

        return (
            f"{self.sets} {'set' if self.sets == 1 else 'sets'} of {self.mean_count:.6g} points"
            + ("" if self.sets == 1 else " on average")
            + number("least distance", self.least_distance)
            + number("relative to that of a hexagonal lattice", self.relative_radius)
            + number("mean distance to the nearest point", self.mean_distance)
            + number("effective Nyquist frequency", self.effective_nyquist)
            + number("oscillations", self.oscillations)
            + number("psi_6", self.psi_6)
        )

    def plot(
        self, ax: Axes | None = None, curve: Literal["power", "pair_correlation"] = "power"
    ) -> Axes:
        """Draw the radial power or the pair correlation with matplotlib.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; by default a new figure.
        curve : {'power', 'pair_correlation'}
            Power by frequency in units of sqrt(N), or the pair correlation by distance in mean
            spacings. A line at 1 is what independent points have.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        BadRequest
            There is no such curve.
        ImportError
            matplotlib is not installed.
        """
        if curve == "power":
            return _plots.curve(ax, self.frequency, self.power, "frequency / sqrt(N)", "power")
        if curve == "pair_correlation":
            x, y = self.distance, self.pair_correlation
            return _plots.curve(ax, x, y, "distance / mean spacing", "pair correlation")
        raise BadRequest("curve", shown(curve), "must be one of power, pair_correlation")


def analyze(
    points: npt.ArrayLike | Sequence[npt.ArrayLike],
    *,
    domain: Domain | None = None,
    torus: bool | None = None,
    max_frequency: SupportsFloat = 2,
    threads: Whole = 0,
    progress: Progress | Literal[True] | None = None,
) -> Analysis:
    """Spectrum and statistics of a point set, or their mean over several sets.

    Time grows little faster than the number of points. Memory is about 400 bytes per point.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2), or a list of them
        Each set must have at least one point.
    domain : tuple of float, optional
        (width, height) or (x0, y0, x1, y1) of all sets. By default the first set's domain if that
        is a PointSet, else (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as in the first set if it is a PointSet, else False.
    max_frequency : float
        Largest frequency of the spectrum in units of sqrt(N): over 0, at most 1000. Time and memory
        grow with its square.
    threads : int
        0 is one for each core. The results do not depend on it.
    progress : callable or True, optional
        Called with two ints: the finished thousandths of the work, and 1000. True: as for
        ``sample``.

    Returns
    -------
    Analysis

    Raises
    ------
    BadRequest, TypeError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> sets = [lacuna.sample(0.05, torus=True, seed=seed) for seed in range(3)]
    >>> found = lacuna.analyze(sets)
    >>> found.sets, found.power.shape == found.frequency.shape, found.least_distance >= 0.05
    (3, True, True)
    """
    several: list[object] = [points]
    if isinstance(points, (list, tuple)) and points:
        if all(isinstance(one, HasPoints) or np.ndim(one) == 2 for one in points):
            several = list(points)
    elif isinstance(points, np.ndarray) and points.ndim == 3:
        several = list(points)
    asked = options(
        **domain_of(several[0], domain, torus), max_frequency=max_frequency, threads=threads
    )
    arrays = [points_array("points", one) for one in several]
    with watched(progress) as told:
        found = _core.analyze(arrays, asked, told)
    bins = np.arange(len(found["pair_correlation"]))
    return Analysis(sets=len(arrays), distance=(bins + 0.5) / _BINS_OF_A_SPACING, **found)
