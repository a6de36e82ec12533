#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/search/setting.hpp"

namespace asv::core {

/// The samplers by name. Stepwise and corridor need a chain; own is what the space proposes by
/// itself.
enum class SamplerKind { own, uniform, grid, stepwise, corridor, gaussian, bridge, passage, mix };

/// Where samples come from. What each field is, settings_of() says below; the weights are those of
/// the mix, in the order of SamplerKind, own first.
struct SamplerOptions {
    SamplerKind kind = SamplerKind::own;
    double sigma = 0;
    std::size_t grid_cells = 1000;
    std::size_t displacements = 5;
    std::array<double, static_cast<std::size_t>(SamplerKind::mix)> weights = {};
};

inline std::vector<Setting> settings_of(SamplerOptions& options) {
    const std::vector<std::string> words{"own",      "uniform", "grid",    "stepwise", "corridor",
                                         "gaussian", "bridge",  "passage", "mix"};
    std::vector<Setting> settings{
        {.name = "sampler",
         .meaning = "where samples come from",
         .value = one_of(options.kind, words),
         .why = "each space proposes what suits its body; the roadmaps have the one that they are "
                "named after",
         .source = "own, and the papers of the roadmaps"},
        {.name = "sigma",
         .meaning = "deviation of gaussian, bridge and passage; 0: a twentieth of the longest side",
         .value = number(options.sigma, 0, 1e4, in_metric),
         .why = "a twentieth of the unit square, 0.05, is reported for the passage filter",
         .source = "Boor and others 1999, Hsu and others 2003"},
        {.name = "grid-cells",
         .meaning = "cells of the first grid; each further one has twice as many",
         .value = number(options.grid_cells, 1, 1e8),
         .why = "as reported for a point on a map",
         .source = "Kavraki and others 1996"},
        {.name = "passage-draws",
         .meaning = "draws around a sample of which some, but not all, have to collide for passage",
         .value = number(options.displacements, 1, 1000),
         .why = "as reported for the passage filter",
         .source = "report on seven extensions"}};
    for (std::size_t i = 0; i < options.weights.size(); ++i)
        settings.push_back({.name = "mix-" + words[i],
                            .meaning = "weight of " + words[i] + " in the mix",
                            .value = number(options.weights[i], 0, 1e6),
                            .why = "nothing is in the mix until it is asked for",
                            .source = "own"});
    return settings;
}

}  // namespace asv::core
