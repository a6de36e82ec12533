#include "core/chain/chain.hpp"

#include <numbers>
#include <stdexcept>

#include "geometry/elementary/functions.hpp"
#include "geometry/elementary/sine_cosine.hpp"

namespace asv::core {

using geometry::Point;

Chain::Chain(std::size_t asv_count, double broom_length, Anchor anchor)
    : asv_count_(asv_count), broom_length_(broom_length), anchor_(anchor) {
    if (asv_count == 0) throw std::invalid_argument("Chain: asv_count must be at least 1");
    if (!(broom_length > 0)) throw std::invalid_argument("Chain: broom_length must be positive");
    link_length_.assign(broom_count(), broom_length);
    ratio_.assign(broom_count(), 1.0);
    anchor_lever_.assign(broom_count(), 0.0);
    heading_share_.assign(turn_count(), 0.0);
    if (anchor == Anchor::first_asv) return;
    const auto n = static_cast<double>(asv_count);
    for (std::size_t k = 0; k < broom_count(); ++k)
        anchor_lever_[k] = -(n - 1 - static_cast<double>(k)) / n;
    for (std::size_t i = 0; i < turn_count(); ++i)
        heading_share_[i] = (n - 2 - static_cast<double>(i)) / (n - 1);
}

Chain::Chain(std::span<const double> link_lengths)
    : Chain(link_lengths.size() + 1, link_lengths.empty() ? 1.0 : link_lengths[0],
            Anchor::first_asv) {
    link_length_.assign(link_lengths.begin(), link_lengths.end());
    for (std::size_t k = 0; k < broom_count(); ++k) {
        if (!(link_length_[k] > 0))
            throw std::invalid_argument("Chain: link lengths must be positive");
        ratio_[k] = link_length_[k] / broom_length_;
    }
}

void Chain::configuration(std::span<const Point> positions, std::span<double> row) const {
    row[0] = positions[0].x;
    row[1] = positions[0].y;
    if (anchor_ == Anchor::centroid) {
        double sum_x = 0, sum_y = 0;
        for (const Point& p : positions) {
            sum_x += p.x;
            sum_y += p.y;
        }
        row[0] = sum_x / static_cast<double>(asv_count_);
        row[1] = sum_y / static_cast<double>(asv_count_);
    }
    if (asv_count_ < 2) return;
    const auto heading = [&](std::size_t k) {
        return elementary::atan2(positions[k + 1].y - positions[k].y,
                                 positions[k + 1].x - positions[k].x);
    };
    row[2] = heading(0);
    for (std::size_t i = 0; i < turn_count(); ++i) {
        double turn = heading(i + 1) - heading(i);
        if (turn > std::numbers::pi) turn -= 2 * std::numbers::pi;
        if (turn <= -std::numbers::pi) turn += 2 * std::numbers::pi;
        row[3 + i] = turn;
    }
    for (std::size_t i = 0; i < turn_count(); ++i) row[2] += heading_share_[i] * row[3 + i];
}

Pose Chain::make_pose() const {
    Pose pose;
    for (auto* array : {&pose.heading, &pose.ux, &pose.uy}) array->resize(broom_count());
    for (auto* array : {&pose.x, &pose.y}) array->resize(asv_count_);
    return pose;
}

void Chain::forward(std::span<const double> row, Pose& pose) const {
    headings(row, pose.heading);
    elementary::sine_cosine(pose.heading, pose.uy, pose.ux);
    positions({row[0], row[1]}, pose.ux, pose.uy, pose.x, pose.y);
}

void Chain::positions(const Point& place, std::span<const double> ux, std::span<const double> uy,
                      std::span<double> x, std::span<double> y) const {
    double at_x = place.x, at_y = place.y;
    for (std::size_t k = 0; k < broom_count(); ++k) {
        at_x += broom_length_ * anchor_lever_[k] * ux[k];
        at_y += broom_length_ * anchor_lever_[k] * uy[k];
    }
    x[0] = at_x;
    y[0] = at_y;
    for (std::size_t k = 0; k < broom_count(); ++k) {
        x[k + 1] = at_x += link_length_[k] * ux[k];
        y[k + 1] = at_y += link_length_[k] * uy[k];
    }
}

void Chain::headings(std::span<const double> row, std::span<double> headings) const {
    if (asv_count_ < 2) return;
    double heading = row[2];
    for (std::size_t i = 0; i < turn_count(); ++i) heading -= heading_share_[i] * row[3 + i];
    headings[0] = heading;
    for (std::size_t i = 0; i < turn_count(); ++i) headings[i + 1] = heading += row[3 + i];
}

void copy_positions(const Pose& pose, std::span<Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {pose.x[i], pose.y[i]};
}

}  // namespace asv::core
