"""sample and sample_many: make point sets."""

from __future__ import annotations

import os
import sys
import time
from itertools import islice
from typing import TYPE_CHECKING, Any, Collection, Iterable, Iterator, Literal, Sized
from typing import SupportsFloat, TypedDict, Unpack, overload

from . import _core
from ._arguments import MOST_64, importance_of, options, points_array, raster_in, real
from ._arguments import chunk_in, shown, watched, whole
from ._classes import borders_of, classes_of, classes_of_points, masks_of
from ._errors import BadRequest, MemoryRefused
from ._polygons import places_of
from ._sets import PointSet, set_attributes

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Domain, Metric, Mode, Progress, Seed, Whole
    from ._classes import Border, ClassSizes, Masks
    from ._polygons import Obstacles, PlacesOfClasses

# The most sets in a batch, and for an iterator the most points. A batch is made by one call of the
# library, and its first set is handed out only when all of them are made.
_MOST_SETS_AHEAD = 4096
_MOST_POINTS_AHEAD = 2**20
_BYTES_OF_A_POINT = 16
_BYTES_OF_A_SET = 1000  # a PointSet without its points; a little less than measured


def sample(
    radius: SupportsFloat | None = None,
    n: Whole | None = None,
    *,
    field: npt.ArrayLike | None = None,
    ellipses: npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    metric: Metric | None = None,
    mask: Masks | None = None,
    inside: PlacesOfClasses = None,
    outside: PlacesOfClasses = None,
    avoid: Obstacles | None = None,
    near: Obstacles | None = None,
    edge: SupportsFloat | None = None,
    border: Border = 0,
    inside_by_radius: bool = False,
    keep: npt.ArrayLike | None = None,
    classes: ClassSizes | None = None,
    between: str | npt.ArrayLike = "sum",
    priority: bool = False,
    keep_classes: Iterable[object] | None = None,
    domain: Domain | None = None,
    chunk: tuple[Whole, Whole] | None = None,
    chunk_size: SupportsFloat | None = None,
    on_pixels: tuple[Whole, Whole] | None = None,
    torus: bool = False,
    mode: Mode | None = None,
    seed: Seed = None,
    progressive: bool = False,
    limit: Whole | None = None,
    relax: Whole = 0,
    gaussian: Whole = 0,
    gaussian_distance: SupportsFloat | None = None,
    lines_per_radius: Whole | None = None,
    snap: bool = False,
    uniform_x: bool = False,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | Literal[True] | None = None,
) -> PointSet:
    """Make a maximal set of random points, evenly spread; with ``field`` dense where it is high.

    A maximal set has no room for one more point. No two points are closer than the radius.

    The same arguments and seed give the same points, bit for bit, on every backend and with any
    number of threads. The commands ``lacuna sample`` and ``lacuna stipple`` give the same points.

    Parameters
    ----------
    radius : float
        Least distance between two points, in the unit of ``domain``. Give ``radius`` or ``n``; with
        a field give ``scale`` or ``n``.
    n : int
        Exactly ``n`` points. The radius or scale is chosen so that a few more would fit: the set is
        not maximal.
    field : array_like, shape (rows, columns), optional
        Importance: points are dense where it is high. Finite and at least 0; where it is 0 there is
        no point. Row 0 is the top, where y is largest. Any real dtype, byte order and
        strides. It is read once, before the work begins.
    ellipses : array_like, shape (rows, columns, 3), optional
        An ellipse for each point instead of a disk: two radii in the unit of ``domain``, and the
        angle of the first, in radians counterclockwise from the x axis. Two points conflict if each
        lies in the other's ellipse. Row 0 is the top. Where both radii are 0 there is no point. In
        'exact'; not with a field, classes or ``relax``.
    scale : float
        With a field, the radius at a point is ``scale / sqrt(importance there)``. With ellipses a
        factor of all radii, by default 1.
    metric : {'min', 'mean', 'max'}, optional
        With a field: the least distance of two points is the min, mean or max of their radii. By
        default 'min', but 'mean' in 'cells' with ``relax``. 'exact' accepts 'min' only.
    mask : array_like, shape (rows, columns), optional
        Points may lie on pixels that are not 0 or False. The mask is stretched over the domain. Row
        0 is the top. Any real dtype, byte order and strides. ``draw_mask`` makes one of polygons.
        With classes also a dict: that of a class by its name, and by None that of the others. The
        first one gives the domain its shape, unless there is a field.
    inside, outside : Polygons, iterable of array_like, or list of Polygons, optional
        Polygons in which points must lie, and must not lie: outlines of shape (N, 2) in the unit of
        ``domain``, y upwards, or what ``read_polygons`` gives. An outline within another is a hole,
        and outlines that overlap in part are joined. Of several Polygons a point lies in any. With
        classes also a dict: those of a class by its name, and by None those of all. A class that
        has ``inside`` of its own lies in that alone. Beside a mask points lie where both allow it.
    avoid : list of (Polygons or iterable of array_like, float), optional
        Obstacles: lines, outlines and points, and the distance that points keep from them.
        ``read_lines`` reads them; an array of one row is a point, of two a line, and of more an
        outline with its inside.
    near : list of (Polygons or iterable of array_like, float), optional
        Lines, outlines and points as for ``avoid``, and the distance within which points lie from
        any of them.
    edge : float, optional
        How far inside of these outlines points may begin, in the unit of ``domain``; points never
        lie outside. By default a sixteenth of the least radius, which is estimated for ``n``.
    border : float or dict of str to float
        Least distance of points to the domain's edges, in the unit of ``domain``, and to the
        outlines of ``inside`` and ``outside``; not on a torus. With classes a dict of the border of
        each, which is 0 for those that are left out.
    inside_by_radius : bool
        No object overhangs the domain's edges, the outlines of ``inside`` and ``outside``, or the
        obstacles of ``avoid``: points keep half of ``radius`` from them, and those of a class half
        of the distance that two of it keep. Not with ``n``, a field, ellipses, a mask or a torus.
    keep : array_like, shape (N, 2), optional
        Points that are there already. They come first, unmoved, and new points keep their distance
        from them. Each must lie where points may lie, and keep its distance from the others. They
        count for ``n`` and ``limit``. Those outside of a domain without ``torus`` are no points of
        the set, but new points keep their distance from them: give those of the sets beside it.
    classes : dict of str to float, optional
        Points of several kinds: the radius of each by its name, or a radius and a weight, which
        says how often the class is drawn, or these two and how many points the class has, such as
        ``(0.05, 1, 20)``. A text is a range of radii: ``'1.5..3'`` has objects of 8 sizes, and
        ``'1.5..3/5'`` of 5; ``radii_of_classes`` of the set has the radius of each point. A number
        of points is not for ``n``, ``limit`` and ``progressive``. With classes give no ``radius``
        or ``scale``; with ``n`` the radii are in proportion. With a field they are those where the
        importance is 1. At most 16, and each size counts as one.
    between : {'sum', 'union'} or array_like, shape (K, K)
        The least distance of two classes. 'sum': the sum of their radii, as of objects that do not
        overlap. 'union': each class alone is a set of its radius, and all together are evenly
        distributed. Or a symmetric matrix; the radii in ``classes`` are then None.
    priority : bool
        With classes: each is full before the next begins, in the order of the dict: as many trees
        as have room, then bushes, then grass. Not with weights, ``n``, ``limit`` or ``progressive``.
    keep_classes : iterable of str or int, optional
        With classes, of each point of ``keep``: the name of its class, or its place in ``classes``.
        By default those of ``keep``, if it is a PointSet with classes.
    domain : tuple of float, optional
        (width, height), or (x0, y0, x1, y1) of a domain whose lower left corner is not (0, 0),
        such as a part of a map. By default the shape of the field or else of the mask, with a
        longer side of 1; else ``domain_around`` the polygons and obstacles; without all of these
        (1, 1). A corner is at most 2^20 times the longer side from 0.
    chunk, chunk_size : tuple of int and float, optional
        (I, J): the square from (I * chunk_size, J * chunk_size) on, in place of ``domain``. Each
        chunk is the same in whatever order chunks are made, and all of them are one maximal set:
        a chunk keeps the points of some of the chunks beside it, which are made for it. The size
        is over the greatest distance of two points. Polygons lie in the plane. Not with a field,
        ellipses, a mask, a border, ``n``, ``limit``, ``progressive``, ``keep`` or ``torus``.
    on_pixels : tuple of int, optional
        (columns, rows): the domain is cut into these pixels (and is (columns, rows), unless it is
        given). ``n`` points lie in the centres of pixels, at most one on each, as even as can be
        or as dense as ``field`` says: where it asks for more than one point on a pixel, the rest
        goes elsewhere. ``pixels`` of the result is the boolean mask. The importance, and
        whether points may lie there, are those at a pixel's centre.
    torus : bool
        Whether the edges wrap.
    mode : {'exact', 'lines', 'cells', 'stratified', 'pixels'}, optional
        'exact', the default, leaves no gap; 'lines' is the approximation of Kalantari & Sen 2011;
        'cells', for a field, puts points on a lattice, as they do. Mask, border and keep need
        'exact'. 'stratified' is a start for ``relax``: every part of the domain has its share of
        the points. It is the default with ``relax`` and ``n``, unless ``metric``, ``limit``,
        ``lines_per_radius`` or ``round_size`` is given. 'pixels' is that of ``on_pixels``.
    seed : None, int or numpy.random.Generator
        An int from 0 to 2^64 - 1 is the same as --seed of the command. A generator gives 64 random
        bits; for None the system gives them. The result holds the seed. Sets of different seeds are
        independent.
    progressive : bool
        Order the points so that the first k, for any k from 16 on, are spread as evenly as a set
        of k points; ``n`` may cut the sequence anywhere. In mode 'exact'.
    limit : int, optional
        Stop after this many points.
    relax : int
        How often the points are moved after sampling, as ``lacuna.relax`` does. Not with mask,
        border or keep.
    gaussian, gaussian_distance : int and float
        Steps of descent that follow, as for ``lacuna.relax``, and their distance, 0.9 by default.
        Not with a field, ellipses, mask, border or keep.
    lines_per_radius : int, optional
        1 to 1000. By default 30 in 'lines', 10 in 'cells' and 6 in 'exact' (1 with a field, a mask,
        a border or kept points). In 'exact' it changes only the speed.
    snap, uniform_x : bool
        In 'lines': points lie on the lines; all lines with room are equally likely.
    round_size : int
        Draws in a round; 0 chooses, 1 is the paper's algorithm.
    backend : {'auto', 'cpu', 'opencl', 'vulkan', 'reference'}
        'auto' is the backend that the environment variable LACUNA_BACKEND names, or else 'cpu'.
    device : int or str, optional
        For opencl and vulkan: a device's number or a part of its name.
    threads : int
        0 is one for each core.
    memory_limit : int, optional
        Refuse a set that takes more bytes; by default the machine's memory.
    progress : callable or True, optional
        Called with the number of points so far and the number expected, at most 50 times a second,
        on the calling thread. An exception that it raises ends the run. While relaxing it is called
        with points times iterations and steps. True: a progress bar, if tqdm is installed.

    Returns
    -------
    PointSet

    Raises
    ------
    BadRequest
        A ValueError: a value is invalid. Names the argument.
    TypeError
        An argument is of the wrong type. Names it.
    MemoryRefused
        A MemoryError: the set would take more memory than there is.
    Unavailable, DeviceError
        RuntimeErrors: there is no such backend or device, or it failed.
    KeyboardInterrupt
        On Ctrl-C, within 0.2 s.

    Examples
    --------
    >>> import lacuna
    >>> made = lacuna.sample(0.05, torus=True, seed=1)
    >>> made.points.shape, made.maximal
    ((278, 2), True)
    >>> lacuna.sample(n=1000, domain=(2, 1), seed=1).points.shape
    (1000, 2)

    More points to the right:

    >>> import numpy as np
    >>> ramp = np.linspace(0, 1, 64) * np.ones((64, 1))
    >>> dense = lacuna.sample(n=500, field=ramp, seed=1)
    >>> bool((dense.points[:, 0] > 0.5).mean() > 0.7)
    True

    Trees with bushes and grass between them, no two of which overlap:

    >>> wood = lacuna.sample(classes={"trees": 0.05, "bushes": 0.02, "grass": 0.005}, seed=1)
    >>> wood.maximal, wood.classes[wood.class_of[-1]]
    (True, 'grass')
    >>> bool(lacuna.verify(wood))
    True

    Ellipses four times as long as wide, around the middle of the domain:

    >>> y, x = np.mgrid[1:-1:64j, -1:1:64j]
    >>> swirl = np.dstack([np.full_like(x, 0.08), np.full_like(x, 0.02), np.arctan2(x, -y)])
    >>> made = lacuna.sample(ellipses=swirl, seed=1)
    >>> made.maximal, made.ellipses.shape == (len(made), 3)
    (True, True)
    >>> bool(lacuna.verify(made, ellipses=swirl))
    True

    A mask that samples a quarter of 64 x 48 pixels, all of them in the middle:

    >>> y, x = np.mgrid[-1:1:48j, -1:1:64j]
    >>> made = lacuna.sample(on_pixels=(64, 48), n=768, field=1 / (0.05 + x**2 + y**2), seed=1)
    >>> made.pixels.shape, int(made.pixels.sum()), bool(made.pixels[22:26, 30:34].all())
    ((48, 64), 768, True)

    Inside of a triangle, around a rock:

    >>> triangle, rock = [(0, 0), (1, 0), (0.5, 1)], [(0.5, 0.4)]
    >>> made = lacuna.sample(0.05, inside=[triangle], avoid=[([rock], 0.2)], seed=1)
    >>> made.maximal, bool((np.hypot(*(made.points - rock).T) >= 0.2).all())
    (True, True)
    """
    importance = importance_of(field, ellipses)
    if ellipses is not None and scale is None and n is None and classes is None:
        scale = 1
    kept = None if keep is None else points_array("keep", keep)
    kinds = classes_of(classes, between, priority)
    masks, first_mask = masks_of(mask, kinds)
    borders = borders_of(border, inside_by_radius, kinds)
    places = places_of(inside, outside, avoid, near)
    if domain is None and on_pixels is not None:
        domain = raster_in("on_pixels", on_pixels)
    if chunk is not None and domain is not None:
        raise BadRequest("chunk", "with domain", "is a domain by itself")
    if domain is None:
        domain = (1, 1) if chunk else _core.domain_around(places, first_mask, importance)
    asked = options(
        radius=radius, n=n, scale=scale, metric=metric, domain=domain, chunk=chunk,
        chunk_size=chunk_size, on_pixels=on_pixels, torus=torus, mode=mode,
        edge=edge, seed=seed, progressive=progressive, limit=limit, relax=relax,
        gaussian=gaussian, gaussian_distance=gaussian_distance, lines_per_radius=lines_per_radius,
        snap=snap, uniform_x=uniform_x, round_size=round_size, backend=backend, device=device,
        threads=threads, memory_limit=memory_limit,
    )  # fmt: skip
    asked.update(kinds | borders | masks)
    arrays = {
        "field": field, "ellipses": ellipses, "mask": mask, "inside": inside, "outside": outside,
        "avoid": avoid, "near": near, "keep": keep, "classes": classes,
    }  # fmt: skip
    asked["given"] = [name for name, array in arrays.items() if array is not None]
    own = keep._names_of_points(kinds) if isinstance(keep, PointSet) and kinds else None
    of_kept = classes_of_points("keep_classes", keep_classes, own, kinds, kept)
    with watched(progress) as told:
        made = _core.sample(asked, importance, places, kept, of_kept, told)
    if chunk is not None:
        i, j = chunk_in(chunk)
        side = asked["chunk_size"]
        made["domain"] = (i * side, j * side, (i + 1) * side, (j + 1) * side)
    # The command names the files of these.
    where = masks or places or None
    files = {"keep": keep, "field": field, "ellipses": ellipses, "mask": where}
    said: dict[str, Any] = {name: "an array" for name, one in files.items() if one is not None}
    if chunk is not None:
        kept = points_array("keep", [])
        said |= {name: asked[name] for name in ("chunk", "chunk_size")}
        said["keep"] = "the points of the chunks beside it"
    if made["_promised"]["inside_by_radius"]:
        said["inside_by_radius"] = True
    if kept is not None:
        said["kept"] = made["_promised"]["kept"]
        if neighbours := len(made["_promised"]["neighbours"]):
            said["neighbours"] = neighbours
    if made["relaxed"] is not None:
        said["relax"] = asked["relax"]
    if asked["gaussian"]:
        said["gaussian"] = asked["gaussian"]
        said["gaussian_distance"] = asked.get("gaussian_distance", 0.9)
    return PointSet(**set_attributes(made, **said))


class More(TypedDict, total=False):
    """The arguments of ``sample`` that ``sample_many`` has, too."""

    classes: ClassSizes | None
    between: str | npt.ArrayLike
    priority: bool
    domain: Domain
    on_pixels: tuple[Whole, Whole]
    torus: bool
    mode: Literal["exact", "lines"] | None
    progressive: bool
    limit: Whole | None
    lines_per_radius: Whole | None
    snap: bool
    uniform_x: bool
    round_size: Whole
    backend: str
    device: int | str | None
    threads: Whole
    memory_limit: Whole | None
    frame: SupportsFloat | None
    progress: Progress | Literal[True] | None


@overload
def sample_many(
    seeds: Iterator[Whole],
    radius: SupportsFloat | None = ...,
    n: Whole | None = ...,
    **more: Unpack[More],
) -> Iterator[PointSet]: ...
@overload
def sample_many(
    seeds: Collection[Whole],
    radius: SupportsFloat | None = ...,
    n: Whole | None = ...,
    **more: Unpack[More],
) -> list[PointSet]: ...
def sample_many(
    seeds: Collection[Whole] | Iterator[Whole],
    radius: SupportsFloat | None = None,
    n: Whole | None = None,
    **more: Unpack[More],
) -> list[PointSet] | Iterator[PointSet]:
    """Make many sets of one request, one for each seed. Small sets are made in parallel.

    Each set is the same as that of ``sample`` with this seed. Sets of up to about 20,000 points are
    made on one thread each, several at the same time; larger sets are made one after another. Seeds
    are read a batch at a time.

    Parameters
    ----------
    seeds : iterable of int
        Such as ``range(1000)``. Each is from 0 to 2^64 - 1. For an iterator, such as
        ``itertools.count()`` or a generator, the sets come one at a time and are not kept.
    radius, n : float, int
        As for ``sample``.
    **more
        classes, between, priority, domain, on_pixels, torus, mode, progressive, limit, lines_per_radius, snap,
        uniform_x, round_size, backend, device and threads, as for ``sample``; memory_limit, which
        is for each set; and progress, which is called with the number of sets that are done and the
        number of all sets, for an iterator with the number of seeds that have been read.
        frame, with torus: all sets have the points within this distance of the edges in common,
        those of the first seed. So any of them fit side by side, as tiles. At least 1.5 times the
        greatest distance of two points, and under half of the domain's shorter side.

    Returns
    -------
    list of PointSet, or for an iterator an iterator of PointSet
        In the order of the seeds. The ``seconds`` of a set are the time of its batch, divided by
        the number of sets in it.

    Raises
    ------
    BadRequest, TypeError, MemoryRefused, Unavailable, DeviceError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> tiles = lacuna.sample_many(range(100), n=256, torus=True)
    >>> len(tiles), tiles[7].seed
    (100, 7)
    >>> bool((tiles[7].points == lacuna.sample(n=256, torus=True, seed=7).points).all())
    True
    >>> import itertools
    >>> for tile in lacuna.sample_many(itertools.count(), n=256, torus=True):
    ...     if tile.seed == 200:
    ...         break
    """
    for name in more:
        if name not in More.__annotations__:
            raise TypeError(f"sample_many() got an unexpected keyword argument {name!r}")
    kinds = classes_of(
        more.pop("classes", None), more.pop("between", "sum"), more.pop("priority", False)
    )
    progress = more.pop("progress", None)
    frame = more.pop("frame", None)
    width = None if frame is None else real("frame", frame)
    if isinstance(seeds, (str, bytes)) or not isinstance(seeds, Iterable):
        raise TypeError(f"seeds must be an iterable of int, not {shown(seeds)}")
    usual = {"backend": "auto", "threads": 0, "round_size": 0}
    if (pixels := more.get("on_pixels")) is not None:
        more.setdefault("domain", raster_in("on_pixels", pixels))
    asked = {**options(radius=radius, n=n, **{**usual, **more}), **kinds}
    asked["given"] = ["classes"] if kinds else []
    expected = None
    if isinstance(seeds, Sized):
        expected = _number_of(seeds)
        _refuse_more_sets(expected, asked.get("n", 1))
    else:
        _core.sample_many(asked, [], None, None)  # refuses the request now, not with the first set
    sets = _made(asked, seeds, expected, width, progress)
    return sets if isinstance(seeds, Iterator) else list(sets)


def _made(
    asked: dict[str, Any],
    seeds: Iterable[Whole],
    expected: int | None,
    width: float | None,
    progress: Progress | Literal[True] | None,
) -> Iterator[PointSet]:
    """Samples once for each seed.

    Seeds are read and sets are made a batch at a time. If ``expected`` is given, it is the number
    of seeds, and all sets are wanted. If it is None, the first batch is one set, and each further
    batch has twice as many, up to _MOST_POINTS_AHEAD points.
    """
    remaining = iter(seeds)
    frame = None
    done, size = 0, 1 if expected is None else _MOST_SETS_AHEAD
    with watched(progress) as told:

        def count_on(of_batch: int, in_batch: int) -> None:
            assert told is not None
            told(done + of_batch, done + in_batch if expected is None else expected)

        while batch := [whole("seeds", seed, 0, MOST_64) for seed in islice(remaining, size)]:
            started = time.perf_counter()
            if width is not None and frame is None:
                frame = _core.tile_ring(asked, batch[0], width)
            all_made = _core.sample_many(asked, batch, frame, count_on if told else None)
            total = time.perf_counter() - started
            for made in all_made:
                made["seconds"] = {"total": total / len(batch)}
                said = {} if width is None else {"frame": width, "kept": made["_promised"]["kept"]}
                yield PointSet(**set_attributes(made, **said))
            done += len(batch)
            points = sum(len(made["points"]) for made in all_made)
            if expected is None and 2 * points <= _MOST_POINTS_AHEAD:
                size = min(2 * size, _MOST_SETS_AHEAD)


def _number_of(seeds: Sized) -> int:
    try:
        return len(seeds)
    except OverflowError:  # a range that is longer than a list can be
        return sys.maxsize


def _refuse_more_sets(sets: int, points: int) -> None:
    """Refuses sets that together take more memory than the machine has."""
    needed = sets * (_BYTES_OF_A_SET + _BYTES_OF_A_POINT * points)
    available = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    if needed > available:
        raise MemoryRefused(
            "seeds",
            f"of {sets} sets",
            f"take at least {needed / 1e9:.3g} GB together, of {available / 1e9:.3g} GB; with "
            "iter(seeds) the sets come one at a time",
        )
