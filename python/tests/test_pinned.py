"""The sets of tests/pinned.txt, made by Python's functions: the command's bytes."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
import pytest
from conftest import REPOSITORY
from translated import call_of

import lacuna


def rows() -> list[tuple[str, str]]:
    """Hash and request of each row that Python makes."""
    lines = (REPOSITORY / "tests" / "pinned.txt").read_text().splitlines()
    parts = [line.split(" ", 2) for line in lines if line and not line.startswith("#")]
    return [(hashed, request) for hashed, doors, request in parts if "p" in doors]


@pytest.mark.parametrize("pinned, request_", rows(), ids=[request for _, request in rows()])
def test_the_bytes_are_pinned(pinned: str, request_: str, tmp_path: Path) -> None:
    made = call_of(request_, REPOSITORY)()
    path = tmp_path / "set.npy"
    if isinstance(made, lacuna.PointSet):
        made.save(path)
    elif isinstance(made, (lacuna.Relaxed, lacuna.SpaceSet)):
        np.save(path, made.points)
    else:  # a mask of thresholds
        path.write_bytes(made.astype("<u4").tobytes())
    assert hashlib.sha256(path.read_bytes()).hexdigest() == pinned
