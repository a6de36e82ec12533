#include "core/bounds/passages/cells/chain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bounds/walls.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::core {

namespace {

using std::numbers::pi;

/// No cell is halved where that moves no ASV by more than this share of a broom.
constexpr double finest = 4e-4;

double largest(const Interval& interval) {
    return std::max(std::abs(interval.low), std::abs(interval.high));
}

/// Does every segment from a place in the rectangle along `share` of a vector in the hull of the
/// corners meet the obstacle? It is enough that those from corner to corner do: for one place, the
/// ends of all segments that meet a convex obstacle make up a convex set, which is its shadow; for
/// one vector, the places from which they do are a convex set as well.
bool always_meets(const Box& places, std::span<const Point> corners, double share,
                  const Box& obstacle) {
    const auto meets = [&](const Point& place, const Point& vector) {
        return geometry::meets({place, {place.x + share * vector.x, place.y + share * vector.y}},
                               obstacle);
    };
    // Most do not, which one segment shows.
    if (!meets(geometry::centre(places), corners[0])) return false;
    const auto& [low, high] = places;
    for (const Point& place : {low, high, Point{low.x, high.y}, Point{high.x, low.y}})
        for (const Point& vector : corners)
            if (!meets(place, vector)) return false;
    return true;
}

/// Where such segments end.
Box moved(const Box& places, const Box& vectors, double share) {
    const auto [left, right] = std::minmax({share * vectors.low.x, share * vectors.high.x});
    const auto [down, up] = std::minmax({share * vectors.low.y, share * vectors.high.y});
    return {{places.low.x + left, places.low.y + down},
            {places.high.x + right, places.high.y + up}};
}

}  // namespace

ChainCells::ChainCells(const Problem& problem, const Box& middle)
    : brooms_(problem.asv_count() - 1), bounds_(widened_bounds(problem.requirements)) {
    const Requirements& requirements = problem.requirements;
    const double tolerance = requirements.tolerance + rounding_slack(requirements);
    turn_tolerance_ = requirements.tolerance * 1.1;
    shortest_ = requirements.broom_length - tolerance;
    longest_ = requirements.broom_length + tolerance;
    required_area_ =
        (requirements.min_area(problem.asv_count()) - requirements.tolerance) * (1 - 1e-9);
    const Box reach = grown(middle, longest_ * static_cast<double>(brooms_));
    for (const Box& whole : problem.obstacles) {
        const Box box = shrunk(whole, requirements.tolerance, requirements);
        if (!vanishes(box) && geometry::overlap(box, reach)) obstacles_.push_back(box);
    }
    make_arms();
    all_.middle = middle;
    all_.headings.fill({-pi, 3 * pi + static_cast<double>(brooms_) * turn_tolerance_});
    all_.headings[0].high = pi;
}

/// In the middle is an ASV or, with an odd number of brooms, the middle of one.
void ChainCells::make_arms() {
    const std::size_t middle = brooms_ / 2;
    std::size_t first_whole = middle;
    if (brooms_ % 2 == 1) {
        arms_[0].push_back({middle, 0.5});
        arms_[1].push_back({middle, -0.5});
        ++first_whole;
    }
    for (std::size_t i = first_whole; i < brooms_; ++i) arms_[0].push_back({i, 1});
    for (std::size_t i = middle; i-- > 0;) arms_[1].push_back({i, -1});
}

std::vector<ChainCell> ChainCells::with_heading(const BroomHeading& wanted) const {
    std::vector<ChainCell> cells;
    for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
        ChainCell cell = all_;
        Interval& heading = cell.headings[wanted.broom];
        heading.low = std::max(heading.low, wanted.heading.low + turn);
        heading.high = std::min(heading.high, wanted.heading.high + turn);
        if (heading.low <= heading.high) cells.push_back(cell);
    }
    return cells;
}

bool ChainCells::holds_no_state(ChainCell& cell) const {
    if (!narrow(cell)) return true;
    std::array<BroomSector, most_asvs_in_cells - 1> all;
    for (std::size_t i = 0; i < brooms_; ++i)
        all[i] = broom_sector(cell.headings[i], shortest_, longest_);
    const Sectors sectors(all.data(), brooms_);
    return lacks_area(sectors) || turns_right_at_an_end(sectors) ||
           is_blocked(cell.middle, sectors);
}

/// Leaves out headings that no convex chain has beside those of the other brooms. False when none
/// are left.
bool ChainCells::narrow(ChainCell& cell) const {
    const double back = turn_tolerance_, on = pi + turn_tolerance_;
    const auto headings = std::span(cell.headings).first(brooms_);
    for (std::size_t i = 1; i < brooms_; ++i) {
        headings[i].low = std::max(headings[i].low, headings[i - 1].low - back);
        headings[i].high = std::min(headings[i].high, headings[i - 1].high + on);
    }
    for (std::size_t i = brooms_ - 1; i > 0; --i) {
        headings[i - 1].low = std::max(headings[i - 1].low, headings[i].low - on);
        headings[i - 1].high = std::min(headings[i - 1].high, headings[i].high + back);
    }
    const double round = 2 * pi + static_cast<double>(brooms_ + 1) * turn_tolerance_;
    headings.back().high = std::min(headings.back().high, headings[0].high + round);
    headings[0].low = std::max(headings[0].low, headings.back().low - round);
    return std::all_of(headings.begin(), headings.end(),
                       [](const Interval& each) { return each.low <= each.high; });
}

/// Twice the area is the sum of l_i l_j sin(theta_j - theta_i) over all pairs i < j of brooms, with
/// l their lengths and theta their headings. Two bounds on it: the sum of the greatest terms, and
/// the mean value form, which says what it is in the middle of the cell and how steeply it can
/// rise from there (Moore 1966). The first is better in large cells, the second in small ones.
bool ChainCells::lacks_area(Sectors sectors) const {
    const double most = longest_ * longest_, least = shortest_ * shortest_;
    double of_greatest_terms = 0;
    double mean_value_form = 0;
    std::array<Interval, most_asvs_in_cells - 1> slopes{};  // in each heading, of longest brooms
    for (std::size_t i = 0; i < brooms_; ++i) {
        for (std::size_t j = i + 1; j < brooms_; ++j) {
            const Interval sine = turn_sines(sectors[i], sectors[j]);
            const Interval cosine = turn_cosines(sectors[i], sectors[j]);
            of_greatest_terms += sine.high * (sine.high > 0 ? most : least);
            mean_value_form += most * sine_between(sectors[i].middle, sectors[j].middle);
            // Where a term is negative, the shortest brooms have more area than the longest.
            if (sine.low < 0) mean_value_form -= sine.low * (most - least);
            slopes[j] = {slopes[j].low + cosine.low, slopes[j].high + cosine.high};
            slopes[i] = {slopes[i].low - cosine.high, slopes[i].high - cosine.low};
        }
    }
    for (std::size_t i = 0; i < brooms_; ++i)
        mean_value_form += most * largest(slopes[i]) * width(sectors[i].heading) / 2;
    return std::min(of_greatest_terms, mean_value_form) < 2 * required_area_;
}

/// The closing side leads from the last ASV to the first. The turn to it has the sign of the sum of
/// l_i sin(turn from broom i to the last one), the turn from it that of the sum of l_i sin(turn
/// from the first broom to broom i).
bool ChainCells::turns_right_at_an_end(Sectors sectors) const {
    const auto greatest = [&](const BroomSector& from, const BroomSector& to) {
        const double sine = turn_sines(from, to).high;
        return sine * (sine > 0 ? longest_ : shortest_);
    };
    double at_first = 0, at_last = 0;
    for (const BroomSector& each : sectors.subspan(1)) at_first += greatest(sectors[0], each);
    for (const BroomSector& each : sectors.first(brooms_ - 1))
        at_last += greatest(each, sectors.back());
    // A turn within the tolerance counts as straight, however long the closing side is.
    const double straight = turn_tolerance_ * longest_ * static_cast<double>(brooms_);
    return at_first < -straight || at_last < -straight;
}

/// Does one broom meet one obstacle in every state of the cell, or is an ASV out of bounds? All
/// that ties a broom to the place of the middle counts for those next to it; further out, the place
/// of an ASV may be anywhere in a rectangle, whatever the headings of the brooms on both sides.
bool ChainCells::is_blocked(const Box& middle, Sectors sectors) const {
    if (!geometry::overlap(middle, bounds_)) return true;
    for (const std::vector<Link>& arm : arms_) {
        Box places = middle;
        for (const auto& [broom, share] : arm) {
            const BroomSector& sector = sectors[broom];
            if (!sector.wide) {
                for (const Box& obstacle : obstacles_)
                    if (always_meets(places, sector.corners, share, obstacle)) return true;
            }
            places = moved(places, sector.box, share);
            if (!geometry::overlap(places, bounds_)) return true;
        }
    }
    return false;
}

std::optional<std::pair<ChainCell, ChainCell>> ChainCells::halves(const ChainCell& cell) const {
    std::pair<ChainCell, ChainCell> both{cell, cell};
    auto& [first, second] = both;
    // Whose interval moves the chain most. All of it moves with the middle, with a heading what is
    // beyond the broom: its last ASV in proportion to the number of brooms there, the first hardly.
    double most = finest * longest_;
    double* end_of_first = nullptr;
    double* begin_of_second = nullptr;
    const auto consider = [&](double effect, double& high, double& low) {
        if (effect <= most) return;
        most = effect;
        end_of_first = &high;
        begin_of_second = &low;
    };
    const auto& [low, high] = cell.middle;
    consider(high.x - low.x, first.middle.high.x, second.middle.low.x);
    consider(high.y - low.y, first.middle.high.y, second.middle.low.y);
    for (const std::vector<Link>& arm : arms_) {
        double beyond = 0;
        for (std::size_t i = arm.size(); i-- > 0;) {
            const std::size_t broom = arm[i].broom;
            beyond += std::abs(arm[i].share);
            consider(width(cell.headings[broom]) * longest_ * std::sqrt(beyond),
                     first.headings[broom].high, second.headings[broom].low);
        }
    }
    if (!end_of_first) return std::nullopt;
    *end_of_first = *begin_of_second = *begin_of_second / 2 + *end_of_first / 2;
    return both;
}

}  // namespace asv::core
