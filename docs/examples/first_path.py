"""A first path: three ASVs past a box, solved, checked and drawn."""

import asv

problem = asv.Problem(start=[(0.10, 0.50), (0.15, 0.50), (0.15, 0.55)],
                      goal=[(0.80, 0.50), (0.85, 0.50), (0.85, 0.55)],
                      obstacles=[(0.40, 0.30, 0.60, 0.80)])  # low x, low y, high x, high y

result = asv.solve(problem, seed=1)
print(f"{result.status}: cost {result.cost:.3f}, at least {result.lower_bound:.3f}")
print(f"states x ASVs x 2: {result.path.shape}")

highest = result.path[:, :, 1].max()
print(f"the highest ASV came to y = {highest:.3f}")

report = asv.validate(problem, result, continuous=True)
print("valid" if report.valid else report)

result.draw(title="Past a box").save("first_path.svg")
result.player().save("first_path.html")
