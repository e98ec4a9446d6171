"""order: puts points that are there already into a progressive order."""

from __future__ import annotations

from typing import TYPE_CHECKING, SupportsFloat

from . import _core
from ._arguments import field_of, options, points_array, shape_of
from ._sets import domain_of

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._arguments import Domain, Seed


def order(
    points: npt.ArrayLike,
    field: npt.ArrayLike | None = None,
    *,
    domain: Domain | None = None,
    torus: bool | None = None,
    seed: Seed = 0,
) -> npt.NDArray[np.uint32]:
    """Order points so that the first k, for any k, are spread as evenly as can be.

    Each level chooses points that keep a distance from all that were chosen before; from level to
    level the distance shrinks by 2^(-1/32). ``sample(progressive=True)`` makes new points in such
    an order, more evenly spread at each k.

    It is not for dithering: the first half of the centres of all pixels has 0.6 of the power of
    white noise at low frequencies, because places of a lattice have few different distances.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2)
        Points of the domain.
    field : array_like, shape (rows, columns), optional
        Importance, as for ``sample``, not 0 at a point: distances follow it.
    domain : tuple of float, optional
        (width, height) or (x0, y0, x1, y1). By default the PointSet's domain, else the field's
        shape with a longer side of 1, else (1, 1).
    torus : bool, optional
        Whether the edges wrap. By default as in the PointSet, else False.
    seed : None, int or numpy.random.Generator
        Decides in which order points come that are equally good; as for ``sample``.

    Returns
    -------
    ndarray, shape (N,), uint32
        The indices of the points: ``points[order(points)]`` are in order.

    Raises
    ------
    BadRequest, TypeError
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> even = lacuna.sample(n=256, torus=True, relax=30, seed=1)
    >>> ordered = even.points[lacuna.order(even)]
    >>> ordered.shape
    (256, 2)
    """
    importance = None if field is None else field_of("field", field)
    asked = options(**domain_of(points, domain, torus, shape_of(importance)), seed=seed)
    return _core.progressive_order(points_array("points", points), importance, asked)
