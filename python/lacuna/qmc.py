"""An engine like those in scipy.stats.qmc. Needs scipy.

>>> from lacuna import qmc
>>> engine = qmc.PoissonDisk(2, radius=0.1, rng=1)
>>> len(engine.random(10)), len(engine.fill_space()) > 50
(10, True)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, SupportsFloat

import numpy as np
from scipy.stats import qmc as _qmc

from ._arguments import numbers, options, shown, whole
from ._errors import BadRequest
from ._sample import sample
from ._space import sample_volume

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Seed, Whole

__all__ = ["PoissonDisk"]

# Rectangles up to this area, in squared radii, and boxes up to this volume are filled at once. The set has up to about 14,000
# points and takes about 20 ms; runs for a few points at a time would take longer together.
_SMALL = 20_000


def _bounds(name: str, value: npt.ArrayLike, d: int) -> npt.NDArray[np.float64]:
    array = numbers(name, value).astype(np.float64)
    if array.shape not in ((), (1,), (d,)) or not np.isfinite(array).all():
        several = {2: "two", 3: "three"}[d]
        raise BadRequest(name, shown(value), f"must be one or {several} finite numbers")
    return np.broadcast_to(array, d)


class PoissonDisk(_qmc.QMCEngine):  # type: ignore[misc]
    """Maximal Poisson-disk sampling of a rectangle or a box, with the methods of scipy's engine.

    It differs from scipy.stats.qmc.PoissonDisk in what it promises: no two points are closer than
    ``radius``, with bounds too, and after ``fill_space`` there is no room for another point.

    Parameters
    ----------
    d : int
        The dimension, 2 or 3.
    radius : float
        Least distance between two points, in the unit of the bounds.
    l_bounds, u_bounds : array_like, shape (d,) or ()
        The rectangle or box; by default 0 and 1. Points lie in [l_bounds, u_bounds).
    hypersphere, ncandidates : str, int
        scipy's ways to throw candidates. They are accepted and have no effect: here every point is
        uniform over all the room that is left.
    optimization : None
        Must be None: moving the points would bring some closer than ``radius``.
    rng, seed : None, int or numpy.random.Generator
        As ``seed`` of ``lacuna.sample``; ``seed`` is scipy's older name.
    torus : bool
        Whether the edges wrap.
    backend, device, threads
        As for ``lacuna.sample``; with three dimensions as for ``lacuna.sample_volume``.

    Attributes
    ----------
    num_generated : int
        How many points were drawn so far.

    Raises
    ------
    BadRequest, TypeError
        As ``lacuna.sample``; the methods raise what it raises.

    Examples
    --------
    >>> from lacuna import qmc
    >>> engine = qmc.PoissonDisk(2, radius=0.05, l_bounds=(-1, 0), u_bounds=(1, 1), rng=7)
    >>> first = engine.random(100)
    >>> rest = engine.fill_space()
    >>> bool((engine.reset().random(100) == first).all())
    True
    """

    def __init__(
        self,
        d: Whole = 2,
        *,
        radius: SupportsFloat = 0.05,
        hypersphere: Literal["volume", "surface"] = "volume",
        ncandidates: Whole = 30,
        optimization: None = None,
        l_bounds: npt.ArrayLike | None = None,
        u_bounds: npt.ArrayLike | None = None,
        rng: Seed = None,
        seed: Seed = None,
        torus: bool = False,
        backend: str = "auto",
        device: int | str | None = None,
        threads: Whole = 0,
    ) -> None:
        if whole("d", d, 0, 2**31) not in (2, 3):
            raise BadRequest("d", f"{d}", "must be 2 or 3")
        if hypersphere not in ("volume", "surface"):
            allowed = "must be one of volume, surface"
            raise BadRequest("hypersphere", shown(hypersphere), allowed)
        whole("ncandidates", ncandidates, 1, 2**31)
        if optimization is not None:
            raise BadRequest("optimization", shown(optimization), "must be None")
        if rng is not None and seed is not None:
            raise BadRequest("seed", "and rng", "give one of them")
        super().__init__(int(d))
        given = options(radius=radius, torus=torus, seed=seed if rng is None else rng)
        self.radius: float = given["radius"]
        self.l_bounds = _bounds("l_bounds", 0.0 if l_bounds is None else l_bounds, self.d)
        self.u_bounds = _bounds("u_bounds", 1.0 if u_bounds is None else u_bounds, self.d)
        if not (self.l_bounds < self.u_bounds).all():
            raise BadRequest("l_bounds", shown(l_bounds), "must be less than u_bounds")
        with np.errstate(over="ignore"):  # infinite sides are refused by name
            self._sides = self.u_bounds - self.l_bounds
        self._seed: int = given["seed"]
        self._torus: bool = given["torus"]
        self._place = {"backend": backend, "device": device, "threads": threads}
        if self.d == 3 and self._place.pop("device") is not None:
            raise BadRequest("device", shown(device), "is for two dimensions")
        self._points: npt.NDArray[np.float64] = np.empty((0, self.d))
        self._is_full = False
        # Makes one point now, so that invalid arguments are refused by the constructor.
        self._fetch(1)

    def _fetch(self, count: int | None) -> None:
        """Makes sure that the first ``count`` points of the set are made, or all of them."""
        if self._is_full or (count is not None and count <= len(self._points)):
            return
        radius, limit = self.radius, None
        if self.l_bounds.any():
            # Adding l_bounds rounds each coordinate by up to one unit in the last place.
            last = np.spacing(np.abs([self.l_bounds, self.u_bounds]).max())
            radius += 8 * float(last)
        sides = tuple(float(side) for side in self._sides)
        is_small = radius > 0 and float(np.prod([side / radius for side in sides])) <= _SMALL
        if count is not None and not is_small:
            # Makes a prefix, twice as long as asked for, so that the whole set takes few runs.
            limit = max(64, 2 * count)
        try:
            make: Any = sample if self.d == 2 else sample_volume
            made = make(
                radius,
                domain=sides,
                torus=self._torus,
                seed=self._seed,
                limit=limit,
                **self._place,
            )
        except BadRequest as error:
            if error.argument != "domain":
                raise
            value = f"less l_bounds, {error.value}"
            raise BadRequest("u_bounds", value, error.reason) from None
        points: npt.NDArray[np.float64] = made.points
        if self.l_bounds.any():
            points = points + self.l_bounds
            np.minimum(points, np.nextafter(self.u_bounds, self.l_bounds), out=points)
        self._points = points
        self._is_full = limit is None or len(points) < limit

    def _random(self, n: Whole = 1, *, workers: Whole = 1) -> npt.NDArray[np.float64]:
        begin = self.num_generated
        count = whole("n", n, 0, 2**31)
        self._fetch(begin + count)
        return self._points[begin : begin + count].copy()

    def random(self, n: Whole = 1, *, workers: Whole = 1) -> npt.NDArray[np.float64]:
        """Draw the next points; fewer than ``n`` if no more room is left.

        Parameters
        ----------
        n : int
            The number of points.
        workers : int
            Has no effect; see ``threads``.

        Returns
        -------
        ndarray, shape (n or fewer, d)
        """
        drawn = self._random(n, workers=workers)
        self.num_generated += len(drawn)
        return drawn

    def fill_space(self) -> npt.NDArray[np.float64]:
        """Draw points until no room is left. Returns an array of shape (N, d)."""
        self._fetch(None)
        return self.random(len(self._points) - self.num_generated)

    def reset(self) -> PoissonDisk:
        """Go back to the first point. Returns the engine itself."""
        self.num_generated = 0
        return self

    def fast_forward(self, n: Whole) -> PoissonDisk:
        """Skip ``n`` points. Returns the engine itself."""
        self.random(n)
        return self
