"""The sets of tests/pinned.txt, made by Python's functions: the command's bytes."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import pytest
from conftest import REPOSITORY

import lacuna

NAMES = {"count": "n", "start": "mode"}  # of Python, where they are not the option's
SIDES = {"domain": float, "on_pixels": int}  # values such as 2x1


def rows() -> list[tuple[str, str]]:
    """Hash and request of each row that Python makes."""
    lines = (REPOSITORY / "tests" / "pinned.txt").read_text().splitlines()
    parts = [line.split(" ", 2) for line in lines if line and not line.startswith("#")]
    return [(hashed, request) for hashed, doors, request in parts if "p" in doors]


def value_of(name: str, word: str) -> Any:
    if name in SIDES:
        return tuple(map(SIDES[name], word.split("x")))
    for number in (int, float):
        try:
            return number(word)
        except ValueError:
            pass
    return word


def arguments_of(words: list[str]) -> tuple[list[Any], dict[str, Any]]:
    """What a function is called with for the words of a command line; a flag has no value."""
    given: list[Any] = []
    named: dict[str, Any] = {"seed": 0}
    while words:
        word = words.pop(0)
        if not word.startswith("--"):
            given.append(REPOSITORY / word)
            continue
        name = word[2:].replace("-", "_")
        is_flag = not words or words[0].startswith("--")
        named[NAMES.get(name, name)] = True if is_flag else value_of(name, words.pop(0))
    return given, named


@pytest.mark.parametrize("pinned, request_", rows(), ids=[request for _, request in rows()])
def test_the_bytes_are_pinned(pinned: str, request_: str, tmp_path: Path) -> None:
    command, *words = request_.split()
    if command == "mask":
        columns, rows_ = map(int, words.pop(0).split("x"))
        _, named = arguments_of(words)
        made = lacuna.threshold_mask(columns, rows_, **named).astype("<u4").tobytes()
    else:
        given, named = arguments_of(words)
        lacuna_set = getattr(lacuna, command)(*given, **named)
        lacuna_set.save(tmp_path / "set.npy")
        made = (tmp_path / "set.npy").read_bytes()
    assert hashlib.sha256(made).hexdigest() == pinned
