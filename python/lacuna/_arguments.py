"""Converts the arguments of lacuna's functions: checks types and shapes. Errors name the argument.

All rules about values are checked by the library itself.
"""

from __future__ import annotations

import operator
import os
import secrets
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Callable, Iterator, Literal, SupportsFloat, SupportsIndex

import numpy as np

from . import _core
from ._errors import BadRequest

if TYPE_CHECKING:
    import numpy.typing as npt

    # A whole number; 1e5 and np.float64(1e5) are whole, too.
    Whole = SupportsIndex | float
    Mode = Literal["exact", "lines", "cells", "stratified", "pixels"]
    Metric = Literal["min", "mean", "max"]
    Seed = int | float | np.integer[Any] | np.random.Generator | None
    Progress = Callable[[int, int], object]
    # A domain: (width, height), or (x0, y0, x1, y1) with its corners.
    Domain = (
        tuple[SupportsFloat, SupportsFloat]
        | tuple[SupportsFloat, SupportsFloat, SupportsFloat, SupportsFloat]
    )
    Extent = tuple[float, float] | tuple[float, float, float, float]

# Most pixels in all and along a side, as exponents of 2. Masks of draw_mask may be larger.
_OF_FIELDS = (28, 20)
_OF_MASKS = (33, 24)
_MOST_POINTS = 2**31
MOST_64 = 2**64 - 1
_LONGEST_SHOWN = 60  # characters of a value in a message
_LONGEST_NAME = 200  # characters
_PIXELS_OF_PART = 2**22  # copied at a time, in some milliseconds; Ctrl-C works between two parts


def shown(value: object) -> str:
    """The value for a message: its repr on one line, and only the beginning of a long one."""
    try:
        written = repr(value)
    except ValueError:  # Python writes no int of more than 4300 digits
        if isinstance(value, int):
            return f"an int of {value.bit_length()} bits"
        return f"a {type(value).__name__}"
    line = " ".join(written.split())
    return line if len(line) <= _LONGEST_SHOWN else line[: _LONGEST_SHOWN - 3] + "..."


def real(name: str, value: SupportsFloat) -> float:
    """A float. The library refuses NaN and infinity."""
    if isinstance(value, (str, bytes, bytearray)):
        raise TypeError(f"{name} must be a number, not {shown(value)}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {shown(value)}") from None
    except OverflowError:
        raise BadRequest(name, shown(value), "is too large for a float") from None


def whole(name: str, value: Whole, least: int, most: int) -> int:
    """An int from ``least`` to ``most``, also given as a float without a fraction."""
    try:
        is_float = isinstance(value, (float, np.floating))
        number = int(value) if is_float and value.is_integer() else operator.index(value)  # type: ignore
    except TypeError:
        raise TypeError(f"{name} must be a whole number (int), not {shown(value)}") from None
    if not least <= number <= most:
        raise BadRequest(name, shown(number), f"must be {least} to {most}")
    return number


def flag(name: str, value: object) -> bool:
    """A bool. numpy's bools, 0 and 1 are accepted as well."""
    if isinstance(value, (bool, np.bool_)) or (isinstance(value, int) and value in (0, 1)):
        return bool(value)
    raise TypeError(f"{name} must be True or False, not {shown(value)}")


def text(name: str, value: object) -> str:
    """A name: a str of some length that UTF-8 can encode, without NUL."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {shown(value)}")
    if len(value) > _LONGEST_NAME:
        raise BadRequest(name, shown(value), f"must have at most {_LONGEST_NAME} characters")
    if "\0" in value:
        raise BadRequest(name, shown(value), "must have no NUL")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise BadRequest(name, shown(value), "must have no surrogates") from None
    return value


def _device(name: str, value: object) -> str:
    """A device by number or by a part of its name."""
    if isinstance(value, str):
        return text(name, value)
    return str(whole(name, value, 0, 2**31))  # type: ignore[arg-type]


def domain_in(name: str, value: object) -> Extent:
    """(width, height) if the lower left corner is (0, 0), or else (x0, y0, x1, y1)."""
    try:
        given: list[SupportsFloat] = list(value)  # type: ignore[call-overload]
    except TypeError:
        given = []
    if len(given) == 2:
        return real(name, given[0]), real(name, given[1])
    if len(given) != 4:
        of_space = "; sample_volume and verify_volume have three sides" if len(given) == 3 else ""
        raise TypeError(
            f"{name} must be (width, height) or (x0, y0, x1, y1), not {shown(value)}{of_space}"
        )
    x0, y0, x1, y1 = (real(name, one) for one in given)
    if not (x0 < x1 and y0 < y1):
        raise BadRequest(name, shown(value), "must be (x0, y0, x1, y1) with x0 < x1 and y0 < y1")
    return (x0, y0, x1, y1) if x0 != 0 or y0 != 0 else (x1, y1)


def raster_in(name: str, value: object) -> tuple[int, int]:
    """(columns, rows) of pixels."""
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise TypeError(f"{name} must be (columns, rows), not {shown(value)}")
    return whole(name, value[0], 0, 2**32 - 1), whole(name, value[1], 0, 2**32 - 1)


def chunk_in(value: object) -> tuple[int, int]:
    """I and J of a chunk."""
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise TypeError(f"chunk must be (I, J), not {shown(value)}")
    return whole("chunk", value[0], -(2**63), 2**63 - 1), whole("chunk", value[1], -(2**63), 2**63 - 1)


def corner_and_sides(domain: Extent) -> tuple[float, float, float, float]:
    """x0, y0, width and height."""
    if len(domain) == 2:
        return 0.0, 0.0, domain[0], domain[1]
    return domain[0], domain[1], domain[2] - domain[0], domain[3] - domain[1]


def _seed(name: str, value: Any) -> int:
    """A seed of 64 bits: the number itself, or drawn from a generator or from the system."""
    if value is None:
        return secrets.randbits(64)
    if isinstance(value, np.random.Generator):
        return int(value.integers(2**64, dtype=np.uint64))
    if isinstance(value, (np.random.RandomState, np.random.BitGenerator, np.random.SeedSequence)):
        raise TypeError(
            f"{name} must be None, an int or a numpy.random.Generator, not a "
            f"{type(value).__name__}: wrap it with numpy.random.default_rng"
        )
    return whole(name, value, 0, MOST_64)


def _counts(name: str, value: Any) -> list[int]:
    return [whole(name, count, 0, MOST_64) for count in value]


def _whole(name: str, value: Any) -> int:
    """The library refuses numbers that are too large for the option."""
    return whole(name, value, 0, MOST_64)


_READERS: dict[str, Callable[[str, Any], object]] = {"real": real, "whole": _whole, "flag": flag, "text": text}
# What each argument is converted by: the kind of its option, or what only Python has.
_KINDS: dict[str, Callable[[str, Any], object]] = {
    **{name: _READERS[kind] for name, kind in _core.kinds_of_options().items()},
    "backend": text,
    "chunk": lambda name, value: "{},{}".format(*chunk_in(value)),
    "device": _device,
    "domain": domain_in,
    **dict.fromkeys(("crop", "dot_size", "pens", "pen", "paper_size", "margin", "plot_time"), text),
    "ink_counts": _counts,
    "measure": flag,
    "on_pixels": lambda name, value: "{}x{}".format(*raster_in(name, value)),
    "paper_colour": text,
    "memory_limit": lambda name, value: whole(name, value, 1, MOST_64),
    "seed": _seed,
    "sharpen": _whole,
    "sharpen_amount": real,
}
# Arguments that may be None, which means that they are not given.
_OPTIONAL = set(
    "radius n chunk chunk_size on_pixels scale metric mode domain edge limit relax gaussian_distance "
    "lines_per_radius device memory_limit black_ink ink_counts tolerance "
    "crop dot_size pens pen dot_style paper_size margin pen_path plot_time seconds_per_dot "
    "seconds_per_metre_down seconds_per_metre_up seconds_per_corner".split()
)


def options(**given: object) -> dict[str, Any]:
    """The arguments by their names, as the library takes them, without those not given."""
    return {
        name: _KINDS[name](name, value)
        for name, value in given.items()
        if value is not None or name not in _OPTIONAL
    }


@contextmanager
def watched(progress: Progress | Literal[True] | None) -> Iterator[Progress | None]:
    """A progress to call: the one given, or for True a bar of tqdm, if that is installed."""
    if progress is not True:
        if progress is not None and not callable(progress):
            raise TypeError(f"progress must be callable or True, not {shown(progress)}")
        yield progress
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield None
        return
    with tqdm(disable=None) as bar:  # None: only on a terminal or in a notebook

        def show(done: int, expected: int) -> None:
            bar.n, bar.total = done, expected
            bar.refresh()

        yield show
        bar.n = bar.total or bar.n
        bar.refresh()


def numbers(name: str, value: object) -> npt.NDArray[Any]:
    """An array of real numbers, of any dtype and strides."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} must not be a masked array: pass its filled(0), for example")
    try:
        array = np.asarray(value)
    except ValueError:
        if not isinstance(value, (list, tuple)):
            raise
        raise BadRequest(name, shown(value), "must have rows of one length") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name} must hold real numbers, not dtype {str(array.dtype)[:_LONGEST_SHOWN]}")
    return array


def points_array(name: str, value: object) -> npt.NDArray[np.float64]:
    """Points as rows of two float64. Copies the array only if it has another form."""
    array = numbers(name, value)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise BadRequest(name, f"of shape {array.shape}", "must be N x 2")
    if len(array) >= _MOST_POINTS:
        raise BadRequest(name, f"of shape {array.shape}", "must be fewer than 2^31")
    return np.ascontiguousarray(array, dtype=np.float64)


def _pixels(name: str, value: object, most: tuple[int, int]) -> npt.NDArray[Any]:
    """An array of rows and columns, of any dtype and strides."""
    array = numbers(name, value)
    if array.ndim != 2 or array.size == 0:
        raise BadRequest(name, f"of shape {array.shape}", "must be rows x columns, at least 1 x 1")
    if array.size > 2 ** most[0] or max(array.shape) > 2 ** most[1]:
        raise BadRequest(name, f"of shape {array.shape}", f"must have at most 2^{most[0]} pixels, 2^{most[1]} to a side")
    return array


def _parts(array: npt.NDArray[Any]) -> Iterator[slice]:
    """Slices of rows that are copied at a time; Ctrl-C works between them."""
    rows = max(1, _PIXELS_OF_PART // array.shape[1])
    for begin in range(0, len(array), rows):
        yield slice(begin, begin + rows)


def field_of(name: str, value: object) -> _core.Field:
    """Importance, row 0 on top. Copies the array once, whatever its dtype and strides."""
    array = _pixels(name, value, _OF_FIELDS)
    field = _core.make_field(*array.shape)
    values = field.values
    for part in _parts(array):
        np.copyto(values[part], array[part], casting="same_kind")
    return field


def ellipses_of(name: str, value: object) -> _core.Field:
    """An ellipse for each pixel, row 0 on top: two radii and the angle of the first."""
    array = numbers(name, value)
    if array.ndim != 3 or array.shape[2] != 3 or array.size == 0:
        raise BadRequest(name, f"of shape {array.shape}", "must be rows x columns x 3, at least 1 x 1 x 3")
    _pixels(name, array[:, :, 0], _OF_FIELDS)
    return _core.ellipse_field(np.ascontiguousarray(array, dtype=np.float64))


def importance_of(field: object, ellipses: object) -> _core.Field | None:
    """The field of either argument; None without both."""
    if field is not None and ellipses is not None:
        raise BadRequest("ellipses", "", "cannot be used with field")
    if ellipses is not None:
        return ellipses_of("ellipses", ellipses)
    return None if field is None else field_of("field", field)


def mask_of(name: str, value: object) -> _core.Mask:
    """A mask, row 0 on top: points may lie where a number is not 0."""
    array = _pixels(name, value, _OF_MASKS)
    mask = _core.make_mask(*array.shape)
    values = mask.values
    for part in _parts(array):
        if array.dtype.kind == "f" and not (finite := np.isfinite(array[part])).all():
            wrong = array[part][~finite][0]
            raise BadRequest(name, f"{wrong}", "must be finite numbers, 0 where no point may lie")
        values[part] = array[part] != 0
    return mask


def shape_of(field: _core.Field | None) -> Extent | None:
    """The domain of a field: its shape, the longer side 1. None if there is none."""
    return None if field is None else _core.domain_around([], {}, field)


def path_bytes(name: str, value: str | bytes | os.PathLike[Any]) -> bytes:
    """A path for the library. "-" is a file of that name, not standard input."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{name} must be a path, not {shown(value)}")
    try:
        path = os.fsencode(value)
    except UnicodeEncodeError:  # a surrogate that os.fsdecode does not make
        raise BadRequest(name, shown(value), "must have no surrogate that stands for no byte") from None
    if b"\0" in path:
        raise BadRequest(name, shown(path), "must have no NUL")
    return b"./-" if path == b"-" else path
