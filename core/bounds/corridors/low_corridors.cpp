#include "core/bounds/corridors/low_corridors.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "core/bounds/corridors/area_between_walls.hpp"
#include "core/bounds/walls.hpp"

namespace asv::core {

namespace {

struct NumberedWall {
    Wall wall;
    std::optional<std::size_t> obstacle;
};

class LowCorridors {
  public:
    explicit LowCorridors(const Problem& problem)
        : requirements_(problem.requirements),
          asv_count_(problem.asv_count()),
          // The numbers of the proof, each by slightly too much.
          tolerance_(requirements_.tolerance + rounding_slack(requirements_)),
          step_(requirements_.max_step + tolerance_),
          broom_(requirements_.broom_length + tolerance_),
          half_chain_(broom_ * static_cast<double>(asv_count_ - 1) / 2),
          required_area_((requirements_.min_area(asv_count_) - requirements_.tolerance) *
                         (1 - 1e-9)),
          too_low_(required_area_ / (2 * half_chain_) * (1 - 1e-9)) {
        for (const Wall& wall : outside(requirements_)) walls_.push_back({wall, std::nullopt});
        for (std::size_t i = 0; i < problem.obstacles.size(); ++i)
            add_wall(problem.obstacles[i], i);
    }

    std::vector<LowCorridor> find() {
        for (const bool upright : {false, true}) {
            if (upright) {
                for (auto& [wall, obstacle] : walls_)
                    wall = {transposed(wall.whole), transposed(wall.shrunk)};
            }
            find_between_lower_and_upper(upright);
        }
        return std::move(found_);
    }

  private:
    /// Walls that are too short either way or too thin are none.
    void add_wall(const Box& whole, std::size_t obstacle) {
        const Box left = shrunk(whole, shrink_for_steps(requirements_), requirements_);
        const double longer = std::max(whole.high.x - whole.low.x, whole.high.y - whole.low.y);
        if (vanishes(left) || longer < 2 * half_chain_) return;
        walls_.push_back({{whole, left}, obstacle});
    }

    void find_between_lower_and_upper(bool upright) {
        std::sort(walls_.begin(), walls_.end(), [](const auto& a, const auto& b) {
            return a.wall.whole.low.y < b.wall.whole.low.y;
        });
        for (const NumberedWall& lower : walls_) {
            const double top = lower.wall.whole.high.y;
            // Shrinking opens a gap where they overlap by less.
            const double lowest = top - 2 * shrink_for_steps(requirements_) - tolerance_;
            // A flat chain has more area than a third of a strip as long as it.
            const double highest = top + 3 * required_area_ / (2 * half_chain_);
            auto upper = std::partition_point(walls_.begin(), walls_.end(), [&](const auto& other) {
                return other.wall.whole.low.y < lowest;
            });
            for (; upper != walls_.end() && upper->wall.whole.low.y <= highest; ++upper)
                add_if_too_low(lower, *upper, upright);
        }
    }

    void add_if_too_low(const NumberedWall& lower, const NumberedWall& upper, bool upright) {
        const Box& below = lower.wall.whole;
        const Box& above = upper.wall.whole;
        // One that starts below the other and ends above it is no wall above it.
        if (above.high.y <= below.high.y || above.low.y <= below.low.y) return;
        const double from_mouth = tolerance_ + half_chain_ + step_ / 2;
        const double left = std::max(below.low.x, above.low.x) + from_mouth;
        const double right = std::min(below.high.x, above.high.x) - from_mouth;
        if (left >= right) return;
        LowCorridor corridor;
        corridor.height = above.low.y - below.high.y;
        if (!is_too_low(corridor.height + 2 * tolerance_)) return;
        const Box closed{{left, lower.wall.shrunk.high.y}, {right, upper.wall.shrunk.low.y}};
        if (vanishes(closed)) return;
        corridor.closed = upright ? transposed(closed) : closed;
        corridor.walls = {lower.obstacle, upper.obstacle};
        corridor.upright = upright;
        found_.push_back(corridor);
    }

    /// Asks for the area only where no lower or higher corridor has told it already.
    bool is_too_low(double height) {
        if (height <= too_low_) return true;
        if (height >= high_enough_) return false;
        const bool found = max_area_between_walls(asv_count_, broom_, height) < required_area_;
        (found ? too_low_ : high_enough_) = height;
        return found;
    }

    const Requirements& requirements_;
    std::size_t asv_count_;
    double tolerance_, step_, broom_, half_chain_, required_area_;
    std::vector<NumberedWall> walls_;
    double too_low_;  ///< the greatest height known to be; at first that of a strip of the area
    double high_enough_ = std::numeric_limits<double>::infinity();  ///< or nothing is proven
    std::vector<LowCorridor> found_;
};

/// To five digits.
std::string short_number(double value) {
    std::ostringstream text;
    text << std::setprecision(5) << value;
    return text.str();
}

/// Likewise, but never more than it is.
std::string rounded_down(double value) {
    double unit = 1;
    while (unit * 1e4 > value) unit /= 10;
    while (unit * 1e5 <= value) unit *= 10;
    return short_number(std::floor(value / unit) * unit);
}

std::string height_of(const LowCorridor& corridor) {
    return short_number(corridor.height) + (corridor.upright ? " wide" : " high");
}

}  // namespace

Point middle_of_chain(const std::vector<Point>& state) {
    const Point& before = state[(state.size() - 1) / 2];
    const Point& after = state[state.size() / 2];
    return {(before.x + after.x) / 2, (before.y + after.y) / 2};
}

std::vector<LowCorridor> find_low_corridors(const Problem& problem) {
    if (problem.body_kind() != BodyKind::chain || problem.asv_count() < 3) return {};
    return LowCorridors(problem).find();
}

std::string place_of(const std::array<std::optional<std::size_t>, 2>& walls, bool upright) {
    const auto& [first, second] = walls;
    if (first && second)
        return "between obstacles " + std::to_string(*first + 1) + " and " +
               std::to_string(*second + 1);
    if (!first && !second) return "between opposite borders";
    const std::string border = upright ? (first ? "right" : "left") : (first ? "upper" : "lower");
    return "between obstacle " + std::to_string((first ? *first : *second) + 1) + " and the " +
           border + " border";
}

std::string describe(const std::vector<LowCorridor>& corridors, const Problem& problem) {
    const Requirements& requirements = problem.requirements;
    const double least = height_without_chains(problem.asv_count(), requirements);
    // Corridors that are named are too low, so that this is above 0.
    const std::string needed = rounded_down(least - 2 * requirements.tolerance) + " is needed";
    std::string sentence =
        "no chain of " + std::to_string(problem.asv_count()) + " ASVs passes the ";
    if (corridors.size() == 1)
        return sentence + "corridor " + place_of(corridors[0].walls, corridors[0].upright) +
               ": it is " + height_of(corridors[0]) + ", and " + needed;
    sentence += "corridors ";
    for (std::size_t i = 0; i < corridors.size(); ++i) {
        if (i > 0) sentence += i + 1 < corridors.size() ? ", " : " and ";
        sentence += place_of(corridors[i].walls, corridors[i].upright) + " (" +
                    height_of(corridors[i]) + ")";
    }
    return sentence + ": " + needed;
}

}  // namespace asv::core
