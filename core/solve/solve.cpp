#include "core/solve/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "core/bounds/feasibility.hpp"
#include "core/bounds/lower_bound.hpp"
#include "core/model/cost.hpp"
#include "core/model/planning_window.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/validation/validate.hpp"

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

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One call of solve().
class Solver {
  public:
    Solver(const Problem& problem, const SolveOptions& options)
        : given_(problem),
          options_(options),
          problem_(options.reverse ? reversed(problem) : problem),
          planning_(make_body_solver(problem_, options.planner)),
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
            find_bounds();
        }
        result_.statistics.time_total = seconds_since(options_.started);
        return std::move(result_);
    }

  private:
    static Problem reversed(Problem problem) {
        std::swap(problem.start, problem.goal);
        if (auto* arm = std::get_if<PlanarArm>(&problem.body)) std::swap(arm->start, arm->goal);
        return problem;
    }

    /// Seconds to keep for turning a path into steps, checking and writing it: some 5 sides of the
    /// field for each ASV, in steps of the greatest length, at thrice the half microsecond that
    /// each position takes.
    double time_to_finish() const {
        const Box window = planning_window(given_);
        const double side = std::max(window.high.x - window.low.x, window.high.y - window.low.y);
        const double positions =
            5 * side / given_.requirements.max_step * static_cast<double>(given_.asv_count());
        const double obstacles = static_cast<double>(given_.obstacles.size());
        return std::min(0.015 + 1.5e-6 * positions + 4e-6 * obstacles, 0.5 * options_.time_limit);
    }

    /// What any path costs, as well as that can be told in the time that is left: at most some
    /// quarter of it goes into searches, since the path that is found must not come too late.
    void find_bounds() {
        const double left = options_.time_limit - seconds_since(options_.started);
        const double preparation = 1e-3 + 1e-5 * static_cast<double>(given_.obstacles.size());
        if (left < preparation) return;
        constexpr double cells_per_second = 5e5;
        const auto effort =
            static_cast<std::size_t>(std::min(cells_per_second * left, 1.0 * max_bound_effort));
        const CostLowerBound bound = cost_lower_bound(given_, Reading::intended, effort);
        result_.statistics.cost_lower_bound = bound.total;
        result_.statistics.steps_lower_bound = steps_lower_bound(given_, bound);
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
        Costs costs;
        const Observer observer = note_costs(costs, thread == 0 ? make_observer() : Observer{});
        Attempt attempt = planning_->search(limits, rng, observer, thread);
        const std::lock_guard lock(mutex_);
        SolveStatistics& statistics = result_.statistics;
        statistics.state_checks += attempt.state_checks;
        statistics.edge_checks += attempt.edge_checks;
        const bool solved = attempt.search.outcome == Outcome::solved;
        if (!winner_ && (solved || thread == 0)) {
            failure_ = attempt.search.outcome;
            statistics.iterations = attempt.search.iterations;
            for (std::size_t side = 0; side < attempt.search.trees.size(); ++side)
                statistics.tree_nodes[side] = attempt.search.trees[side].size();
            if (options_.keep_trees) draw_trees(attempt.search);
        }
        if (!solved || winner_) return;
        winner_ = thread;
        stop_.request_stop();
        rows_ = std::move(attempt.search.path);
        const double cost = planning_->cost(rows_);
        statistics.cost_of_search = cost;
        if (costs.empty() || cost < costs.back().second)
            costs.emplace_back(seconds_since(options_.started), cost);
        std::tie(statistics.time_to_first, statistics.cost_first) = costs.front();
        statistics.cost_history = std::move(costs);
    }

    using Costs = std::vector<std::pair<double, double>>;

    /// Notes when a search that improves its path found which cost, then tells the other observer.
    Observer note_costs(Costs& costs, Observer other) const {
        return [this, &costs, told = std::move(other)](const Progress& progress) {
            if (progress.cost < (costs.empty() ? infinity : costs.back().second))
                costs.emplace_back(seconds_since(options_.started), progress.cost);
            if (told) told(progress);
        };
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
        const Configurations first = rows_;
        double best = infinity;
        const auto improve_once = [&](std::size_t thread) {
            Configurations rows = improved(first, thread);
            const double cost = planning_->cost(rows);
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

    Configurations improved(const Configurations& first, std::size_t thread) {
        ImprovementOrder order;
        order.work = cheap_work + 1e6 * options_.optimize;
        order.other_paths = options_.optimize > 0;
        order.limits.deadline = deadline_;
        order.limits.stop = options_.stop;
        // Searches that take much longer than the first one did are not worth their time.
        order.search_limits = order.limits;
        order.search_limits.max_iterations = 3 * result_.statistics.iterations + 200;
        order.on_better = [&](double cost) { note_better(cost, thread == 0); };
        Rng rng(~seed_of(*winner_ + thread));
        Attempt spent;
        Configurations rows = planning_->improve(first, order, rng, spent);
        const std::lock_guard lock(mutex_);
        result_.statistics.state_checks += spent.state_checks;
        result_.statistics.edge_checks += spent.edge_checks;
        return rows;
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
        Path path = planning_->steps(rows_);
        if (options_.reverse) path = backwards(path);
        const double total = cost(given_, path);
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

    static Path backwards(const Path& path) {
        Path result(path.asv_count());
        result.reserve(path.size());
        for (std::size_t i = path.size(); i-- > 0;) result.push_back(path.state(i));
        return result;
    }

    void draw_trees(const SearchResult& search) {
        result_.trees.clear();
        result_.edges = search.edges;
        for (const Tree& tree : search.trees) {
            const bool roadmap = search.trees.size() == 1 && !search.edges.empty();
            const bool at_start = result_.trees.empty() != options_.reverse;
            const auto root =
                roadmap ? TreeRoot::roadmap : (at_start ? TreeRoot::start : TreeRoot::goal);
            TreePicture picture{root, planning_->places(tree), {}};
            for (std::uint32_t node = 0; node < tree.size(); ++node)
                picture.parents.push_back(tree.parent(node) == Tree::none
                                              ? -1
                                              : static_cast<std::int64_t>(tree.parent(node)));
            result_.trees.push_back(std::move(picture));
        }
        if (options_.reverse) std::reverse(result_.trees.begin(), result_.trees.end());
    }

    const Problem& given_;
    const SolveOptions& options_;
    Problem problem_;
    std::unique_ptr<BodySolver> planning_;
    Clock::time_point deadline_;
    std::stop_source stop_;
    std::stop_callback<std::function<void()>> outside_stop_;
    std::mutex mutex_;
    std::optional<std::size_t> winner_;
    std::optional<std::string> infeasible_;
    Outcome failure_ = Outcome::deadline;
    Configurations rows_;
    double last_report_ = 0;
    SolveResult result_;
};

}  // namespace

SolveResult solve(const Problem& problem, const SolveOptions& options) {
    require_usable(options.planner, problem.body_kind());
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
