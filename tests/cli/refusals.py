#!/usr/bin/env python3
"""refusals.py PROGRAM: the command refuses the rows of tests/refusals.txt that have an exit code.

It prints one line, the row's message, and neither writes nor changes a file.
refusals.py --write PROGRAM writes the message of every row anew.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TABLE = Path(__file__).resolve().parents[1] / "refusals.txt"


def make_file(folder, name, content):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    if content.startswith("-> "):
        path.symlink_to(content[3:])
    elif content.startswith("=> "):
        path.hardlink_to(folder / content[3:])
    else:
        path.write_text(content.replace("\\n", "\n"))


def files_in(folder):
    """The content of each file; nothing for a folder and for a link that leads nowhere."""
    return {path: path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")}


def answer(program, request, folder):
    """The exit code, and the message: all that is printed, if that is not one line of ours."""
    output = r"^(sample|stipple|relax|order)\b(?!.* (-o|--output|--format)\b)"
    line = re.sub(output, r"\1 -o new.npy", request)
    words = ["bash", "-c", f'exec "$0" {line}', program]
    run = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    said = run.stdout + run.stderr
    one = re.fullmatch("lacuna: (.*)\n", said)
    return str(run.returncode), one[1] if one else repr(said)


def main(program, writes):
    lines, rows, wrong = TABLE.read_text().splitlines(), 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for i, line in enumerate(lines):
            if line.startswith("= "):
                make_file(folder, *line[2:].partition(" ")[::2])
            row = re.fullmatch("([a-z]*)([0-9]?) (.*?) ?=> (.*)", line)
            if line[:1] in "=#" or row[4] == "accepted" or not (row[2] or writes):
                continue
            _, code, request, expected = row.groups()
            before = files_in(folder)
            ended, message = answer(program, request, folder)
            rows += 1
            pattern = re.escape(expected).replace(re.escape("<...>"), ".+")
            changed = files_in(folder).items() ^ before.items()
            if re.fullmatch(pattern, message) and ended == (code or ended) and not changed:
                continue
            wrong += 1
            print(f"lacuna {request}: exit code {ended}: {message}")
            print(*(f"    changes {path.name}" for path in {path for path, _ in changed}))
            lines[i] = line[: line.index(" => ")] + f" => {message}"
    if writes:
        TABLE.write_text("\n".join(lines) + "\n")
    print(f"refusals: {rows - wrong} of {rows} rows are as the table says")
    return 0 if writes or not wrong else 1


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[-1]), "--write" in sys.argv))
