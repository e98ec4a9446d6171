"""Runs the tests of the page, like `python3 -m unittest`, and prints how long the page takes."""

import pathlib
import sys
import unittest

if __name__ == "__main__":
    tests = unittest.defaultTestLoader.discover(str(pathlib.Path(__file__).parent), "test_*.py")
    result = unittest.TextTestRunner(verbosity=2).run(tests)
    sys.exit(not (result.wasSuccessful() and result.testsRun > 0))
