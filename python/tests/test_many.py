"""Many sets of one request: those of each seed alone, in memory for one batch."""

from __future__ import annotations

import gc
import itertools
import weakref
from typing import Iterator

import pytest

import lacuna


def test_many_seeds_give_the_sets_of_each_alone() -> None:
    told: list[tuple[int, int]] = []
    made = lacuna.sample_many(
        range(5, 200), radius=0.1, torus=True, progress=lambda *done: told.append(done)
    )
    assert [one.seed for one in made] == list(range(5, 200))
    for one in made[::20]:
        alone = lacuna.sample(0.1, torus=True, seed=one.seed)
        assert one.sha256 == alone.sha256 and one.rounds == alone.rounds
        assert one.report()["request"]["seed"] == one.seed
    assert all(expected == 195 for _, expected in told)
    assert lacuna.sample_many([], n=10) == []


def test_seeds_of_an_iterator_are_read_as_sets_are_taken() -> None:
    read: list[int] = []

    def seeds() -> Iterator[int]:
        for seed in itertools.count():
            read.append(seed)
            yield seed

    for made in lacuna.sample_many(seeds(), n=1000):
        assert made.sha256 == lacuna.sample(n=1000, seed=made.seed).sha256
        assert len(read) <= 2 * made.seed + 1
        if made.seed == 40:
            break
    large = lacuna.sample_many(itertools.count(), n=300_000)
    assert next(large).seed == 0 and next(large).seed == 1
    with pytest.raises(lacuna.BadRequest, match="seeds"):
        list(lacuna.sample_many(iter([1, -1]), n=10))


def test_sets_of_an_iterator_are_not_kept() -> None:
    sets = lacuna.sample_many(itertools.count(), n=5)
    taken = [weakref.ref(next(sets)) for _ in range(200)]
    gc.collect()
    assert not any(one() for one in taken[:50])


def test_more_seeds_than_a_list_of_sets_has_room_for_are_refused() -> None:
    for many in (10**12, 10**20):
        with pytest.raises(lacuna.MemoryRefused, match=r"^seeds of \d+ sets.*iter\(seeds\)"):
            lacuna.sample_many(range(many), n=5)
        assert next(lacuna.sample_many(iter(range(many)), n=5)).seed == 0


def test_seeds_that_make_no_sense_are_refused() -> None:
    for wrong, error in (([-1], ValueError), ([1.5], TypeError), (7, TypeError), ("12", TypeError)):
        with pytest.raises(error, match="seeds"):
            lacuna.sample_many(wrong, n=10)  # type: ignore[arg-type]
