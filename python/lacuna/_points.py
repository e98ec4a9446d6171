"""What all results with points have in common."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Iterator

import numpy as np

from . import _core, _plots
from ._arguments import path_bytes
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class HasPoints:
    """Points of a domain. numpy accepts the object as an array of N x 2 float64."""

    points: Floats = field(repr=False)
    domain: tuple[float, float]
    torus: bool

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Floats]:
        return iter(self.points)

    def __getitem__(self, key: Any) -> Any:
        return self.points[key]

    def __repr__(self) -> str:
        told = [f"{one.name}={getattr(self, one.name)!r}" for one in fields(self) if one.repr]
        return f"{type(self).__name__}({', '.join([f'{len(self)} points', *told])})"

    def __setstate__(self, state: dict[str, Any]) -> None:
        # Arrays that were copied or pickled are writable again.
        self.__dict__.update(state)
        for value in state.values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        if copy is None:
            return np.asarray(self.points, dtype=dtype)
        if not copy and dtype is not None and np.dtype(dtype) != self.points.dtype:
            raise ValueError(f"points are float64: an array of {np.dtype(dtype)} is a copy")
        return np.array(self.points, dtype=dtype, copy=copy)

    def _least_distance(self) -> float:
        """The radius of the set: dots have a third of it. 0 if it is not known."""
        return 0.0

    def _radii(self) -> Floats | None:
        """The radius of each dot; None if all dots are equal."""
        return None

    def _layers(self) -> list[tuple[_core.Ink, int]]:
        """The inks of the dots and how many dots each has, in order; empty if all are black."""
        return []

    def _classes(self) -> tuple[list[str], npt.NDArray[np.uint8] | None]:
        """The names of classes, and the class of each point; none if there are no classes."""
        return [], None

    def _ellipses(self) -> Floats | None:
        """The ellipse of each point; None if there are none."""
        return None

    def _describe(self, saved: _core.Saved) -> None:
        """Fills in what .json holds besides: how the set was made."""

    def save(self, path: str | bytes | os.PathLike[Any]) -> None:
        """Write the points to a file, whose extension names the format, as the command does.

        ``.txt``, ``.csv``, ``.npy``, ``.ply`` and ``.json`` hold every coordinate to the last bit.
        ``.csv``, ``.npy``, ``.ply`` and ``.json`` hold the class, ink and ellipse of each point,
        for which ``.txt`` has no place. ``.json`` says how the set was made, so that
        ``lacuna verify`` can prove it.
        ``.svg``, ``.pdf`` and ``.png`` are pictures of dots on white, with the radii of ``radii``
        if the result has it, and black unless it has inks. The file appears whole or not at all.

        Parameters
        ----------
        path : path
            An older file of this name is replaced.

        Raises
        ------
        FileError
            An OSError: the file cannot be written.
        BadRequest
            The extension is not one of these, or ``.txt`` for points with classes, inks or
            ellipses.
        TypeError
            The argument is not a path.
        """
        name, saved = path_bytes("path", path), _core.Saved()
        saved.width, saved.height = self.domain
        saved.torus = self.torus
        saved.radius = self._least_distance()
        saved.layers = self._layers()
        saved.classes, class_of = self._classes()
        self._describe(saved)
        try:
            _core.write_points(
                name, self.points, saved, self._radii(), class_of, self._ellipses()
            )
        except BadRequest as error:
            raise error.called("path") from None

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the points with matplotlib, as ``save`` draws them.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ImportError
            matplotlib is not installed.
        """
        colours = [ink.hex for ink, _ in self._layers()]
        dots = [count for _, count in self._layers()]
        color = np.repeat(colours, dots) if colours else "black"
        least, radii = self._least_distance(), self._radii()
        return _plots.dots(ax, self.points, self.domain, least, radii, color)

    @property
    def sha256(self) -> str:
        """The SHA-256 of the points as little-endian float64, as in the command's --report."""
        return hashlib.sha256(np.ascontiguousarray(self.points, "<f8").data).hexdigest()
