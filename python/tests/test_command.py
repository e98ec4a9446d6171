"""The command that pip installs with the module behaves as the program itself does."""

from __future__ import annotations

import os
import signal
import subprocess
import sysconfig
import time
from pathlib import Path

from conftest import PROGRAM

import lacuna


def test_the_version_is_the_modules() -> None:
    run = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == f"lacuna {lacuna.__version__}\n"


def test_what_it_refuses_is_one_line_and_exit_code_2() -> None:
    run = subprocess.run([PROGRAM, "sample", "--radius", "no"], capture_output=True, text=True)
    assert (run.returncode, run.stdout, run.stderr.count("\n")) == (2, "", 1)
    assert run.stderr.startswith("lacuna: --radius no: ")


def catches_interrupts(process: int) -> bool:
    """Whether Python has become the program, and that has its handler."""
    if "python" in os.path.basename(os.readlink(f"/proc/{process}/exe")):
        return False
    status = Path(f"/proc/{process}/status").read_text()
    caught = int(status.split("SigCgt:")[1].split()[0], 16)
    return bool(caught & 1 << signal.SIGINT - 1)


def test_an_interrupt_is_answered_in_one_line() -> None:
    options = ["sample", "--radius", "0.0002", "-o", "/dev/null"]
    with subprocess.Popen([PROGRAM, *options], stderr=subprocess.PIPE, text=True) as run:
        while not catches_interrupts(run.pid):
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        _, message = run.communicate()
    assert message == "lacuna: interrupted, nothing was written\n"
    assert run.returncode == 128 + signal.SIGINT


def test_a_closed_pipe_ends_it_silently() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    run = subprocess.run([PROGRAM, "help"], stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert (run.returncode, run.stderr) == (-signal.SIGPIPE, b"")


def test_completions_are_installed_beside_it() -> None:
    folder = Path(sysconfig.get_path("data")) / "share"
    for file in (
        "bash-completion/completions/lacuna",
        "zsh/vendor-completions/_lacuna",
        "fish/vendor_completions.d/lacuna.fish",
    ):
        assert "lacuna" in (folder / file).read_text()
