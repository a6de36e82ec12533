#include "core/routes/improve_along_routes.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/search/trees/interpolate.hpp"
#include "core/space/motion_cost.hpp"

namespace asv::core {

namespace {

// Where these come from: on 9 problems, nine in ten of the paths that ended within 1 % of the best
// cost at most 1.25 times as much as that after some shortcuts (1.45 in one maze), 1.03 after three
// pulls, 1.02 after all of them.

/// So many shortcuts in a row without a gain end them.
constexpr int shortcut_patience = 25;
/// Above so many times the best cost, a path is dropped after the shortcuts, ...
constexpr double hopeless_after_shortcuts = 1.25;
/// ... after the first pulls, ...
constexpr int first_pulls = 3;
constexpr double hopeless_after_first_pulls = 1.07;
/// ... and not pulled at the fine spacing after all of them.
constexpr int more_pulls = 27, fine_pulls = 30;
constexpr double hopeless_after_pulls = 1.012;
/// Pieces: pulls before the second look and before the last, and what the last asks for.
constexpr int first_pulls_of_piece = 2, more_pulls_of_piece = 10;
constexpr double hopeless_piece = 1.005;
/// Pulls of the whole path, when it is new and when a piece of it is.
constexpr int pulls_of_whole = 4;
/// Shortest and longest piece, as shares of the cost of the path; beyond an end it is cut off.
constexpr double shortest_piece = 0.25, longest_piece = 1.2;
/// Of the work, what goes into searches along routes; the rest renews pieces. Untried routes come
/// before pieces as long as so much of the work is left: pieces do not mend a wrong route.
constexpr double route_share = 0.55, left_for_pieces = 0.5;
/// The path is shortened to the end when so much of the work is left, in units of what the first
/// shortcuts and pulls took; again only where it has got better by a share since.
constexpr double work_to_finish = 1.5, finished_again = 1e-3;
/// Microseconds of a move that finds nothing to do.
constexpr double idle_work = 50;

class RouteImprovement {
  public:
    RouteImprovement(const ChainWorld& world, ChainShortener& shortener, RouteSearch& routes,
                     const ImproveOptions& options, Rng& rng)
        : world_(world),
          shortener_(shortener),
          routes_(routes),
          options_(options),
          rng_(rng),
          improvement_(shortener, options),
          motion_cost_(world.chain) {}

    Configurations improve(Configurations path) {
        improvement_.take(std::move(path));
        if (improvement_.finished()) return improvement_.best_path();
        all_work_ = improvement_.work_left();
        shortener_.shortcut(improvement_, shortcut_patience, rng_);
        shortener_.pull_taut(improvement_, coarse_spacing, pulls_of_whole);
        const double late = work_to_finish * (all_work_ - improvement_.work_left());
        double finished_cost = improvement_.best_cost() / (1 - finished_again);
        while (!improvement_.finished()) {
            const double best = improvement_.best_cost(), left = improvement_.work_left();
            if (left < late && best < finished_cost * (1 - finished_again)) {
                shorten_to_the_end();
                finished_cost = improvement_.best_cost();
            } else if (exploring() || routes_have_less_than_their_share()) {
                try_route();
                work_on_routes_ += left - improvement_.work_left();
            } else {
                renew_piece();
                work_on_pieces_ += left - improvement_.work_left();
            }
        }
        return improvement_.best_path();
    }

  private:
    /// The motions of a path from one row to another.
    struct Piece {
        std::size_t first, last;
        double cost;
    };

    /// Is it time for routes that were not tried yet, and for nothing else?
    bool exploring() {
        return improvement_.work_left() > left_for_pieces * all_work_ &&
               routes_.has_untried(improvement_.best_cost());
    }

    bool routes_have_less_than_their_share() const {
        return work_on_routes_ < route_share * (work_on_routes_ + work_on_pieces_);
    }

    void shorten_to_the_end() {
        improvement_.take(improvement_.best_path());
        shortener_.shorten(improvement_, rng_);
    }

    void try_route() {
        RouteSearch::Found found = routes_.search_along_route(improvement_.best_cost(), rng_);
        improvement_.charge(found.work);
        if (found.path.empty()) return;
        const Configurations earlier = improvement_.best_path();
        const double earlier_cost = improvement_.best_cost();
        improvement_.take(std::move(found.path));
        const bool hopeful = shorten_in_stages(earlier_cost);
        routes_.note_cost(improvement_.cost());
        if (hopeful) shortener_.cross(earlier, improvement_, rng_);
    }

    /// False where the path was dropped on the way, or left as it is for the time being.
    bool shorten_in_stages(double best) {
        shortener_.shortcut(improvement_, shortcut_patience, rng_);
        if (improvement_.cost() > hopeless_after_shortcuts * best) return false;
        shortener_.pull_taut(improvement_, coarse_spacing, first_pulls);
        if (improvement_.cost() > hopeless_after_first_pulls * best || exploring()) return false;
        shortener_.pull_taut(improvement_, coarse_spacing, more_pulls);
        if (improvement_.cost() <= hopeless_after_pulls * best)
            shortener_.pull_taut(improvement_, fine_spacing, fine_pulls);
        return true;
    }

    /// Searches anew between two way points of the best path.
    void renew_piece() {
        const Configurations path = improvement_.best_path();
        const Piece piece = draw_piece(path);
        if (piece.last < piece.first + 2) {
            improvement_.charge(idle_work);
            return;
        }
        const Leader leader = rng_.chance(0.5) ? Leader::first_asv : Leader::last_asv;
        RouteSearch::Found found =
            routes_.search_between({row(path, piece.first), row(path, piece.last)}, leader, rng_);
        improvement_.charge(found.work);
        if (found.path.empty() || !shorten_piece(found.path, piece.cost)) return;
        improvement_.take(with_piece(path, piece, found.path));
        shortener_.pull_taut(improvement_, coarse_spacing, pulls_of_whole);
    }

    Piece draw_piece(const Configurations& path) {
        std::vector<double> cost_to{0};
        for (std::size_t i = 1; i < path.size() / dimension(); ++i)
            cost_to.push_back(cost_to.back() + motion_cost_(row(path, i - 1), row(path, i)));
        const double whole = cost_to.back();
        const double length = whole * rng_.uniform(shortest_piece, longest_piece);
        const double begin = rng_.uniform(-0.5 * length, whole - 0.5 * length);
        const auto first = std::upper_bound(cost_to.begin() + 1, cost_to.end() - 1, begin) - 1;
        const auto last = std::lower_bound(first, cost_to.end() - 1, begin + length);
        return {static_cast<std::size_t>(first - cost_to.begin()),
                static_cast<std::size_t>(last - cost_to.begin()), *last - *first};
    }

    /// False where it was dropped on the way.
    bool shorten_piece(Configurations& path, double old_cost) {
        ImproveOptions options;
        options.work = improvement_.work_left();
        options.limits = options_.limits;
        Improvement piece(shortener_, options);
        piece.take(std::move(path));
        shortener_.shortcut(piece, shortcut_patience, rng_);
        if (piece.cost() > hopeless_after_shortcuts * old_cost) return false;
        shortener_.pull_taut(piece, coarse_spacing, first_pulls_of_piece);
        if (piece.cost() > hopeless_after_first_pulls * old_cost) return false;
        shortener_.pull_taut(piece, coarse_spacing, more_pulls_of_piece);
        if (piece.cost() > hopeless_piece * old_cost) return false;
        path = piece.path();
        return true;
    }

    /// The path with another piece, which may have made another number of full turns.
    Configurations with_piece(const Configurations& path, const Piece& place,
                              const Configurations& piece) const {
        const auto d = static_cast<std::ptrdiff_t>(dimension());
        const auto rows = static_cast<std::ptrdiff_t>(place.first);
        Configurations joined(path.begin(), path.begin() + rows * d);
        joined.insert(joined.end(), piece.begin(), piece.end());
        std::vector<double> before(piece.end() - d, piece.end());
        for (std::size_t i = place.last + 1; i < path.size() / dimension(); ++i) {
            std::vector<double> next(row(path, i).begin(), row(path, i).end());
            unwrap(next, before, world_.wrapping());
            joined.insert(joined.end(), next.begin(), next.end());
            before = std::move(next);
        }
        return joined;
    }

    std::size_t dimension() const { return world_.chain.dimension(); }
    std::span<const double> row(const Configurations& path, std::size_t i) const {
        return {path.data() + i * dimension(), dimension()};
    }

    const ChainWorld& world_;
    ChainShortener& shortener_;
    RouteSearch& routes_;
    const ImproveOptions& options_;
    Rng& rng_;
    Improvement improvement_;
    double all_work_ = 0;
    double work_on_routes_ = 0, work_on_pieces_ = 0;
    MotionCost motion_cost_;
};

}  // namespace

Configurations improve_along_routes(Configurations path, const ChainWorld& world,
                                    ChainShortener& shortener, RouteSearch& routes,
                                    const ImproveOptions& options, Rng& rng) {
    return RouteImprovement(world, shortener, routes, options, rng).improve(std::move(path));
}

}  // namespace asv::core
