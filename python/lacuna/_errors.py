"""The exceptions of lacuna. They have the same names as in the C++ library."""

from __future__ import annotations

# Control characters, which paths may contain, are escaped: a message is one line.
_CONTROLS = {code: f"\\x{code:02x}" for code in (*range(32), 127)}


class Error(Exception):
    """The base class of lacuna's exceptions."""


class BadRequest(Error, ValueError):
    """An invalid value. The message names the argument, its value and what is allowed.

    Attributes
    ----------
    argument : str
        The argument's name.
    value : str
        What the argument was; may be empty.
    reason : str
        What is allowed.
    """

    def __init__(self, argument: str, value: str, reason: str) -> None:
        super().__init__(argument, value, reason)
        self.argument, self.value, self.reason = argument, value, reason

    def __str__(self) -> str:
        what = " ".join(part for part in (self.argument, self.value) if part)
        return ": ".join(part for part in (what, self.reason) if part).translate(_CONTROLS)

    def called(self, argument: str) -> BadRequest:
        """This error of an argument that the caller knows by another name."""
        return type(self)(argument, self.value, self.reason)


class MemoryRefused(BadRequest, MemoryError):
    """The set asked for would take more memory than there is, or than ``memory_limit``."""


class Unavailable(Error, RuntimeError):
    """The backend or device asked for is missing or cannot be used."""


class DeviceError(Error, RuntimeError):
    """A device failed during the work. Names the call, the error code and the driver's log."""


class FileError(Error, OSError):
    """A file could not be read or written. Names the path and the reason."""

    def __init__(self, message: str) -> None:
        super().__init__(message.translate(_CONTROLS))
