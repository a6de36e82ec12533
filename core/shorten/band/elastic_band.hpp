#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/search/search_result.hpp"
#include "core/shorten/band/block_tridiagonal.hpp"
#include "core/shorten/band/contacts.hpp"
#include "core/shorten/band/way_points.hpp"
#include "core/shorten/band/way_ties.hpp"
#include "core/space/metric.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/proof/motion_checker.hpp"

namespace asv::core {

/// Pulls a whole path taut, like an elastic band (Quinlan and Khatib, 1993) that moves all of its
/// way points at once: sequential quadratic steps in which the ASVs pull along their ways (WayTies)
/// and what is near pushes back (Contacts). Way points are linked to their neighbours only, so each
/// step is one block-tridiagonal system. Where the result cannot be proven valid it gives way to
/// the path before, which is valid at any time. Holds scratch memory.
class ElasticBand {
  public:
    ElasticBand(MotionChecker& checker, const Metric& metric);

    /// Takes a valid path, with way points put in so that no motion is longer than spacing (in the
    /// metric).
    void take(const Configurations& path, double spacing);

    /// Pulls once, by some tens of steps; returns by how much the cost fell, 0 where it did not and
    /// the path is what it was. Gives up as soon as stop() says so, which is asked at every step.
    double tighten(const std::function<bool()>& stop);

    /// The path without the way points past which the straight motion is proven and costs no more.
    Configurations path();

    /// How often a way point was moved by one step, so far.
    std::uint64_t way_point_steps() const { return way_point_steps_; }

  private:
    bool pull(const std::function<bool()>& stop);
    bool repair(const std::function<bool()>& stop);
    bool step(double damping, double barrier);
    void advance(std::size_t i, std::span<const double> step);
    bool refine();
    void keep_valid();
    void thin(double longest, double tolerance);

    MotionChecker& checker_;
    const Metric& metric_;
    const Chain& chain_;
    std::size_t dimension_;
    double spacing_ = 0, damping_ = 0, cost_now_ = 0;

    WayPoints path_;      ///< valid
    WayPoints proposed_;  ///< as many way points, where the steps have led to
    WayTies ties_;
    Contacts contacts_;
    MotionCost cost_;
    BlockTridiagonal system_;
    std::vector<double> step_;
    std::vector<double> from_;
    Pose pose_;
    std::uint64_t way_point_steps_ = 0;
};

}  // namespace asv::core
