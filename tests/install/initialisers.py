"""Each member of each struct of the public headers has an initialiser: with one member given, as in
lacuna::sample({.radius = .05, .seed = 3}), no compiler warns of the others.

    initialisers.py INCLUDE SCRATCH COMPILER...
"""

import pathlib
import re
import subprocess
import sys

include, scratch, *compilers = sys.argv[1:]
MEMBER = re.compile(r"    (?! )[\w:<>, *]+[ >](\w+)(?: = [^()]+(?:\(\))?|\{[^()]*\})?;")

lines = ["#include <lacuna/%s>" % path.name for path in sorted(pathlib.Path(include, "lacuna").glob("*.h"))]
structs = 0
for path in sorted(pathlib.Path(include, "lacuna").glob("*.h")):
    for name, body in re.findall(r"^struct (\w+) \{\n(.*?)^\};", path.read_text(), re.M | re.S):
        members = [found[1] for found in map(MEMBER.match, body.splitlines()) if found]
        assert members, "%s: no member of %s was found" % (path.name, name)
        # The first member is looked at in the second of these.
        for member in {members[0], members[-1]}:
            lines.append("const lacuna::%s %s_%s{.%s = {}};" % (name, name, member, member))
        structs += 1
assert structs >= 20, "only %d structs were found" % structs
lines += [
    "auto set() { return lacuna::sample({.radius = .05, .seed = 3}); }",
    "auto proof() { return lacuna::prove({}, {.radius = .05, .domain = {.width = 2}}); }",
]
source = pathlib.Path(scratch, "initialisers.cpp")
source.parent.mkdir(parents=True, exist_ok=True)
source.write_text("\n".join(lines) + "\n")
for compiler in compilers:
    command = [compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-Wno-unused-const-variable"]
    subprocess.run([*command, "-fsyntax-only", "-I", include, str(source)], check=True)
