"""A tile of thresholds for dithering: dithering_tile.py [TILE.png] [DITHERED.png]

Void and cluster (Ulichney 1993): the pixels of a tile are ranked such that for every K those of
rank under K are spread evenly, also across the tile's edges. The method begins with an even
pattern: here the pixels under a relaxed set of points on a torus.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import lacuna

SIDE = 64  # pixels
FIRST = 400  # points of the first pattern

# How much a pixel at row 0, column 0 crowds each pixel of the tile, whose edges wrap.
away = np.minimum(np.arange(SIDE), SIDE - np.arange(SIDE))
crowding = np.exp(-(away[:, None] ** 2 + away**2) / (2 * 1.5**2))


def crowd_of(row: int, column: int) -> np.ndarray:
    return np.roll(crowding, (row, column), axis=(0, 1))


points = lacuna.sample(n=FIRST, torus=True, seed=1, relax=30).points
columns, rows = (points * SIDE).astype(int).T
pattern = np.zeros((SIDE, SIDE), bool)
pattern[rows, columns] = True
crowd = sum(crowd_of(*place) for place in np.argwhere(pattern))
rank = np.empty((SIDE, SIDE), int)

# Ranks within the first pattern: the pixel in the tightest cluster is removed, again and again.
left, left_crowd = pattern.copy(), crowd.copy()
for turn in range(pattern.sum() - 1, -1, -1):
    place = np.unravel_index(np.where(left, left_crowd, -1).argmax(), left.shape)
    left[place] = False
    left_crowd -= crowd_of(*place)
    rank[place] = turn
# Ranks above: the pixel in the largest void is added, again and again.
for turn in range(pattern.sum(), SIDE * SIDE):
    place = np.unravel_index(np.where(pattern, np.inf, crowd).argmin(), pattern.shape)
    pattern[place] = True
    crowd += crowd_of(*place)
    rank[place] = turn

threshold = (rank + 0.5) / (SIDE * SIDE)

# A picture that gets lighter to the right, in black and white.
ramp = np.linspace(0, 1, 8 * SIDE) * np.ones((2 * SIDE, 1))
dithered = ramp > np.tile(threshold, (2, 8))

plt.imsave(sys.argv[1] if len(sys.argv) > 1 else "tile.png", threshold, cmap="gray")
plt.imsave(sys.argv[2] if len(sys.argv) > 2 else "dithered.png", dithered, cmap="gray")
print(f"{len(np.unique(rank))} thresholds on {SIDE} x {SIDE} pixels")
