"""Classes of points: their names, distances and weights."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arguments import real, shown
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt

    # A radius, or a radius and a weight; None and a weight, or None, if distances are given.
    Size = float | tuple[float | None, float] | None
    ClassSizes = Mapping[str, Size]
    Bytes = npt.NDArray[np.uint8]


def classes_of(classes: ClassSizes | None, between: object) -> dict[str, Any]:
    """The classes among the options of a request; empty if there are none."""
    if classes is None:
        if not isinstance(between, str) or between != "sum":
            raise BadRequest(f"between {shown(between)}: is for classes", "between")
        return {}
    if not isinstance(classes, Mapping) or not classes:
        raise TypeError(
            f"classes must be a dict of names and radii, such as {{'trees': 0.05}}, not "
            f"{shown(classes)}"
        )
    sizes = [_size_of(name, size) for name, size in classes.items()]
    radii = [radius for radius, _ in sizes]
    if isinstance(between, str):
        if between not in ("sum", "union"):
            raise BadRequest(
                f"between {shown(between)}: must be 'sum', 'union' or a matrix", "between"
            )
        if any(radius is None for radius in radii):
            raise BadRequest("classes: each needs a radius unless between is a matrix", "classes")
        known = [radius for radius in radii if radius is not None]
        by_rule = _core.distances_by_sum if between == "sum" else _core.distances_by_union
        distances = by_rule(known)
    else:
        if any(radius is not None for radius in radii):
            raise BadRequest("classes: need no radius, for between has all distances", "classes")
        distances = _matrix_of(between, len(radii))
    weights = [weight for _, weight in sizes]
    return {"class_names": list(classes), "distances": distances, "weights": weights}


def _size_of(name: object, size: Any) -> tuple[float | None, float]:
    if not isinstance(name, str):
        raise TypeError(f"classes: a name must be a str, not {shown(name)}")
    radius, weight = size if isinstance(size, tuple) and len(size) == 2 else (size, 1.0)
    return None if radius is None else real("classes", radius), real("classes", weight)


def _matrix_of(between: Any, count: int) -> list[float]:
    try:
        matrix = np.array(between, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(
            f"between must be 'sum', 'union' or a matrix of numbers, not {shown(between)}"
        ) from None
    if matrix.shape != (count, count):
        raise BadRequest(
            f"between of shape {matrix.shape}: must be {count} x {count}, as many as classes",
            "between",
        )
    return [float(distance) for distance in matrix.ravel()]


def _numbers(argument: str, given: Iterable[object], names: Sequence[str]) -> Bytes:
    """The places of classes among the names: ``given`` are names or places."""
    places = {name: place for place, name in enumerate(names)}
    numbers = []
    for one in given:
        place = places.get(one) if isinstance(one, str) else one
        if isinstance(place, (bool, float)) or place is None or not hasattr(place, "__index__"):
            raise BadRequest(
                f"{argument} {shown(one)}: must be one of {', '.join(names)}", argument
            )
        number = place.__index__()
        if not 0 <= number < len(names):
            raise BadRequest(
                f"{argument} {shown(one)}: must be from 0 to {len(names) - 1}", argument
            )
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
        raise BadRequest(f"{argument}: is for points with classes", argument)
    return _numbers(argument, given, classes["class_names"])
