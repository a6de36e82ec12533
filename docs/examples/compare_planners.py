"""Planners compared: what each of them finds among the same boxes, before and after shortening."""

import statistics

import asv

problem = asv.generate("clutter", asv_count=3, seed=4, obstacles=10)
seeds = range(1, 6)

print(f"{'planner':12} {'solved':>7} {'found':>7} {'shortened':>10} {'nodes':>7}")
for planner in ["auto", "rrt-connect", "rrt", asv.Planner("rrt-star", nodes=1500)]:
    results = [asv.solve(problem, planner, seed=seed, optimize=0.05) for seed in seeds]
    solved = [result.statistics for result in results if result.solved]
    found = statistics.median(spent.cost_of_search for spent in solved)
    shortened = statistics.median(spent.cost for spent in solved)
    nodes = statistics.median(sum(spent.tree_nodes) for spent in solved)
    print(f"{results[0].planner:12} {len(solved):>4}/{len(results)} {found:7.2f} {shortened:10.2f} "
          f"{nodes:7.0f}")

bound = max(result.lower_bound for result in results if result.solved)
print(f"no path costs less than {bound:.2f}")
