#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/search/extensions/reported.hpp"
#include "core/search/search_result.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/tree.hpp"

namespace asv::core {

/// How often failing nodes are chosen.
enum class ExhaustionKind {
    off,
    plain,     ///< a node is dropped after some failed connects
    heuristic  ///< a node's distance is scaled by its failed connects
};

/// What each field is, settings_of() says below.
struct ExhaustionOptions {
    ExhaustionKind kind = ExhaustionKind::off;
    std::size_t drop_after = 15;
    std::size_t centre = 20;
    double share = 0.1;
};

inline std::vector<Setting> settings_of(ExhaustionOptions& options) {
    return {
        {.name = "exhaustion",
         .meaning = "extension 3: drop nodes that failed, or scale their distance by their fails",
         .value = one_of(options.kind, {"off", "plain", "heuristic"}),
         .why = extension_is_off,
         .source = extensions_report},
        {.name = "drop-after",
         .meaning = "fails after which plain exhaustion drops a node",
         .value = number(options.drop_after, 1, 1e9),
         .why = "as reported",
         .source = extensions_report},
        {.name = "fails-centre",
         .meaning = "fails at which heuristic exhaustion prefers a node most, C",
         .value = number(options.centre, 1, 1e6),
         .why = "as reported",
         .source = extensions_report},
        {.name = "fails-share",
         .meaning = "share of the distance by which it does",
         .value = number(options.share, 0, 1),
         .why = "as reported",
         .source = extensions_report},
    };
}

/// Extension 3: whether a node is chosen for growing depends on how often growing from it failed,
/// that is, made no progress at all.
///
/// The heuristic scales its distance by 1 - share + (share / C) abs(C - fails), as reported with
/// share 0.1. Its form is odd: a fresh node has factor 1, one with C fails 1 - share, one with 2 C
/// fails 1 again and beyond that it looks farther and farther. So nodes that failed about C times,
/// which may stand in a narrow passage, are preferred, and hopeless ones fade out without ever
/// being dropped. It is built as it stands.
class Exhaustion {
  public:
    explicit Exhaustion(const ExhaustionOptions& options) : options_(options) {}

    /// The node to grow from toward the row; when all are dropped, the nearest one of them.
    std::uint32_t nearest(const Tree& tree, int side, std::span<const double> row) {
        if (options_.kind == ExhaustionKind::off) return tree.nearest(row);
        auto& factors = factors_[static_cast<std::size_t>(side)];
        factors.resize(tree.size(), factor(0));
        const auto found = tree.neighbours().nearest(row, factors);
        return found ? static_cast<std::uint32_t>(*found) : tree.nearest(row);
    }

    /// Tells of a growth from a node.
    void grown(int side, std::uint32_t node, Steered outcome) {
        if (options_.kind == ExhaustionKind::off || outcome != Steered::trapped) return;
        const auto index = static_cast<std::size_t>(side);
        if (fails_[index].size() <= node) fails_[index].resize(node + 1, 0);
        if (factors_[index].size() <= node) factors_[index].resize(node + 1, factor(0));
        factors_[index][node] = factor(++fails_[index][node]);
    }

    /// What the distance to a node with so many fails is multiplied by; infinite: dropped.
    float factor(std::size_t fails) const {
        if (options_.kind == ExhaustionKind::plain)
            return fails < options_.drop_after ? 1.f : std::numeric_limits<float>::infinity();
        const auto c = static_cast<double>(options_.centre);
        const double off = std::abs(c - static_cast<double>(fails));
        return static_cast<float>(1 - options_.share + options_.share / c * off);
    }

  private:
    ExhaustionOptions options_;
    std::array<std::vector<std::size_t>, 2> fails_;
    std::array<std::vector<float>, 2> factors_;
};

}  // namespace asv::core
