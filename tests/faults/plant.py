#!/usr/bin/env python3
"""Plants faults at random lines of host/ and kernels/, one at a time, and runs the tests on each.

    tests/faults/plant.py --seed 1 --faults 30 --build build

A fault changes one operator, number or word. If the build refuses it, another one is drawn. The
file is restored after each fault, also after Ctrl-C. Each line of the output has the fault's number,
whether a test found it and which, the place, and the line before and after. By hand: with a build
of several minutes a fault takes about as long as the tests do until the first of them fails.
"""

from __future__ import annotations

import argparse
import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# What is replaced, and by what. Operators stand between spaces, as clang-format writes them.
CHANGES: list[tuple[str, str]] = [
    (r" < ", " <= "),
    (r" <= ", " < "),
    (r" > ", " >= "),
    (r" >= ", " > "),
    (r" == ", " != "),
    (r" != ", " == "),
    (r" && ", " || "),
    (r" \|\| ", " && "),
    (r" \+ ", " - "),
    (r" - ", " + "),
    (r" \* ", " + "),
    (r" / ", " * "),
    (r" >> ", " << "),
    (r" \+= ", " -= "),
    (r"\bstd::min\b", "std::max"),
    (r"\bstd::max\b", "std::min"),
    (r"\bstd::floor\b", "std::ceil"),
    (r"\bstd::ceil\b", "std::floor"),
    (r"\btrue\b", "false"),
    (r"\bfalse\b", "true"),
    (r"\bif \((?!constexpr)", "if (!"),
    (r"(?<=[ (\[])0(?=[;,)\] ])", "1"),
    (r"(?<=[ (\[])1(?=[;,)\] ])", "2"),
    (r"(?<=[ (\[])2(?=[;,)\] ])", "1"),
    (r"\bcontinue;", "break;"),
]
COMMENT = re.compile(r"^\s*(//|\*|/\*|#)|static_assert|^\s*$")


def sources() -> list[Path]:
    found = [*ROOT.glob("host/**/*.cpp"), *ROOT.glob("host/**/*.h"), *ROOT.glob("kernels/**/*.h")]
    return sorted(path for path in found if "include/lacuna" not in path.as_posix())


def draw(rng: random.Random, files: list[Path]) -> tuple[Path, int, str, str]:
    """A file, the index of a line, and the line before and after. Lines are equally likely."""
    lines = [(path, i) for path in files for i in range(len(path.read_text().splitlines()))]
    while True:
        path, i = rng.choice(lines)
        line = path.read_text().splitlines()[i]
        code = line.split(" // ")[0]
        places = [
            (match, by) for change, by in CHANGES for match in re.finditer(change, code)
        ]
        if COMMENT.search(line) or '"' in code or not places:
            continue
        match, by = rng.choice(places)
        return path, i, line, line[: match.start()] + by + line[match.end() :]


def run(*words: str, seconds: float) -> tuple[int, str]:
    try:
        done = subprocess.run(
            words, cwd=ROOT, timeout=seconds, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )
    except subprocess.TimeoutExpired as late:
        return 1, (late.stdout or b"").decode(errors="replace") + "\nran too long"
    return done.returncode, done.stdout.decode(errors="replace")


def verdict_of(build: str, targets: list[str], tests: list[str]) -> str | None:
    """The first test that fails, 'none', or null if the build refuses the fault."""
    wanted = ["--target", *targets] if targets else []
    if run("cmake", "--build", build, *wanted, seconds=3600)[0] != 0:
        return None
    failed, told = run(
        "ctest", "--test-dir", build, "-j2", "--stop-on-failure", *tests, seconds=3600
    )
    if failed == 0:
        return "none"
    names = re.findall(r"^\s*\d+ - (\S+) \(", told, re.MULTILINE)
    return names[0] if names else "ran too long"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--faults", type=int, default=30)
    parser.add_argument("--skip", type=int, default=0, help="draws that are made and not tried")
    parser.add_argument("--build", default="build")
    parser.add_argument("--targets", nargs="*", default=[], help="built in place of all")
    parser.add_argument("tests", nargs="*", help="more arguments for ctest, after --")
    given = parser.parse_args()
    rng = random.Random(given.seed)
    files = sources()
    found = tried = drawn = 0
    while tried < given.faults:
        path, i, before, after = draw(rng, files)
        drawn += 1
        if drawn <= given.skip:
            continue
        text = path.read_text()
        lines = text.splitlines(keepends=True)
        lines[i] = after + "\n"
        try:
            path.write_text("".join(lines))
            verdict = verdict_of(given.build, given.targets, given.tests)
        finally:
            path.write_text(text)
        if verdict is None:
            continue
        tried += 1
        found += verdict != "none"
        where = f"{path.relative_to(ROOT)}:{i + 1}"
        print(f"{tried} (draw {drawn}) found by {verdict}: {where}", file=sys.stdout)
        print(f"    - {before.strip()}\n    + {after.strip()}", flush=True)
    print(f"{found} of {tried} faults were found")


if __name__ == "__main__":
    main()
