"""The rows of tests/refusals.txt that Python refuses, too: in the command's words, but arguments
have Python's names."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import REPOSITORY
from translated import NAMES, call_of

import lacuna

LINES = (REPOSITORY / "tests" / "refusals.txt").read_text().splitlines()
ROWS = [
    line.partition(" ")[2].split(" => ") for line in LINES if re.match("[a-z0-9]*p[a-z0-9]* ", line)
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of the table."""
    made = tmp_path_factory.mktemp("refusals")
    for line in LINES:
        name, _, content = line.removeprefix("= ").partition(" ")
        if line.startswith("= ") and "/" not in name and content[:1] not in "-=":
            (made / name).write_text(content.replace("\\n", "\n"))
    return made


def python_name(option: str) -> str:
    return NAMES.get(option, option.replace("-", "_"))


def in_python(message: str) -> str:
    """Options are arguments, arrays have no names, and words are in quotes."""
    message = re.sub("^[A-Z]+ ", lambda argument: argument[0].lower(), message)
    names = "--([a-z-]+)|\\ba (count)\\b"
    message = re.sub(names, lambda one: python_name(one[1] or one[2]), message)
    message = re.sub(r" \w+\.(csv|pgm|txt)\b", "", message)
    return re.sub("^(mode|metric) ([a-z]+): must be", r"\1 '\2': must be", message)


@pytest.mark.parametrize(("request_", "message"), ROWS, ids=[row[0] for row in ROWS])
def test_a_row_is_refused(request_: str, message: str, folder: Path) -> None:
    with pytest.raises((lacuna.BadRequest, lacuna.MemoryRefused)) as caught:
        call_of(request_, folder)()
    expected = re.escape(in_python(message)).replace(re.escape("<...>"), ".+")
    assert re.fullmatch(expected, str(caught.value))
    assert str(caught.value).startswith(caught.value.argument)
