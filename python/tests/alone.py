"""Runs where OpenCL, Vulkan and TBB cannot be opened: python/check hides them."""

import ctypes
import subprocess
import sys
from pathlib import Path

for name in ("libOpenCL.so.1", "libvulkan.so.1", "libtbb.so.12"):
    try:
        ctypes.CDLL(name)
    except OSError:
        continue
    raise SystemExit(f"{name} is not hidden")

import lacuna  # noqa: E402

made = lacuna.sample(0.02, torus=True, seed=1)
assert lacuna.verify(made).maximal
assert len(lacuna.stipple([[0.0, 1.0], [0.5, 0.2]], 50, seed=1)) == 50
assert lacuna.analyze(made).sets == 1
assert lacuna.draw_mask([[(0, 0), (1, 0), (0, 1)]], 0.1).any()
for device in lacuna.devices():
    if device.backend in ("opencl", "vulkan"):
        assert "loader" in device.unusable, device
        try:
            lacuna.sample(0.1, backend=device.backend)
        except lacuna.Unavailable as error:
            assert "loader" in str(error)
        else:
            raise SystemExit(f"{device.backend} is not hidden")
# Python may have loaded an OpenSSL of its own, of another version.
assert "lacuna/libcrypto" not in Path("/proc/self/maps").read_text()
program = Path(sys.executable).with_name("lacuna")
options = ["sample", "--radius", "0.02", "--torus", "--seed", "1", "--quiet", "-o", "-"]
written = subprocess.run([program, *options], check=True, capture_output=True, text=True).stdout
assert [float(word) for word in written.split()] == made.points.ravel().tolist()
listed = subprocess.run([program, "devices"], capture_output=True, text=True).stdout
assert listed.count("loader") == 2, listed
print(f"{len(made)} points without OpenCL, Vulkan and TBB")
