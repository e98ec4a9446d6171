"""A photograph as dots: stippled_photograph.py PHOTO [OUTPUT.svg] [COUNT]"""

import sys

import lacuna

photo = sys.argv[1]
output = sys.argv[2] if len(sys.argv) > 2 else "stippled.svg"
count = int(sys.argv[3]) if len(sys.argv) > 3 else None  # as suits the photograph

dots = lacuna.stipple(photo, count, seed=1)

# The longer side is 512 units; y points up in a set, and down in SVG.
width, height = (512 * side for side in dots.domain)
with open(output, "w", encoding="utf-8") as svg:
    svg.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}">\n')
    for (x, y), radius in zip(dots.points * 512, dots.radii * 512):
        svg.write(f'<circle cx="{x:.3f}" cy="{height - y:.3f}" r="{radius:.3f}"/>\n')
    svg.write("</svg>\n")
print(f"{len(dots)} dots in {dots.seconds['total']:.2f} s")
