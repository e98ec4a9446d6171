"""verify, analyze and devices: what judges points, and what there is to run on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Sequence, SupportsFloat, SupportsIndex

import numpy as np

from . import _core
from ._arguments import field_of, flag, pair, points_array, real, whole
from ._errors import BadRequest
from ._results import Analysis, Device, PointSet, Relaxed
from ._runs import MOST_32, checked_progress, shape_of
from ._verdict import Verdict

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._runs import Progress

_BINS_OF_A_SPACING = 20  # of the pair correlation


def _domain_of(
    points: object,
    domain: object,
    torus: object | None,
    shape: tuple[float, float] = (1.0, 1.0),
) -> tuple[float, float, bool]:
    """What was given, or else what a set knows of itself, or else the shape."""
    known = isinstance(points, (PointSet, Relaxed))
    if domain is not None:
        width, height = pair("domain", domain)
    else:
        width, height = points.domain if isinstance(points, (PointSet, Relaxed)) else shape
    if torus is None:
        torus = known and points.torus  # type: ignore[attr-defined]
    return width, height, flag("torus", torus)


def _claimed(
    points: object, radius: SupportsFloat | None, scale: SupportsFloat | None, has_field: bool
) -> float:
    """The radius, with a field the scale: what was given, or else what a set knows of itself."""
    if not has_field:
        if scale is not None:
            raise BadRequest(f"scale {scale!r:.60}: is for a field", "scale")
        if radius is None:
            if not isinstance(points, PointSet):
                raise BadRequest("radius missing: give the least distance to be proven", "radius")
            radius = points.radius
        return real("radius", radius)
    if radius is not None:
        raise BadRequest(f"radius {radius!r:.60}: with a field give scale", "radius")
    if scale is None and isinstance(points, PointSet):
        scale = points.scale
    if scale is None:
        raise BadRequest("scale missing: give the radius where importance is 1", "scale")
    return real("scale", scale)


def verify(
    points: npt.ArrayLike,
    radius: SupportsFloat | None = None,
    *,
    field: npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
    torus: bool | None = None,
    tolerance: SupportsFloat | None = None,
    distances_only: bool = False,
) -> Verdict:
    """Prove or refute that points are a maximal Poisson-disk set, from their coordinates alone.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2)
        Whoever made them.
    radius : float, optional
        Least distance between two points. By default a PointSet's own. Not with a field.
    field : array_like, shape (rows, columns), optional
        Importance, as of ``sample``: each place has its pixel's radius, and two points, or a point
        and a spot, the smaller of theirs. Within 2^-28 of the longer side of a border of pixels a
        point may count for either.
    scale : float, optional
        With a field the radius where importance is 1. By default a PointSet's own.
    domain : tuple of float, optional
        Width and height. By default a PointSet's own, else the field's shape, its longer side 1, or
        (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as a PointSet's do; else they do not.
    tolerance : float, optional
        How far over the radius a gap may be; by default 2^-28 of the longer side, with a field
        twice that.
    distances_only : bool
        Do not look for gaps, which takes most of the time.

    Returns
    -------
    Verdict
        True where the claim holds; with the closest pair and the emptiest spot.

    Raises
    ------
    BadRequest, TypeError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> made = lacuna.sample(0.05, seed=1)
    >>> bool(lacuna.verify(made))
    True
    >>> verdict = lacuna.verify(made.points[:-1], 0.05)
    >>> verdict.kept, verdict.covered
    (True, False)

    Of a set that follows a field:

    >>> import numpy as np
    >>> ramp = np.linspace(0, 1, 64) * np.ones((64, 1))
    >>> dense = lacuna.sample(field=ramp, scale=0.02, mode="exact", seed=1)
    >>> lacuna.verify(dense, field=ramp).maximal
    True
    """
    claimed = _claimed(points, radius, scale, field is not None)
    importance = None if field is None else field_of("field", field)
    shape = (1.0, 1.0) if importance is None else shape_of(importance)
    width, height, wraps = _domain_of(points, domain, torus, shape)
    allowed = None if tolerance is None else real("tolerance", tolerance)
    only = flag("distances_only", distances_only)
    array = points_array("points", points)
    found = _core.verify(array, claimed, importance, width, height, wraps, allowed, only)
    if allowed is None:
        allowed = 2.0 ** (-28 if importance is None else -27) * max(width, height)
    inside = found["outside"] is None and found["forbidden"] is None
    pair_known = inside and len(array) > 1
    gaps_known = inside and not only
    spot_known = gaps_known and len(array) > 0
    return Verdict(
        holds=inside and found["kept"] and (only or found["covered"]),
        maximal=found["maximal"],
        kept=found["kept"] if inside else None,
        covered=found["covered"] if gaps_known else None,
        outside=found["outside"],
        forbidden=found["forbidden"],
        closest_pair=(found["first"], found["second"]) if pair_known else None,
        least_distance=found["least_distance"] if pair_known else np.inf,
        least_limit=found["least_limit"] if pair_known else None,
        emptiest_spot=found["emptiest"] if spot_known else None,
        emptiest_distance=found["emptiest_distance"] if spot_known else None,
        emptiest_limit=found["emptiest_limit"] if spot_known else None,
        radius=claimed if importance is None else claimed / float(importance.values.max()) ** 0.5,
        tolerance=allowed,
        scale=None if importance is None else claimed,
    )


def analyze(
    points: npt.ArrayLike | Sequence[npt.ArrayLike],
    *,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
    torus: bool | None = None,
    max_frequency: SupportsFloat = 2,
    threads: SupportsIndex = 0,
    progress: Progress | None = None,
) -> Analysis:
    """Spectrum and statistics of a point set, or of several that are averaged.

    The time grows little faster than the count; memory is some 400 bytes a point.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2), or a list of them
        Each of at least one point.
    domain : tuple of float, optional
        Width and height of all. By default the first PointSet's own, else (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as the first PointSet's do; else they do not.
    max_frequency : float
        How far the spectrum reaches, in units of sqrt(N): over 0, at most 1000. Its time and memory
        grow with the square of this.
    threads : int
        0 is one a core. The numbers do not depend on it.
    progress : callable, optional
        Called with thousandths done, and 1000.

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
    width, height, wraps = _domain_of(several[0], domain, torus)
    checked_progress(progress)
    arrays = [points_array("points", one) for one in several]
    reach = real("max_frequency", max_frequency)
    workers = whole("threads", threads, 0, MOST_32)
    found = _core.analyze(arrays, width, height, wraps, reach, workers, progress)
    bins = np.arange(len(found["pair_correlation"]))
    return Analysis(sets=len(arrays), distance=(bins + 0.5) / _BINS_OF_A_SPACING, **found)


def devices() -> list[Device]:
    """List every backend's devices, in order of preference, as ``lacuna devices`` does.

    What is not there has an entry too, whose ``unusable`` says why.

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
