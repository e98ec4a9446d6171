"""Polygons in which points may lie, and obstacles: read from files, and drawn onto masks."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterable, Mapping, SupportsFloat

import numpy as np

from . import _core
from ._arguments import options, path_bytes, points_array, real, shown
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Domain, Extent, Whole

    Floats = npt.NDArray[np.float64]


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


if TYPE_CHECKING:
    Places = Polygons | Iterable[npt.ArrayLike] | Iterable[Polygons] | None
    # Also those of classes, by their names, and by None those of all.
    PlacesOfClasses = Places | Mapping[str | None, Places]
    # Lines and the distance that points keep from them.
    Obstacles = list[tuple[Polygons | Iterable[npt.ArrayLike], float]]


def read_polygons(path: str | bytes | os.PathLike[Any]) -> Polygons:
    """Read the polygons of a file, by its extension.

    Parameters
    ----------
    path : path
        ``.svg``, ``.svgz``: the outlines of its shapes, in user units of the page;
        ``map.svg#lakes`` is the part with this id or Inkscape label. ``.geojson``, ``.geojsonl``,
        ``.json``: polygons, with unchanged coordinates. ``.txt``: ``x y`` on each line, and a blank
        line between rings. Polygons of one file that overlap are joined, each filled by its own
        rule. docs/domains.md lists what is
        read and what is skipped.

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
    >>> made = lacuna.sample(0.1, inside=moon, seed=1)
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
    return Polygons(**found)


def read_lines(path: str | bytes | os.PathLike[Any]) -> Polygons:
    """Read lines and outlines from a file, for ``avoid`` and ``near`` of ``sample`` and ``verify``.

    A line becomes a ring that goes there and back, an outline one that goes around and back, and a
    point a ring of one point: nothing lies inside of these.

    Parameters
    ----------
    path : str, bytes or os.PathLike
        A .svg, whose open paths are lines and whose closed ones are outlines, or a part of it as
        for ``read_polygons``; a .geojson with points, lines and polygons; or a .txt with rings, of
        which one of two points is a line.

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
    >>> made = lacuna.sample(0.03, avoid=[(lacuna.read_lines(path), 0.1)], seed=1)
    >>> beside = made.points[abs(made.points[:, 0] - 0.5) < 0.3]
    >>> bool((abs(beside[:, 1] - 0.5) >= 0.1).all())
    True
    >>> folder.cleanup()
    """
    return _read(path, as_lines=True)


def _outline(
    argument: str, given: object, distance: float | None, kind: str | None = None
) -> _core.Outline:
    """Rings of one argument for the library, which are read once."""
    page = None
    if isinstance(given, Polygons):
        rings, page = list(given.rings), given.domain
    elif isinstance(given, (str, bytes, os.PathLike)) or not isinstance(given, Iterable):
        raise TypeError(f"{argument} must be Polygons or a list of N x 2 arrays, not {shown(given)}")
    else:
        rings = [points_array(argument, ring) for ring in given]
        if argument != "near":  # whose rings are lines
            rings = _core.joined(rings)
    return argument, rings, distance, kind or "", page


def places_of(
    inside: object,
    outside: object,
    avoid: object,
    near: object,
    border: float | None = None,
    inner: str = "inside",
) -> list[_core.Outline]:
    """The places of these arguments. ``border`` is the distance from outlines in place of the border
    of points, and ``inner`` the name of the first argument."""
    places = [
        _outline(argument, one, border, kind)
        for argument, given in ((inner, inside), ("outside", outside))
        for kind, some in (given.items() if isinstance(given, Mapping) else [(None, given)])
        for one in _several(some)
    ]
    for argument, given in (("avoid", avoid), ("near", near)):
        if given is None:
            continue
        if not isinstance(given, (list, tuple)) or not all(
            isinstance(one, (list, tuple)) and len(one) == 2 for one in given
        ):
            raise TypeError(
                f"{argument} must be a list of pairs of lines and their distance, not "
                f"{shown(given)}"
            )
        for lines, distance in given:
            width = real(argument, distance)
            if not 0 < width < np.inf:
                raise BadRequest(argument, f"{width}", "a distance must be a finite number over 0")
            places.append(_outline(argument, lines, width))
    return places


def _several(given: object) -> list[object]:
    """One Polygons or list of rings, or several Polygons, as a list."""
    if isinstance(given, (list, tuple)) and given and isinstance(given[0], Polygons):
        return list(given)
    return [] if given is None else [given]


def domain_around(*places: Places) -> Extent:
    """The domain of places: what ``sample`` and ``verify`` use unless they are given one.

    The first page of Polygons that have one; else (1, 1), or the farthest corner if the places
    reach beyond it. If they lie far from (0, 0), or beyond it, the box around them, or a larger
    square if doubles cannot resolve a box so small there.

    Parameters
    ----------
    *places : Polygons, iterable of array_like, each of shape (N, 2), or list of Polygons

    Returns
    -------
    tuple of float
        (width, height), or (x0, y0, x1, y1) of a box that does not begin at (0, 0).

    Raises
    ------
    BadRequest
        The places lie far from (0, 0) in a box that has no area.
    TypeError
        An argument is of the wrong type.

    Examples
    --------
    >>> import lacuna
    >>> lacuna.domain_around([[(10, 5), (90, 5), (50, 60)]])
    (90.0, 60.0)
    >>> lacuna.domain_around([[(448000, 5411000), (450000, 5411000), (449000, 5412500)]])
    (448000.0, 5411000.0, 450000.0, 5412500.0)
    """
    outlines = [_outline("places", one, None) for all in places for one in _several(all)]
    return _core.domain_around(outlines, {}, None)


def draw_mask(
    rings: Places,
    edge: SupportsFloat,
    *,
    outside: Places = None,
    avoid: Obstacles | None = None,
    near: Obstacles | None = None,
    border: SupportsFloat = 0,
    torus: bool = False,
    domain: Domain | None = None,
    memory_limit: Whole | None = None,
) -> npt.NDArray[np.bool_]:
    """Draw polygons onto an array of bool, the ``mask`` of ``sample`` and ``verify``.

    A pixel is True if all of it is inside. A ring within another is a hole, and rings that overlap
    in part are joined. So no point of ``sample`` lies outside. The diagonal of a pixel is at
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
        ``read_lines`` reads them; an array of one row is a point, of two a line, and of more an
        outline with its inside.
    near : list of (Polygons or iterable of array_like, float), optional
        Likewise, and the distance from any of them within which pixels are True.
    border : float
        The least distance of pixels that are True to the outlines of ``rings`` and ``outside``.
    torus : bool
        Whether ``avoid`` and ``near`` reach around the edges of the domain.
    edge : float
        How far inside of the outline pixels may begin to be True. The command takes a sixteenth of
        the least radius.
    domain : tuple of float, optional
        (width, height) or (x0, y0, x1, y1), which must be passed to ``sample`` too. By default
        ``domain_around`` all these places. A page is stretched over it.
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
        The edge is so small that the mask exceeds the limit.
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
    distance = real("border", border)
    places = places_of(rings, outside, avoid, near, distance, "rings")
    asked = options(
        domain=_core.domain_around(places, {}, None) if domain is None else domain,
        edge=edge,
        torus=torus,
        memory_limit=memory_limit,
    )
    try:
        return _core.draw_mask(places, asked).values.view(np.bool_)
    except BadRequest as error:
        if error.argument != "inside":
            raise
        raise error.called("rings") from None
