"""lacuna.qmc.PoissonDisk where scipy.stats.qmc.PoissonDisk stood."""

from lacuna import qmc

engine = qmc.PoissonDisk(d=2, radius=0.01, l_bounds=(0, 0), u_bounds=(1, 1), rng=1)
first = engine.random(1000)
rest = engine.fill_space()
print(len(first) + len(rest), "points")
