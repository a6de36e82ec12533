#include "tools/manual/words.hpp"

#include <stdexcept>

namespace asv::tools::manual {

namespace {

const Entry problem_file{
    "PROBLEM",
    "A problem file: the number n of ASVs; the n positions at the start, two coordinates each; "
    "those at the goal; the number of obstacles; four corners for each. Or a scenario, a JSON file "
    "for arms, points, other brooms, bounds and maps."};
const Entry solution_file{
    "SOLUTION", "The cost, then a line of positions for every primitive step, start and goal too."};

Words solve() {
    return {"plan a motion for a chain of ASVs among obstacles",
            {"ASVs (autonomous surface vehicles) are points in the plane, joined to a chain by "
             "rigid brooms. The chain may touch no obstacle, must stay convex and keep an area. A "
             "solution is written only when an independent validator accepts it.",
             "A summary goes to standard error, progress too when that is a terminal. Ctrl-C ends "
             "the search or the improvement; the best solution so far is written."},
            {problem_file,
             solution_file,
             {"Trajectory",
              "For each sample its time in seconds and, for every vehicle, position, heading in "
              "radians and speed; in YAML a nav_msgs/Path of ROS for each vehicle."},
             {"Certificate",
              "JSON: what a proof that there is no path rests on, for asv-validate --certificate."},
             {"Trees", "JSON with a point for ASV 1 in every node; asv-view draws them."},
             {"Statistics", "JSON with times, counts, costs and what any path costs at least."}},
            {{"asv-solve problem.txt solution.txt", "Plans with the default planner."},
             {"asv-solve problem.txt solution.txt --planner rrt-connect --set ladder=off",
              "Takes another planner and one of its settings."},
             {"asv-solve problem.txt solution.txt --seed 7 --threads 1",
              "Gives the same file each time, byte for byte."},
             {"asv-solve problem.txt solution.txt --trajectory t.csv --speed 0.05 "
              "--acceleration 0.02",
              "Writes the path with times, too."},
             {"asv-solve problem.txt solution.txt --certificate proof.json",
              "Writes the proof where there is no path."},
             {"asv-solve --list-planners", "Tells all planners and settings, with sources."}}};
}

Words validate() {
    return {"check a solution, or the start and the goal of a problem",
            {"Predicates are exact. Each line says how many states were looked at, and which one "
             "comes nearest to a violation or is the worst one."},
            {problem_file, solution_file},
            {{"asv-validate problem.txt", "Are the start and the goal of the problem valid?"},
             {"asv-validate problem.txt solution.txt --continuous",
              "Is the solution valid, between its steps too?"},
             {"asv-validate problem.txt --certificate proof.json",
              "Does the proof hold that there is no path?"},
             {"asv-validate problem.txt solution.txt --trajectory t.csv --speed 0.05 "
              "--acceleration 0.02",
              "Does the trajectory keep to the path and the limits?"}}};
}

Words view() {
    return {"draw a problem and its solution, or make a player or a gallery",
            {"The kind of an output is told by the ending of its name. A player is one page with "
             "everything in it; it needs a browser and no network. A solution that is not valid "
             "is shown with what is wrong in red."},
            {problem_file,
             solution_file,
             {"NAME.solution.txt, NAME.trees.json, NAME.stats.json",
              "What a gallery takes for the problem NAME.txt, where they exist."}},
            {{"asv-view problem.txt -o problem.svg", "Draws start, goal and obstacles."},
             {"asv-view problem.txt solution.txt -o solution.pdf -o solution.html",
              "Draws the solution and makes a player of it."},
             {"asv-view --gallery pictures testcases", "Lays out all problems of a folder."}}};
}

Words bench() {
    return {
        "run planners on problems with many seeds and tell how it went",
        {"Times of different machines are compared in a unit u, the time of a million plain "
         "state checks in the same session."},
        {problem_file,
         {"Outputs",
          "Tables in Markdown or LaTeX, CSV, JSON, plots, logs of OMPL's benchmarks, and an "
          "SQLite database for Planner Arena."}},
        {{"asv-bench testcases/3ASV.txt --planner auto --planner rrt --seeds 20",
          "Compares two planners and prints a table."},
         {"asv-bench testcases/3ASV.txt --planner \"swaps: rrt-connect swap-limiter=on\"",
          "Runs a planner with a setting under a name of its own."},
         {"asv-bench testcases/3ASV.txt --planner \"mine: exec ./my-planner {problem} {solution}\"",
          "Runs another program, and checks what it writes."},
         {"asv-bench \"generate: corridor -n 7 --seed 3\" --planner all",
          "Runs all planners on a problem made from words of asv-generate."},
         {"asv-bench --set \"maze-0*\" --seeds 1 --time-limit 2",
          "Runs the mazes for up to nine ASVs of the benchmark set."},
         {"asv-bench testcases/*.txt --planner all --csv runs.csv --plot runs.svg",
          "Runs all planners on many problems."},
         {"asv-bench testcases/*.txt --resume sweep.jsonl --csv runs.csv",
          "Runs a sweep that, once killed, goes on when the same is typed again."},
         {"asv-bench --from monday.json --from tuesday.json --plot both.svg",
          "Puts runs of two benchmarks together, and runs nothing."}}};
}

Words ompl() {
    return {"plan with a planner of OMPL",
            {"OMPL is the Open Motion Planning Library. Its planners get the space of the body and "
             "a check of motions that proves them whole. A solution is written only when an "
             "independent validator accepts it, but for --motion sampled.",
             "A planner's draws follow the seed; PRM and PRMstar, which look for the path in a "
             "thread of their own, do not give the same path each time even so."},
            {problem_file, solution_file},
            {{"asv-ompl problem.txt solution.txt --planner KPIECE1 --set range=0.5",
              "Plans with another planner and one of its parameters."},
             {"asv-ompl --list-planners", "Tells all planners and parameters."}}};
}

Words generate() {
    return {
        "write a random problem of a family",
        {"The options of a family stand behind its name; those of all families may stand "
         "before or behind it.",
         "With --from there is no family: a scenario has the world and the start, and a goal is "
         "drawn that turns the same way. Lengths of options are those of brooms 0.05 long, and "
         "grow with the brooms of the scenario."},
        {{"OUTPUT", "The problem file, as asv-solve reads it; with --from a scenario."},
         {"OUTPUT.json", "With --solvable: the verdict and all parameters."}},
        {{"asv-generate -n 5 --seed 3 -o maze.txt maze", "Draws a maze for five ASVs."},
         {"asv-generate corridor -n 7 --height-factor 1.1 -o corridor.txt",
          "Draws a corridor that is hardly higher than the chain must be."},
         {"asv-generate rooms -n 5 --infeasible fenced -o fenced.txt",
          "Draws rooms with a fence around the goal, so that there is no path."},
         {"asv-generate --from start.json --seed 2 -o problem.json",
          "Draws a goal for a scenario that has a start alone."},
         {"asv-generate maze --help", "Lists the options of a family."}}};
}

}  // namespace

Words words_of(std::string_view program) {
    if (program == "asv-solve") return solve();
    if (program == "asv-validate") return validate();
    if (program == "asv-view") return view();
    if (program == "asv-bench") return bench();
    if (program == "asv-generate") return generate();
    if (program == "asv-ompl") return ompl();
    throw std::invalid_argument("no manual page for '" + std::string(program) + "'");
}

std::vector<Entry> environment_of_all() {
    return {{"ASV_SIMD",
             "The instruction set that vector code runs on, instead of the best that the processor "
             "has: AVX3 (which is AVX-512), AVX2, SSE4 or SCALAR (portable C++) on x86; NEON on "
             "Arm. Answers and files are the same on each."}};
}

}  // namespace asv::tools::manual
