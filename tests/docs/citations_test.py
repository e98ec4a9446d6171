#!/usr/bin/env python3
"""Fails when a comment or a page cites what does not exist, and prints each such citation:

- in code and pages, a page of docs/, a section of it by number, or a quoted name in that section;
- in code, the path of a file, from the repository's root or from the folder of the code;
- in pages, a relative link, or a path in backticks. NAME, GROUP and X in a path stand for anything.

It also fails for an option of CMake that docs/cpp.md does not name, and where the prover or the judge
of the tests includes code that it must not share with the samplers;
and for what test_lines.py says of the tests.
"""
import pathlib
import re
import sys

import test_lines

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = "cmake docs examples host kernels python shaders tests web".split()
CODE = {".cpp", ".h", ".cl", ".in", ".py", ".sh", ".cmake", ".txt", ".js"}
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]

# A page, after its folder or in a link; then perhaps sections; then perhaps a name in quotes.
CITATION = re.compile(
    r"(?:\bdocs/|\]\()(?P<page>[a-z_]+\.md)\)?`?"
    r"(?:, sections? (?P<sections>\d+(?:(?:, | and | to )\d+)*)(?:, \"(?P<name>[^\"]+)\")?)?"
)
LINK = re.compile(r"\]\((?!https?:|#)(?P<target>[^)#\s]+)")
BACKTICKS = re.compile(r"`([^`]+)`")
PATH = re.compile(rf"(?:{'|'.join(FOLDERS)}|\.ci)/[\w./*-]*$")
FILE = re.compile(rf"(?<![\w/.}}-])(?:{'|'.join(FOLDERS)})/[\w./-]*\w\.(?:cpp|h|cl|comp|js|json|py|md)\b")
OPTION = re.compile(r'^(?:option\((LACUNA_\w+)|set\((LACUNA_\w+) "" CACHE)', re.MULTILINE)
SOURCE = re.compile(r"[\w/*-]+\.(?:cpp|h|cl|comp|cmake)$")
INCLUDE = re.compile(r'^#include ["<]([\w./]+)[">]', re.MULTILINE)
# A fault in what two of them share would blind both. Of this project's own code each may include what
# is named here, beside the public headers.
APART = {"tests/judge": ("judge/",), "host/verify": ("verify/", "base/", "checks/", "places/sets.h"),
         "host/checks": ("checks/", "base/"), "host/base": ("base/",)}


def joined(text: str) -> str:
    """The text without line ends and the marks of comments that follow them."""
    return re.sub(r"\s*\n\s*(?://+|#+|\*+(?=\s))?\s*", " ", text)


def sections_of(page: pathlib.Path) -> dict[str, str]:
    parts = re.split(r"^## (\d+)\. ", page.read_text(), flags=re.MULTILINE)
    return {number: joined(body) for number, body in zip(parts[1::2], parts[2::2])}


def wrong_citations(text: str):
    for found in CITATION.finditer(joined(text)):
        page = ROOT / "docs" / found["page"]
        if not page.exists():
            if found[0].startswith("docs/") or found["sections"]:
                yield found[0]
            continue
        for number in re.findall(r"\d+", found["sections"] or ""):
            section = sections_of(page).get(number)
            if section is None or (found["name"] or "") not in section:
                yield found[0]


def exists(word: str) -> bool:
    pattern = re.sub(r"(?<![A-Za-z])(?:NAME|GROUP|X)(?![A-Za-z])", "*", word).rstrip("/")
    if PATH.match(word):
        return any(ROOT.glob(pattern))
    return any(any((ROOT / folder).rglob(pattern)) for folder in FOLDERS)


def wrong_files(folder: pathlib.Path, text: str):
    for word in FILE.findall(text):
        if not any((base / word).exists() for base in (ROOT, folder)):
            yield word


def wrong_paths(page: pathlib.Path, text: str):
    yield from (f[0] for f in LINK.finditer(text) if not (page.parent / f["target"]).exists())
    prose = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    for word in (word for quoted in BACKTICKS.findall(prose) for word in quoted.split()):
        if (PATH.match(word) or SOURCE.match(word)) and not exists(word):
            yield f"`{word}`"


def shared(folder: str, text: str):
    for header in INCLUDE.findall(text):
        is_ours = any((ROOT / base / header).exists() for base in ("host", "kernels", "tests", folder))
        if is_ours and not header.startswith(APART[folder]):
            yield f'a reason for {folder} to share "{header}"'


def main() -> int:
    planted = "none.md", "design.md,\n// section 99", 'design.md, section 4, "nowhere"'
    assert all(any(wrong_citations("docs/" + text)) for text in planted)
    assert len(list(wrong_paths(PAGES[1], "[a](../none.md) `host/none.h` `none/NAME.h`"))) == 3
    assert list(wrong_files(ROOT / "host", '"host/none.h", tests/none.json, NAME/host/none.h')) == [
        "host/none.h", "tests/none.json"]
    includes = ['"verify/domain.h"', "<plan/plan.h>", '"fields.h"', "<lacuna/sample.h>", "<cmath>"]
    assert [len(list(shared("tests/judge", "#include " + one))) for one in includes] == [1, 1, 1, 0, 0]
    code = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in CODE]
    code.remove(pathlib.Path(__file__))  # its planted faults
    faults = [(path, fault) for path in [*PAGES, *code] for fault in wrong_citations(path.read_text())]
    faults += [(page, fault) for page in PAGES for fault in wrong_paths(page, page.read_text())]
    faults += [(path, fault) for path in code for fault in wrong_files(path.parent, path.read_text())]
    for folder in APART:
        faults += [(path, fault) for path in sorted((ROOT / folder).rglob("*.*"))
                   for fault in shared(folder, path.read_text())]
    cpp = ROOT / "docs" / "cpp.md"
    named = cpp.read_text()
    for path in [ROOT / "CMakeLists.txt", *(ROOT / "cmake").glob("*.cmake")]:
        options = ("".join(found) for found in OPTION.findall(path.read_text()))
        faults += [(cpp, f"a word on the option {one}") for one in options if f"`{one}`" not in named]
    of_tests = [*test_lines.faults_of_table(), *test_lines.faults_of_lines()]
    for path, fault in faults:
        print(f"{path.relative_to(ROOT)}: {fault} does not exist")
    for fault in of_tests:
        print(fault)
    return 1 if faults or of_tests else 0


if __name__ == "__main__":
    sys.exit(main())
