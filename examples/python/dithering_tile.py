"""A tile of thresholds for dithering: dithering_tile.py [TILE.png] [DITHERED.png]

The pixels of the tile are ranked such that for every K those of rank under K are spread evenly,
also across the tile's edges. A picture that is compared with the tile becomes black and white.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import lacuna

SIDE = 64  # pixels

ranks = lacuna.threshold_mask(SIDE, SIDE)
threshold = (ranks + 0.5) / ranks.size

# A picture that gets lighter to the right, in black and white.
ramp = np.linspace(0, 1, 8 * SIDE) * np.ones((2 * SIDE, 1))
dithered = ramp > np.tile(threshold, (2, 8))

plt.imsave(sys.argv[1] if len(sys.argv) > 1 else "tile.png", threshold, cmap="gray")
plt.imsave(sys.argv[2] if len(sys.argv) > 2 else "dithered.png", dithered, cmap="gray")
print(f"{len(np.unique(ranks))} thresholds on {SIDE} x {SIDE} pixels")
