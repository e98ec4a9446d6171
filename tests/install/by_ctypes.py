"""The interface for C from Python's ctypes, as other languages call it.

    by_ctypes.py LIBRARY PICTURE
"""

import ctypes
import pathlib
import sys

library, picture = sys.argv[1:]
lacuna = ctypes.CDLL(library)


class Facts(ctypes.Structure):
    _fields_ = [("width", ctypes.c_double), ("height", ctypes.c_double),
                ("radius", ctypes.c_double), ("maximal", ctypes.c_int),
                ("x", ctypes.c_double), ("y", ctypes.c_double), ("depth", ctypes.c_double)]


class Given(ctypes.Structure):
    _fields_ = [("importance", ctypes.c_void_p), ("columns", ctypes.c_size_t),
                ("rows", ctypes.c_size_t), ("kept", ctypes.c_void_p),
                ("kept_count", ctypes.c_size_t), ("allowed", ctypes.c_void_p),
                ("mask_columns", ctypes.c_size_t), ("mask_rows", ctypes.c_size_t),
                ("kept_classes", ctypes.c_void_p), ("classes", ctypes.c_void_p),
                ("outlines", ctypes.c_void_p), ("outline_count", ctypes.c_size_t)]


lacuna.lacuna_error.restype = lacuna.lacuna_version.restype = ctypes.c_char_p
lacuna.lacuna_sample.restype = lacuna.lacuna_stipple.restype = ctypes.c_void_p
lacuna.lacuna_sample.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
lacuna.lacuna_stipple.argtypes = [ctypes.c_char_p, ctypes.c_char_p, ctypes.c_size_t]
lacuna.lacuna_verify.argtypes = [ctypes.c_char_p, ctypes.c_void_p, ctypes.c_void_p,
                                 ctypes.c_size_t]
lacuna.lacuna_points.restype = ctypes.POINTER(ctypes.c_double)
lacuna.lacuna_sample_volume.restype = ctypes.c_void_p
lacuna.lacuna_sample_volume.argtypes = [ctypes.c_char_p, ctypes.c_void_p, ctypes.c_size_t]
lacuna.lacuna_layers.restype = ctypes.POINTER(ctypes.c_ubyte)
lacuna.lacuna_count.restype = ctypes.c_size_t
lacuna.lacuna_describe.restype = Facts
for name in ("points", "layers", "count", "describe", "free"):
    getattr(lacuna, "lacuna_" + name).argtypes = [ctypes.c_void_p]

made = lacuna.lacuna_sample(b"--radius 0.05 --seed 1", None)
count, points = lacuna.lacuna_count(made), lacuna.lacuna_points(made)
facts = lacuna.lacuna_describe(made)
assert 200 < count < 350, count
assert (facts.width, facts.radius, facts.maximal) == (1.0, 0.05, 1)
assert all(0 <= points[i] <= 1 for i in range(2 * count))
assert lacuna.lacuna_verify(b"--radius 0.05", None, points, count) == 1, lacuna.lacuna_error()
assert lacuna.lacuna_verify(b"--radius 0.051", None, points, count) == 0
lacuna.lacuna_free(made)

volume = lacuna.lacuna_sample_volume(b"--count 90 --domain 1x1x0.5", None, 0)
assert (lacuna.lacuna_count(volume), lacuna.lacuna_describe(volume).depth) == (90, 0.5)
lacuna.lacuna_free(volume)

kinds = b"--class trees:0.05 --class grass:0.02 --border trees:0.1"
wood = lacuna.lacuna_sample(kinds, None)
count, points = lacuna.lacuna_count(wood), lacuna.lacuna_points(wood)
classes = (ctypes.c_ubyte * count)(*lacuna.lacuna_layers(wood)[:count])
given = Given(classes=ctypes.addressof(classes))
assert set(classes) == {0, 1}
assert lacuna.lacuna_verify(kinds, ctypes.byref(given), points, count) == 1, lacuna.lacuna_error()
classes[classes[:].index(1)] = 0
assert lacuna.lacuna_verify(kinds, ctypes.byref(given), points, count) == 0
lacuna.lacuna_free(wood)

content = pathlib.Path(picture).read_bytes()
dots = lacuna.lacuna_stipple(b"--count 300 --relax 2", content, len(content))
assert lacuna.lacuna_count(dots) == 300, lacuna.lacuna_error()
lacuna.lacuna_free(dots)

assert lacuna.lacuna_sample(b"--radius -1", None) is None
assert b"radius -1" in lacuna.lacuna_error(), lacuna.lacuna_error()
print("version", lacuna.lacuna_version().decode())
