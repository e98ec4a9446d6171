"""devices: lists what can run the work."""

from __future__ import annotations

from dataclasses import dataclass

from . import _core


@dataclass(frozen=True)
class Device:
    """A device that a backend can run on, or a backend that cannot run.

    Attributes
    ----------
    backend : str
        The value for the argument ``backend``.
    number : int
        The value for the argument ``device``, for opencl and vulkan.
    name, kind : str
        The name as the driver gives it; cpu, gpu or other.
    memory_bytes, largest_buffer_bytes : int
        0 if not known.
    unusable : str
        Why it cannot be used; empty if it can.
    """

    backend: str
    number: int
    name: str
    kind: str
    memory_bytes: int
    largest_buffer_bytes: int
    unusable: str

    @property
    def usable(self) -> bool:
        """Whether it can be used."""
        return not self.unusable


def devices() -> list[Device]:
    """List every backend's devices, in order of preference, like ``lacuna devices``.

    A backend that cannot be used has an entry too, whose ``unusable`` says why.

    Returns
    -------
    list of Device

    Raises
    ------
    DeviceError
        A driver is there but fails.

    Examples
    --------
    >>> import lacuna
    >>> first = lacuna.devices()[0]
    >>> first.backend, first.usable
    ('cpu', True)
    """
    listed: list[Device] = []
    for backend, name, kind, memory, largest, unusable in _core.devices():
        number = sum(device.backend == backend for device in listed)
        listed.append(Device(backend, number, name, kind, memory, largest, unusable))
    return listed
