"""read_polygons, read_lines and draw_mask: polygons in which points may lie, and obstacles."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterable, SupportsFloat

import numpy as np

from . import _core
from ._arguments import flag, pair, path_bytes, points_array, real, shown, whole
from ._errors import BadRequest
from ._runs import MOST_64

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Whole

    Floats = npt.NDArray[np.float64]
    # Lines and the distance that points keep from them.
    Obstacles = list[tuple["Polygons | Iterable[npt.ArrayLike]", float]]


@dataclass(frozen=True, eq=False)
class Polygons:
    """Closed outlines. A point is inside if an odd number of outlines goes around it.

    Attributes
    ----------
    rings : tuple of ndarray, each of shape (N, 2), float64
        The corners of each outline, y upwards. The last is joined to the first.
    domain : tuple of float or None
        Width and height of the page; None if the file has no page.
    """

    rings: tuple[Floats, ...] = field(repr=False)
    domain: tuple[float, float] | None

    def __len__(self) -> int:
        return len(self.rings)


def read_polygons(path: str | bytes | os.PathLike[Any]) -> Polygons:
    """Read the polygons of a file, by its extension.

    Parameters
    ----------
    path : path
        ``.svg``: the outlines of its shapes, in user units of the page. ``.geojson``, ``.json``:
        polygons, with unchanged coordinates. ``.txt``: ``x y`` on each line, and a blank line
        between rings. Polygons of one file that overlap are joined, each filled by its own rule.
        docs/domains.md lists what is read and what is skipped.

    Returns
    -------
    Polygons

    Raises
    ------
    FileError
        An OSError: the file cannot be read, is broken or has no polygon.
    BadRequest
        The extension is not one of these.
    TypeError
        The argument is not a path.

    Examples
    --------
    >>> import lacuna, pathlib, tempfile
    >>> folder = tempfile.TemporaryDirectory()
    >>> path = pathlib.Path(folder.name, "moon.svg")
    >>> _ = path.write_text('<svg viewBox="0 0 4 2"><circle cx="2" cy="1" r="0.9"/></svg>')
    >>> moon = lacuna.read_polygons(path)
    >>> len(moon), moon.domain
    (1, (4.0, 2.0))
    >>> mask = lacuna.draw_mask(moon, 0.1 / 16)
    >>> made = lacuna.sample(0.1, mask=mask, domain=moon.domain, seed=1)
    >>> made.maximal, bool((abs(made.points - (2, 1)) < 0.91).all())
    (True, True)
    >>> folder.cleanup()
    """
    return _read(path, as_lines=False)


def _read(path: str | bytes | os.PathLike[Any], as_lines: bool) -> Polygons:
    try:
        found = _core.read_polygons(path_bytes("path", path), as_lines)
    except BadRequest as error:
        raise error.called("path") from None
    width, height = found["width"], found["height"]
    return Polygons(tuple(found["rings"]), (width, height) if width > 0 else None)


def read_lines(path: str | bytes | os.PathLike[Any]) -> Polygons:
    """Read lines and outlines from a file, for ``avoid`` of ``draw_mask`` and ``verify``.

    A line becomes a ring that goes there and back, an outline one that goes around and back, and a
    point a ring of one point: nothing lies inside of these.

    Parameters
    ----------
    path : str, bytes or os.PathLike
        A .svg, whose open paths are lines and whose closed ones are outlines; a .geojson with
        points, lines and polygons; or a .txt with rings, of which one of two points is a line.

    Returns
    -------
    Polygons

    Raises
    ------
    FileError, BadRequest, TypeError
        As ``read_polygons``.

    Examples
    --------
    >>> import lacuna, pathlib, tempfile
    >>> folder = tempfile.TemporaryDirectory()
    >>> path = pathlib.Path(folder.name, "fence.txt")
    >>> _ = path.write_text("0.2 0.5\\n0.8 0.5\\n")
    >>> mask = lacuna.draw_mask(None, 0.002, avoid=[(lacuna.read_lines(path), 0.1)])
    >>> made = lacuna.sample(0.03, mask=mask, seed=1)
    >>> beside = made.points[abs(made.points[:, 0] - 0.5) < 0.3]
    >>> bool((abs(beside[:, 1] - 0.5) >= 0.1).all())
    True
    >>> folder.cleanup()
    """
    return _read(path, as_lines=True)


def rings_on(name: str, rings: object, domain: tuple[float, float]) -> list[Floats]:
    """The rings as arrays. If they have a page, it is stretched over the domain."""
    if isinstance(rings, Polygons):
        if rings.domain is None:
            return list(rings.rings)
        scale = domain[0] / rings.domain[0], domain[1] / rings.domain[1]
        with np.errstate(over="ignore", invalid="ignore"):  # the library refuses inf and NaN
            return [ring * scale for ring in rings.rings]
    if isinstance(rings, (str, bytes, os.PathLike)) or not isinstance(rings, Iterable):
        raise TypeError(f"{name} must be Polygons or a list of N x 2 arrays, not {shown(rings)}")
    return [points_array(name, ring) for ring in rings]


def sets_on(
    name: str,
    given: object,
    domain: tuple[float, float],
    forbidden: bool = False,
    distance: float = 0.0,
) -> list[tuple[list[Floats], bool, float]]:
    """One set of polygons, or one for each Polygons of a list."""
    if given is None:
        return []
    several = [given]
    if isinstance(given, (list, tuple)) and given and isinstance(given[0], Polygons):
        several = list(given)
    return [(rings_on(name, one, domain), forbidden, distance) for one in several]


def _pairs(avoid: object) -> list[tuple[object, SupportsFloat]]:
    if avoid is None:
        return []
    if not isinstance(avoid, (list, tuple)) or not all(
        isinstance(one, (list, tuple)) and len(one) == 2 for one in avoid
    ):
        raise TypeError(
            f"avoid must be a list of pairs of lines and their distance, not {shown(avoid)}"
        )
    return list(avoid)


def lines_of(avoid: object) -> list[object]:
    return [lines for lines, _ in _pairs(avoid)]


def obstacles_on(
    avoid: object, domain: tuple[float, float], torus: bool = False
) -> list[tuple[list[Floats], bool, float]]:
    """A set for each pair of lines and their distance; on a torus with its images."""
    sets = []
    for lines, distance in _pairs(avoid):
        rings = rings_on("avoid", lines, domain)
        if torus:
            around = (-1.0, 0.0, 1.0)
            images = [np.multiply((i, j), domain) for i in around for j in around]
            rings = [ring + image for ring in rings for image in images]
        width = real("avoid", distance)
        if not 0 < width < np.inf:
            raise BadRequest(f"avoid {width}: a distance must be a finite number over 0", "avoid")
        sets.append((rings, True, width))
    return sets


def page_of(*given: object) -> tuple[float, float] | None:
    """The first page of these polygons."""
    for one in given:
        for polygons in one if isinstance(one, (list, tuple)) else [one]:
            if isinstance(polygons, Polygons) and polygons.domain is not None:
                return polygons.domain
    return None


def domain_around(*places: object) -> tuple[float, float]:
    """The domain of places: what ``draw_mask`` and ``verify`` take unless they are given one.

    The first page of Polygons that have one; else (1, 1), or the farthest corner if the places
    reach beyond it.

    Parameters
    ----------
    *places : Polygons, iterable of array_like, each of shape (N, 2), or list of Polygons

    Returns
    -------
    tuple of float
        Width and height.

    Raises
    ------
    BadRequest
        The places lie far from (0, 0), where a domain begins.
    TypeError
        An argument is of the wrong type.

    Examples
    --------
    >>> import lacuna
    >>> lacuna.domain_around([[(10, 5), (90, 5), (50, 60)]])
    (90.0, 60.0)
    """
    return around(*(("places", given) for given in places))


def around(*places: tuple[str, object]) -> tuple[float, float]:
    """``domain_around`` places that come with the names of their arguments."""
    page = page_of(*(given for _, given in places))
    if page is not None:
        return page
    sets = []
    for name, given in places:
        for one in sets_on(name, given, (1.0, 1.0)):
            if not all(np.isfinite(ring).all() for ring in one[0]):
                raise BadRequest(f"{name}: coordinates must be finite numbers", name)
            sets.append(one)
    return _core.domain_around(sets) if sets else (1.0, 1.0)


def draw_mask(
    rings: Polygons | Iterable[npt.ArrayLike] | Iterable[Polygons] | None,
    edge: SupportsFloat,
    *,
    outside: Polygons | Iterable[npt.ArrayLike] | Iterable[Polygons] | None = None,
    avoid: Obstacles | None = None,
    border: SupportsFloat = 0,
    torus: bool = False,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
    memory_limit: Whole | None = None,
) -> npt.NDArray[np.bool_]:
    """Draw polygons onto a mask, for ``sample``.

    A pixel is True if all of it is inside: if an odd number of rings goes around it. So a ring
    within another is a hole, and no point of ``sample`` lies outside. The diagonal of a pixel is at
    most ``edge``, so all that is farther than ``edge`` from the rings is True. The same rings give
    the same mask on every machine, which is also the mask of the command's ``--inside`` with this
    ``--edge``.

    Parameters
    ----------
    rings : Polygons, iterable of array_like, each of shape (N, 2), or list of Polygons
        The corners of each ring in the unit of ``domain``, y upwards. Of several Polygons a pixel
        may lie in any. None: everywhere.
    outside : as ``rings``, optional
        Polygons in which no pixel is True.
    avoid : list of (Polygons or iterable of array_like, float), optional
        Obstacles: lines, outlines and points, and the distance in which no pixel is True.
        ``read_lines`` reads them; an array of one row is a point.
    border : float
        The least distance of pixels that are True to the outlines of ``rings`` and ``outside``.
    torus : bool
        Whether ``avoid`` reaches around the edges of the domain.
    edge : float
        How far inside of the outline pixels may begin to be True. The command takes a sixteenth of
        the least radius.
    domain : tuple of float, optional
        Width and height, which must be passed to ``sample`` too. By default ``domain_around`` all
        these places. A page is stretched over it.
    memory_limit : int, optional
        Refuse a mask of more bytes; a pixel takes one. By default a quarter of the machine's
        memory.

    Returns
    -------
    ndarray, shape (rows, columns), bool
        Row 0 is the top, where y is largest.

    Raises
    ------
    BadRequest
        The edge is so small that the mask exceeds the limit, or no pixel is inside the rings.
    TypeError
        An argument is of the wrong type. Names it.

    Examples
    --------
    >>> import lacuna
    >>> outer, hole = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0.2, 0.2), (0.6, 0.2), (0.2, 0.6)]
    >>> mask = lacuna.draw_mask([outer, hole], 0.01)
    >>> mask.shape, round(float(mask.mean()), 2)  # all but a triangle of 0.08
    ((142, 142), 0.89)
    >>> lacuna.sample(0.05, mask=mask, seed=1).maximal
    True
    """
    most = 0 if memory_limit is None else whole("memory_limit", memory_limit, 1, MOST_64)
    distance = real("border", border)

    def sets_for(size: tuple[float, float], around: bool) -> list[tuple[list[Floats], bool, float]]:
        sets = sets_on("rings", rings, size, distance=distance)
        sets += sets_on("outside", outside, size, forbidden=True, distance=distance)
        return sets + obstacles_on(avoid, size, around)

    page = page_of(rings, outside, *lines_of(avoid))
    if domain is not None:
        width, height = pair("domain", domain)
    else:
        width, height = page or _core.domain_around(sets_for((1.0, 1.0), False))
    sets = sets_for((width, height), flag("torus", torus))
    try:
        mask = _core.draw_mask(sets, width, height, real("edge", edge), most)
    except BadRequest as error:
        raise error.called("rings") if error.argument == "inside" else error from None
    return mask.values.view(np.bool_)
