"""threshold_mask: makes a tile of thresholds for dithering."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._arguments import options, whole

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._arguments import Seed, Whole


def threshold_mask(
    columns: Whole, rows: Whole, seed: Seed = 0, frames: Whole | None = None
) -> npt.NDArray[np.uint32]:
    """Make a tile of ranks for dithering, by void and cluster (Ulichney 1993).

    For every k the pixels of rank under k are spread evenly, also across the tile's edges.
    With ``frames`` they are so in every frame, and those of one place also in time (Wolfe et al.
    2022); after the last frame comes the first one again.

    Parameters
    ----------
    columns, rows : int
        The tile's sides in pixels, each 8 to 1024. The time grows with the square of their product.
    seed : None, int or numpy.random.Generator
        Another seed gives another tile, independent of this one; as for ``sample``.
    frames : int, optional
        So many tiles, for the frames of a film: with all of them at most 1024 * 1024 pixels.

    Returns
    -------
    ndarray, shape (rows, columns) or (frames, rows, columns), uint32
        The rank of each pixel, each of 0 to the number of pixels - 1 once, row 0 on top. As thresholds
        between 0 and 1: ``(ranks + 0.5) / ranks.size``.

    Raises
    ------
    BadRequest, TypeError
        For sides, a seed or frames that are none of these.

    Examples
    --------
    >>> import lacuna, numpy as np
    >>> tile = (lacuna.threshold_mask(64, 64) + 0.5) / 4096
    >>> ramp = np.linspace(0, 1, 256) * np.ones((64, 1))
    >>> dithered = ramp > np.tile(tile, (1, 4))
    >>> float(dithered.mean().round(2))
    0.5
    """
    width, height = whole("columns", columns, 0, 2**32 - 1), whole("rows", rows, 0, 2**32 - 1)
    tiles = 1 if frames is None else whole("frames", frames, 0, 2**32 - 1)
    ranks = _core.threshold_mask(width, height, options(seed=seed)["seed"], tiles)
    return ranks.reshape((height, width) if frames is None else (tiles, height, width))
