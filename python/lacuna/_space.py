"""Surfaces and volumes: maximal sets of points in space, and their proofs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, SupportsFloat

import numpy as np

from . import _core
from ._arguments import numbers, options, real, shown, watched
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Progress, Seed, Whole

    Floats = npt.NDArray[np.float64]
    Sides = tuple[SupportsFloat, SupportsFloat, SupportsFloat]


@dataclass(frozen=True, eq=False)
class SpaceSet:
    """A set of points in space.

    Attributes
    ----------
    points : ndarray, shape (N, 3)
        In order of admission; read-only, as all arrays.
    radius : float
        The least distance: asked for, or chosen for ``n``.
    maximal : bool
        False if ``n`` or ``limit`` ended the run while there was room.
    triangles : ndarray of uint32 or None
        On a mesh: the triangle of each point. Kept points have none: they are the first ones.
    shares : ndarray, shape (N, 3), or None
        On a mesh: the barycentric coordinates of each point, shares of the triangle's corners.
    normals : ndarray, shape (N, 3), or None
        On a mesh: the unit normal of each point's triangle.
    seed, rounds, draws : int
    backend, device : str
    seconds : dict
        As of a ``PointSet``.
    """

    points: Floats
    radius: float
    maximal: bool
    triangles: npt.NDArray[np.uint32] | None
    shares: Floats | None
    normals: Floats | None
    seed: int
    rounds: int
    draws: int
    backend: str
    device: str
    seconds: dict[str, float]

    def __len__(self) -> int:
        return len(self.points)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Floats:
        return np.array(self.points, dtype) if copy else np.asarray(self.points, dtype)


@dataclass(frozen=True)
class SpaceVerdict:
    """What was proven of a set in space; true if all holds.

    Attributes
    ----------
    holds : bool
        No two points are closer than the radius, and unless only distances were asked for, no spot
        is farther from all points, by more than the tolerance.
    maximal : bool
        This was proven, and the tolerance is at most 1 % of the radius.
    outside : int or None
        The first point that lies off the surface, or outside of the volume. Then nothing else was
        looked at.
    closest_pair : tuple of int or None
    least_distance : float
    largest_gap : tuple of float or None
        The spot that is farthest from all points.
    largest_gap_distance : float
    tolerance : float
    """

    holds: bool
    maximal: bool
    outside: int | None
    closest_pair: tuple[int, int] | None
    least_distance: float
    largest_gap: tuple[float, float, float] | None
    largest_gap_distance: float
    tolerance: float

    def __bool__(self) -> bool:
        return self.holds


def _rows(name: str, value: object) -> Floats:
    array = numbers(name, value)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise BadRequest(name, f"of shape {array.shape}", "must be N x 3")
    return np.ascontiguousarray(array, dtype=np.float64)


def _faces(faces: object) -> npt.NDArray[np.uint32]:
    array = numbers("faces", faces)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iu":
        raise BadRequest("faces", f"of shape {array.shape} and type {array.dtype}", "must be M x 3 whole numbers")
    if array.size and (array.min() < 0 or array.max() >= 2**32):
        raise BadRequest("faces", shown(int(array.min())), "must be numbers of vertices")
    return np.ascontiguousarray(array, dtype=np.uint32)


def _sides(value: object) -> list[float]:
    try:
        sides = [real("domain", side) for side in value]  # type: ignore[attr-defined]
    except TypeError:
        sides = []
    if len(sides) != 3:
        raise BadRequest("domain", shown(value), "must be (width, height, depth)")
    return sides


def _made(
    progress: Progress | Literal[True] | None,
    asked: dict[str, Any],
    keep: object,
    mesh: tuple[Floats | None, npt.NDArray[np.uint32] | None, npt.NDArray[np.uint8] | None],
) -> SpaceSet:
    kept = None if keep is None else _rows("keep", keep)
    with watched(progress) as told:
        return SpaceSet(**_core.sample_in_space(asked, *mesh, kept, told))


def sample_surface(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    radius: SupportsFloat | None = None,
    *,
    n: Whole | None = None,
    allowed: npt.ArrayLike | None = None,
    keep: npt.ArrayLike | None = None,
    limit: Whole | None = None,
    seed: Seed = None,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | Literal[True] | None = None,
) -> SpaceSet:
    """Make a maximal Poisson-disk set on the surface of a triangle mesh.

    No two points are closer than the radius, straight through space, and no spot of the surface is
    farther from all points. The set is distributed as if darts were thrown until no room is left.
    Meshes of trimesh, Open3D and igl fit as they are: ``mesh.vertices, mesh.faces``.

    Parameters
    ----------
    vertices : array_like, shape (V, 3)
    faces : array_like of int, shape (M, 3)
        Triangles, as numbers of vertices. Holes, triangles without area, edges of three triangles
        and triangles that cross each other are fine.
    radius : float, optional
        Least distance between two points. Give it or ``n``.
    n : int, optional
        Exactly this many points, at a radius that has room for a few more.
    allowed : array_like of bool, shape (M,), optional
        Whether points may lie on each triangle.
    keep : array_like, shape (K, 3), optional
        Points that are there already; they come first.
    limit, seed, round_size, backend, device, threads, memory_limit, progress
        As for ``sample``.

    Returns
    -------
    SpaceSet

    Raises
    ------
    BadRequest, TypeError, Unavailable, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    >>> sides = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    >>> made = lacuna.sample_surface(corners, sides, 0.1, seed=1)
    >>> made.points.shape == made.normals.shape, lacuna.verify_surface(made, corners, sides, 0.1).maximal
    (True, True)
    """
    asked = options(
        radius=radius, n=n, limit=limit, seed=seed, round_size=round_size, backend=backend,
        device=device, threads=threads, memory_limit=memory_limit,
    )  # fmt: skip
    may = None
    if allowed is not None:
        may = np.ascontiguousarray(numbers("allowed", allowed) != 0, dtype=np.uint8)
        if may.ndim != 1 or may.size == 0:
            raise BadRequest("allowed", f"of shape {may.shape}", "must have one value for each triangle")
    return _made(progress, asked, keep, (_rows("vertices", vertices), _faces(faces), may))


def sample_volume(
    radius: SupportsFloat | None = None,
    *,
    n: Whole | None = None,
    domain: Sides = (1, 1, 1),
    torus: bool = False,
    keep: npt.ArrayLike | None = None,
    limit: Whole | None = None,
    seed: Seed = None,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | Literal[True] | None = None,
) -> SpaceSet:
    """Make a maximal Poisson-disk set in a box of three sides, or on a torus.

    The parameters are those of ``sample_surface``, but for

    domain : tuple of float
        (width, height, depth); the lower corner is (0, 0, 0).
    torus : bool
        Whether opposite sides are the same.

    Returns
    -------
    SpaceSet

    Examples
    --------
    >>> import lacuna
    >>> made = lacuna.sample_volume(0.1, torus=True, seed=1)
    >>> bool(lacuna.verify_volume(made, 0.1, torus=True))
    True
    """
    asked = options(
        radius=radius, n=n, torus=torus, limit=limit, seed=seed, round_size=round_size,
        backend=backend, device=device, threads=threads, memory_limit=memory_limit,
    )  # fmt: skip
    asked["volume"] = _sides(domain)
    return _made(progress, asked, keep, (None, None, None))


def verify_surface(
    points: npt.ArrayLike,
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    radius: SupportsFloat,
    *,
    tolerance: SupportsFloat | None = None,
    distances_only: bool = False,
) -> SpaceVerdict:
    """Prove or refute, from coordinates alone, that a set on a mesh is maximal, whoever made it.

    A gap, and the distance of a point from the surface, may be ``tolerance`` larger than the radius
    and 0; by default 2^-28 of the longest side of the box around the mesh.
    """
    asked = options(radius=radius, tolerance=tolerance, distances_only=distances_only)
    mesh = _rows("vertices", vertices), _faces(faces)
    return SpaceVerdict(**_core.verify_in_space(_rows("points", points), asked, *mesh))


def verify_volume(
    points: npt.ArrayLike,
    radius: SupportsFloat,
    *,
    domain: Sides = (1, 1, 1),
    torus: bool = False,
    tolerance: SupportsFloat | None = None,
    distances_only: bool = False,
) -> SpaceVerdict:
    """Prove or refute that a set in a box or on a torus of three sides is maximal."""
    asked = options(radius=radius, torus=torus, tolerance=tolerance, distances_only=distances_only)
    asked["volume"] = _sides(domain)
    return SpaceVerdict(**_core.verify_in_space(_rows("points", points), asked, None, None))
