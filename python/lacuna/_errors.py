"""The exceptions of lacuna, under the names that the C++ library has for them."""

from __future__ import annotations

# What the library calls what Python spells in another way.
_SPELLED = {"count": "n", "iterations": "iterations", "sets": "points"}


# A path may hold them; a message is one line.
_CONTROLS = {code: f"\\x{code:02x}" for code in (*range(32), 127)}


class Error(Exception):
    """What all exceptions of lacuna are."""

    def __init__(self, message: str, argument: str = "") -> None:
        super().__init__(message)


class BadRequest(Error, ValueError):
    """A value that cannot be met. The message names the argument, its value and what is allowed.

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
        """The same of an argument of another name."""
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
    """The backend or device asked for is not there."""


class DeviceError(Error, RuntimeError):
    """A device failed in the middle of the work; names the call, the code and the driver's log."""


class FileError(Error, OSError):
    """A picture could not be read: names the path and the reason."""

    def __init__(self, message: str, argument: str = "") -> None:
        super().__init__(message.translate(_CONTROLS))
