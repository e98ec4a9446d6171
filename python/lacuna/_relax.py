"""relax: moves points until their cells have equal capacity."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, SupportsFloat

from . import _core
from ._arguments import field_of, options, points_array, shape_of, watched
from ._sets import Relaxed, domain_of, relaxed_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Domain, Progress, Whole


def relax(
    points: npt.ArrayLike,
    field: npt.ArrayLike | None = None,
    *,
    iterations: Whole = 15,
    gaussian: Whole = 0,
    gaussian_distance: SupportsFloat | None = None,
    domain: Domain | None = None,
    torus: bool | None = None,
    measure: bool = False,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    progress: Progress | Literal[True] | None = None,
) -> Relaxed:
    """Move points until their cells hold equal importance and each is the centroid of its cell.

    This is a centroidal power diagram with equal capacities. It is computed in whole numbers: every
    backend and any number of threads give the same points. No least distance is promised.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2)
        Points of the domain, in the order in which they come back.
    field : array_like, shape (rows, columns), optional
        Importance, as for ``sample``; by default it is the same everywhere.
    iterations : int
        How often points are moved, at most 10,000. 10 to 30 are enough.
    gaussian : int
        How many steps of descent on the Gaussian energy (Ahmed, Ren & Wonka 2022) follow, at most
        10,000; 150 are usual. They take the power of low frequencies from about 1e-3 to 1e-9. Not
        with a field.
    gaussian_distance : float, optional
        The distance, in mean spacings, 0 to 1, below which these steps push points apart. By
        default 0.9.
    domain : tuple of float, optional
        (width, height) or (x0, y0, x1, y1). By default the PointSet's domain, else the field's
        shape with a longer side of 1, else (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as in the PointSet, else False.
    measure : bool
        Fill in ``Relaxed.evenness``, which costs two more passes over the lattice.
    backend, device, threads, progress
        As for ``sample``; progress is called with points times iterations and steps.

    Returns
    -------
    Relaxed

    Raises
    ------
    BadRequest, TypeError, Unavailable, DeviceError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> made = lacuna.sample(n=256, torus=True, seed=1)
    >>> even = lacuna.relax(made, measure=True)
    >>> even.points.shape, even.evenness.after_voronoi < even.evenness.before
    ((256, 2), True)
    """
    importance = None if field is None else field_of("field", field)
    asked = options(
        **domain_of(points, domain, torus, shape_of(importance)), iterations=iterations,
        gaussian=gaussian, gaussian_distance=gaussian_distance, measure=measure, backend=backend,
        device=device, threads=threads,
    )  # fmt: skip
    with watched(progress) as told:
        made = _core.relax(points_array("points", points), importance, asked, told)
    place = {name: asked[name] for name in ("domain", "torus", "iterations", "gaussian")}
    return relaxed_of(made, **place)
