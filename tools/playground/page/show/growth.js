// How the trees of a planner grow, node by node, and what each step of that planner does.

/** What a planner does, and how it tells of the step that makes a node of one of its trees. */
const stories = {
  rrt: {
    idea: "One tree. Draw a place at random, find the nearest node, go one step toward the place.",
    step: ({ node, parent }) => `A random place is drawn; node ${parent} is nearest to it and grows one step toward it: node ${node}.`,
  },
  "rrt-connect": {
    idea: "Two trees. One takes a step toward a random place; the other runs toward the new node as far as it gets.",
    step: ({ tree, node, parent, runsOn }) => runsOn
      ? `The ${tree} tree runs on from node ${parent}, toward the newest node of the other tree: node ${node}.`
      : `The ${tree} tree branches at node ${parent}, the nearest to its target: node ${node}.`,
  },
  "rrt-star": {
    idea: "One tree that is rewired: each new node takes the parent by which it is reached at least cost, and then offers itself to its neighbours.",
    step: ({ node, parent }) => `Node ${node} is new. Of its neighbours node ${parent} is the parent that makes its way to the start shortest.`,
  },
  auto: {
    idea: "Two trees that slide along what is in the way, and pull the chain by its ends.",
    step: ({ tree, node, parent, runsOn }) => runsOn
      ? `The ${tree} tree goes on from node ${parent}, sliding along what is in its way: node ${node}.`
      : `The ${tree} tree tries again from node ${parent}, pulled toward a passage or a random place: node ${node}.`,
  },
  prm: {
    idea: "A roadmap: draw free places all over the field, join each to its neighbours, then look for the shortest way in that graph.",
    step: ({ node }) => `A free place is kept as node ${node}, and joined to each of its neighbours that it can reach in a straight line.`,
  },
};

export const storyOf = (planner) => stories[planner] ?? stories[planner.split("-")[0]] ?? stories.rrt;

/**
 * The trees of one answer in the order in which they grew. Of two trees each one's own order is
 * known, but not how they took turns: they are shown as growing side by side.
 */
export class Growth {
  constructor(planner, answer) {
    this.planner = planner;
    this.answer = answer;
    const { start = null, goal = null, edges = null } = answer.trees ?? {};
    const isRoadmap = start?.parents.length > 1 && start.parents.every((parent) => parent < 0);
    this.trees = [[isRoadmap ? "roadmap" : "start", start], ["goal", goal]].flatMap(([kind, tree]) => (tree ? [{ kind, ...tree }] : []));
    this.edges = edges ?? []; // of a roadmap: pairs of nodes, one after the other
    this.total = Math.max(...this.trees.map(({ parents }) => parents.length), 0);
  }

  get nodes() {
    return this.trees.reduce((sum, { parents }) => sum + parents.length, 0);
  }

  shownOf(tree, step) {
    return Math.round((Math.min(step, this.total) / Math.max(this.total, 1)) * tree.parents.length);
  }

  /** The trees after a number of steps, as the player paints them. */
  at(step) {
    return this.trees.map((tree) => {
      const count = this.shownOf(tree, step);
      // A rewired node may have a parent that came later: it hangs in the air, unseen, till then.
      const parents = tree.parents.subarray(0, count).map((parent) => (parent < count ? parent : -1));
      return { kind: tree.kind, points: tree.points.subarray(0, 2 * count), parents, edges: this.edgesUpTo(count) };
    });
  }

  edgesUpTo(count) {
    const kept = [];
    for (let i = 0; i < this.edges.length; i += 2) {
      if (this.edges[i] < count && this.edges[i + 1] < count) kept.push(this.edges[i], this.edges[i + 1]);
    }
    return kept;
  }

  /** One sentence about what happened last. */
  sentence(step) {
    const { status, reason, cost } = this.answer;
    if (step >= this.total) {
      if (status !== "solved") return `${this.nodes} nodes and no path: ${reason || status}.`;
      return `There is a path after ${this.nodes} nodes. Shortened, it costs ${cost.toFixed(4)}.`;
    }
    if (step <= 1) return storyOf(this.planner).idea;
    const tree = this.trees[step % this.trees.length];
    const node = Math.max(this.shownOf(tree, step) - 1, 0);
    const parent = tree.parents[node];
    if (node === 0) return storyOf(this.planner).idea;
    return storyOf(this.planner).step({ tree: tree.kind, node, parent, runsOn: parent > 0 && parent === node - 1 });
  }
}
