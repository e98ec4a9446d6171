"""A photograph as dots: stippled_photograph.py [PHOTO] [OUTPUT.svg] [COUNT]"""

import sys
from pathlib import Path

import lacuna

photo = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1] / "raccoon.png"
output = sys.argv[2] if len(sys.argv) > 2 else "stippled.svg"
count = int(sys.argv[3]) if len(sys.argv) > 3 else None  # None: a number that suits the photo

dots = lacuna.stipple(photo, count, seed=1)
dots.save(output)
print(f"{len(dots)} dots in {dots.seconds['total']:.2f} s")
