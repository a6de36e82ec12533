#include "asv/core/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "asv/core/path/cost.hpp"
#include "asv/core/path/feasibility.hpp"
#include "asv/core/path/improve.hpp"
#include "asv/core/path/lower_bound.hpp"
#include "asv/core/path/motion_cost.hpp"
#include "asv/core/path/primitive_steps.hpp"
#include "asv/core/space/broom_world.hpp"
#include "asv/core/space/sliding_space.hpp"
#include "asv/core/validate.hpp"
#include "asv/geometry/polygon.hpp"

namespace asv::core {

namespace {

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

Clock::time_point after(Clock::time_point begin, double seconds) {
    // Beyond what a clock can count, never.
    constexpr double longest = 1e9;
    if (!(seconds < longest)) return Clock::time_point::max();
    return begin +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Microseconds of work for --optimize 0: shortcuts that take less time than writing what they
/// save.
constexpr double cheap_work = 2000;

/// Seconds of search after which a proof that there is no path is looked for, some of them for each
/// obstacle: about what the proof itself takes.
double easy(const Problem& problem) {
    return 0.2 + 2e-5 * static_cast<double>(problem.obstacles.size());
}

/// What one thread makes of the problem.
struct Attempt {
    SearchResult search;
    std::uint64_t state_checks = 0, edge_checks = 0, constrained_steps = 0;
};

Attempt run(const AutoPlanner& planner, const BroomWorld& world, const Limits& limits, Rng& rng,
            const Observer& observer) {
    SlidingSpace space(world, planner.steering);
    Attempt attempt;
    attempt.search =
        slide_pull(space, {world.start, world.goal}, planner.search, limits, rng, observer);
    attempt.state_checks = space.checker().state_checks();
    attempt.edge_checks = space.checker().motion_checks();
    attempt.constrained_steps = space.constrained_steps();
    return attempt;
}

Attempt run(const RrtConnectPlanner& planner, const BroomWorld& world, const Limits& limits,
            Rng& rng, const Observer& observer) {
    ClassicSpace space(world, planner.space);
    Attempt attempt;
    attempt.search =
        rrt_connect(space, {world.start, world.goal}, planner.search, limits, rng, observer);
    attempt.state_checks = space.checker().state_checks();
    attempt.edge_checks = space.checker().motion_checks();
    return attempt;
}

Anchor anchor_of(const Planner& planner) {
    return std::holds_alternative<RrtConnectPlanner>(planner) ? Anchor::first_asv
                                                              : Anchor::centroid;
}

/// One call of solve().
class Solver {
  public:
    Solver(const Problem& problem, const SolveOptions& options)
        : given_(problem),
          options_(options),
          problem_(options.reverse ? reversed(problem) : problem),
          world_(problem_, anchor_of(options.planner)),
          deadline_(after(options.started, options.time_limit - time_to_finish())),
          outside_stop_(options.stop, [this] { stop_.request_stop(); }) {}

    SolveResult run() {
        search();
        if (infeasible_) {
            result_.status = SolveStatus::infeasible;
            result_.reason = *infeasible_;
        } else if (!winner_) {
            result_.status =
                options_.stop.stop_requested() ? SolveStatus::interrupted : SolveStatus::timeout;
            result_.reason = "no path found: " + std::string(name(failure_));
        } else {
            improve_path();
            finish();
            if (seconds_since(options_.started) + time_of_bound() < options_.time_limit)
                result_.statistics.cost_lower_bound = cost_lower_bound(given_).total;
        }
        result_.statistics.time_total = seconds_since(options_.started);
        return std::move(result_);
    }

  private:
    static Problem reversed(Problem problem) {
        std::swap(problem.start, problem.goal);
        return problem;
    }

    /// Seconds to keep for turning a path into steps, checking and writing it: some 5 units of way
    /// for each ASV, in steps of the greatest length, at a few microseconds for each position.
    double time_to_finish() const {
        const double positions =
            5 / given_.requirements.max_step * static_cast<double>(given_.asv_count());
        const double obstacles = static_cast<double>(given_.obstacles.size());
        return std::min(0.02 + 3e-6 * positions + 1e-5 * obstacles, 0.5 * options_.time_limit);
    }

    /// Seconds that the lower bound takes at most, roughly.
    double time_of_bound() const {
        return 1e-3 + 3e-5 * static_cast<double>(given_.obstacles.size());
    }

    std::uint64_t seed_of(std::size_t thread) const {
        return options_.seed + 0x9e3779b97f4a7c15u * thread;
    }

    /// All threads race; the first path stops the others.
    void search() {
        std::vector<std::jthread> racers;
        for (std::size_t thread = 1; thread < std::max<std::size_t>(options_.threads, 1); ++thread)
            racers.emplace_back([this, thread] { race(thread); });
        race(0);
    }

    void race(std::size_t thread) {
        Limits limits;
        limits.deadline = deadline_;
        limits.stop = stop_.get_token();
        Rng rng(seed_of(thread));
        const Observer observer = thread == 0 ? make_observer() : Observer{};
        Attempt attempt = std::visit(
            [&](const auto& planner) { return core::run(planner, world_, limits, rng, observer); },
            options_.planner);
        const std::lock_guard lock(mutex_);
        SolveStatistics& statistics = result_.statistics;
        statistics.state_checks += attempt.state_checks;
        statistics.edge_checks += attempt.edge_checks;
        const bool solved = attempt.search.outcome == Outcome::solved;
        if (!winner_ && (solved || thread == 0)) {
            failure_ = attempt.search.outcome;
            statistics.iterations = attempt.search.iterations;
            for (int side : {0, 1}) {
                const auto index = static_cast<std::size_t>(side);
                statistics.tree_nodes[side] = attempt.search.trees[index].size();
            }
            if (options_.keep_trees) draw_trees(attempt.search.trees);
        }
        if (!solved || winner_) return;
        winner_ = thread;
        stop_.request_stop();
        rows_ = std::move(attempt.search.path);
        statistics.time_to_first = seconds_since(options_.started);
        statistics.cost_first = MotionCost(world_.chain).path(rows_);
        statistics.cost_history.emplace_back(statistics.time_to_first, statistics.cost_first);
    }

    /// Reports progress and, once a search turns out not to be easy, looks for a proof that it is
    /// in vain. The search itself never sees either.
    Observer make_observer() {
        return [this, last = 0.0, checked = false](const Progress& progress) mutable {
            const double elapsed = seconds_since(options_.started);
            if (!checked && elapsed > easy(given_) && options_.time_limit > 10 * easy(given_)) {
                checked = true;
                const Feasibility proof = check_separation(given_);
                if (proof.cause != Infeasibility::none) {
                    infeasible_ = proof.reason;
                    stop_.request_stop();
                }
            }
            if (!options_.on_progress || elapsed - last < 0.1) return;
            last = elapsed;
            options_.on_progress({progress, std::nullopt, elapsed});
        };
    }

    /// Every thread improves the path with draws of its own; the best one stays.
    void improve_path() {
        const Rows first = rows_;
        double best = std::numeric_limits<double>::infinity();
        const auto improve_once = [&](std::size_t thread) {
            Rows rows = improved(first, thread);
            const double cost = MotionCost(world_.chain).path(rows);
            const std::lock_guard lock(mutex_);
            if (cost >= best) return;
            best = cost;
            rows_ = std::move(rows);
        };
        std::vector<std::jthread> helpers;
        for (std::size_t thread = 1; thread < std::max<std::size_t>(options_.threads, 1); ++thread)
            helpers.emplace_back([&improve_once, thread] { improve_once(thread); });
        improve_once(0);
    }

    Rows improved(const Rows& first, std::size_t thread) {
        Limits limits;
        limits.deadline = deadline_;
        limits.stop = options_.stop;
        // Searches that take much longer than the first one did are not worth their time.
        Limits search_limits = limits;
        search_limits.max_iterations = 3 * result_.statistics.iterations + 200;
        const auto another = [&](Rng& draws) {
            Attempt attempt = std::visit(
                [&](const auto& chosen) {
                    return core::run(chosen, world_, search_limits, draws, {});
                },
                options_.planner);
            count(attempt.state_checks, attempt.edge_checks);
            return AnotherPath{
                std::move(attempt.search.path),
                work_of(attempt.state_checks, attempt.constrained_steps, given_.asv_count())};
        };
        MotionChecker checker = world_.make_checker();
        const auto* planner = std::get_if<AutoPlanner>(&options_.planner);
        SlideSteering steering(checker, world_.metric,
                               planner ? planner->steering : SlideOptions{});
        Rng rng(~seed_of(*winner_ + thread));
        Rows rows = improve(first, checker, world_.metric, steering,
                            options_.optimize > 0 ? another : std::function<AnotherPath(Rng&)>{},
                            cheap_work + 1e6 * options_.optimize, limits, rng,
                            [&](double cost) { note_better(cost, thread == 0); });
        count(checker.state_checks(), checker.motion_checks());
        return rows;
    }

    void count(std::uint64_t state_checks, std::uint64_t edge_checks) {
        const std::lock_guard lock(mutex_);
        result_.statistics.state_checks += state_checks;
        result_.statistics.edge_checks += edge_checks;
    }

    /// Keeps the history of the best cost of all threads; the first one reports.
    void note_better(double cost, bool reports) {
        const double elapsed = seconds_since(options_.started);
        const std::lock_guard lock(mutex_);
        auto& history = result_.statistics.cost_history;
        if (cost < history.back().second) history.emplace_back(elapsed, cost);
        if (!reports || !options_.on_progress || elapsed - last_report_ < 0.1) return;
        last_report_ = elapsed;
        options_.on_progress({{}, history.back().second, elapsed});
    }

    void finish() {
        MotionChecker checker = world_.make_checker();
        const Path planned = primitive_steps(world_.problem, rows_, checker);
        Path path(planned.asv_count());
        path.reserve(planned.size());
        std::vector<Point> state;
        for (std::size_t i = 0; i < planned.size(); ++i) {
            const auto from = planned.state(options_.reverse ? planned.size() - 1 - i : i);
            state.assign(from.begin(), from.end());
            if (world_.transposed)
                for (Point& p : state) std::swap(p.x, p.y);
            path.push_back(state);
        }
        const double total = cost(path);
        Solution solution{std::move(path), total};
        const ValidationReport report =
            validate(given_, solution, {.tolerance = given_.requirements.tolerance});
        if (!report.valid()) {
            for (const CheckResult& check : report.checks)
                if (!check.ok())
                    throw std::logic_error("the path found fails the check of " +
                                           std::string(name(check.check)) + ": " + describe(check));
        }
        result_.statistics.cost = total;
        result_.solution = std::move(solution);
        result_.status = SolveStatus::solved;
    }

    void draw_trees(const std::vector<Tree>& trees) {
        result_.trees.clear();
        Pose pose = world_.chain.make_pose();
        for (const Tree& tree : trees) {
            TreePicture picture;
            for (std::uint32_t node = 0; node < tree.size(); ++node) {
                world_.chain.forward(tree.row(node), pose);
                const Point at =
                    world_.transposed ? Point{pose.y[0], pose.x[0]} : Point{pose.x[0], pose.y[0]};
                picture.points.push_back(at);
                picture.parents.push_back(tree.parent(node) == Tree::none
                                              ? -1
                                              : static_cast<std::int64_t>(tree.parent(node)));
            }
            result_.trees.push_back(std::move(picture));
        }
        if (options_.reverse) std::reverse(result_.trees.begin(), result_.trees.end());
    }

    const Problem& given_;
    const SolveOptions& options_;
    Problem problem_;
    BroomWorld world_;
    Clock::time_point deadline_;
    std::stop_source stop_;
    std::stop_callback<std::function<void()>> outside_stop_;
    std::mutex mutex_;
    std::optional<std::size_t> winner_;
    std::optional<std::string> infeasible_;
    Outcome failure_ = Outcome::deadline;
    Rows rows_;
    double last_report_ = 0;
    SolveResult result_;
};

}  // namespace

std::string_view name(SolveStatus status) {
    switch (status) {
        case SolveStatus::solved:
            return "solved";
        case SolveStatus::timeout:
            return "timeout";
        case SolveStatus::infeasible:
            return "infeasible";
        case SolveStatus::interrupted:
            return "interrupted";
    }
    return "unknown";
}

std::vector<InvalidEnd> invalid_ends(const Problem& problem) {
    std::vector<InvalidEnd> found;
    // Where no chain has the area, that of start and goal is not what is wrong.
    if (check_area(problem).cause != Infeasibility::none) return found;
    for (const bool goal : {false, true}) {
        const ValidationReport report =
            validate_state(problem, goal ? problem.goal : problem.start,
                           {.tolerance = problem.requirements.tolerance});
        for (const CheckResult& check : report.checks)
            if (!check.ok()) found.push_back({goal, describe(check)});
    }
    return found;
}

SolveResult solve(const Problem& problem, const SolveOptions& options) {
    require_usable(options.planner);
    const auto infeasible = [](Feasibility&& proof) {
        SolveResult result;
        result.status = SolveStatus::infeasible;
        result.reason = std::move(proof.reason);
        return result;
    };
    if (auto proof = check_area(problem); proof.cause != Infeasibility::none)
        return infeasible(std::move(proof));
    if (const auto invalid = invalid_ends(problem); !invalid.empty())
        throw std::invalid_argument(std::string(invalid[0].goal ? "goal" : "start") +
                                    " is not valid: " + invalid[0].reason);
    if (auto proof = check_orientation(problem); proof.cause != Infeasibility::none)
        return infeasible(std::move(proof));
    return Solver(problem, options).run();
}

}  // namespace asv::core
