"""A tile of thresholds for dithering: dithering_tile.py [TILE.png] [DITHERED.png]

Void and cluster (Ulichney 1993): the pixels of a tile are ranked such that those of rank under K
are spread evenly for every K, edges included. It begins from an even pattern, which a relaxed set
of points on a torus is, and so needs no pass that makes one.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import lacuna

SIDE = 64  # pixels
FIRST = 400  # pixels that are on in the pattern that it begins from

# How much a pixel crowds each other one, around the edges.
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

# From the tightest cluster of the pattern down to the first pixel,
left, left_crowd = pattern.copy(), crowd.copy()
for turn in range(pattern.sum() - 1, -1, -1):
    place = np.unravel_index(np.where(left, left_crowd, -1).argmax(), left.shape)
    left[place] = False
    left_crowd -= crowd_of(*place)
    rank[place] = turn
# then from its largest void up to the last.
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
