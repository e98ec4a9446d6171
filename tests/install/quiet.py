#!/usr/bin/env python3
"""quiet.py LIBRARY: the library, an archive, never prints, ends the process or reads the clock.

It calls no function of the system that does so.
"""
import re
import subprocess
import sys

PRINT = r"v?f?printf|puts|f?putc|putchar|fputs|fwrite|write|perror|std::(cout|cerr|clog)"
END = r"exit|_exit|_Exit|quick_exit|abort|raise|kill"
CLOCK = r"clock|clock_gettime|gettimeofday|time|std::chrono::.*::now\(\)"
FORBIDDEN = re.compile(rf"(std::)?({PRINT}|{END}|{CLOCK})(@.*)?$")

text = subprocess.run(["nm", "-uC", sys.argv[1]], capture_output=True, text=True, check=True).stdout
needed = {line.split(maxsplit=1)[1] for line in text.splitlines() if re.match(r" +U ", line)}
assert "memcpy" in needed and FORBIDDEN.match("std::cout") and not FORBIDDEN.match("snprintf")
wrong = sorted(name for name in needed if FORBIDDEN.match(name))
print(f"{len(needed)} functions and objects of others, {len(wrong)} forbidden ones: {wrong}")
sys.exit(1 if wrong else 0)
