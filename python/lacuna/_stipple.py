"""stipple: turns a picture into dots."""

from __future__ import annotations

import io
import os
from typing import TYPE_CHECKING, Any, Callable, Literal, Sequence, SupportsFloat, TypeVar

import numpy as np

from . import _core
from ._arguments import choice, flag, numbers, path_bytes, real, shown, text, whole
from ._errors import BadRequest, FileError
from ._results import Relaxed, Stippling
from ._runs import (
    MOST_32,
    MOST_64,
    checked_progress,
    fill,
    least_distance,
    make,
    place,
    refuse_what_is_not_for_inks,
    relax_options,
    request_of,
    set_of,
    set_size,
    settle,
    shape_of,
)

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Metric, Seed, Whole
    from ._runs import Progress

STARTS = ("stratified", "cells", "exact")

Decoded = TypeVar("Decoded")


def _tone(
    invert: object,
    black: SupportsFloat,
    white: SupportsFloat,
    auto_levels: object,
    gamma: SupportsFloat,
    min_importance: SupportsFloat,
    sharpen: Whole,
    sharpen_amount: SupportsFloat,
    along: SupportsFloat,
) -> _core.Tone:
    tone = _core.Tone()
    tone.invert = flag("invert", invert)
    tone.black = real("black", black)
    tone.white = real("white", white)
    tone.auto_levels = flag("auto_levels", auto_levels)
    tone.gamma = real("gamma", gamma)
    tone.min_importance = real("min_importance", min_importance)
    tone.sharpen = whole("sharpen", sharpen, 0, 1000)
    tone.sharpen_amount = real("sharpen_amount", sharpen_amount)
    tone.along = real("along", along)
    return tone


def _decoded(
    image: object, read: Callable[[bytes], Decoded], decode: Callable[[bytes, str], Decoded]
) -> Decoded:
    """What read or decode makes of a picture in a file or an array, which is like an .npy file."""
    if isinstance(image, (str, bytes, os.PathLike)):
        return read(path_bytes("image", image))
    encoded = io.BytesIO()
    np.lib.format.write_array(encoded, numbers("image", image), allow_pickle=False)
    try:
        return decode(encoded.getvalue(), "image")
    except FileError as error:
        raise BadRequest(str(error), "image") from None


def _picture(image: object, tone: _core.Tone) -> _core.Field:
    """The importance of a picture."""
    return _decoded(
        image,
        lambda path: _core.read_field(path, tone),
        lambda content, name: _core.decode_field(content, name, tone),
    )


def _separation(
    image: object, inks: list[_core.Ink], tone: _core.Tone, black_ink: SupportsFloat | None
) -> list[_core.Field]:
    """The importance of each ink of a picture."""
    black = _core.black_ink if black_ink is None else real("black_ink", black_ink)
    return _decoded(
        image,
        lambda path: _core.read_inks(path, inks, tone, black),
        lambda content, name: _core.decode_inks(content, name, inks, tone, black),
    )


def _sum_of(fields: list[_core.Field]) -> _core.Field:
    total = _core.make_field(fields[0].rows, fields[0].columns)
    total.values[...] = sum(one.values for one in fields)
    return total


def _dots_of(
    counts: Sequence[Whole] | None,
    n: int | None,
    inks: list[_core.Ink],
    fields: list[_core.Field],
) -> list[int]:
    """The number of dots of each ink."""
    if counts is None:
        assert n is not None
        return _core.dots_by_ink(n, fields)
    dots = [whole("ink_counts", count, 0, MOST_32) for count in counts]
    if len(dots) != len(inks):
        raise BadRequest(f"ink_counts {len(dots)} numbers: must be one for each ink", "ink_counts")
    if n is not None:
        raise BadRequest("ink_counts with n: give one of both", "ink_counts")
    for ink, count, field in zip(inks, dots, fields):
        if count and not field.values.any():
            raise BadRequest(
                f"ink_counts {count}: must be 0 for {ink.name}: the picture needs none of this ink",
                "ink_counts",
            )
    if not sum(dots):
        raise BadRequest("ink_counts 0: must not be 0 for all inks", "ink_counts")
    return dots


# Moves the dots of all tones to where they are drawn, and finds their radii.
_Draw = Callable[["list[npt.NDArray[np.float64]]", "list[_core.Field]"], tuple[Any, Any]]


def _draw(
    request: _core.Request, relaxed: bool, by_tone: float, white: _core.Field | None
) -> _Draw:
    """With `white`, dots are kept off the white parts of that picture."""
    shape = request.width, request.height

    def draw(
        parts: list[npt.NDArray[np.float64]], tones: list[_core.Field]
    ) -> tuple[Any, Any]:
        def radii(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
            ends = np.cumsum([len(part) for part in parts])[:-1]
            return np.concatenate(
                [
                    _core.dot_radii(its, tone, *shape, relaxed, by_tone, white is not None)
                    for its, tone in zip(np.split(points, ends), tones)
                ]
            )

        points = np.concatenate(parts)
        if white is None:
            return points, radii(points)
        points = _core.pull_inside(points, radii(points), white, request)
        return points, _core.fit_inside(points, radii(points), white, request)

    return draw


def _stipple_inks(
    request: _core.Request,
    densities: list[_core.Field],
    tones: list[_core.Field],
    draw: _Draw,
    inks: list[_core.Ink],
    dots: list[int],
    iterations: int,
    progress: Progress | None,
) -> Stippling:
    checked_progress(progress)
    options = relax_options(request, iterations)
    parts = [part for part in zip(densities, dots, tones) if part[1]]
    placed = _core.place_inks(
        [part[0] for part in parts],
        [part[1] for part in parts],
        request.seed,
        options,
        progress,
    )
    ends = np.cumsum([count for _, count, _ in parts])[:-1]
    points, all_radii = draw(np.split(placed["points"], ends), [tone for *_, tone in parts])
    relaxed = Relaxed(
        points=placed["points"],
        domain=(request.width, request.height),
        torus=request.torus,
        iterations=iterations,
        lattice=placed["lattice"],
        evenness=None,
        seconds=placed["seconds"],
        backend=placed["backend"],
        device=placed["device"],
    )
    request.count = len(points)
    asked = dict(request_of(request, True, 0), relax=iterations, inks=[ink.name for ink in inks])
    made = dict(
        points=points,
        radius=least_distance(points, options),
        scale=None,
        lines_per_radius=0,
        maximal=False,
        levels=(),
        rounds=0,
        draws=len(points),
        seconds=placed["seconds"],
        backend=placed["backend"],
        device=placed["device"],
    )
    ink = np.repeat(np.arange(len(inks), dtype=np.uint8), dots)
    ink.flags.writeable = False
    points.flags.writeable = all_radii.flags.writeable = False
    return Stippling(
        **set_of(made, request, True, relaxed, asked),
        radii=all_radii,
        ink=ink,
        inks={ink.name: ink.hex for ink in inks},
    )


def stipple(
    image: str | bytes | os.PathLike[str] | npt.ArrayLike,
    n: Whole | None = None,
    *,
    scale: SupportsFloat | None = None,
    relax: Whole | None = None,
    metric: Metric | None = None,
    mode: Literal["stratified", "cells", "exact"] | None = None,
    inks: str | None = None,
    black_ink: SupportsFloat | None = None,
    ink_counts: Sequence[Whole] | None = None,
    invert: bool = False,
    black: SupportsFloat = 0.0,
    white: SupportsFloat = 1.0,
    auto_levels: bool = False,
    gamma: SupportsFloat = 1.0,
    min_importance: SupportsFloat = 0.0,
    sharpen: Whole = 0,
    sharpen_amount: SupportsFloat = 1.0,
    along: SupportsFloat = 1.0,
    size_by_tone: SupportsFloat = 0.0,
    keep_inside: bool = False,
    torus: bool = False,
    seed: Seed = None,
    limit: Whole | None = None,
    lines_per_radius: Whole | None = None,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | None = None,
) -> Stippling:
    """Stipple a picture: random dots, evenly spread, dense where it is dark.

    Parameters
    ----------
    image : path or array_like, shape (rows, columns) or (rows, columns, 1, 3 or 4)
        A picture: PNG, JPEG, PGM, PPM, PFM, Radiance HDR or .npy; or an array, row 0 on top.
        Black is 0. White is 255 or 65535 for 8-bit and 16-bit numbers; for other numbers it is 1,
        or the largest number in the array if that is over 1.
    n : int, optional
        Exactly ``n`` dots. By default, without ``scale``, one dot for 16 black pixels, at most a
        million. A grey pixel counts by its darkness; the longer side counts as 512 to 2048 pixels.
    scale : float
        The radius where the picture is black, if its longer side is 1.
    relax : int, optional
        How often the dots are moved after sampling, so that their cells hold equal darkness: 15
        times by default, and never with ``along``. With 0 they are not moved and stay random, as in Kalantari & Sen 2011.
    metric : {'min', 'mean', 'max'}, optional
        In 'cells' the least distance of two dots is the min, mean or max of their radii. By default
        'mean', but 'min' with ``relax=0``. 'exact' knows 'min' only.
    mode : {'stratified', 'cells', 'exact'}, optional
        How dots are placed before they are moved. 'stratified': every part of the picture has its
        share of the dots. 'cells' places dots on a lattice, as in Kalantari & Sen 2011. 'exact'
        places them in the plane and leaves no gap: the set that ``sample`` makes of the picture's
        importance. By default 'stratified', but 'cells' with ``relax=0`` and with ``scale``,
        ``metric``, ``limit``, ``lines_per_radius`` or ``round_size``, which are about distances.
    inks : str, optional
        Dots in colour: 'cmyk', or inks separated by commas: names such as 'black,red', '#rrggbb' or
        'NAME=#rrggbb'. Each ink's dots are even, and all dots together are. Colours are separated
        in linear light. Dots come ink by ink, begin stratified, and are relaxed at least once.
    black_ink : float, optional
        How much black replaces other inks that would look grey together, 0 to 1; 0.8 by default.
    ink_counts : sequence of int, optional
        The dots of each ink, in place of ``n``. By default as the picture needs of each.
    invert : bool
        Bright is dense instead of dark.
    black, white : float
        Luminance up to ``black`` counts as black, and from ``white`` on as white; 0 to 1.
    auto_levels : bool
        Choose ``black`` and ``white`` so that half a percent of the pixels lie beyond each.
    gamma : float
        Importance is raised to this power: over 1 lightens middle tones.
    min_importance : float
        Least importance, so that white has dots too.
    sharpen, sharpen_amount : int, float
        Sharpen edges of about ``sharpen`` pixels by an unsharp mask, ``sharpen_amount`` times as
        much: shows more with few dots. 0 pixels: not at all.
    along : float
        Over 1, dots are ellipses up to this many times as long as wide, along the picture's edges:
        a set in mode 'exact' that is not relaxed. The result has them as ``.ellipses``.
    size_by_tone : float
        How much of the tone is in the dots' sizes, 0 to 1: areas are proportional to importance to
        this power, and dots are as dense as importance over area.
    keep_inside : bool
        Keep dots off white, and in the picture: dots that overhang an edge are moved inwards, and
        in a shape narrower than a dot they are made smaller. Where the picture is black, dots
        leave no gaps.
    torus, seed, limit, lines_per_radius, round_size, backend, device, threads, memory_limit, \
progress
        As for ``sample``.

    Returns
    -------
    Stippling
        Points of the picture, whose longer side is 1, y upwards, with the dots' radii.

    Raises
    ------
    FileError
        An OSError: the file cannot be read, or is no picture.
    BadRequest, TypeError, MemoryRefused, Unavailable, DeviceError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna, numpy as np
    >>> y, x = np.mgrid[0:100, 0:150]
    >>> disk = np.where(np.hypot(x - 75, y - 50) < 40, 0.0, 1.0)
    >>> dots = lacuna.stipple(disk, 200, seed=1)
    >>> dots.points.shape, dots.radii.shape, [round(side, 3) for side in dots.domain]
    ((200, 2), (200,), [1.0, 0.667])
    >>> len(lacuna.stipple(disk, seed=1))  # a third of 512 x 341 pixels, over 16
    3650
    >>> hairs = lacuna.stipple(disk * 0.5 + 0.2, 500, seed=1, along=4)
    >>> hairs.maximal, bool(hairs.ellipses[:, 0].max() > hairs.ellipses[:, 1].min())
    (False, True)
    >>> red_disk = np.stack([np.ones_like(disk), disk, disk], axis=-1)
    >>> dots = lacuna.stipple(red_disk, 200, seed=1, inks="cmyk")
    >>> np.bincount(dots.ink)  # cyan, magenta, yellow; the disk needs no black
    array([  0, 112,  88])
    """
    tone = _tone(
        invert, black, white, auto_levels, gamma, min_importance, sharpen, sharpen_amount, along
    )
    by_tone = real("size_by_tone", size_by_tone)
    if not 0 <= by_tone <= 1:
        raise BadRequest(f"size_by_tone {by_tone}: must be 0 to 1", "size_by_tone")
    palette = [] if inks is None else _core.inks_of(text("inks", inks))
    for name, value in (("black_ink", black_ink), ("ink_counts", ink_counts)):
        if value is not None and not palette:
            raise BadRequest(f"{name} {shown(value)}: needs inks", name)
    fields = _separation(image, palette, tone, black_ink) if palette else [_picture(image, tone)]
    field = _sum_of(fields) if palette else fields[0]
    densities = [_core.density_of(one, by_tone) for one in fields] if by_tone else fields
    request = _core.Request()
    sides = shape_of(field)
    if n is None and scale is None and ink_counts is None:
        n = _core.dot_count(field, *sides)
    along_edges = tone.along != 1
    if along_edges and relax is not None and whole("relax", relax, 0, MOST_32):
        raise BadRequest(f"relax {relax}: cannot be used with along", "relax")
    if mode is not None:
        choice("mode", mode, STARTS)
    dots = []
    if palette and scale is None:
        dots = _dots_of(ink_counts, None if n is None else whole("n", n, 1, MOST_64), palette, densities)
        n = sum(dots)
    set_size(request, {"n": n, "scale": scale})
    place(request, sides, torus, backend, device, threads)
    fill(
        request,
        seed=seed,
        limit=limit,
        lines_per_radius=lines_per_radius,
        round_size=round_size,
        memory_limit=memory_limit,
    )
    if palette:
        refuse_what_is_not_for_inks(request, mode, metric)
    iterations = settle(
        request,
        mode=mode,
        metric=metric,
        relax=relax,
        picture=True,
        inks=bool(palette),
        ellipses=along_edges,
    )
    kept_inside = field if flag("keep_inside", keep_inside) else None
    draw = _draw(request, iterations != 0, by_tone, kept_inside)
    if palette:
        return _stipple_inks(request, densities, fields, draw, palette, dots, iterations, progress)
    made = make(request, densities[0], relax_options(request, iterations), progress)
    points, radii = draw([made["points"]], [field])
    points.flags.writeable = radii.flags.writeable = False
    if kept_inside is not None:
        options = relax_options(request, iterations)
        made.update(points=points, radius=least_distance(points, options), maximal=False)
        if field.has_ellipses:
            made["ellipses"] = _core.ellipses_of(points, densities[0], made["scale"], *sides)
    return Stippling(**made, radii=radii)
