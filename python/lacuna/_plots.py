"""The pictures of results with matplotlib, which is imported when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._verify import Verdict

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
    domain: tuple[float, float],
    least_distance: float,
    radii: Floats | None,
    color: str | npt.NDArray[np.str_] = "black",
) -> Axes:
    """Draws points in their domain, as dots with the same radii as in ``save``."""
    ax = _axes(ax)
    from matplotlib.collections import EllipseCollection

    ax.set(aspect="equal", xlim=(0, domain[0]), ylim=(0, domain[1]))
    if radii is None:
        if least_distance == 0:
            least_distance = (_DENSITY * domain[0] * domain[1] / max(1, len(points))) ** 0.5
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


def power(ax: Axes | None, frequency: Floats, power: Floats) -> Axes:
    """Draws the radial power, and a line at 1, the power of independent points."""
    ax = _axes(ax)
    ax.plot(frequency, power)
    ax.axhline(1, color="gray", linewidth=0.5)
    ax.set(
        xlabel="frequency / sqrt(N)", ylabel="power", xlim=(0, float(frequency[-1])), ylim=(0, None)
    )
    return ax


def verdict(ax: Axes | None, found: Verdict) -> Axes:
    """Draws the points, and what was found: a point where none may lie, the closest pair, and the
    largest gap."""
    points = found.points
    ax = _axes(ax)
    from matplotlib.patches import Circle

    dots(ax, points, found.domain, 0, None, "gray")
    for wrong in (found.outside, found.moved, found.forbidden):
        if wrong is not None and wrong < len(points) and np.isfinite(points[wrong]).all():
            ax.plot(*points[wrong], "x", color=_WRONG, label=f"point {wrong}")
    if found.closest_pair is not None:
        color = "black" if found.kept else _WRONG
        ax.plot(*points[list(found.closest_pair)].T, ".-", color=color, label="closest pair")
    if found.largest_gap is not None and found.largest_gap_distance is not None:
        color = "black" if found.covered else _WRONG
        reach = found.largest_gap_distance
        ax.add_patch(Circle(found.largest_gap, reach, color=color, fill=False, label="largest gap"))
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper right")
    return ax
