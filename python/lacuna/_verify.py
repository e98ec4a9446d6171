"""verify: proves or refutes a set."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterable, Mapping, SupportsFloat

import numpy as np

from . import _core, _plots
from ._arguments import flag, importance_of, options, points_array, shown
from ._classes import borders_of, classes_of, classes_of_points, masks_of
from ._errors import BadRequest
from ._polygons import places_of
from ._sets import HasPoints, PointSet, domain_of

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._arguments import Domain, Extent
    from ._classes import Border, ClassSizes, Masks
    from ._polygons import Obstacles, PlacesOfClasses

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
        Why the claim does not hold; empty if it does. A PointSet of ``n``, ``limit``, ``relax``
        or another mode than 'exact' has gaps, and is then named as not meant to be maximal.
    maximal : bool
        The claim holds, gaps were looked for, and the tolerance is at most 1 % of the least radius.
    kept, covered : bool or None
        Whether distances are kept, and whether all spots are covered. ``covered`` is None with
        ``distances_only``. Both are None if there is an ``outside``, ``moved``, ``miscounted`` or
        ``forbidden``.
    outside : int or None
        The first point outside the domain: nothing else is then looked at.
    moved : int or None
        The first point of ``keep`` that is not in its place: nothing else is then looked at.
    miscounted : str or None
        The first class that has another number of points than asked for: nothing else is then
        looked at.
    forbidden, forbidden_by : int or None, str or None
        The first point that lies where no point may, and what forbids it: 'field', 'mask', 'inside'
        or 'border'. Nothing else is then looked at.
    closest_pair, least_distance : tuple of int or None, float
        The indices of the closest two points, and their distance: infinite for fewer than two
        points. A point of ``keep`` outside of the domain has the index ``len(points)`` plus its
        place in ``keep``. With a field, the pair whose distance is smallest relative to its limit.
    least_limit : float or None
        The limit of these two points.
    largest_gap, largest_gap_distance : tuple of float or None, float or None
        The spot that is farthest from every point, and its distance from the nearest. With a field
        the spot farthest over its limit, and its distance from the point that covers it best.
    largest_gap_limit : float or None
        The limit of that spot and that point.
    largest_gap_class : str or None
        With classes: the class of which a point has most room there.
    radius, tolerance : float
        As claimed; with a field radius is the least of all radii.
    scale : float or None
        With a field the radius where importance is 1, as claimed.
    points, keep, domain : ndarray, shape (N, 2); ndarray, shape (K, 2); tuple of float
        The set that was looked at, the points to keep, and its width and height.
    """

    holds: bool
    maximal: bool
    kept: bool | None
    covered: bool | None
    outside: int | None
    moved: int | None
    miscounted: str | None
    forbidden: int | None
    forbidden_by: str | None
    closest_pair: tuple[int, int] | None
    least_distance: float
    least_limit: float | None
    largest_gap: tuple[float, float] | None
    largest_gap_distance: float | None
    largest_gap_limit: float | None
    largest_gap_class: str | None
    radius: float
    tolerance: float
    scale: float | None
    points: Floats = field(repr=False)
    keep: Floats = field(repr=False)
    domain: Extent = field(repr=False)
    reason: str

    def __bool__(self) -> bool:
        return self.holds

    def __str__(self) -> str:
        if not self.holds:
            return f"refuted: {self.reason}"
        kind = "a maximal set" if self.maximal else "a set without gaps over the tolerance"
        found = "" if self.closest_pair is None else (
            f"; the closest two are {self.least_distance:.6g} apart"
        )
        if self.covered is None:
            kind = "far enough apart"
        if self.largest_gap_distance is not None:
            found += f"; the largest gap is {self.largest_gap_distance:.6g} from the nearest point"
        return f"{len(self.points)} points are {kind}{found}"

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the points, the closest pair and the largest gap with matplotlib. Whatever refutes
        the claim is red. Arguments and errors are as of ``PointSet.plot``."""
        wrong = [one for one in (self.outside, self.moved, self.forbidden) if one is not None]
        pair = gap = None
        if self.closest_pair is not None:
            both = np.vstack([self.points, self.keep])[list(self.closest_pair)]
            pair = (both, bool(self.kept))
        if self.largest_gap is not None and self.largest_gap_distance is not None:
            gap = (self.largest_gap, self.largest_gap_distance, bool(self.covered))
        return _plots.verdict(ax, self.points, self.domain, wrong, pair, gap)


def _reason(found: dict[str, Any], count: int, is_meant_to_be_maximal: bool) -> str:
    """Why a claim does not hold, or nothing."""
    if found["outside"] is not None:
        return f"point {found['outside']} lies outside of the domain"
    if found["moved"] is not None:
        return f"point {found['moved']} is not the point of keep"
    if found["miscounted"] is not None:
        return f"class {found['miscounted']} has another number of points than asked for"
    if found["forbidden"] is not None:
        return f"point {found['forbidden']} lies where {found['forbidden_by']} allows none"
    if not found["kept"]:
        first, second = (
            f"{one}" if one < count else f"{one - count} of keep" for one in found["closest_pair"]
        )
        return (
            f"points {first} and {second} are {found['least_distance']:.6g} "
            f"apart, less than their limit {found['least_limit']:.6g}"
        )
    if found["holds"]:
        return ""
    if found["largest_gap"] is None:
        return "there is no point"
    x, y = found["largest_gap"]
    gap = (
        f"the spot ({x:.6g}, {y:.6g}) is {found['largest_gap_distance']:.6g} from the "
        f"nearest point, more than its limit {found['largest_gap_limit']:.6g}"
    )
    return gap if is_meant_to_be_maximal else gap + (
        "; this set is not meant to be maximal, because of n, limit, relax or mode: "
        "distances_only=True does not look for gaps"
    )


def _size(
    own: Mapping[str, Any],
    radius: SupportsFloat | None,
    scale: SupportsFloat | None,
    has_field: bool,
    has_ellipses: bool,
) -> dict[str, SupportsFloat | None]:
    """The radius, or with a field or ellipses the scale: as given, or else the PointSet's own."""
    name, other, given, wrong = "radius", "scale", radius, scale
    if has_field or has_ellipses:
        name, other, given, wrong = "scale", "radius", scale, radius
    if wrong is not None:
        reason = "is for a field" if other == "scale" else "with a field give scale"
        raise BadRequest(other, shown(wrong), reason)
    given = (own.get(name) or None) if given is None else given
    if given is None and has_ellipses:
        given = 1
    if given is None:
        what = "the radius where importance is 1"
        what = what if name == "scale" else "the least distance to be proven"
        raise BadRequest(name, "missing", f"give {what}")
    return {name: given}


def verify(
    points: npt.ArrayLike,
    radius: SupportsFloat | None = None,
    *,
    field: npt.ArrayLike | None = None,
    ellipses: npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    mask: Masks | None = None,
    inside: PlacesOfClasses = None,
    outside: PlacesOfClasses = None,
    avoid: Obstacles | None = None,
    near: Obstacles | None = None,
    edge: SupportsFloat | None = None,
    border: Border | None = None,
    inside_by_radius: bool | None = None,
    keep: npt.ArrayLike | None = None,
    keep_classes: Iterable[object] | None = None,
    classes: ClassSizes | None = None,
    between: str | npt.ArrayLike = "sum",
    priority: bool | None = None,
    class_of: Iterable[object] | None = None,
    domain: Domain | None = None,
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
        Where points may lie, as of ``sample``, also of classes. Spots where no point may lie need not be covered.
    inside, outside : Polygons, iterable of array_like, or list of Polygons, optional
        Polygons in which points must lie, and must not lie, as of ``draw_mask``. They are used as
        they are, not drawn onto a mask.
    avoid : list of (Polygons or iterable of array_like, float), optional
        Obstacles and the distance that points keep from them, as of ``draw_mask``.
    near : list of (Polygons or iterable of array_like, float), optional
        What points lie near to, and how near, as of ``sample``.
    edge : float, optional
        Spots that are inside of the polygons by up to ``edge`` need not be covered. No point may
        lie outside. By default that of the PointSet, else a sixteenth of the least radius.
    border, inside_by_radius
        As of ``sample``: no point may be closer to the domain's edges, nor to the outlines of
        ``inside`` and ``outside``. By default a PointSet's own.
    keep : array_like, shape (N, 2), optional
        The first of the points must be equal to these, to the last bit. Those outside of the domain
        are no points of the set, but distances to them are checked, and they cover spots. By
        default those that a PointSet has kept.
    keep_classes : iterable of str or int, optional
        As of ``sample``; needed for points of ``keep`` outside of the domain.
    classes, between
        As of ``sample``: each two classes have a least distance, and no spot may be left where a
        point of any class with a weight has room. By default a PointSet's own.
    priority : bool, optional
        Whether there is no room for a point of a class beside those of the classes before it, its
        own and those kept. By default as the PointSet was made.
    class_of : iterable of str or int, optional
        The class of each point: its name, or its place in ``classes``. By default a PointSet's own.
    domain : tuple of float, optional
        (width, height) or (x0, y0, x1, y1). By default a PointSet's own, else the shape of the
        field or of the mask, its longer side 1, else ``domain_around`` the polygons and obstacles.
    torus : bool, optional
        Whether the edges wrap. By default as in the PointSet, else False.
    tolerance : float, optional
        How far over the limit a gap may be. By default 2^-28 of the longer side; twice that with a
        field, mask, polygons, border or kept points; and with classes twice that or more, see
        docs/exact.md.
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
    own: Mapping[str, Any] = points._promised if isinstance(points, PointSet) else {}
    array = points_array("points", points)
    importance = importance_of(field, ellipses)
    kinds = classes_of(classes, between)
    of_points: Iterable[object] | None = None
    if isinstance(points, PointSet) and points.distances is not None:
        of_points = points._names_of_points(kinds) if kinds else points.class_of
        kinds = kinds or {
            "class_names": list(points.classes),
            "distances": points.distances.ravel().tolist(),
            "weights": own["weights"],
            "counts": own["counts"],
        }
    if own.get("priority") if priority is None else flag("priority", priority):
        kinds = kinds | {"priority": True}
    masks, first_mask = masks_of(mask, kinds)
    if kinds and radius is None and scale is None:
        least = min((one for one in kinds["distances"] if one > 0), default=0.0)
        size = {"radius" if importance is None else "scale": least}
    else:
        size = _size(own, radius, scale, field is not None, ellipses is not None)
    if border is None and inside_by_radius is None:
        promised = ("border", "inside_by_radius", *(["borders"] if kinds else []))
        borders = {name: own[name] for name in promised if own.get(name)}
    else:
        borders = borders_of(0 if border is None else border, bool(inside_by_radius), kinds)
    if borders.get("inside_by_radius") and (importance is not None or masks):
        raise BadRequest("inside_by_radius", "with a field, ellipses or a mask", "is for disks and outlines")
    places = places_of(inside, outside, avoid, near)
    if not flag("distances_only", distances_only):
        for name, is_given in (
            ("ellipses" if own.get("has_ellipses") else "field", importance is not None),
            ("mask", bool(masks) or bool(places)),
        ):
            if own.get(f"has_{name}") and not is_given:
                raise BadRequest(name, "missing", "the set was made with one: give it too")
    shape = None
    if domain is None and not isinstance(points, HasPoints):
        shape = _core.domain_around(places, first_mask, importance)
    asked = options(
        **domain_of(points, domain, torus, shape),
        **size,
        edge=(own.get("edge") or None) if edge is None else edge,
        tolerance=tolerance,
        distances_only=distances_only,
    )
    asked.update(kinds | borders | masks)
    kept, of_kept = np.empty((0, 2)), None
    if keep is not None:
        kept = points_array("keep", keep)
        names = keep._names_of_points(kinds) if isinstance(keep, PointSet) and kinds else None
        of_kept = classes_of_points("keep_classes", keep_classes, names, kinds, kept)
    elif own:
        kept = np.vstack([array[: own["kept"]], own["neighbours"]])
        if isinstance(points, PointSet) and points.class_of is not None:
            of_kept = np.concatenate([points.class_of[: own["kept"]], own["of_neighbours"]])
    if kinds and class_of is None and of_points is None:
        raise BadRequest("class_of", "missing", "give the class of each point")
    numbers = classes_of_points("class_of", class_of, of_points, kinds, array)
    found = _core.verify(array, asked, importance, places, kept, of_kept, numbers)
    shown_points = array.view()
    shown_points.flags.writeable = False
    return Verdict(
        reason=_reason(found, len(array), not own.get("distances_only")),
        points=shown_points,
        keep=kept,
        domain=asked["domain"],
        **found,
    )
