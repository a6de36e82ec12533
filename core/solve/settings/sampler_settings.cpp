#include "core/solve/settings/settings_of.hpp"

namespace asv::core {

std::vector<Setting> settings_of(SamplerOptions& sampler) {
    const std::vector<std::string> words{"own",      "uniform", "grid",    "stepwise", "corridor",
                                         "gaussian", "bridge",  "passage", "mix"};
    std::vector<Setting> settings{
        choice("sampler", sampler.kind, words, "where samples come from"),
        number("sigma", sampler.sigma, 0, 1e4, metric_unit,
               "deviation of gaussian, bridge and passage; 0: a twentieth of the longest side"),
        number("grid-cells", sampler.grid_cells, 1, 1e8, "",
               "cells of the first grid; each further one has twice as many"),
        number("passage-draws", sampler.displacements, 1, 1000, "",
               "draws around a sample of which some, but not all, have to collide for passage")};
    for (std::size_t i = 0; i < sampler.weights.size(); ++i)
        settings.push_back(number("mix-" + words[i], sampler.weights[i], 0, 1e6, "",
                                  "weight of " + words[i] + " in the mix"));
    return settings;
}

}  // namespace asv::core
