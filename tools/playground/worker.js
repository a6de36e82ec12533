// The planner and the validator in a worker: messages in, messages out, in order.
//
// Page -> worker {id, kind, ...}; worker -> page {id, kind: "result" | "progress" | "error", ...}. An error has a
// message and, where text was read, its line and column. A problem is the JSON object of docs/scenario.md (no map). States are a
// Float64Array, one state after the other, each x1 y1 x2 y2 ... in chain order (of an arm: all joints, the base first).
// Arrays of an answer are transferred. Before all else the worker says {kind: "ready", version, simd}.
//
//   check    {problem}           -> {start: [violation], goal: [violation], minimumArea, infeasible: null | text}
//                                   violation: {requirement, text, asv, broom, obstacle}, numbers from 1, or null
//   plan     {problem, planner, settings: {key: value}, seed, optimize, timeLimit, warm: states | null, trees: bool,
//             progress: bool, slot}
//                                -> {status, reason, cost, bound, seconds: {first, total, check}, states, valid, violation,
//                                    history: [[seconds, cost]], trees: null | {start: tree, goal: tree}}
//                                   status: "solved", "not found", "infeasible", "invalid ends" or "interrupted";
//                                   tree: {points: states (of ASV 1, the tip or the point), parents: Int32Array}
//                                   with progress, {cost, states} after each slice that found a better path
//   validate {problem, states}   -> {valid, checks: [{name, ok, text}], cost}
//   profile  {problem, states}   -> {clearance, area, turn, cost}: Float64Arrays, one number for each state
//   planners {}                  -> {planners: [{name, summary, source, settings: [{key, meaning, unit, min, max, default}]}]}
//   read     {name, text, problem} -> {problem, states | null}; the problem is needed for a solution file
//   write    {what: "problem" | "scenario" | "solution", problem, states} -> {name, text}
//
// optimize and timeLimit are seconds. A plan is warm-started from the states of `warm`, a path of a problem like this one.
// Latest wins: a plan that waits is given up ("interrupted") when another one of the same slot arrives, and one that is
// being improved in slices (progress: true) ends with the best path it has.
"use strict";
