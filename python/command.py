#!python
"""The command lacuna of a Python environment: becomes the program beside the module lacuna."""

import os
import signal
import sys
from importlib.util import find_spec

spec = find_spec("lacuna")  # does not import it, which would take longer
folders = (spec and spec.submodule_search_locations) or []
programs = [path for folder in folders if os.path.isfile(path := os.path.join(folder, "lacuna"))]
if not programs:
    sys.exit(f"{sys.argv[0]}: the Python module lacuna, which holds the program, is not installed")
# Python ignores these signals, and programs inherit that.
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
os.execv(programs[0], sys.argv)
