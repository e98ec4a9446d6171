# The interface of lacuna._core, the compiled part of the package.
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

version: str

class Field:
    @property
    def has_ellipses(self) -> bool: ...
    @property
    def rows(self) -> int: ...
    @property
    def columns(self) -> int: ...
    @property
    def values(self) -> npt.NDArray[np.float64]: ...

class Mask:
    @property
    def rows(self) -> int: ...
    @property
    def columns(self) -> int: ...
    @property
    def values(self) -> npt.NDArray[np.uint8]: ...

class Tone:
    black: float
    white: float
    auto_levels: bool
    invert: bool
    gamma: float
    min_importance: float
    along: float
    sharpen: int
    sharpen_amount: float
    def __init__(self) -> None: ...

class Classes:
    names: list[str]
    distances: list[float]
    weights: list[float]
    def __init__(self) -> None: ...

def distances_by_sum(radii: list[float]) -> list[float]: ...
def distances_by_union(radii: list[float]) -> list[float]: ...

class Request:
    width: float
    height: float
    torus: bool
    backend: str
    device: str
    threads: int
    radius: float | None
    count: int | None
    scale: float | None
    border: float
    classes: Classes
    lines_per_radius: int | None
    progressive: bool
    limit: int | None
    snap: bool
    uniform_x: bool
    round_size: int
    seed: int
    memory_limit: int
    mode: str
    metric: str
    def __init__(self) -> None: ...

class RelaxOptions:
    width: float
    height: float
    torus: bool
    backend: str
    device: str
    threads: int
    iterations: int
    gaussian: int
    gaussian_distance: float
    measure: bool
    def __init__(self) -> None: ...

class Moves:
    iterations: int
    gaussian: int
    gaussian_distance: float
    def __init__(self) -> None: ...

class Claim:
    width: float
    height: float
    torus: bool
    radius: float
    scale: float
    border: float
    classes: Classes
    edge: float
    tolerance: float | None
    distances_only: bool
    def __init__(self) -> None: ...

def make_field(rows: int, columns: int) -> Field: ...
def ellipse_field(ellipses: npt.NDArray[np.float64]) -> Field: ...
def make_mask(rows: int, columns: int) -> Mask: ...
def sample(
    request: Request,
    field: Field | None,
    mask: Mask | None,
    keep: npt.NDArray[np.float64] | None,
    keep_classes: npt.NDArray[np.uint8] | None,
    moves: Moves,
    progress: Callable[[int, int], object] | None,
) -> dict[str, Any]: ...
def sample_many(
    request: Request, seeds: list[int], progress: Callable[[int, int], object] | None
) -> list[dict[str, Any]]: ...
def relax(
    points: npt.NDArray[np.float64],
    field: Field | None,
    options: RelaxOptions,
    progress: Callable[[int, int], object] | None,
) -> dict[str, Any]: ...
class Ink:
    name: str
    hex: str
    def __init__(self, name: str, colour: list[int]) -> None: ...

def inks_of(text: str) -> list[Ink]: ...

class Picture:
    def __init__(self, content: bytes) -> None: ...

def read_picture(path: bytes) -> Picture: ...

class StippleOptions:
    request: Request
    tone: Tone
    relax: int | None
    inks: list[Ink]
    black_ink: float | None
    ink_counts: list[int]
    size_by_tone: float
    keep_inside: bool
    start: str
    metric: str
    def __init__(self) -> None: ...

def stipple(
    picture: Picture,
    options: StippleOptions,
    progress: Callable[[int, int], object] | None,
) -> dict[str, Any]: ...
def progressive_order(
    points: npt.NDArray[np.float64],
    field: Field | None,
    width: float,
    height: float,
    torus: bool,
    seed: int,
) -> npt.NDArray[np.uint32]: ...
def settle(
    request: Request,
    mode: str | None,
    metric: str | None,
    relax: int | None,
    gaussian: int,
    has_ellipses: bool,
) -> int: ...
class Saved:
    width: float
    height: float
    torus: bool
    is_relaxed: bool
    radius: float
    least_radius: float
    layers: list[tuple[Ink, int]]
    classes: list[str]
    mode: str
    seed: int
    maximal: bool
    scale: float
    options: str
    levels: list[tuple[float, int]]
    def __init__(self) -> None: ...

def write_points(
    path: bytes,
    points: npt.NDArray[np.float64],
    saved: Saved,
    radii: npt.NDArray[np.float64] | None,
    class_of: npt.NDArray[np.uint8] | None,
    ellipses: npt.NDArray[np.float64] | None,
) -> None: ...
def read_polygons(path: bytes, as_lines: bool) -> dict[str, Any]: ...
def domain_around(
    sets: list[tuple[list[npt.NDArray[np.float64]], bool, float]],
) -> tuple[float, float]: ...
def draw_mask(
    sets: list[tuple[list[npt.NDArray[np.float64]], bool, float]],
    width: float,
    height: float,
    edge: float,
    memory_limit: int,
) -> Mask: ...
def verify(
    points: npt.NDArray[np.float64],
    claim: Claim,
    field: Field | None,
    mask: Mask | None,
    polygons: list[tuple[list[npt.NDArray[np.float64]], bool, float]],
    keep: npt.NDArray[np.float64] | None,
    class_of: npt.NDArray[np.uint8] | None,
) -> dict[str, Any]: ...
def analyze(
    points: list[npt.NDArray[np.float64]],
    width: float,
    height: float,
    torus: bool,
    max_frequency: float,
    threads: int,
    progress: Callable[[int, int], object] | None,
) -> dict[str, Any]: ...
def devices() -> list[tuple[str, str, str, int, int, str]]: ...
