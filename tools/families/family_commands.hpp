#pragma once

#include <functional>
#include <vector>

#include "core/generate/families.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

/// A family's subcommand and the function that draws one of its problems.
struct Family {
    CLI::App* command;
    std::function<core::Problem(const core::ChainOptions&, core::Rng&)> draw;
};

/// Adds a subcommand for every family, with its options.
std::vector<Family> add_families(CLI::App& app);

}  // namespace asv::tools
