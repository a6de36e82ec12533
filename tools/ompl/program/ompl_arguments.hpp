#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/problem/reading.hpp"

namespace asv::tools {

/// What asv-ompl was asked for.
struct OmplArguments {
    std::string problem, solution;
    std::string planner = "RRTConnect";
    std::vector<std::string> settings;
    std::string motion = "certified";
    bool anytime = false;
    bool check_planner = false;
    std::uint64_t seed = 1;
    double time_limit = 60;
    io::ReadOptions reading;
};

void add_options(CLI::App& app, OmplArguments& arguments);

}  // namespace asv::tools
