"""Fixtures and helpers of the tests: the command, the backends of this machine, and a field."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable

import numpy as np
import numpy.typing as npt
import pytest

import lacuna

REPOSITORY = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.executable).with_name("lacuna")  # the command, which pip installs with the module
BACKENDS = ("cpu", "opencl", "vulkan", "reference")

Command = Callable[..., npt.NDArray[np.float64]]


def required(name: str) -> bool:
    """Whether CI requires it: a test then fails instead of being skipped if it is missing."""
    return name in os.environ.get("LACUNA_REQUIRE", "").split(",")


def refused(
    error: type[Exception],
    argument: str,
    call: Callable[..., object],
    *args: Any,
    **kwargs: Any,
) -> None:
    """Calls ``call``, which must raise ``error``: one line that begins with the argument."""
    with pytest.raises(error) as caught:
        call(*args, **kwargs)
    message = str(caught.value)
    assert message.startswith(argument), message
    assert "\n" not in message
    if isinstance(caught.value, lacuna.BadRequest):
        assert caught.value.argument == argument


@pytest.fixture(scope="session")
def command(tmp_path_factory: pytest.TempPathFactory) -> Command:
    """Runs the command lacuna, and returns the points that it writes; to the file ``more``, too."""
    folder = tmp_path_factory.mktemp("command")

    def run(*arguments: object, more: Path | None = None) -> npt.NDArray[np.float64]:
        file = folder / "points.npy"
        outputs = ["-o", str(file)] + (["-o", str(more)] if more else [])
        subprocess.run([PROGRAM, *map(str, arguments), "--quiet", *outputs], check=True)
        points: npt.NDArray[np.float64] = np.load(file)
        return points

    return run


@pytest.fixture(scope="session", params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> str:
    """Each backend that can be used here."""
    name: str = request.param
    if not any(device.usable for device in lacuna.devices() if device.backend == name):
        if required(name):
            pytest.fail(f"backend {name} is not there")
        pytest.skip(f"backend {name} is not there")
    return name


@pytest.fixture(scope="session")
def ramp() -> npt.NDArray[np.float64]:
    """A field that rises from 0 on the left to 1 on the right."""
    return np.linspace(0, 1, 48) * np.ones((32, 1))
