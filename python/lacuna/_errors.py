"""The exceptions of lacuna. They have the same names as in the C++ library."""

from __future__ import annotations

import re

# Python's arguments for options of the library. For all other options, _ replaces -.
_SPELLED = {"class": "classes", "count": "n", "sets": "points"}

# Options of the command that the library's messages name, and its word for n.
_OPTION = re.compile(r"(?<![^\s(])(--[a-z][a-z-]+|uniform-x|lines-per-radius|a count)\b")

# Control characters, which paths may contain, are escaped: a message is one line.
_CONTROLS = {code: f"\\x{code:02x}" for code in (*range(32), 127)}


def _argument_of(option: re.Match[str]) -> str:
    """Python's argument for an option."""
    name = option[0].lstrip("-").removeprefix("a ")
    return "invert=True" if name == "invert" else _SPELLED.get(name, name.replace("-", "_"))


class Error(Exception):
    """The base class of lacuna's exceptions."""

    def __init__(self, message: str, argument: str = "") -> None:
        super().__init__(_OPTION.sub(_argument_of, message))


class BadRequest(Error, ValueError):
    """An invalid value. The message names the argument, its value and what is allowed.

    Attributes
    ----------
    argument : str
        The argument's name.
    """

    def __init__(self, message: str, argument: str = "") -> None:
        name = _SPELLED.get(argument, argument.replace("-", "_"))
        if argument and message.startswith(argument):
            message = name + message[len(argument) :]
        super().__init__(message.translate(_CONTROLS))
        self.argument = name

    def called(self, argument: str) -> BadRequest:
        """Renames the argument in this error."""
        self.args = (argument + str(self)[len(self.argument) :],)
        self.argument = argument
        return self


class MemoryRefused(Error, MemoryError):
    """The set asked for would take more memory than there is, or than ``memory_limit``.

    Attributes
    ----------
    argument : str
        The argument that is to blame.
    """

    def __init__(self, message: str, argument: str = "") -> None:
        spelled = BadRequest(message, argument)
        super().__init__(str(spelled))
        self.argument = spelled.argument


class Unavailable(Error, RuntimeError):
    """The backend or device asked for is missing or cannot be used."""


class DeviceError(Error, RuntimeError):
    """A device failed during the work. Names the call, the error code and the driver's log."""


class FileError(Error, OSError):
    """A file could not be read or written. Names the path and the reason."""

    def __init__(self, message: str, argument: str = "") -> None:
        super().__init__(message.translate(_CONTROLS))
