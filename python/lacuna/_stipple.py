"""stipple: turns a picture into dots."""

from __future__ import annotations

import io
import os
from typing import TYPE_CHECKING, Literal, Sequence, SupportsFloat

import numpy as np

from . import _core
from ._arguments import numbers, options, path_bytes, points_array, text, watched
from ._errors import BadRequest, FileError
from ._sets import PointSet, Stippling, set_attributes

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Metric, Progress, Seed, Whole


def _picture(image: object) -> _core.Picture:
    """A picture in a file, or in an array, which is like an .npy file."""
    if isinstance(image, (str, bytes, os.PathLike)):
        return _core.read_picture(path_bytes("image", image))
    encoded = io.BytesIO()
    np.lib.format.write_array(encoded, numbers("image", image), allow_pickle=False)
    return _core.Picture(encoded.getvalue())


def stipple(
    image: str | bytes | os.PathLike[str] | npt.ArrayLike,
    n: Whole | None = None,
    *,
    start_points: PointSet | npt.ArrayLike | None = None,
    scale: SupportsFloat | None = None,
    relax: Whole | None = None,
    metric: Metric | None = None,
    mode: Literal["stratified", "cells", "exact"] | None = None,
    inks: str | None = None,
    black_ink: SupportsFloat | None = None,
    ink_counts: Sequence[Whole] | None = None,
    paper_colour: str = "white",
    turn: Whole = 0,
    crop: str | None = None,
    invert: bool = False,
    black: SupportsFloat = 0.0,
    white: SupportsFloat = 1.0,
    background: Literal["white", "black"] = "white",
    auto_levels: bool = False,
    light: bool = False,
    gamma: SupportsFloat = 1.0,
    min_importance: SupportsFloat = 0.0,
    sharpen: Whole = 0,
    sharpen_amount: SupportsFloat = 1.0,
    along: SupportsFloat = 1.0,
    size_by_tone: SupportsFloat = 0.0,
    keep_inside: bool = False,
    dot_size: str | None = None,
    pens: str | None = None,
    pen: str | None = None,
    dot_style: Literal["spiral", "circle"] | None = None,
    paper_size: str | None = None,
    margin: str | None = None,
    pen_path: bool | None = None,
    path_line: bool = False,
    plot_time: str | None = None,
    seconds_per_dot: SupportsFloat | None = None,
    seconds_per_metre_down: SupportsFloat | None = None,
    seconds_per_metre_up: SupportsFloat | None = None,
    seconds_per_corner: SupportsFloat | None = None,
    torus: bool = False,
    seed: Seed = None,
    limit: Whole | None = None,
    lines_per_radius: Whole | None = None,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | Literal[True] | None = None,
) -> Stippling:
    """Stipple a picture: random dots, evenly spread, dense where it is dark.

    Parameters
    ----------
    image : path or array_like, shape (rows, columns) or (rows, columns, 1, 3 or 4)
        A picture: PNG, JPEG, TIFF, WebP, HEIC, AVIF, PGM, PPM, PFM, Radiance HDR or .npy; or an
        array, row 0 on top.
        Black is 0. White is 255 or 65535 for 8-bit and 16-bit numbers; for other numbers it is 1,
        or the largest number in the array if that is over 1. A grey of number v, from 0 to 1, is
        covered to 1 - v: made smaller by any viewer, a drawing of the dots is the picture made
        smaller.
    n : int, optional
        Exactly ``n`` dots. By default, without ``scale``, one dot for 16 black pixels, at most a
        million. A grey pixel counts by its darkness; the longer side counts as 512 to 2048 pixels.
    start_points : PointSet or array_like, shape (N, 2), optional
        Instead of placing new dots: the dots of the picture before this one in a sequence, which
        are moved on. Each changes its place little where the pictures are alike, jumps if it is
        needed elsewhere, and keeps its index, except with ``pens`` and along a pen's path. Not with
        ``inks``, ``along``, ``scale``, ``plot_time`` or ``relax=0``.
    scale : float
        The radius where the picture is black, if its longer side is 1.
    relax : int, optional
        How often the dots are moved after sampling, so that their cells hold equal darkness: 15
        times by default, and never with ``along``. With 0 they are not moved and stay random, as
        in Kalantari & Sen 2011.
    metric : {'min', 'mean', 'max'}, optional
        In 'cells' the least distance of two dots is the min, mean or max of their radii. By default
        'mean', but 'min' with ``relax=0``. 'exact' accepts 'min' only.
    mode : {'stratified', 'cells', 'exact'}, optional
        How dots are placed before they are moved. 'stratified': every part of the picture has its
        share of the dots. 'cells' places dots on a lattice, as in Kalantari & Sen 2011. 'exact'
        places them in the plane and leaves no gap: the set that ``sample`` makes of the picture's
        importance. By default 'stratified'. The default is 'cells' with ``relax=0``, and if
        ``scale``, ``metric``, ``limit``, ``lines_per_radius`` or ``round_size`` is given,
        because a stratified set keeps no least distance.
    inks : str, optional
        Dots in colour: 'cmyk', or inks separated by commas: names such as 'black,red', '#rrggbb' or
        'NAME=#rrggbb'. The dots of each ink are evenly spread, and so are all dots together.
        Of a colour that the inks cannot make, they keep the lightness first, then the hue. The
        result has the dots of the first ink, then of the second, and so on. They begin stratified
        and are relaxed at least once.
    black_ink : float, optional
        How much black replaces other inks that would look grey together, 0 to 1; 0.8 by default.
    ink_counts : sequence of int, optional
        The number of dots of each ink, instead of ``n``. By default ``n`` is shared out in
        proportion to how much of each ink the picture needs.
    paper_colour : str
        A name such as 'black', or '#rrggbb': inks are separated for paper of this colour. Inks that
        are lighter than it are opaque, as of gel pens.
    turn : int
        Turns the picture right by 90, 180 or 270 degrees.
    crop : str, optional
        Takes a part of the picture, as it was turned: 'X,Y,W,H' is W x H pixels, X from its left
        edge and Y from its top.
    invert : bool
        Bright is dense instead of dark.
    black, white : float
        Luminance up to ``black`` counts as black, and from ``white`` on as white; 0 to 1.
    background : {'white', 'black'}
        What shows through where the picture is transparent: black for light drawings.
    auto_levels : bool
        Choose ``black`` and ``white`` so that half a percent of the pixels lie beyond each, and
        paper, which is what most of the picture shows at its light end.
    light : bool
        Areas average as light, for prints seen from afar: 8- and 16-bit numbers are decoded as
        sRGB, and others are light already. A grey of 128 of 255 is then covered to 0.78, not 0.50.
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
        in a shape narrower than a dot they are smaller and denser. Where the picture is black, dots
        leave no gaps.
    dot_size : str, optional
        The diameter of the pen's dots, such as '0.4mm', or '0.3mm..0.8mm' from light to dark. With
        ``along`` each dot is a stroke of that pen. There are as many dots as suit the picture.
    pens : str, optional
        The widths of several pens, such as '0.3mm,0.5mm,0.8mm': each dot is as wide as one of them,
        wider where it is darker, and each pen has a layer of its own.
    pen : str, optional
        The width of the one pen that draws dots of all sizes, such as '0.3mm': wider ones as
        spirals that leave no gap, or as ``dot_style`` says; none is narrower.
    dot_style : {'spiral', 'circle'}, optional
        With ``pen``: how it draws wider dots; circles have the dots' outer edges. By default
        'spiral'.
    paper_size, margin : str, optional
        The sheet, such as 'A5' or '200x150mm', and its margin, such as '10mm', by default 0. The
        picture lies in its middle, as large as the margin allows, and saved pictures show it. No
        ink lies in the margin.
    pen_path : bool, optional
        Order the dots of each ink along a short path of the pen: by default with ``dot_size``,
        ``pens``, ``pen``, or ``inks`` that have pens.
    path_line : bool
        Draw that path as one line for each ink, in place of dots.
    plot_time : str, optional
        In place of ``n``: as many dots as a plotter draws in at most this time, such as '1h' or
        '30min'; with pens no more than the picture needs. The result's ``.plot_seconds`` says how
        long it takes.
    seconds_per_dot : float, optional
        How long the plotter takes to lower and raise the pen. The default of this and of the next
        arguments is that of an AxiDraw V3: 0.28.
    seconds_per_metre_down, seconds_per_metre_up : float, optional
        How long it takes for a metre at full speed: with the pen down, along strokes and lines, 20
        by default; and with the pen up, 6.6 by default.
    seconds_per_corner : float, optional
        How long it takes to stop and start again with the pen down, at full speed: 0.066 by
        default. It is less in blunt corners and on short ways.
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
    array([  0, 110,  90])
    """
    asked = options(
        n=n, scale=scale, relax=relax, metric=metric, mode=mode, black_ink=black_ink,
        ink_counts=ink_counts, paper_colour=paper_colour, turn=turn, crop=crop,
        invert=invert, black=black, white=white,
        background=background, auto_levels=auto_levels, light=light, gamma=gamma,
        min_importance=min_importance, sharpen=sharpen, sharpen_amount=sharpen_amount,
        along=along, size_by_tone=size_by_tone, keep_inside=keep_inside, dot_size=dot_size,
        pens=pens, pen=pen, dot_style=dot_style, paper_size=paper_size, margin=margin,
        pen_path=pen_path, path_line=path_line,
        plot_time=plot_time, seconds_per_dot=seconds_per_dot,
        seconds_per_metre_down=seconds_per_metre_down, seconds_per_metre_up=seconds_per_metre_up,
        seconds_per_corner=seconds_per_corner, torus=torus, seed=seed,
        limit=limit, lines_per_radius=lines_per_radius, round_size=round_size, backend=backend,
        device=device, threads=threads, memory_limit=memory_limit,
    )  # fmt: skip
    palette = [] if inks is None else _core.inks_of(text("inks", inks))
    picture = _picture(image)
    first = None if start_points is None else points_array("start_points", start_points)
    if first is not None and len(first) == 0:
        raise BadRequest("start_points", "", "must have at least one point")
    try:
        with watched(progress) as told:
            made = _core.stipple(picture, asked, palette, first, told)
    except FileError as error:
        if isinstance(image, (str, bytes, os.PathLike)):
            raise
        raise BadRequest("image", "", str(error).removeprefix("image: ")) from None
    iterations = made.pop("iterations")
    said = {"inks": [ink.name for ink in palette]} if palette else {"field": "an array"}
    attributes = set_attributes(made, relax=iterations, **said)
    layers = attributes.pop("layers")
    attributes["inks"] = {ink.name: ink.hex for ink in layers} or None
    attributes["pens"] = {ink.name: ink.pen_mm for ink in layers if ink.pen_mm} or None
    return Stippling(**attributes, paper_colour=paper_colour)
