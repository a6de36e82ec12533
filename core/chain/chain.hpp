#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// What the first three coordinates of a configuration refer to. The turns follow in both cases, so
/// a straight line in C-space bends the chain in the same way; only what stays put differs.
enum class Anchor {
    first_asv,  ///< [x, y of ASV 1, heading of broom 1, turns]: the C-space of the assignment
    centroid    ///< [x, y of the centroid, mean heading, turns]: nearly decoupled, for metrics
};

/// Forward kinematics of a chain at one configuration, as a structure of arrays.
struct Pose {
    std::vector<double> heading;  ///< of each broom, radians, not wrapped; n - 1 entries
    std::vector<double> ux, uy;   ///< unit vector along each broom; n - 1 entries
    std::vector<double> x, y;     ///< position of each ASV; n entries
};

/// The chain of n points and n - 1 links as a kinematic model: ASVs and brooms of one length, an
/// arm whose first point stays at its base, or a point without any link. A configuration is a row
/// of dimension() numbers (see Anchor); angles are in radians, heading 0 is along +x.
class Chain {
  public:
    /// Brooms of one length. Precondition: asv_count >= 1, broom_length > 0.
    Chain(std::size_t asv_count, double broom_length, Anchor anchor);

    /// Links of these lengths, all positive, anchored at the first point.
    explicit Chain(std::span<const double> link_lengths);

    std::size_t asv_count() const { return asv_count_; }
    std::size_t broom_count() const { return asv_count_ - 1; }
    /// Number of intermediate turns, at ASV 2 to n - 1.
    std::size_t turn_count() const { return asv_count_ < 3 ? 0 : asv_count_ - 2; }
    /// n + 1 numbers for a chain, 2 for a single point.
    std::size_t dimension() const { return asv_count_ + 1; }
    /// Of every broom; where lengths differ, that of the first, which the levers refer to.
    double broom_length() const { return broom_length_; }
    double link_length(std::size_t k) const { return link_length_[k]; }
    Anchor anchor() const { return anchor_; }

    /// The configuration whose pose is nearest to the given positions: turns in (-pi, pi], anchored
    /// at the positions' own anchor, so that brooms that are off by rounding spread their error.
    /// Precondition: positions.size() == asv_count(), row.size() == dimension().
    void configuration(std::span<const geometry::Point> positions, std::span<double> row) const;

    /// A pose with arrays of the right size.
    Pose make_pose() const;

    /// Forward kinematics. Precondition: pose comes from make_pose() of an equal chain.
    void forward(std::span<const double> row, Pose& pose) const;

    /// The part of it that comes after the headings: positions of the n points, given the first two
    /// coordinates and the n - 1 unit vectors along the links.
    void positions(const geometry::Point& place, std::span<const double> ux,
                   std::span<const double> uy, std::span<double> x, std::span<double> y) const;

    /// The n - 1 headings of a configuration. They are linear in it: a displacement of the
    /// configuration gives their rates.
    void headings(std::span<const double> row, std::span<double> headings) const;

    /// How much the position of the point at fraction s of broom j follows broom k: its derivative
    /// by heading k is broom_length * lever(j, s, k) * (unit normal of broom k).
    double lever(std::size_t j, double s, std::size_t k) const {
        const double ahead = k < j ? 1.0 : (k == j ? s : 0.0);
        return ahead * ratio_[k] + anchor_lever_[k];
    }
    /// The part of lever() that the anchor causes: 0, or minus the share of the ASVs behind broom
    /// k.
    std::span<const double> anchor_lever() const { return anchor_lever_; }
    /// The derivative of the first heading coordinate's offset by turn i: heading of broom 1 is
    /// row[2] - sum of share[i] * row[3 + i].
    std::span<const double> heading_share() const { return heading_share_; }

  private:
    std::size_t asv_count_;
    double broom_length_;
    Anchor anchor_;
    std::vector<double> link_length_;
    std::vector<double> ratio_;  ///< of link_length_ to broom_length_
    std::vector<double> anchor_lever_;
    std::vector<double> heading_share_;
};

/// Positions of a pose as points. Precondition: points.size() == pose.x.size().
void copy_positions(const Pose& pose, std::span<geometry::Point> points);

}  // namespace asv::core
