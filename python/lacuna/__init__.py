"""Blue-noise point sets: numpy in and numpy out.

>>> import lacuna
>>> points = lacuna.sample(0.01, torus=True, seed=1).points
>>> points.shape[1], points.dtype.name
(2, 'float64')

``sample`` makes maximal Poisson-disk sets, ``stipple`` turns pictures into dots, and ``relax``
makes any set more even. ``sample_surface`` and ``sample_volume`` make sets on meshes and in volumes.
``verify`` proves or refutes that a set is maximal, and ``analyze``
measures it. ``threshold_mask`` makes tiles for dithering. ``read_polygons`` and ``draw_mask`` turn outlines into masks. ``devices`` lists
backends and devices. ``lacuna.qmc`` has an engine like those in scipy.stats.qmc.
"""

from typing import TYPE_CHECKING, Any

from . import _core
from ._analysis import Analysis, analyze
from ._devices import Device, devices
from ._errors import BadRequest, DeviceError, Error, FileError, MemoryRefused, Unavailable
from ._order import order
from ._polygons import Polygons, domain_around, draw_mask, read_lines, read_polygons
from ._relax import relax
from ._sample import sample, sample_many
from ._sets import Evenness, PointSet, Relaxed, Stippling
from ._space import SpaceSet, SpaceVerdict, sample_surface, sample_volume, verify_surface, verify_volume
from ._stipple import stipple
from ._thresholds import threshold_mask
from ._verify import Verdict, verify

__version__: str = _core.version
__all__ = [
    "Analysis", "BadRequest", "Device", "DeviceError", "Error", "Evenness", "FileError",
    "MemoryRefused", "PointSet", "Polygons", "Relaxed", "SpaceSet", "SpaceVerdict", "Stippling", "Unavailable", "Verdict",
    "analyze", "devices", "domain_around", "draw_mask", "order", "read_lines", "read_polygons",
    "relax", "sample", "sample_many", "sample_surface", "sample_volume", "stipple", "threshold_mask", "verify",
    "verify_surface", "verify_volume",
]  # fmt: skip

if TYPE_CHECKING:
    from . import qmc as qmc


def __getattr__(name: str) -> Any:
    """Imports ``lacuna.qmc`` when it is first used, because it needs scipy."""
    if name == "qmc":
        import importlib

        return importlib.import_module(".qmc", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


# Help and tracebacks then name the classes as users import them.
for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
