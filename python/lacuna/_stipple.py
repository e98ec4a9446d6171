"""stipple: turns a picture into dots."""

from __future__ import annotations

import io
import os
from typing import TYPE_CHECKING, SupportsFloat, SupportsIndex

import numpy as np

from . import _core
from ._arguments import choice, flag, numbers, path_bytes, real, whole
from ._errors import BadRequest, FileError
from ._results import Stippling
from ._runs import MOST_32, choose_metric, choose_start, fill, make, place, set_size, shape_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Seed
    from ._runs import Progress

STARTS = ("stratified", "cells", "exact")


def _tone(
    invert: object,
    black: SupportsFloat,
    white: SupportsFloat,
    auto_levels: object,
    gamma: SupportsFloat,
    min_importance: SupportsFloat,
) -> _core.Tone:
    tone = _core.Tone()
    tone.invert = flag("invert", invert)
    tone.black = real("black", black)
    tone.white = real("white", white)
    tone.auto_levels = flag("auto_levels", auto_levels)
    tone.gamma = real("gamma", gamma)
    tone.min_importance = real("min_importance", min_importance)
    return tone


def _picture(image: object, tone: _core.Tone) -> _core.Field:
    """The importance of a picture in a file or in an array. An array is read like an .npy file."""
    if isinstance(image, (str, bytes, os.PathLike)):
        return _core.read_field(path_bytes("image", image), tone)
    encoded = io.BytesIO()
    np.lib.format.write_array(encoded, numbers("image", image), allow_pickle=False)
    try:
        return _core.decode_field(encoded.getvalue(), "image", tone)
    except FileError as error:
        raise BadRequest(str(error), "image") from None


def stipple(
    image: str | bytes | os.PathLike[str] | npt.ArrayLike,
    n: SupportsIndex | None = None,
    *,
    scale: SupportsFloat | None = None,
    relax: SupportsIndex = 15,
    metric: str | None = None,
    mode: str | None = None,
    invert: bool = False,
    black: SupportsFloat = 0.0,
    white: SupportsFloat = 1.0,
    auto_levels: bool = False,
    gamma: SupportsFloat = 1.0,
    min_importance: SupportsFloat = 0.0,
    torus: bool = False,
    seed: Seed = None,
    limit: SupportsIndex | None = None,
    lines_per_radius: SupportsIndex | None = None,
    round_size: SupportsIndex = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: SupportsIndex = 0,
    memory_limit: SupportsIndex | None = None,
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
    relax : int
        How often the dots are moved after sampling, so that their cells hold equal darkness. With 0
        they are not moved and stay random, as in Kalantari & Sen 2011.
    metric : {'min', 'mean', 'max'}, optional
        In 'cells' the least distance of two dots is the min, mean or max of their radii. By default
        'mean', but 'min' with ``relax=0``. 'exact' knows 'min' only.
    mode : {'stratified', 'cells', 'exact'}, optional
        How dots are placed before they are moved. 'stratified': every part of the picture has its
        share of the dots. 'cells' places dots on a lattice, as in Kalantari & Sen 2011. 'exact'
        places them in the plane and leaves no gap: the set that ``sample`` makes of the picture's
        importance. By default 'stratified', but 'cells' with ``relax=0`` and with ``scale``,
        ``metric``, ``limit``, ``lines_per_radius`` or ``round_size``, which are about distances.
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
    """
    field = _picture(image, _tone(invert, black, white, auto_levels, gamma, min_importance))
    request = _core.Request()
    request.mode = choice("mode", "cells" if mode is None else mode, STARTS)
    sides = shape_of(field)
    if n is None and scale is None:
        n = _core.dot_count(field, *sides)
    set_size(request, {"n": n, "scale": scale})
    iterations = whole("relax", relax, 0, MOST_32)
    place(request, sides, torus, backend, device, threads)
    fill(
        request,
        seed=seed,
        limit=limit,
        lines_per_radius=lines_per_radius,
        round_size=round_size,
        memory_limit=memory_limit,
    )
    choose_start(request, mode, metric, iterations)
    choose_metric(request, metric, iterations)
    made = make(request, field, iterations, progress)
    radii = _core.dot_radii(made["points"], field, request.width, request.height, iterations != 0)
    return Stippling(**made, radii=radii)
