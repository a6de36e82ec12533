"""RRT, RRT-Connect, RRT* and PRM in one lesson: a point between two walls, and a picture of each."""

import math

import asv


# part: space
class TwoWalls:
    """A point in the unit square. Each wall leaves a door."""

    low, high = (0, 0), (1, 1)
    walls = [(0.30, 0.00, 0.35, 0.75), (0.65, 0.25, 0.70, 1.00)]  # low x, low y, high x, high y

    def sample(self, rng):
        """A free point, or None: this try is lost."""
        point = rng.uniform(), rng.uniform()
        return point if self.motion_valid(point, point) else None

    def distance(self, a, b):
        return math.dist(a, b)

    def motion_valid(self, a, b):
        """All of the straight way, not samples of it."""
        return not any(meets(a, b, wall) for wall in self.walls)


def meets(a, b, box):
    """Does the segment from a to b meet the box? Clips it between both pairs of sides."""
    enter, leave = 0.0, 1.0
    for i in (0, 1):
        low, high, way = box[i] - a[i], box[i + 2] - a[i], b[i] - a[i]
        if way == 0:
            if low > 0 or high < 0:
                return False
        else:
            first, last = sorted((low / way, high / way))
            enter, leave = max(enter, first), min(leave, last)
    return enter <= leave
# end of part


# part: sketch
def lines(ways, colour, width):
    """Ways of points as one path of an SVG, the square being 400 wide and y upwards."""
    moves = " ".join("M" + "L".join(f"{400 * x:.1f},{400 * (1 - y):.1f}" for x, y in way)
                     for way in ways)
    return f'<path d="{moves}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def sketch(space, found, file):
    """Walls, trees or roadmap, and the path."""
    parts = [lines([[((low + high) / 2, bottom), ((low + high) / 2, top)]], "#808d9a",
                   400 * (high - low)) for low, bottom, high, top in space.walls]
    for tree, colour in zip(found.trees, ("#0068a8", "#007d57")):
        parts.append(lines([(tree.rows[parent], row) for row, parent
                            in zip(tree.rows, tree.parents) if parent >= 0], colour, 0.8))
        parts.append(lines([(tree.rows[a], tree.rows[b]) for a, b in found.edges], colour, 0.3))
    parts.append(lines([found.path], "#18242f", 3))
    with open(file, "w", encoding="utf-8") as out:
        out.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 400">'
                  '<rect width="400" height="400" fill="#f4f7fa"/>' + "".join(parts) + "</svg>\n")
# end of part


# part: lesson
space, start, goal = TwoWalls(), (0.1, 0.1), (0.9, 0.9)
corners = [start, (0.30, 0.75), (0.35, 0.75), (0.65, 0.25), (0.70, 0.25), goal]
shortest = sum(math.dist(a, b) for a, b in zip(corners, corners[1:]))
print(f"the shortest way is {shortest:.3f} long")

for planner in [asv.Planner("rrt", step=0.05),
                asv.Planner("rrt-connect"),
                asv.Planner("rrt-star", step=0.1, nodes=1500),
                asv.Planner("prm-random", samples=300)]:
    found = asv.search(space, start, goal, planner, seed=1)
    nodes = sum(len(tree.rows) for tree in found.trees)
    print(f"{planner.name}: {found.outcome} after {found.iterations} samples, {nodes} nodes, "
          f"{found.cost:.3f} long")
    sketch(space, found, f"lesson-{planner.name}.svg")
# end of part
