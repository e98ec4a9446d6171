"""A first set, drawn with matplotlib: first_set.py [OUTPUT.png]"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import lacuna

made = lacuna.sample(0.03, torus=True, seed=1)
even = lacuna.sample(n=len(made), torus=True, seed=1, relax=30)

figure, (left, right, power) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
for axes, points, title in (
    (left, made.points, f"sample(0.03): {len(made)} points"),
    (right, even.points, "relax=30: as many, more even"),
):
    axes.scatter(*points.T, s=4, color="black")
    axes.set(title=title, aspect="equal", xlim=(0, 1), ylim=(0, 1), xticks=[], yticks=[])
# Averaged over ten sets, because the spectrum of a single random set is rough.
for relax, label in ((0, "random"), (30, "relaxed")):
    sets = [lacuna.sample(n=len(made), torus=True, seed=i, relax=relax) for i in range(10)]
    spectrum = lacuna.analyze(sets)
    power.plot(spectrum.frequency, spectrum.power, label=label)
power.axhline(1, color="gray", linewidth=0.5)
power.set(title="radial power of 10 sets", xlabel="frequency / sqrt(N)", xlim=(0, 2), ylim=(0, None))
power.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "first_set.png", dpi=100)

print(f"{len(made)} points, maximal: {lacuna.verify(made).maximal}")
