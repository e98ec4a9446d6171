"""verify: proves or refutes a set."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterable, SupportsFloat

import numpy as np

from . import _core, _plots
from ._arguments import ellipses_of, field_of, flag, mask_of, points_array, real, shown
from ._classes import class_numbers, classes_of
from ._domains import Polygons, around, lines_of, obstacles_on, sets_on
from ._errors import BadRequest
from ._judging import domain_of
from ._results import PointSet, Relaxed
from ._runs import shape_of

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._classes import ClassSizes
    from ._domains import Obstacles

    Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Verdict:
    """What ``verify`` has found. True if the claim holds.

    The limit of two points, or of a spot and a point, is the radius. With a field each spot has a
    radius of its own, and the limit is the smaller of the two radii.

    Attributes
    ----------
    holds : bool
        No two points are closer than their limit and, unless ``distances_only``, every spot has a
        point within their limit + tolerance.
    reason : str
        Why the claim does not hold; empty if it does. A PointSet of ``n``, ``limit`` or ``relax``
        has gaps, and is then named as one that is not meant to be maximal.
    maximal : bool
        The claim holds, gaps were looked for, and the tolerance is at most 1 % of the least radius.
    kept, covered : bool or None
        Whether distances are kept, and whether all spots are covered. ``covered`` is None with
        ``distances_only``. Both are None if there is an ``outside``, ``moved`` or ``forbidden``.
    outside : int or None
        The first point outside the domain: nothing else is then looked at.
    moved : int or None
        The first point of ``keep`` that is not in its place: nothing else is then looked at.
    forbidden, forbidden_by : int or None, str or None
        The first point that lies where no point may, and what forbids it: 'field', 'mask', 'inside'
        or 'border'. Nothing else is then looked at.
    closest_pair, least_distance : tuple of int or None, float
        The indices of the closest two points, and their distance: infinite for fewer than two
        points. With a field, the pair whose distance is smallest relative to its limit.
    least_limit : float or None
        The limit of these two points.
    largest_gap, largest_gap_distance : tuple of float or None, float or None
        The spot that is farthest from every point, and its distance from the nearest. With a field
        the spot farthest over its limit, and its distance from the point that covers it best.
    largest_gap_limit : float or None
        The limit of that spot and that point.
    largest_gap_class : str or None
        With classes: the class of which a point has most room there.
    emptiest_spot, emptiest_distance, emptiest_limit
        Deprecated names of ``largest_gap``, ``largest_gap_distance`` and ``largest_gap_limit``.
    radius, tolerance : float
        As claimed; with a field radius is the least of all radii.
    scale : float or None
        With a field the radius where importance is 1, as claimed.
    points, domain : ndarray, shape (N, 2); tuple of float
        The set that was looked at, and its width and height.
    """

    holds: bool
    maximal: bool
    kept: bool | None
    covered: bool | None
    outside: int | None
    moved: int | None
    forbidden: int | None
    forbidden_by: str | None
    closest_pair: tuple[int, int] | None
    least_distance: float
    least_limit: float | None
    largest_gap: tuple[float, float] | None
    largest_gap_distance: float | None
    largest_gap_limit: float | None
    radius: float
    tolerance: float
    scale: float | None
    points: Floats = field(repr=False)
    domain: tuple[float, float] = field(repr=False)
    largest_gap_class: str | None = field(default=None, kw_only=True)
    reason: str = field(default="", kw_only=True)

    # Deprecated names, for programs that were written for them.
    emptiest_spot = property(lambda self: self.largest_gap)
    emptiest_distance = property(lambda self: self.largest_gap_distance)
    emptiest_limit = property(lambda self: self.largest_gap_limit)

    def __bool__(self) -> bool:
        return self.holds

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the points, the closest pair and the largest gap with matplotlib. Whatever refutes
        the claim is red. Arguments and errors are as of ``PointSet.plot``."""
        return _plots.verdict(ax, self)


def _reason(found: dict[str, Any], gaps_known: bool, points: object, count: int) -> str:
    """Why a claim does not hold, or nothing."""
    if found["outside"] is not None:
        return f"point {found['outside']} lies outside of the domain"
    if found["moved"] is not None:
        return f"point {found['moved']} is not the point of keep"
    if found["forbidden"] is not None:
        return f"point {found['forbidden']} lies where {found['forbidden_by']} allows none"
    if not found["kept"]:
        return (
            f"points {found['first']} and {found['second']} are {found['least_distance']:.6g} "
            f"apart, less than their limit {found['least_limit']:.6g}"
        )
    if not gaps_known or found["covered"]:
        return ""
    if not count:
        return "there is no point"
    spot, limit = found["largest_gap"], found["largest_gap_limit"]
    gap = (
        f"the spot ({spot[0]:.6g}, {spot[1]:.6g}) is {found['largest_gap_distance']:.6g} from the "
        f"nearest point, more than its limit {limit:.6g}"
    )
    if isinstance(points, PointSet) and not points.maximal:
        gap += (
            "; this set is not meant to be maximal, because of n, limit or relax: "
            "distances_only=True does not look for gaps"
        )
    return gap


def _claimed(
    points: object, radius: SupportsFloat | None, scale: SupportsFloat | None, has_field: bool
) -> float:
    """The radius, or with a field the scale: as given, or else the PointSet's own."""
    if not has_field:
        if scale is not None:
            raise BadRequest(f"scale {shown(scale)}: is for a field", "scale")
        if radius is None:
            if not isinstance(points, PointSet):
                raise BadRequest("radius missing: give the least distance to be proven", "radius")
            radius = points.radius
        return real("radius", radius)
    if radius is not None:
        raise BadRequest(f"radius {shown(radius)}: with a field give scale", "radius")
    if scale is None and isinstance(points, PointSet):
        scale = points.scale
    if scale is None:
        raise BadRequest("scale missing: give the radius where importance is 1", "scale")
    return real("scale", scale)


def _classes(
    points: object,
    classes: ClassSizes | None,
    between: object,
    class_of: Iterable[object] | None,
    count: int,
) -> tuple[_core.Classes, npt.NDArray[np.uint8] | None]:
    """The classes claimed, and that of each point: as given, or else the PointSet's own."""
    made = classes_of(classes, between)
    own = points if isinstance(points, PointSet) and points.class_of is not None else None
    if not made.names and own is not None and own.distances is not None:
        made.names = list(own.classes)
        made.distances = [float(distance) for distance in own.distances.ravel()]
        made.weights = list(own._request["weights"])
    if not made.names:
        if class_of is not None:
            raise BadRequest("class_of: is for classes", "class_of")
        return made, None
    if class_of is None and own is not None:
        return made, own.class_of
    if class_of is None:
        raise BadRequest("class_of missing: give the class of each point", "class_of")
    return made, class_numbers("class_of", class_of, made.names, count)


def _read_only(array: Floats) -> Floats:
    view = array.view()
    view.flags.writeable = False
    return view


def _shape(
    pixels: _core.Field | _core.Mask | None, *places: tuple[str, object]
) -> tuple[float, float]:
    """The domain if neither the caller nor a PointSet gives it."""
    if pixels is not None:
        return shape_of(pixels)
    return around(*places)


def verify(
    points: npt.ArrayLike,
    radius: SupportsFloat | None = None,
    *,
    field: npt.ArrayLike | None = None,
    ellipses: npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    mask: npt.ArrayLike | None = None,
    inside: Polygons | Iterable[npt.ArrayLike] | Iterable[Polygons] | None = None,
    outside: Polygons | Iterable[npt.ArrayLike] | Iterable[Polygons] | None = None,
    avoid: Obstacles | None = None,
    edge: SupportsFloat = 0,
    border: SupportsFloat | None = None,
    keep: npt.ArrayLike | None = None,
    classes: ClassSizes | None = None,
    between: str | npt.ArrayLike = "sum",
    class_of: Iterable[object] | None = None,
    domain: tuple[SupportsFloat, SupportsFloat] | None = None,
    torus: bool | None = None,
    tolerance: SupportsFloat | None = None,
    distances_only: bool = False,
) -> Verdict:
    """Prove or refute that points are a maximal Poisson-disk set, from their coordinates alone.

    Parameters
    ----------
    points : PointSet or array_like, shape (N, 2)
        The points, made by any program.
    radius : float, optional
        Least distance between two points. By default a PointSet's own. Not with a field.
    field : array_like, shape (rows, columns), optional
        Importance, as of ``sample``: each spot has its pixel's radius, and the limit of two points,
        or of a spot and a point, is the smaller of their radii. A point within 2^-28 of the longer
        side of a border of pixels may have the radius of either pixel.
    ellipses : array_like, shape (rows, columns, 3), optional
        The ellipses, as of ``sample``. The limit of two points is the smaller radius of both
        ellipses along the way between them.
    scale : float, optional
        With a field the radius where importance is 1. By default a PointSet's own. With ellipses a
        factor of all radii, by default a PointSet's own, else 1.
    mask : array_like, shape (rows, columns), optional
        Where points may lie, as of ``sample``. Spots where no point may lie need not be covered.
    inside, outside : Polygons, iterable of array_like, or list of Polygons, optional
        Polygons in which points must lie, and must not lie, as of ``draw_mask``. They are used as
        they are, not drawn onto a mask.
    avoid : list of (Polygons or iterable of array_like, float), optional
        Obstacles and the distance that points keep from them, as of ``draw_mask``.
    edge : float
        Spots that are inside of the polygons by up to ``edge`` need not be covered. No point may
        lie outside.
    border : float
        No point may be closer to the domain's edges, nor to the outlines of ``inside`` and
        ``outside``. By default a PointSet's own, else 0.
    keep : array_like, shape (N, 2), optional
        The first of the points must be equal to these, to the last bit. By default those that a
        PointSet has kept.
    classes, between
        As of ``sample``: each two classes have a least distance, and no spot may be left where a
        point of any class with a weight has room. By default a PointSet's own.
    class_of : iterable of str or int, optional
        The class of each point: its name, or its place in ``classes``. By default a PointSet's own.
    domain : tuple of float, optional
        Width and height. By default a PointSet's own, else the shape of the field or of the mask,
        its longer side 1, else ``domain_around`` the polygons and obstacles.
    torus : bool, optional
        Whether the edges wrap. By default as in the PointSet, else False.
    tolerance : float, optional
        How far over the limit a gap may be. By default 2^-28 of the longer side; twice that with a
        field, mask, polygons or border.
    distances_only : bool
        Do not look for gaps, which takes most of the time.

    Returns
    -------
    Verdict
        True if the claim holds; with the closest pair and the largest gap.

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
    >>> "not meant to be maximal" in lacuna.verify(lacuna.sample(n=100, seed=1)).reason
    True

    A set that follows a field, in a part of the domain:

    >>> import numpy as np
    >>> ramp = np.linspace(0, 1, 64) * np.ones((64, 1))
    >>> disk = np.hypot(*np.mgrid[-1:1:64j, -1:1:64j]) < 0.9
    >>> dense = lacuna.sample(field=ramp, scale=0.02, mask=disk, seed=1)
    >>> lacuna.verify(dense, field=ramp, mask=disk).maximal
    True
    """
    claim = _core.Claim()
    array = points_array("points", points)
    claim.classes, of_points = _classes(points, classes, between, class_of, len(array))
    if claim.classes.names and radius is None and scale is None:
        distances = [distance for distance in claim.classes.distances if distance > 0]
        claimed = min(distances, default=0.0)
    else:
        if ellipses is not None and scale is None and not isinstance(points, PointSet):
            scale = 1
        claimed = _claimed(points, radius, scale, field is not None or ellipses is not None)
    if field is not None and ellipses is not None:
        raise BadRequest("ellipses: cannot be used with field", "ellipses")
    if field is None and ellipses is None:
        claim.radius = claimed
    else:
        claim.scale = claimed
    importance = None if field is None else field_of("field", field)
    if ellipses is not None:
        importance = ellipses_of("ellipses", ellipses)
    allowed = None if mask is None else mask_of("mask", mask)
    own = points._request if isinstance(points, PointSet) else {}
    if not flag("distances_only", distances_only):
        has_polygons = inside is not None or outside is not None or avoid is not None
        for name, is_given in (
            ("field", importance is not None),
            ("ellipses", importance is not None),
            ("mask", mask is not None or has_polygons),
        ):
            if name in own and not is_given:
                raise BadRequest(f"{name} missing: the set was made with one: give it too", name)
    claim.border = real("border", own.get("border", 0) if border is None else border)
    claim.edge = real("edge", edge)
    shape = (1.0, 1.0)
    if domain is None and not isinstance(points, (PointSet, Relaxed)):
        obstacles = [("avoid", lines) for lines in lines_of(avoid)]
        shape = _shape(
            importance or allowed, ("inside", inside), ("outside", outside), *obstacles
        )
    claim.width, claim.height, claim.torus = domain_of(points, domain, torus, shape)
    claim.distances_only = flag("distances_only", distances_only)
    if tolerance is not None:
        claim.tolerance = real("tolerance", tolerance)
    size = (claim.width, claim.height)
    sets = sets_on("inside", inside, size, distance=claim.border)
    sets += sets_on("outside", outside, size, forbidden=True, distance=claim.border)
    sets += obstacles_on(avoid, size, claim.torus)
    kept = array[: own["kept"]] if keep is None and "kept" in own else None
    if keep is not None:
        kept = points_array("keep", keep)
    found = _core.verify(array, claim, importance, allowed, sets, kept, of_points)
    in_place = all(found[name] is None for name in ("outside", "moved", "forbidden"))
    pair_known = in_place and len(array) > 1
    gaps_known = in_place and not claim.distances_only
    spot_known = gaps_known and len(array) > 0
    return Verdict(
        holds=in_place and found["kept"] and (not gaps_known or found["covered"]),
        reason=_reason(found, gaps_known, points, len(array)),
        maximal=found["maximal"],
        kept=found["kept"] if in_place else None,
        covered=found["covered"] if gaps_known else None,
        outside=found["outside"],
        moved=found["moved"],
        forbidden=found["forbidden"],
        forbidden_by=found["forbidden_by"],
        closest_pair=(found["first"], found["second"]) if pair_known else None,
        least_distance=found["least_distance"] if pair_known else np.inf,
        least_limit=found["least_limit"] if pair_known else None,
        largest_gap=found["largest_gap"] if spot_known else None,
        largest_gap_distance=found["largest_gap_distance"] if spot_known else None,
        largest_gap_limit=found["largest_gap_limit"] if spot_known else None,
        largest_gap_class=(
            claim.classes.names[found["largest_gap_class"]]
            if spot_known and claim.classes.names
            else None
        ),
        radius=claimed if importance is None else claimed / float(importance.values.max()) ** 0.5,
        tolerance=found["tolerance"],
        scale=None if importance is None else claimed,
        points=_read_only(array),
        domain=(claim.width, claim.height),
    )
