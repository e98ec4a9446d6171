"""The pictures of results with matplotlib, which is imported when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._arguments import corner_and_sides

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._arguments import Extent

    Floats = npt.NDArray[np.float64]

# N r^2 / area of a maximal set on the torus: docs/design.md, section 5.
_DENSITY = 0.69656
_WRONG = "tab:red"


def _axes(ax: Axes | None) -> Axes:
    """``ax``, or the axes of a new figure."""
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError(f"plot needs matplotlib, which pip installs: {error}") from None
    return plt.subplots(layout="constrained")[1]


def dots(
    ax: Axes | None,
    points: Floats,
    domain: Extent,
    least_distance: float,
    radii: Floats | None,
    color: str | npt.NDArray[np.str_] = "black",
) -> Axes:
    """Draws points in their domain, as dots with the same radii as in ``save``."""
    ax = _axes(ax)
    from matplotlib.collections import EllipseCollection

    x0, y0, width, height = corner_and_sides(domain)
    ax.set(aspect="equal", xlim=(x0, x0 + width), ylim=(y0, y0 + height))
    ax.set(xlabel="x (unit of the domain)", ylabel="y (unit of the domain)")
    if radii is None:
        if least_distance == 0:
            least_distance = (_DENSITY * width * height / max(1, len(points))) ** 0.5
        radii = np.full(len(points), least_distance / 3)
    circles = EllipseCollection(
        2 * radii,
        2 * radii,
        np.zeros(len(radii)),
        units="xy",
        offsets=points,
        offset_transform=ax.transData,
        facecolor=color,
        edgecolor="none",
    )
    ax.add_collection(circles, autolim=False)
    return ax


def curve(ax: Axes | None, x: Floats, y: Floats, of_x: str, of_y: str) -> Axes:
    """Draws a curve, and a line at 1, which independent points have."""
    ax = _axes(ax)
    ax.plot(x, y)
    ax.axhline(1, color="gray", linewidth=0.5)
    ax.set(xlabel=of_x, ylabel=of_y, xlim=(0, float(x[-1]) if len(x) else 1), ylim=(0, None))
    return ax


def verdict(
    ax: Axes | None,
    points: Floats,
    domain: Extent,
    wrong: list[int],
    pair: tuple[Floats, bool] | None,
    gap: tuple[tuple[float, float], float, bool] | None,
) -> Axes:
    """Draws points, those where none may lie, the closest pair, and the largest gap with its
    distance. A pair or a gap comes with whether it is allowed."""
    ax = _axes(ax)
    from matplotlib.patches import Circle

    dots(ax, points, domain, 0, None, "gray")
    for one in wrong:
        if one < len(points) and np.isfinite(points[one]).all():
            ax.plot(*points[one], "x", color=_WRONG, label=f"point {one}")
    if pair is not None:
        color = "black" if pair[1] else _WRONG
        ax.plot(*pair[0].T, ".-", color=color, label="closest pair")
    if gap is not None:
        color = "black" if gap[2] else _WRONG
        ax.add_patch(Circle(gap[0], gap[1], color=color, fill=False, label="largest gap"))
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper right")
    return ax
