#!/usr/bin/env python3
"""What docs.citations says of the tests: their table in CONTRIBUTING.md, and their lines.

Every folder of host/ and tests/ is in the table of features. No folder of tests has more lines than
its cap in tests/caps.txt, and all tests have at most .35 lines more for each new line of code.
`tests/docs/test_lines.py --write` writes caps for the lines of today.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAPS = ROOT / "tests" / "caps.txt"
CODE = "host kernels shaders python/src python/lacuna web/page web/npm".split()
ALL = ("tests", "python/tests", "web/tests")
NO_TEXT = {".npy", ".pyc", ".png", ".jpg"}
PER_LINE = 0.35  # of code


def folders_in(top: str) -> list[str]:
    return sorted(f"{top}/{path.name}" for path in (ROOT / top).iterdir()
                  if path.is_dir() and path.name != "__pycache__")


def lines_in(*folders: str) -> int:
    files = (path for folder in folders for path in (ROOT / folder).rglob("*"))
    return sum(path.read_bytes().count(b"\n") for path in files
               if path.is_file() and path.suffix not in NO_TEXT)


def tests() -> list[str]:
    return [*folders_in("tests"), *ALL[1:]]


def faults_of_table():
    table = re.search(r"^\| feature \|.*?\n\n", (ROOT / "CONTRIBUTING.md").read_text(), re.M | re.S)
    for folder in [*folders_in("host"), *folders_in("tests")]:
        if f"`{folder}/`" not in (table[0] if table else ""):
            yield f"CONTRIBUTING.md: no row of the table of features names `{folder}/`"


def faults_of_lines():
    rows = [line.split(maxsplit=2) for line in CAPS.read_text().splitlines() if line[:1] not in ("", "#")]
    caps = {name: int(cap) for name, cap, *_ in rows}
    for folder in tests():
        if (lines := lines_in(folder)) > caps.get(folder, 0):
            yield f"tests/caps.txt: {folder} has {lines} lines: must be at most {caps.get(folder, 0)}"
    allowed = caps["tests"] + PER_LINE * max(0, lines_in(*CODE) - caps["code"])
    if (lines := lines_in(*ALL)) > allowed:
        yield (f"tests/caps.txt: all tests have {lines} lines: must be at most {allowed:.0f}, which are"
               f" {PER_LINE} more for a line of code than when `tests` was written")


def write() -> None:
    lines = CAPS.read_text().splitlines()
    now = {**{folder: -(-lines_in(folder) // 10) * 10 for folder in tests()},
           "code": lines_in(*CODE), "tests": -(-lines_in(*ALL) // 10) * 10}
    head = [line for line in lines if line.startswith("#")]
    CAPS.write_text("\n".join(head + [f"{name} {cap}" for name, cap in now.items()]) + "\n")


if __name__ == "__main__":
    write() if "--write" in sys.argv else print(*faults_of_table(), *faults_of_lines(), sep="\n")
