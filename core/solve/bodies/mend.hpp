#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/limits.hpp"
#include "core/search/search_result.hpp"
#include "core/search/trees/interpolate.hpp"

namespace asv::core {

/// Mends a path whose motions may no longer be valid, in any space.
///
/// The rows are looked at a stride apart, nearer where motions are blocked, and those that proven
/// motions join make up pieces. From the start on, each piece is reached by steering or by a
/// search, then followed to its end; at last the goal.
template <ConfigurationSpace Space>
class PathMender {
  public:
    using MotionValid = std::function<bool(std::span<const double>, std::span<const double>)>;
    /// Searches between two configurations for a while.
    using Search = std::function<SearchResult(const Query&)>;

    PathMender(Space& space, MotionValid valid, Search search)
        : space_(space), valid_(std::move(valid)), search_(std::move(search)) {}

    /// Precondition: start and goal are valid; angles of neighbouring rows are unwrapped alike.
    SearchResult mend(const Query& query, const Configurations& rows) {
        rows_ = &rows;
        result_ = {};
        result_.path.assign(query.start.begin(), query.start.end());
        find_pieces();
        for (const Piece& piece : pieces_) {
            if (!reach(row(piece.first))) return std::move(result_);
            for (const std::size_t next : piece.rest) append(row(next));
        }
        if (reach(query.goal)) result_.outcome = Outcome::solved;
        return std::move(result_);
    }

  private:
    /// Rows that one motion passes over where nothing is in its way.
    static constexpr std::size_t stride = 8;

    /// Rows that proven motions join.
    struct Piece {
        std::size_t first;
        std::vector<std::size_t> rest = {};
    };

    std::size_t dimension() const { return space_.dimension(); }
    std::span<const double> row(std::size_t i) const {
        return {rows_->data() + i * dimension(), dimension()};
    }
    std::span<const double> last() const {
        return {result_.path.data() + result_.path.size() - dimension(), dimension()};
    }

    void find_pieces() {
        pieces_ = {{0}};
        const std::size_t last_row = rows_->size() / dimension() - 1;
        for (std::size_t i = 0; i < last_row;) {
            const std::size_t next = std::min(i + stride, last_row);
            follow(i, next);
            i = next;
        }
        // A row on its own is as likely in the way as on it.
        std::erase_if(pieces_, [](const Piece& piece) { return piece.rest.empty(); });
    }

    void follow(std::size_t from, std::size_t to) {
        if (valid_(row(from), row(to))) {
            pieces_.back().rest.push_back(to);
        } else if (to - from > 1) {
            const std::size_t middle = from + (to - from) / 2;
            follow(from, middle);
            follow(middle, to);
        } else {
            pieces_.push_back({to});
        }
    }

    /// Appends a row as it is, but for full turns.
    void append(std::span<const double> next) {
        std::vector<double> unwrapped(next.begin(), next.end());
        unwrap(unwrapped, last(), space_.wrapping());
        result_.path.insert(result_.path.end(), unwrapped.begin(), unwrapped.end());
    }

    /// Goes on to a target; false where that fails.
    bool reach(std::span<const double> target) {
        const std::vector<double> from(last().begin(), last().end());
        std::vector<double> unwrapped(target.begin(), target.end());
        unwrap(unwrapped, from, space_.wrapping());
        Configurations between;
        if (space_.steer(from, unwrapped, between) == Steered::reached) {
            result_.path.insert(result_.path.end(), between.begin(), between.end());
            return true;
        }
        const SearchResult found = search_({from, unwrapped});
        result_.iterations += found.iterations;
        result_.outcome = found.outcome;
        if (found.outcome != Outcome::solved) return false;
        for (std::size_t i = dimension(); i < found.path.size(); i += dimension())
            append({found.path.data() + i, dimension()});
        result_.outcome = Outcome::iterations;
        return true;
    }

    Space& space_;
    MotionValid valid_;
    Search search_;
    const Configurations* rows_ = nullptr;
    std::vector<Piece> pieces_;
    SearchResult result_;
};

}  // namespace asv::core
