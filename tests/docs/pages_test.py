#!/usr/bin/env python3
"""pages_test.py PROGRAM: the commands of the pages do what the pages say.

Each command of docs/*.md is run in one folder, in the order of the pages, with small inputs that have
the names used there. It must end well and make its files. Where a page says how many points a
command makes, the number is compared; where it says how even they are, the report's is near it.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PHOTOGRAPHS = "photo.jpg", "density.png", "coast.png", "land.png", "in/1.png", "in/2.png"
SECONDS = 300  # no command may hang
# All figures of the paper, which tests/reproduce checks.
LEFT_OUT = "lacuna reproduce all "
# What a page says, and the command that it says it of.
COUNTS = {
    "README.md": [("760 points of radius 0.03 on a torus", "sample --radius 0.03 --torus"),
                  ("2,628 points on an island", "sample --inside examples/lakes.svg --radius 1 --border 1"),
                  ("30,084 dots of 0.5 mm", "stipple examples/raccoon.png --dot-size 0.5mm "
                   "--paper-size A6 --margin 8mm")],
    "docs/stipple_measured.md": [
        ("27,278", "stipple examples/raccoon.png"),
        ("77,658 dots in exact", "stipple examples/raccoon.png --scale 0.002 --relax 0 --mode exact"),
        ("74,584 in cells", "stipple examples/raccoon.png --scale 0.002 --relax 0")],
    "docs/domains.md": [("`: 2,628 points.", "sample --inside examples/lakes.svg --radius 1 --border 1"),
                        ("Its 5,213 dots", "sample --field examples/raccoon.png --scale 0.008")],
    "docs/space.md": [("1,768 points of radius 0.08", "sample --on examples/knot.obj --radius 0.08")],
    "docs/placement.md": [
        ("9,320 points", "sample --class trees:1.8 --class bushes:0.8:2 --class grass:0.25:0.2 "
         "--outside examples/glade.svg")],
}
# A page, what it says, whose last number is measured to within a share of it, the command, and
# where r.json has the number.
TORUS = "lacuna sample --count 4096 --torus --relax 30 -o m.npy"
MEASURED_BY = {"report": " --report r.json", "sheet": " && lacuna analyze m.npy --torus -o r.json",
               "picture": " && lacuna relax m.npy {} --iterations 0 -o n.npy --report r.json"}
CV = "relax capacity_cv"
MEASURES = [
    ("README.md", "**Lacuna, relaxed 15 times** | 0.078", 0.04,
     "lacuna stipple examples/hopper.jpg --count 5000 -o m.npy", "examples/hopper.jpg", f"{CV} before"),
    ("docs/relax.md", "20,000 dots have a CV of 0.064", 0.04,
     "lacuna stipple examples/raccoon.png --count 20000 --light -o m.npy", "examples/raccoon.png --light",
     f"{CV} before"),
    ("docs/relax.md", "all cells, and of 0.053", 0.04,
     "lacuna stipple examples/raccoon.png --count 20000 --light -o m.npy", "report",
     f"{CV} after_in_voronoi_cells"),
    ("docs/relax.md", "15, the default | 0.061", 0.04,
     "lacuna sample --field examples/raccoon.png --count 20000 --relax 15 -o m.npy", "report",
     f"{CV} after_in_voronoi_cells"),
    ("docs/relax.md", "| 30 | 0.0191", 0.02, TORUS, "report", f"{CV} after"),
    ("docs/relax.md", "| 0.005 | 0.950", 0.02, TORUS, "sheet",
     "spectrum effective_nyquist_over_half_sqrt_count"),
    ("docs/relax.md", "| 0.664 | 0.772", 0.02, TORUS, "sheet", "nearest_neighbour relative_radius"),
    ("docs/stipple_measured.md", "| 20,000 | 9,337 | 135.0 | 115.0", 0.02,
     "lacuna stipple examples/raccoon.png --count 20000 --relax 0 --pen-path -o m.npy", "report",
     "pen_path length"),
    ("docs/stipple.md", "that is 124,000", 0.01,
     "lacuna stipple examples/raccoon.png --dot-size 0.5mm --paper-size A4 --margin 15mm -o m.npy",
     "report", "count"),
]


def make_inputs(folder, program):
    """The files that the commands read, beside those that earlier ones write."""
    (folder / "examples").symlink_to(ROOT / "examples")
    for name in "in", "out", "tiles":
        (folder / name).mkdir()
    for name in PHOTOGRAPHS:
        picture = "hopper.jpg" if name.endswith(".jpg") else "raccoon.png"
        shutil.copyfile(ROOT / "examples" / picture, folder / name)
    for name in "park.svg", "garden.svg", "pond.svg":
        shutil.copyfile(ROOT / "examples" / "glade.svg", folder / name)
    (folder / "path.svg").write_text('<svg viewBox="0 0 120 70"><path d="M0 20L120 50"/></svg>')
    (folder / "land.pgw").write_text("1\n0\n0\n-1\n0.5\n767.5\n")
    (folder / "rocks.csv").write_text("x,y,radius\n30,30,5\n80,40,8\n")
    (folder / "distances.csv").write_text("0.2,0.1\n0.1,0.3\n")
    (folder / "trees.csv").write_text("x,y\n0.1,0.2\n0.8,0.3\n")
    (folder / "old.csv").write_text("x,y,class\n0.1,0.2,trees\n0.5,0.9,rocks\n")
    (folder / "points.txt").write_text("0.1 0.2\n0.5 0.9\n0.8 0.3\n")
    shutil.copyfile(ROOT / "tests" / "pinned" / "ellipses.npy", folder / "swirl.npy")
    for make in ["sample --radius 0.01 -o survey.csv", "stipple photo.jpg --count 500 -o dots.npy"]:
        subprocess.run([program, *make.split(), "--quiet"], cwd=folder, check=True)
    # The loop of placement.md, whose lines are no command each.
    loop = re.search(r"^    (for j in .*? > around\.csv)$", (ROOT / "docs/placement.md").read_text(), re.M | re.S)
    subprocess.run(loop[1].replace("lacuna", f"{program} 2>/dev/null"), shell=True, cwd=folder, check=True)


def commands_of(page):
    """The indented commands of a page, without comments; a backslash joins two lines."""
    text = page.read_text().replace("\\\n", " ")
    for line in re.findall(r"^    (lacuna .+)$", text, re.MULTILINE):
        yield re.sub(r" {8,}(?=-)", " ", line).split("  ")[0]


def main(program) -> int:
    faults, ran = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_inputs(folder, program)

        def answer(command):
            shell = f'lacuna() {{ "{program}" "$@"; }}; {command}'
            run = subprocess.run(["bash", "-c", shell], cwd=folder, capture_output=True, text=True,
                                 timeout=SECONDS)
            return run.returncode, run.stderr

        def says_it(page, words):
            if words not in " ".join((ROOT / page).read_text().split()):
                faults.append(f"{page}: no longer says {words!r}")

        for page in sorted((ROOT / "docs").glob("*.md")):
            for command in commands_of(page):
                if command.startswith(LEFT_OUT):
                    continue
                code, message = answer(command)
                ran += 1
                outputs = [word for word in re.findall(r"-o '?([^' ]+)", command) if "{" not in word]
                lost = [word for word in outputs if not (folder / word).exists()]
                if code or lost:
                    faults.append(f"{page.name}: {command}: exit code {code}: {message} {lost or ''}")
        for page, rows in COUNTS.items():
            for words, command in rows:
                says_it(page, words)
                number = re.search("[0-9,]+", words)[0].replace(",", "")
                _, message = answer(f"lacuna {command} -o count.csv")
                if not message.startswith(f"{number} "):
                    faults.append(f"{page}: says {words!r}, but {command} makes {message}")
        for page, words, share, command, by, where in MEASURES:
            says_it(page, words)
            code, message = answer(command + MEASURED_BY.get(by, MEASURED_BY["picture"].format(by)))
            found = json.loads((folder / "r.json").read_text()) if code == 0 else {}
            for key in where.split():
                found = found.get(key, {})
            said = float(re.findall("[0-9][0-9.,]*", words)[-1].replace(",", ""))
            if not isinstance(found, (int, float)) or abs(found / said - 1) > share:
                faults.append(f"{page}: says {words!r}, but {command} gives {found} {message}")
    print(*faults, f"docs.pages: {ran} commands, {len(faults)} faults", sep="\n")
    return 1 if faults or ran < 40 else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
