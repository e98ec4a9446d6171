"""A shared library exports what its public headers declare, and nothing else.

    exported.py LIBRARY HEADERS
"""

import pathlib
import re
import subprocess
import sys

library, headers = sys.argv[1:]
text = "".join(path.read_text() for path in pathlib.Path(headers).glob("*.h"))
text = re.sub(r"//[^\n]*", "", text)
of_c = (pathlib.Path(headers).parent / "lacuna.h").read_text()
functions_of_c = set(re.findall(r"^LACUNA_C_API [^;(]*?(\w+)\(", of_c, re.MULTILINE))
lines = subprocess.run(["nm", "-D", "-C", "--defined-only", library], check=True,
                       capture_output=True, text=True).stdout.splitlines()
symbols = [line.split(maxsplit=2)[2] for line in lines]
described = re.compile(r"^(?:typeinfo(?: name)? for|vtable for) ")
strangers = []
for symbol in symbols:
    if symbol in functions_of_c:
        continue
    plain = described.sub("", symbol).split("(")[0].split("[abi")[0]
    words = plain.split("::")
    if words[0] != "lacuna" or not all(re.search(rf"\b{re.escape(word.lstrip('~'))}(?!\w)", text)
                                       for word in words[1:]):
        strangers.append(symbol)
for symbol in strangers:
    print(f"exported, but in no public header: {symbol}")
functions = {symbol.split("(")[0] for symbol in symbols}
missing = {f"lacuna::{name}" for name in ("sample", "sample_many", "relax", "prove")} - functions
missing |= functions_of_c - functions
for name in sorted(missing):
    print(f"not exported: {name}")
sys.exit(1 if strangers or missing else 0)
