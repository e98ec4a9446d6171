"""Trees and bushes in a park with a pond, off the road and near the fence, from arrays in memory."""
import lacuna

park = [[(0, 0), (90, 5), (100, 70), (10, 80)], [(40, 30), (60, 30), (50, 45)]]  # a hole: the pond
road, fence = [[(0, 60), (100, 20)]], [[(10, 10), (85, 12)]]
made = lacuna.sample(
    classes={"trees": 2.5, "bushes": 0.8}, inside=park, avoid=[(road, 3)], near=[(fence, 25)], seed=0
)
for (x, y), kind in zip(made.points, made.class_of):
    print(f"{x:.17g} {y:.17g} {kind}")
