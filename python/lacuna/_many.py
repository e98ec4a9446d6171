"""sample_many: makes many point sets of one request."""

from __future__ import annotations

import os
import sys
import time
from itertools import islice
from typing import (
    TYPE_CHECKING,
    Any,
    Collection,
    Iterable,
    Iterator,
    Literal,
    Sized,
    SupportsFloat,
    overload,
)

from . import _core
from ._arguments import choice, flag, pair, shown, whole
from ._classes import classes_of
from ._errors import MemoryRefused
from ._results import PointSet
from ._runs import (
    MODES,
    MOST_64,
    checked_progress,
    fill,
    place,
    refuse_what_is_for_fields,
    request_of,
    set_of,
    set_size,
)

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._arguments import Whole

    from ._classes import ClassSizes
    from ._runs import Progress

# The most sets in a batch, and for an iterator the most points. A batch is made by one call of the
# library, and its first set is handed out only when all of them are made.
_MOST_SETS_AHEAD = 4096
_MOST_POINTS_AHEAD = 2**20
_BYTES_OF_A_POINT = 16
_BYTES_OF_A_SET = 1000  # a PointSet without its points; a little less than measured


def _made(
    request: _core.Request,
    seeds: Iterable[Whole],
    expected: int | None,
    progress: Progress | None,
) -> Iterator[dict[str, Any]]:
    """Samples once for each seed. Yields the attributes of PointSets.

    Seeds are read and sets are made a batch at a time. If ``expected`` is given, it is the number
    of seeds, and all sets are wanted. If it is None, the first batch is one set, and each further
    batch has twice as many, up to _MOST_POINTS_AHEAD points.
    """
    remaining = iter(seeds)
    done, size = 0, 1 if expected is None else _MOST_SETS_AHEAD
    while batch := [whole("seeds", seed, 0, MOST_64) for seed in islice(remaining, size)]:
        started = time.perf_counter()
        all_made = _core.sample_many(request, batch, _progress_of(progress, done, expected))
        total = time.perf_counter() - started
        for seed, made in zip(batch, all_made):
            request.seed = seed
            made["seconds"] = {"total": total / len(batch)}
            asked = request_of(request, False, made["lines_per_radius"])
            yield set_of(made, request, False, None, asked)
        done += len(batch)
        points = sum(len(made["points"]) for made in all_made)
        if expected is None and 2 * points <= _MOST_POINTS_AHEAD:
            size = min(2 * size, _MOST_SETS_AHEAD)


def _progress_of(
    progress: Progress | None, before: int, expected: int | None
) -> Progress | None:
    """A progress for one batch, which adds the ``before`` sets of earlier batches."""
    if progress is None:
        return None
    tell = progress

    def told(done: int, of_batch: int) -> None:
        tell(before + done, before + of_batch if expected is None else expected)

    return told


@overload
def sample_many(
    seeds: Iterator[Whole],
    radius: SupportsFloat | None = ...,
    n: Whole | None = ...,
    *,
    classes: ClassSizes | None = ...,
    between: str | npt.ArrayLike = ...,
    domain: tuple[SupportsFloat, SupportsFloat] = ...,
    torus: bool = ...,
    mode: Literal["exact", "lines"] = ...,
    progressive: bool = ...,
    limit: Whole | None = ...,
    lines_per_radius: Whole | None = ...,
    snap: bool = ...,
    uniform_x: bool = ...,
    round_size: Whole = ...,
    backend: str = ...,
    device: int | str | None = ...,
    threads: Whole = ...,
    memory_limit: Whole | None = ...,
    progress: Progress | None = ...,
) -> Iterator[PointSet]: ...
@overload
def sample_many(
    seeds: Collection[Whole],
    radius: SupportsFloat | None = ...,
    n: Whole | None = ...,
    *,
    classes: ClassSizes | None = ...,
    between: str | npt.ArrayLike = ...,
    domain: tuple[SupportsFloat, SupportsFloat] = ...,
    torus: bool = ...,
    mode: Literal["exact", "lines"] = ...,
    progressive: bool = ...,
    limit: Whole | None = ...,
    lines_per_radius: Whole | None = ...,
    snap: bool = ...,
    uniform_x: bool = ...,
    round_size: Whole = ...,
    backend: str = ...,
    device: int | str | None = ...,
    threads: Whole = ...,
    memory_limit: Whole | None = ...,
    progress: Progress | None = ...,
) -> list[PointSet]: ...
def sample_many(
    seeds: Collection[Whole] | Iterator[Whole],
    radius: SupportsFloat | None = None,
    n: Whole | None = None,
    *,
    classes: ClassSizes | None = None,
    between: str | npt.ArrayLike = "sum",
    domain: tuple[SupportsFloat, SupportsFloat] = (1, 1),
    torus: bool = False,
    mode: Literal["exact", "lines"] = "exact",
    progressive: bool = False,
    limit: Whole | None = None,
    lines_per_radius: Whole | None = None,
    snap: bool = False,
    uniform_x: bool = False,
    round_size: Whole = 0,
    backend: str = "auto",
    device: int | str | None = None,
    threads: Whole = 0,
    memory_limit: Whole | None = None,
    progress: Progress | None = None,
) -> list[PointSet] | Iterator[PointSet]:
    """Make many sets of one request, one for each seed. Small sets are made in parallel.

    Each set is the same as that of ``sample`` with this seed. Sets of up to about 20,000 points are
    made on one thread each, several at the same time; larger sets are made one after another. Seeds
    are read a batch at a time.

    Parameters
    ----------
    seeds : iterable of int
        Such as ``range(1000)``. Each is from 0 to 2^64 - 1. For an iterator, such as
        ``itertools.count()`` or a generator, the sets come one at a time and are not kept.
    radius, n, classes, between, domain, torus, mode, progressive, limit, lines_per_radius, snap, uniform_x, round_size, \
backend, device, threads, memory_limit
        As for ``sample``; memory_limit is for each set.
    progress : callable, optional
        Called with the number of sets that are done and the number of all sets; for an iterator
        the latter is the number of seeds that have been read.

    Returns
    -------
    list of PointSet, or for an iterator an iterator of PointSet
        In the order of the seeds. The ``seconds`` of a set are the time of its batch, divided by
        the number of sets in it.

    Raises
    ------
    BadRequest, TypeError, MemoryRefused, Unavailable, DeviceError, KeyboardInterrupt
        As ``sample``.

    Examples
    --------
    >>> import lacuna
    >>> tiles = lacuna.sample_many(range(100), n=256, torus=True)
    >>> len(tiles), tiles[7].seed
    (100, 7)
    >>> bool((tiles[7].points == lacuna.sample(n=256, torus=True, seed=7).points).all())
    True
    >>> import itertools
    >>> for tile in lacuna.sample_many(itertools.count(), n=256, torus=True):
    ...     if tile.seed == 200:
    ...         break
    """
    request = _core.Request()
    request.mode = choice("mode", mode, MODES)
    refuse_what_is_for_fields(mode, None, None)
    request.classes = classes_of(classes, between)
    set_size(request, {"radius": radius, "n": n}, bool(request.classes.names))
    if isinstance(seeds, (str, bytes)) or not isinstance(seeds, Iterable):
        raise TypeError(f"seeds must be an iterable of int, not {shown(seeds)}")
    checked_progress(progress)
    place(request, pair("domain", domain), torus, backend, device, threads)
    fill(
        request,
        seed=0,
        limit=limit,
        lines_per_radius=lines_per_radius,
        round_size=round_size,
        memory_limit=memory_limit,
    )
    request.progressive = flag("progressive", progressive)
    request.snap = flag("snap", snap)
    request.uniform_x = flag("uniform_x", uniform_x)
    expected = None
    if isinstance(seeds, Sized):
        expected = _number_of(seeds)
        _refuse_more_sets(expected, request.count or 1)
    sets = (PointSet(**one) for one in _made(request, seeds, expected, progress))
    return sets if isinstance(seeds, Iterator) else list(sets)


def _number_of(seeds: Sized) -> int:
    try:
        return len(seeds)
    except OverflowError:  # a range that is longer than a list can be
        return sys.maxsize


def _refuse_more_sets(sets: int, points: int) -> None:
    """Refuses sets that together take more memory than the machine has."""
    needed = sets * (_BYTES_OF_A_SET + _BYTES_OF_A_POINT * points)
    available = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    if needed > available:
        raise MemoryRefused(
            f"seeds of {sets} sets: take at least {needed / 1e9:.3g} GB together, of "
            f"{available / 1e9:.3g} GB; with iter(seeds) the sets come one at a time",
            "seeds",
        )
