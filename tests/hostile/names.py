#!/usr/bin/env python3
"""hostile.names: random names of files for `lacuna sample --seeds`, among links and folders.

    names.py PROGRAM [--runs N] [--seed S] [--skip K]

Where two of the files named are one, or a file to be written is also read, or cannot be made, the
program must refuse with one line and must leave everything as it was. Otherwise it must write every
file with the bytes that its seed alone gives, and must leave the input as it was. Makes N runs
(200), and prints the seed, which is a new one each time unless it is given; --skip goes to run K of
the seed. Ends with 1 at the first wrong run, and prints its command.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

OUTPUTS = ["{seed}.txt", "a/{seed}.txt", "link/{seed}.txt", "./{seed}.txt", "a/../{seed}.txt", "1{seed}.txt",
           "{seed}1.txt", "{seed}{seed}.txt", "{seed}/p.txt", "a/{seed}/../{seed}.txt", "b/{seed}.txt",
           "{seed}.csv", "a/{seed}.csv"]
REPORTS = ["all.json", "a/1.json", "1.json", "link/1.json", "{seed}.json", "b/none/all.json"]
KEEPS = ["in.txt", "./in.txt", "1.txt", "a/1.txt", "11.txt"]
REQUEST = ["sample", "--radius", "0.3", "--quiet"]


def plant(random_: random.Random):
    """Makes the folders, the input and some links to it, in the current folder."""
    for folder in "a", "b":
        os.mkdir(folder)
    os.symlink("a", "link")
    for seed in range(1, 13):
        if random_.random() < 0.8:
            os.mkdir(str(seed))
            os.mkdir(f"a/{seed}")
    pathlib.Path("in.txt").write_text("0.5 0.5\n")
    for name in "1.txt", "2.txt", "11.txt", "a/1.txt", "a/2.txt", "1.json":
        kind = random_.choice(["none", "none", "none", "soft", "hard", "dangling", "own", "folder"])
        if kind == "soft":
            os.symlink(os.path.relpath("in.txt", os.path.dirname(name) or "."), name)
        elif kind == "hard":
            os.link("in.txt", name)
        elif kind == "dangling":
            os.symlink("3.txt", name)
        elif kind == "own":
            pathlib.Path(name).write_text("0.25 0.25\n")
        elif kind == "folder":
            os.mkdir(name)


def identity(path: str):
    """What is one for two names of one file."""
    real = os.path.realpath(path)
    if os.path.exists(real):
        status = os.stat(real)
        return status.st_dev, status.st_ino
    return real


def can_be_made(path: str) -> bool:
    folder = os.path.dirname(os.path.realpath(path))
    return os.path.isdir(folder) and not os.path.isdir(path) and os.path.isdir(os.path.dirname(path) or ".")


def may_run(outputs, report, keep, seeds) -> bool:
    written = [output.replace("{seed}", str(seed)) for seed in seeds for output in outputs]
    if report:
        written.append(report)
    names = [identity(path) for path in written]
    return (
        len(set(names)) == len(names)
        and "{seed}" not in (report or "")
        and all(map(can_be_made, written))
        and not (keep and (identity(keep) in names or not os.path.isfile(keep)))
    )


def tree() -> dict:
    """The names and contents of all files below the current folder."""
    found = {}
    for folder, folders, files in os.walk("."):
        for name in folders + files:
            path = os.path.join(folder, name)
            is_file = os.path.isfile(path)
            target = os.readlink(path) if os.path.islink(path) else None
            found[path] = (target, pathlib.Path(path).read_bytes() if is_file else None)
    return found


def command_of(random_: random.Random):
    first = random_.choice([0, 1, 2, 9])
    seeds = range(first, first + random_.randint(1, 4))
    outputs = random_.sample(OUTPUTS, random_.choice([1, 1, 2, 2, 3]))
    report = random_.choice(REPORTS) if random_.random() < 0.4 else None
    keep = random_.choice(KEEPS) if random_.random() < 0.5 else None
    words = ["--seeds", f"{seeds[0]}..{seeds[-1]}"]
    for output in outputs:
        words += ["-o", output]
    words += ["--report", report] if report else []
    words += ["--keep", keep] if keep else []
    return outputs, report, keep, seeds, words


def run(program: str, words: list):
    return subprocess.run([program, *REQUEST, *words], capture_output=True, timeout=60, check=False)


def demand(is_so: bool, otherwise: str):
    if not is_so:
        raise AssertionError(otherwise)


def check_refused(done, before: dict):
    demand(done.returncode in (2, 3), f"exit code {done.returncode}, not 2 or 3: {done.stderr.decode()}")
    demand(done.stderr.count(b"\n") == 1 and done.stderr.startswith(b"lacuna: "), f"said {done.stderr}")
    demand(tree() == before, "a file was made or changed")


def check_made(program: str, done, outputs, report, seeds, kept: bytes):
    demand(done.returncode == 0, f"exit code {done.returncode}: {done.stderr.decode()}")
    with tempfile.NamedTemporaryFile(suffix=".txt") as copy:
        copy.write(kept)
        copy.flush()
        for seed in seeds:
            for output in outputs:
                words = ["--seed", str(seed), "--format", output[-3:]] + (["--keep", copy.name] if kept else [])
                expected = run(program, words).stdout
                path = output.replace("{seed}", str(seed))
                demand(expected != b"" and pathlib.Path(path).read_bytes() == expected, f"{path} is wrong")
    if report:
        demand(json.loads(pathlib.Path(report).read_text())["sets"] == len(seeds), "the report is wrong")


def check_run(program: str, random_: random.Random) -> bool:
    """Makes one run in the current folder; returns whether it was to be refused."""
    plant(random_)
    outputs, report, keep, seeds, words = command_of(random_)
    try:
        is_good = may_run(outputs, report, keep, seeds)
        before = tree()
        kept = pathlib.Path(keep).read_bytes() if is_good and keep else b""
        done = run(program, words)
        if is_good:
            check_made(program, done, outputs, report, seeds, kept)
            demand(not keep or pathlib.Path(keep).read_bytes() == kept, "the input has changed")
        else:
            check_refused(done, before)
        return not is_good
    except AssertionError as error:
        raise AssertionError(f"{error}\n  {' '.join(REQUEST + words)}\n  {sorted(before)}") from None


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(2**32))
    parser.add_argument("--skip", type=int, default=0)
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    print(f"hostile.names: seed {options.seed}", flush=True)
    refused = 0
    for number in range(options.skip, options.skip + options.runs):
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                refused += check_run(program, random.Random(f"{options.seed} {number}"))
            except AssertionError as error:
                print(f"hostile.names: at --seed {options.seed} --skip {number}: {error}", file=sys.stderr)
                return 1
            finally:
                os.chdir("/")
    print(f"hostile.names: {options.runs} runs, {refused} of them refused, failures 0")
    return 0


if __name__ == "__main__":
    sys.exit(main())
