"""verify and analyze give the right results."""

from __future__ import annotations

import re

import numpy as np
import pytest

import lacuna


def test_a_verdict_says_why_a_claim_does_not_hold() -> None:
    assert lacuna.verify(lacuna.sample(0.2, seed=1)).reason == ""
    counted = lacuna.sample(n=50, seed=1)
    refuted = lacuna.verify(counted)
    assert not refuted and "distances_only=True" in refuted.reason
    assert refuted.reason in repr(refuted)
    assert lacuna.verify(counted, distances_only=True).reason == ""
    assert "not meant" not in lacuna.verify(counted.points, counted.radius).reason
    near = lacuna.verify([(0.1, 0.1), (0.9, 0.9), (0.1, 0.2)], 0.15)
    assert near.kept is False and near.closest_pair == (0, 2)
    assert near.reason == "points 0 and 2 are 0.1 apart, less than their limit 0.15"
    assert "point 1 lies outside" in lacuna.verify([(0.1, 0.1), (0.5, 2)], 0.1).reason


def test_results_say_in_a_sentence_what_was_found() -> None:
    made = lacuna.sample(0.2, seed=1)
    said = str(lacuna.verify(made))
    assert re.fullmatch(
        rf"{len(made)} points are a maximal set; the closest two are 0.2\d+ apart; "
        r"the largest gap is 0.1\d+ from the nearest point",
        said,
    )
    only = str(lacuna.verify(made, distances_only=True))
    assert only.startswith(f"{len(made)} points are far enough apart; the closest two are")
    assert str(lacuna.verify(made.points[1:], 0.2)).startswith("refuted: the spot (")
    assert str(lacuna.verify([(0.5, 0.5)], 1)) == (
        "1 points are a maximal set; the largest gap is 0.707107 from the nearest point"
    )
    assert str(lacuna.analyze([made, made])).startswith(f"2 sets of {len(made)} points on average, ")
    assert ", psi_6 0." in str(lacuna.analyze(made))


def test_analyze_gives_arrays_and_numbers() -> None:
    sets = [lacuna.sample(0.03, torus=True, seed=seed) for seed in range(4)]
    found = lacuna.analyze(sets)
    assert found.sets == 4
    assert found.frequency.shape == found.power.shape == found.anisotropy_db.shape
    assert found.distance.shape == found.pair_correlation.shape
    assert found.distance[0] == pytest.approx(0.025)
    # Blue noise has hardly any power at low frequencies, and a peak near 1.
    assert found.power[found.frequency < 0.5].mean() < 0.2
    assert found.power[(found.frequency > 1) & (found.frequency < 1.2)].mean() > 1.3
    assert found.least_distance is not None and found.least_distance >= 0.03
    assert found.mean_count == np.mean([len(one) for one in sets])


def test_analyze_of_an_array_is_that_of_the_list() -> None:
    sets = np.random.default_rng(1).random((3, 100, 2))
    one = lacuna.analyze(sets, torus=True)
    two = lacuna.analyze(list(sets), torus=True)
    assert (one.power == two.power).all() and one.sets == 3
    assert lacuna.analyze([(0.1, 0.1), (0.5, 0.5)]).sets == 1


def test_relaxing_makes_shares_more_equal() -> None:
    made = lacuna.sample(n=500, torus=True, seed=1)
    relaxed = lacuna.relax(made, measure=True)
    assert relaxed.torus and relaxed.domain == (1, 1) and relaxed.evenness is not None
    assert relaxed.evenness.after < relaxed.evenness.before / 2
    at_once = lacuna.sample(n=500, torus=True, seed=1, relax=15, mode="exact")
    assert at_once.sha256 == relaxed.sha256
    stratified = lacuna.sample(n=500, torus=True, seed=1, relax=15)
    assert stratified.mode == "stratified" and stratified.sha256 != relaxed.sha256
    assert stratified.scale is None and stratified.rounds == 0


def test_devices_lists_every_backend() -> None:
    listed = lacuna.devices()
    assert {device.backend for device in listed} == {"cpu", "opencl", "vulkan", "reference"}
    assert all(device.usable == (device.unusable == "") for device in listed)
