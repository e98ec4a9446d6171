#!python
"""The command lacuna of a Python environment: becomes the program beside the module lacuna."""

import os
import signal
import sys

# Python answers these signals itself, or ignores them, and the program would inherit the latter.
# Whether the caller ignored SIGPIPE is not known any more.
if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
signal.signal(signal.SIGXFSZ, signal.SIG_DFL)

from importlib.util import find_spec  # noqa: E402

spec = find_spec("lacuna")  # does not import it, which would take longer
folders = (spec and spec.submodule_search_locations) or []
programs = [path for folder in folders if os.path.isfile(path := os.path.join(folder, "lacuna"))]
if not programs:
    where = ", ".join(folders) or "the Python module lacuna, which is not installed"
    sys.exit(f"{sys.argv[0]}: the program is missing in {where}")
os.execv(programs[0], sys.argv)
