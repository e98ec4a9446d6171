"""The recipe for conda has the project's version and all packages that CMake asks for; its script
configures Lacuna with options that there are, and its tests pass. Nothing is downloaded or built:
whether conda-forge has these packages is not tested.

    conda_recipe.py SOURCE SCRATCH VERSION COMPILER COMMAND
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

try:
    import yaml
except ImportError:
    sys.exit("SKIPPED: Python has no yaml (Debian: python3-yaml)")

source, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
version, compiler, command = sys.argv[3:]
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
recipe = yaml.safe_load((source / "cmake/conda/recipe.yaml").read_text())
assert recipe["context"]["version"] == version, f"{recipe['context']}, but {version}"

# conda-forge's names of what CMakeLists.txt looks for, where they are others.
NAMES = {"tbb": "tbb-devel", "random123_include_dir": "random123", "pkgconfig": "pkg-config",
         "highway_include_dir": "libhwy", "eigen3": "eigen", "png": "libpng", "jpeg": "libjpeg-turbo",
         "tiff": "libtiff", "libwebp": "libwebp-base", "cli11_include_dir": "cli11",
         "libheif_include_dir": "libheif", "assimp_include_dir": "assimp"}
needed = {NAMES.get(name.lower(), name.lower()) for name in re.findall(
    r"^ *(?:lacuna_need(?:_module|_header)?|find_path)\((\w+)", (source / "CMakeLists.txt").read_text(),
    re.MULTILINE)}
assert len(needed) > 15, needed
requirements = recipe["requirements"]
there = {name.split()[0] for part in requirements.values() for name in part}
there |= {pathlib.Path(one.get("target_directory", "")).name for one in recipe["source"]}
assert needed <= there, f"not in recipe.yaml: {needed - there}"

# build.sh, with a cmake that only configures Lacuna, and with the packages of this system.
(scratch / "bin").mkdir()
(scratch / "bin/cmake").write_text(f"""#!/bin/sh
case "$1$2" in -S{source}) exec {shutil.which('cmake')} "$@" -D CMAKE_CXX_COMPILER={compiler} \
    -B {scratch}/build ;; esac
""")
(scratch / "bin/cmake").chmod(0o755)
os.symlink(command, scratch / "bin/lacuna")
environment = dict(os.environ, SRC_DIR=str(source), PREFIX=str(scratch / "prefix"),
                   PATH=f"{scratch / 'bin'}:{os.environ['PATH']}")
script = source / "cmake/conda" / recipe["build"]["script"]
made = subprocess.run([script], env=environment, capture_output=True, text=True)
# CMake warns of options that the project does not have.
assert made.returncode == 0 and made.stderr == "", made.stdout + made.stderr
cache = (scratch / "build/CMakeCache.txt").read_text()
assert re.search("^LACUNA_EXTRAS:BOOL=ON$", cache, re.MULTILINE), "the library has no extras"
for line in recipe["tests"][0]["script"]:
    subprocess.run(line, shell=True, check=True, cwd=scratch, env=environment)
