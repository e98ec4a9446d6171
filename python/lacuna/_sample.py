"""sample: makes a point set."""

from __future__ import annotations

from typing import TYPE_CHECKING, Iterable, SupportsFloat

from . import _core
from ._arguments import (
    choice,
    ellipses_of,
    field_of,
    flag,
    mask_of,
    pair,
    points_array,
    real,
    shown,
    whole,
)
from ._classes import class_numbers, classes_of
from ._errors import BadRequest
from ._results import PointSet
from ._runs import (
    MODES,
    MOST_32,
    fill,
    make,
    place,
    refuse_what_is_for_fields,
    set_size,
    settle,
    shape_of,
)

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Metric, Mode, Seed, Whole
    from ._classes import ClassSizes
    from ._runs import Progress


def sample(
    radius: SupportsFloat | None = None,
    n: Whole | None = None,
    *,
    field: npt.ArrayLike | None = None,
    ellipses: npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    metric: Metric | None = None,
    mask: npt.ArrayLike | None = None,
    border: SupportsFloat = 0,
    keep: npt.ArrayLike | None = None,
    classes: ClassSizes | None = None,
    between: str | npt.ArrayLike = "sum",
    keep_classes: Iterable[object] | None = None,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
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
    progress: Progress | None = None,
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
    border : float
        Least distance of points to the domain's edges, in the unit of ``domain``; not on a torus.
    keep : array_like, shape (N, 2), optional
        Points that are there already. They come first, unmoved, and new points keep their distance
        from them. Each must lie where points may lie, and keep its distance from the others. They
        count for ``n`` and ``limit``.
    classes : dict of str to float, optional
        Points of several kinds: the radius of each by its name, or a radius and a weight, which
        says how often the class is drawn. Then give no ``radius`` or ``scale``; with ``n`` the
        radii are in proportion. With a field they are those where the importance is 1. At most 16.
    between : {'sum', 'union'} or array_like, shape (K, K)
        The least distance of two classes. 'sum': the sum of their radii, as of objects that do not
        overlap. 'union': each class alone is a set of its radius, and all together are evenly
        distributed. Or a symmetric matrix; the radii in ``classes`` are then None.
    keep_classes : iterable of str or int, optional
        With classes, of each point of ``keep``: the name of its class, or its place in ``classes``.
        By default those of ``keep``, if it is a PointSet with classes.
    domain : tuple of float, optional
        Width and height. By default the shape of the field or else of the mask, with a longer side
        of 1; without both (1, 1).
    torus : bool
        Whether the edges wrap.
    mode : {'exact', 'lines', 'cells', 'stratified'}, optional
        'exact', the default, leaves no gap; 'lines' is the approximation of Kalantari & Sen 2011;
        'cells', for a field, puts points on a lattice, as they do. Mask, border and keep need
        'exact'. 'stratified' is a start for ``relax``: every part of the domain has its share of
        the points. It is the default with ``relax`` and ``n``, unless ``metric``, ``limit``,
        ``lines_per_radius`` or ``round_size`` is given.
    seed : None, int or numpy.random.Generator
        An int from 0 to 2^64 - 1 is the same as --seed of the command. A generator gives 64 random
        bits; for None the system gives them. The result holds the seed.
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
    progress : callable, optional
        Called with the number of points so far and the number expected, at most 50 times a second,
        on the calling thread. An exception that it raises ends the run. While relaxing it is called
        with points times iterations and steps.

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

    A sequence that may be cut anywhere:

    >>> sequence = lacuna.sample(n=4096, torus=True, progressive=True, seed=1)
    >>> again = lacuna.sample(n=1000, torus=True, progressive=True, seed=1)
    >>> bool((sequence.points[:1000] == again.points).all())
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

    A maximal set that follows the same field, in a disk, with a point that is there already:

    >>> y, x = np.mgrid[-1:1:64j, -1:1:64j]
    >>> disk = np.hypot(x, y) < 0.9
    >>> made = lacuna.sample(field=ramp, scale=0.02, mask=disk, keep=[(0.5, 0.5)], seed=1)
    >>> made.maximal, made.points[0].tolist()
    (True, [0.5, 0.5])
    """
    request = _core.Request()
    if field is not None and ellipses is not None:
        raise BadRequest("ellipses: cannot be used with field", "ellipses")
    importance = None if field is None else field_of("field", field)
    if ellipses is not None:
        importance = ellipses_of("ellipses", ellipses)
    request.border = real("border", border)
    if mode is not None:
        choice("mode", mode, (*MODES, "stratified"))
    allowed = None if mask is None else mask_of("mask", mask)
    kept = None if keep is None else points_array("keep", keep)
    iterations = whole("relax", relax, 0, MOST_32)
    request.classes = classes_of(classes, between)
    of_kept = None
    if keep_classes is None and request.classes.names and isinstance(keep, PointSet):
        keep_classes = keep._class_names_of_points
    if keep_classes is not None:
        if not request.classes.names or kept is None:
            raise BadRequest("keep_classes: is for keep with classes", "keep_classes")
        of_kept = class_numbers("keep_classes", keep_classes, request.classes.names, len(kept))
    moves = _core.Moves()
    moves.iterations = iterations
    moves.gaussian = whole("gaussian", gaussian, 0, MOST_32)
    if gaussian_distance is not None:
        moves.gaussian_distance = real("gaussian_distance", gaussian_distance)
    if importance is None:
        refuse_what_is_for_fields(mode, scale, metric)
        set_size(request, {"radius": radius, "n": n}, bool(request.classes.names))
        sides = (1.0, 1.0) if allowed is None else shape_of(allowed)
    else:
        if radius is not None:
            raise BadRequest(f"radius {shown(radius)}: with a field give scale or n", "radius")
        if ellipses is not None and scale is None and n is None:
            scale = 1
        set_size(request, {"scale": scale, "n": n}, bool(request.classes.names))
        sides = shape_of(importance)
    if domain is not None:
        sides = pair("domain", domain)
    place(request, sides, torus, backend, device, threads)
    fill(
        request,
        seed=seed,
        limit=limit,
        lines_per_radius=lines_per_radius,
        round_size=round_size,
        memory_limit=memory_limit,
    )
    request.progressive = flag("progressive", progressive)
    has_ellipses = ellipses is not None
    settle(
        request,
        mode=mode,
        metric=metric,
        relax=iterations,
        gaussian=moves.gaussian,
        ellipses=has_ellipses,
    )
    request.snap = flag("snap", snap)
    request.uniform_x = flag("uniform_x", uniform_x)
    return PointSet(**make(request, importance, moves, progress, allowed, kept, of_kept))
