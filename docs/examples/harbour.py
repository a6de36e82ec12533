"""A harbour of one's own, in metres: five ASVs leave a basin, their brooms 5 m long."""

import asv

harbour = asv.parse_scenario({
    "body": {"kind": "chain", "broom_length": 5, "minimum_area_factor": 0.7},
    "bounds": [[0, 0], [120, 80]],
    "obstacles": [[[0, 50], [50, 54]],      # the northern mole
                  [[62, 50], [120, 54]],    # ... and what is left of it behind the entrance
                  [[30, 0], [34, 30]],      # two piers
                  [[76, 20], [80, 50]]],
    "step": 0.1,
    "tolerance": 0.001,
    "start": [[8, 10], [13, 10], [17, 13], [20, 17], [20, 22]],
    "goal": [[98, 58], [103, 58], [107, 61], [110, 65], [110, 70]],
})

for end, reason in asv.invalid_ends(harbour):
    print(f"the {end} is not valid: {reason}")

result = asv.solve(harbour, seed=1, optimize=0.5)
print(f"{result.status}: the ASVs go {result.cost:.0f} m together, at least {result.lower_bound:.0f} m")

report = asv.validate(harbour, result, tolerance=harbour.requirements.tolerance)
print("valid" if report.valid else report)
for check in report.checks:
    if check.name == "collisions":
        print(f"tightest: broom {check.worst.broom + 1} beside obstacle {check.worst.obstacle + 1}")

asv.write_problem("harbour.json", harbour)
result.draw(title="Out of the harbour").save("harbour.svg")
result.player(title="Out of the harbour").save("harbour.html")
