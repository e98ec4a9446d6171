"""Classes of points: their names, distances and weights."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, SupportsFloat

import numpy as np

from . import _core
from ._arguments import flag, mask_of, real, shown, whole
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt

    # A radius, or a radius and a weight, or these two and a number of points; a text such as
    # '1.5..3' for a radius is a range of sizes, and None that distances are given.
    Radius = float | str | None
    Size = Radius | tuple[Radius, float] | tuple[Radius, float, int | None]
    ClassSizes = Mapping[str, Size]
    Border = SupportsFloat | Mapping[str, SupportsFloat]
    Masks = npt.ArrayLike | Mapping[str | None, npt.ArrayLike]
    Bytes = npt.NDArray[np.uint8]


def classes_of(
    classes: ClassSizes | None, between: object, priority: object = False
) -> dict[str, Any]:
    """The classes among the options of a request; empty if there are none."""
    if classes is None:
        if flag("priority", priority):
            raise BadRequest("priority", "without classes", "is the order of classes")
        if not isinstance(between, str) or between != "sum":
            raise BadRequest("between", shown(between), "is for classes")
        return {}
    if not isinstance(classes, Mapping) or not classes:
        raise TypeError(
            f"classes must be a dict of names and radii, such as {{'trees': 0.05}}, not "
            f"{shown(classes)}"
        )
    by_priority = flag("priority", priority)
    sizes = [
        one for name, size in classes.items() for one in _sizes_of(name, size, between, by_priority)
    ]
    names = [name for name, _, _, _ in sizes]
    radii = [radius for _, radius, _, _ in sizes]
    if isinstance(between, str):
        if between not in ("sum", "union"):
            raise BadRequest("between", shown(between), "must be 'sum', 'union' or a matrix")
        if any(radius is None for radius in radii):
            raise BadRequest("classes", "", "each needs a radius unless between is a matrix")
        known = [radius for radius in radii if radius is not None]
        by_rule = _core.distances_by_sum if between == "sum" else _core.distances_by_union
        distances = by_rule(known)
    else:
        if any(radius is not None for radius in radii):
            raise BadRequest("classes", "", "need no radius, for between has all distances")
        distances = _matrix_of(between, len(radii))
    weights = [weight for _, _, weight, _ in sizes]
    counts = [count for _, _, _, count in sizes]
    own: dict[str, Any] = {"counts": counts} if any(count is not None for count in counts) else {}
    if by_priority:
        own["priority"] = True
    return {"class_names": names, "distances": distances, "weights": weights, **own}


def borders_of(
    border: Border, inside_by_radius: object, kinds: dict[str, Any]
) -> dict[str, Any]:
    """The options of these arguments: one border, or one for each class."""
    names = kinds.get("class_names", [])
    if flag("inside_by_radius", inside_by_radius):
        if isinstance(border, Mapping) or real("border", border) != 0:
            raise BadRequest("border", "with inside_by_radius", "both say how far to stay")
        return {"border": 0.0, "inside_by_radius": True}
    if not isinstance(border, Mapping):
        return {"border": real("border", border)}
    for name in border:
        if name not in names:
            raise BadRequest("border", shown(name), "must be the name of a class")
    return {"border": 0.0, "borders": [real("border", border.get(name, 0.0)) for name in names]}


def masks_of(mask: Masks | None, kinds: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Options with the mask of all points, and with those of classes that have their own. Then the
    option of the first one that is given, which decides the domain."""
    if not isinstance(mask, Mapping):
        of_all = {} if mask is None else {"mask": mask_of("mask", mask)}
        return of_all, of_all
    names = kinds.get("class_names", [])
    for name in mask:
        if name is not None and name not in names:
            raise BadRequest("mask", shown(name), "must be the name of a class")
    each = {name: mask_of("mask", one) for name, one in mask.items()}
    own = {"masks": [each.get(name) for name in names]} if each.keys() - {None} else {}
    first = {"mask": one for one in list(each.values())[:1]}
    return own | ({"mask": each[None]} if None in each else {}), first


def _sizes_of(
    name: object, size: Any, between: object, by_priority: bool
) -> list[tuple[str, float | None, float, int | None]]:
    """The name, radius, weight and number of points of each size of a class, which has one but for
    a range."""
    if not isinstance(name, str):
        raise TypeError(f"classes: a name must be a str, not {shown(name)}")
    if isinstance(size, tuple) and len(size) not in (2, 3):
        raise TypeError(
            f"classes {shown(name)}: must be a radius, (radius, weight) or (radius, weight, count), "
            f"not {shown(size)}"
        )
    radius, weight, count = (*size, None)[:3] if isinstance(size, tuple) else (size, 1.0, None)
    weight = real("classes", weight)
    number = None if count is None else whole("classes", count, 1, 2**63 - 1)
    if isinstance(radius, str):
        text = f"{name}:{radius}:{weight!r}" + ("" if number is None else f":{number}")
        rule = between if isinstance(between, str) else "sum"
        try:
            return list(_core.sizes_of_class(text, rule, by_priority))
        except BadRequest as error:
            raise error.called("classes") from None
    return [(name, None if radius is None else real("classes", radius), weight, number)]


def _matrix_of(between: Any, count: int) -> list[float]:
    try:
        matrix = np.array(between, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(
            f"between must be 'sum', 'union' or a matrix of numbers, not {shown(between)}"
        ) from None
    if matrix.shape != (count, count):
        raise BadRequest("between", f"of shape {matrix.shape}", f"must be {count} x {count}, as many as classes")
    return [float(distance) for distance in matrix.ravel()]


def _numbers(argument: str, given: Iterable[object], names: Sequence[str]) -> Bytes:
    """The places of classes among the names: ``given`` are names or places."""
    places = {name: place for place, name in enumerate(names) if names.count(name) == 1}
    numbers = []
    for one in given:
        place = places.get(one) if isinstance(one, str) else one
        if place is None and one in names:
            raise BadRequest(argument, shown(one), "has several sizes: give their places")
        if isinstance(place, (bool, float)) or place is None or not hasattr(place, "__index__"):
            raise BadRequest(argument, shown(one), f"must be one of {', '.join(names)}")
        number = place.__index__()
        if not 0 <= number < len(names):
            raise BadRequest(argument, shown(one), f"must be from 0 to {len(names) - 1}")
        numbers.append(number)
    return np.array(numbers, dtype=np.uint8)


def classes_of_points(
    argument: str,
    given: Iterable[object] | None,
    own: Iterable[object] | None,
    classes: dict[str, Any],
    points: npt.NDArray[np.float64] | None,
) -> Bytes | None:
    """The class of each point: as given, or else the points' own; None without both."""
    if given is None:
        given = own
    if given is None:
        return None
    if not classes or points is None:
        raise BadRequest(argument, "", "is for points with classes")
    return _numbers(argument, given, classes["class_names"])
