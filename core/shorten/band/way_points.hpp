#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/search/search_result.hpp"
#include "core/space/metric.hpp"

namespace asv::core {

/// The way points of a path with their poses, and the poses half-way between them.
struct WayPoints {
    explicit WayPoints(const Chain& kinematics)
        : chain(kinematics), half_way(kinematics.dimension()) {}

    std::size_t count() const { return rows.size() / chain.dimension(); }
    std::span<double> row(std::size_t i) {
        return {rows.data() + i * chain.dimension(), chain.dimension()};
    }
    std::span<const double> row(std::size_t i) const {
        return {rows.data() + i * chain.dimension(), chain.dimension()};
    }

    /// Computes the poses from the rows.
    void stand() {
        poses.resize(count(), chain.make_pose());
        middles.resize(count() - 1, chain.make_pose());
        for (std::size_t i = 0; i < count(); ++i) chain.forward(row(i), poses[i]);
        for (std::size_t i = 0; i + 1 < count(); ++i) {
            for (std::size_t k = 0; k < half_way.size(); ++k)
                half_way[k] = 0.5 * (row(i)[k] + row(i + 1)[k]);
            chain.forward(half_way, middles[i]);
        }
    }

    const Chain& chain;
    Configurations rows;
    std::vector<Pose> poses, middles;
    std::vector<double> half_way;
};

/// The rows of a path with way points put in so that no motion is longer than spacing (in the
/// metric).
Configurations resampled(const Configurations& path, const Metric& metric, double spacing);

}  // namespace asv::core
