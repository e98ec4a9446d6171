"""Requests, runs and results that sample, stipple and relax have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, SupportsFloat

from . import _core
from ._arguments import choice, device_text, flag, real, seed_of, shown, text, whole
from ._classes import attributes_of
from ._errors import BadRequest
from ._results import Evenness, Relaxed

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._arguments import Seed, Whole

    Progress = Callable[[int, int], object]

METRICS = ("min", "mean", "max")
MODES = ("exact", "lines", "cells")
MOST_32 = 2**32 - 1
MOST_64 = 2**64 - 1


def checked_progress(progress: object) -> None:
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, not {shown(progress)}")


def shape_of(field: _core.Field | _core.Mask) -> tuple[float, float]:
    """The domain of a picture: its shape with a longer side of 1."""
    longer = max(field.columns, field.rows)
    return field.columns / longer, field.rows / longer


def place(
    options: _core.Request | _core.RelaxOptions,
    domain: tuple[float, float],
    torus: object,
    backend: object,
    device: object,
    threads: Whole,
) -> None:
    """Fills in the options that all runs have in common."""
    options.width, options.height = domain
    options.torus = flag("torus", torus)
    options.backend = text("backend", backend)
    options.device = device_text(device)
    options.threads = whole("threads", threads, 0, MOST_32)


def fill(
    request: _core.Request,
    *,
    seed: Seed,
    limit: Whole | None,
    lines_per_radius: Whole | None,
    round_size: Whole,
    memory_limit: Whole | None,
) -> None:
    """Fills in the options of both sample and stipple."""
    request.seed = seed_of(seed)
    if limit is not None:
        request.limit = whole("limit", limit, 1, MOST_64)
    if lines_per_radius is not None:
        request.lines_per_radius = whole("lines_per_radius", lines_per_radius, 1, 1000)
    request.round_size = whole("round_size", round_size, 0, MOST_64)
    if memory_limit is not None:
        request.memory_limit = whole("memory_limit", memory_limit, 1, MOST_64)


def settle(
    request: _core.Request,
    *,
    mode: str | None,
    metric: object,
    relax: Whole | None,
    gaussian: int = 0,
    ellipses: bool = False,
) -> int:
    """Fills in the mode and the metric, by the library's rules. Comes after ``fill`` and
    ``set_size``. Returns how often the points are relaxed."""
    return _core.settle(
        request,
        mode,
        None if metric is None else choice("metric", metric, METRICS),
        None if relax is None else whole("relax", relax, 0, MOST_32),
        gaussian,
        ellipses,
    )


def set_size(
    request: _core.Request, sizes: dict[str, Any], has_classes: bool = False
) -> None:
    """Fills in the one of ``sizes`` that is given: radius, scale or n. Exactly one must be; with
    classes none or n, for these have radii."""
    given = {name: value for name, value in sizes.items() if value is not None}
    if has_classes and not given:
        return
    if has_classes and (size := next((name for name in given if name != "n"), None)):
        raise BadRequest(f"{size} {shown(given[size])}: is not for classes, which have radii", size)
    if len(given) != 1:
        allowed = " or ".join(sizes)
        if not given:
            raise BadRequest(f"{next(iter(sizes))} missing: give {allowed}", next(iter(sizes)))
        raise BadRequest(f"{' and '.join(given)}: give one of {allowed}", next(iter(given)))
    name, value = next(iter(given.items()))
    if name == "n":
        request.count = whole("n", value, 1, MOST_64)
    else:
        setattr(request, name, real(name, value))


def refuse_what_is_for_fields(mode: object, scale: object, metric: object) -> None:
    for name, value in (("scale", scale), ("metric", metric)):
        if value is not None:
            raise BadRequest(f"{name} {shown(value)}: is for a field", name)
    if mode == "cells":
        raise BadRequest("field missing: mode cells needs one", "field")


def moved(
    made: dict[str, Any],
    request: _core.Request | _core.RelaxOptions,
    iterations: int,
    gaussian: int = 0,
) -> Relaxed | None:
    """How the points of a set were moved; None if they were not."""
    moves = made.pop("relaxed")
    if moves is None:
        return None
    evenness = moves.pop("evenness")
    moves.update(points=made["points"], seconds=made["seconds"])
    return Relaxed(
        domain=(request.width, request.height),
        torus=request.torus,
        iterations=iterations,
        gaussian=gaussian,
        evenness=None if evenness is None else Evenness(*evenness),
        **moves,
    )


def request_of(request: _core.Request, has_field: bool, lines_per_radius: int) -> dict[str, Any]:
    """The request, as reports have it."""
    cells = request.mode == "cells"
    size = "scale" if has_field else "radius"
    place = {"backend": request.backend, "device": request.device, "threads": request.threads}
    asked: dict[str, Any] = {
        "width": request.width,
        "height": request.height,
        "boundary": "torus" if request.torus else "box",
        "mode": request.mode,
    }
    if request.mode == "stratified":
        return dict(asked, count=request.count, seed=request.seed, **place)
    if has_field:
        asked["metric"] = request.metric
    asked[size] = getattr(request, size)
    asked["count"] = request.count
    asked["lines_per_radius"] = lines_per_radius
    if request.progressive:
        asked["progressive"] = True
    if request.classes.names:
        asked["class_names"] = list(request.classes.names)
        asked["distances"] = []  # set_of fills them in
        asked["weights"] = list(request.classes.weights)
    if not cells:
        asked.update(snap=request.snap, uniform_x=request.uniform_x)
    asked.update(limit=request.limit, round_size=request.round_size, seed=request.seed)
    return dict(asked, **place)


def make(
    request: _core.Request,
    field: _core.Field | None,
    moves: _core.Moves,
    progress: Progress | None,
    mask: _core.Mask | None = None,
    keep: npt.NDArray[np.float64] | None = None,
    keep_classes: npt.NDArray[np.uint8] | None = None,
) -> dict[str, Any]:
    """Samples, and moves the points if that is asked for. Returns the attributes of a PointSet."""
    checked_progress(progress)
    made = _core.sample(request, field, mask, keep, keep_classes, moves, progress)
    asked = request_of(request, field is not None, made["lines_per_radius"])
    if request.border:
        asked["border"] = request.border
    # The command names the files of these.
    for name, given in (("mask", mask), ("keep", keep)):
        if given is not None:
            asked[name] = "an array"
    if field is not None:
        asked["ellipses" if field.has_ellipses else "field"] = "an array"
    if keep is not None:
        asked["kept"] = len(keep)
    relaxed = moved(made, request, moves.iterations, moves.gaussian)
    if relaxed is not None:
        asked["relax"] = moves.iterations
    if moves.gaussian:
        asked["gaussian"] = moves.gaussian
        asked["gaussian_distance"] = moves.gaussian_distance
    return set_of(made, request, field is not None, relaxed, asked)


def set_of(
    made: dict[str, Any],
    request: _core.Request,
    has_field: bool,
    relaxed: Relaxed | None,
    asked: dict[str, Any],
) -> dict[str, Any]:
    if not has_field or request.mode == "stratified":
        made["scale"] = None
    classes = attributes_of(request.classes, made)
    if classes["distances"] is not None:  # those that the set keeps, not those given
        asked["distances"] = classes["distances"].tolist()
    return dict(
        {**made, **classes},
        domain=(request.width, request.height),
        torus=request.torus,
        mode=request.mode,
        metric=request.metric,
        seed=request.seed,
        relaxed=relaxed,
        _request=asked,
    )
