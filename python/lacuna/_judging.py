"""analyze and devices: measuring point sets, and listing devices."""

from __future__ import annotations

from typing import TYPE_CHECKING, Sequence, SupportsFloat

import numpy as np

from . import _core
from ._arguments import flag, pair, points_array, real, whole
from ._errors import BadRequest
from ._results import Analysis, Device, PointSet, Relaxed
from ._runs import MOST_32, checked_progress

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Whole

    from ._runs import Progress

_BINS_OF_A_SPACING = 20  # bins of the pair correlation per mean spacing


def domain_of(
    points: object,
    domain: object,
    torus: object | None,
    shape: tuple[float, float] = (1.0, 1.0),
) -> tuple[float, float, bool]:
    """The domain and torus as given; by default the PointSet's, or else ``shape``, not a torus."""
    known = isinstance(points, (PointSet, Relaxed))
    if domain is not None:
        width, height = pair("domain", domain)
    else:
        width, height = points.domain if isinstance(points, (PointSet, Relaxed)) else shape
    if torus is None:
        torus = known and points.torus  # type: ignore[attr-defined]
    return width, height, flag("torus", torus)


def analyze(
    points: npt.ArrayLike | Sequence[npt.ArrayLike],
    *,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
    torus: bool | None = None,
    max_frequency: SupportsFloat = 2,
    threads: Whole = 0,
    progress: Progress | None = None,
) -> Analysis:
    """Spectrum and statistics of a point set, or their mean over several sets.

    Time grows little faster than the number of points. Memory is about 400 bytes per point.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2), or a list of them
        Each set must have at least one point.
    domain : tuple of float, optional
        Width and height of all sets. By default the first set's domain if that is a PointSet, else
        (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as in the first set if it is a PointSet, else False.
    max_frequency : float
        Largest frequency of the spectrum in units of sqrt(N): over 0, at most 1000. Time and memory
        grow with its square.
    threads : int
        0 is one for each core. The results do not depend on it.
    progress : callable, optional
        Called with two ints: the finished thousandths of the work, and 1000.

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
        if all(isinstance(one, (PointSet, Relaxed)) or np.ndim(one) == 2 for one in points):
            several = list(points)
    elif isinstance(points, np.ndarray) and points.ndim == 3:
        several = list(points)
    width, height, wraps = domain_of(several[0], domain, torus)
    checked_progress(progress)
    arrays = [points_array("points", one) for one in several]
    reach = real("max_frequency", max_frequency)
    workers = whole("threads", threads, 0, MOST_32)
    found = _core.analyze(arrays, width, height, wraps, reach, workers, progress)
    bins = np.arange(len(found["pair_correlation"]))
    return Analysis(sets=len(arrays), distance=(bins + 0.5) / _BINS_OF_A_SPACING, **found)


def devices() -> list[Device]:
    """List every backend's devices, in order of preference, like ``lacuna devices``.

    A backend that cannot be used has an entry too, whose ``unusable`` says why.

    Returns
    -------
    list of Device

    Raises
    ------
    DeviceError
        A driver is there but fails.

    Examples
    --------
    >>> import lacuna
    >>> first = lacuna.devices()[0]
    >>> first.backend, first.usable
    ('cpu', True)
    """
    listed: list[Device] = []
    for backend, name, kind, memory, largest, unusable in _core.devices():
        number = sum(device.backend == backend for device in listed)
        listed.append(Device(backend, number, name, kind, memory, largest, unusable))
    return listed
