#include "core/shorten/hybridise.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "core/search/trees/roadmap.hpp"
#include "core/shorten/band/way_points.hpp"

namespace asv::core {

namespace {

/// Way points farther apart than this (in the metric) are not worth a bridge.
constexpr double longest_bridge = 0.3;
/// Way points that bridges are tried at are so far apart at most.
constexpr double spacing = 0.1;

/// The graph of two paths. Nodes are the way points of one path and then those of the other.
class Hybrid {
  public:
    Hybrid(const Metric& metric, MotionCost& cost)
        : metric_(metric),
          cost_(cost),
          dimension_(metric.dimension()),
          empty_index_(metric.scales(), {}),
          graph_(empty_index_) {}

    void add_path(const Configurations& path) {
        const auto first = static_cast<std::uint32_t>(graph_.size());
        begins_.push_back(first);
        indices_.push_back(empty_index_);
        for (std::size_t i = 0; i < path.size(); i += dimension_) {
            const auto node = graph_.add({path.data() + i, dimension_});
            indices_.back().add(graph_.row(node));
            if (node > first)
                graph_.join(node - 1, node, cost_(graph_.row(node - 1), graph_.row(node)));
        }
        ends_.push_back(static_cast<std::uint32_t>(graph_.size()));
    }

    /// Bridges each way point of one path to the nearest of the other.
    void add_bridges(std::size_t from, std::size_t to, const Bridge& bridge) {
        for (std::uint32_t a = begins_[from] + 1; a + 1 < ends_[from]; ++a) {
            const std::uint32_t nearest =
                begins_[to] + static_cast<std::uint32_t>(indices_[to].nearest(graph_.row(a)));
            if (metric_.distance(graph_.row(a), graph_.row(nearest)) > longest_bridge ||
                bridges_.contains({a, nearest}))
                continue;
            Configurations rows;
            if (!bridge(graph_.row(a), graph_.row(nearest), rows)) continue;
            double length = 0;
            std::span<const double> last = graph_.row(a);
            for (std::size_t i = 0; i < rows.size(); i += dimension_) {
                const std::span<const double> row{rows.data() + i, dimension_};
                length += cost_(last, row);
                last = row;
            }
            graph_.join(a, nearest, length);
            rows.resize(rows.size() - dimension_);
            bridges_[{nearest, a}] = backward(rows);
            bridges_[{a, nearest}] = std::move(rows);
        }
    }

    Configurations shortest() const {
        // The two starts are one configuration, and so are the two goals.
        Configurations best;
        const auto nodes = graph_.dijkstra(begins_[0], ends_[0] - 1);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (i > 0) {
                const auto between = bridges_.find({nodes[i - 1], nodes[i]});
                if (between != bridges_.end())
                    best.insert(best.end(), between->second.begin(), between->second.end());
            }
            const auto row = graph_.row(nodes[i]);
            if (!best.empty() && std::equal(row.begin(), row.end(), best.end() - width())) continue;
            best.insert(best.end(), row.begin(), row.end());
        }
        return best;
    }

    void join_ends() {
        graph_.join(begins_[0], begins_[1], 0);
        graph_.join(ends_[0] - 1, ends_[1] - 1, 0);
    }

  private:
    std::ptrdiff_t width() const { return static_cast<std::ptrdiff_t>(dimension_); }

    Configurations backward(const Configurations& rows) const {
        Configurations reversed;
        for (std::size_t i = rows.size(); i >= dimension_; i -= dimension_)
            reversed.insert(reversed.end(), rows.data() + i - dimension_, rows.data() + i);
        return reversed;
    }

    const Metric& metric_;
    MotionCost& cost_;
    std::size_t dimension_;
    NearestNeighbours empty_index_;
    Roadmap graph_;
    std::vector<std::uint32_t> begins_, ends_;  ///< nodes of each path
    std::vector<NearestNeighbours> indices_;    ///< of each path
    /// What lies between the ends of a bridge.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Configurations> bridges_;
};

}  // namespace

Configurations hybridise(const Configurations& path, const Configurations& other,
                         const Metric& metric, MotionCost& cost, const Bridge& bridge) {
    const auto d = static_cast<std::ptrdiff_t>(metric.dimension());
    if (!std::equal(path.end() - d, path.end(), other.end() - d)) return path;
    Hybrid hybrid(metric, cost);
    hybrid.add_path(resampled(path, metric, spacing));
    hybrid.add_path(resampled(other, metric, spacing));
    hybrid.join_ends();
    hybrid.add_bridges(0, 1, bridge);
    hybrid.add_bridges(1, 0, bridge);
    return hybrid.shortest();
}

}  // namespace asv::core
