#include "tools/ompl/program/ompl_arguments.hpp"

#include <iostream>
#include <limits>

#include "tools/common/command_line.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"
#include "tools/ompl/planner_list.hpp"

namespace asv::tools {

namespace {

/// Each planner with its parameters, their values to begin with and what OMPL suggests for them.
void list_planners(std::ostream& out) {
    const auto information = adaptor::information_of_a_plane();
    for (const std::string_view name : adaptor::ompl_planner_names()) {
        out << name << '\n';
        const auto planner = adaptor::ompl_planner(name, information);
        for (const auto& [key, parameter] : planner->params().getParams())
            out << "    " << key << '=' << parameter->getValue() << "  ("
                << parameter->getRangeSuggestion() << ")\n";
    }
}

void add_planner_options(CLI::App& app, OmplArguments& arguments) {
    app.add_option("--planner", arguments.planner, "Planner of OMPL, see --list-planners")
        ->type_name("NAME")
        ->capture_default_str();
    app.add_option("--set", arguments.settings,
                   "A parameter of the planner, see --list-planners; may be repeated")
        ->type_name("PARAMETER=VALUE")
        ->allow_extra_args(false);
    app.add_option(
           "--motion", arguments.motion,
           "certified: all of a motion is proven valid; sampled: by OMPL's own check, which "
           "looks at samples. What that lets through is written all the same, so that one "
           "can count it; the exit code is 1 where it is not valid")
        ->check(CLI::IsMember({"certified", "sampled"}))
        ->capture_default_str();
    app.add_flag("--anytime", arguments.anytime,
                 "Let a planner that improves its path go on until the time limit; else the first "
                 "path is taken");
    app.add_flag("--check-planner", arguments.check_planner,
                 "Only look whether there are such a planner and such parameters, and exit");
    app.add_flag_callback(
        "--list-planners",
        [] {
            list_planners(std::cout);
            throw CLI::Success();
        },
        "List all planners with their parameters and exit");
}

}  // namespace

void add_options(CLI::App& app, OmplArguments& arguments) {
    app.add_option("PROBLEM", arguments.problem, "Problem file; - for standard input")
        ->type_name(problem_file);
    app.add_option("SOLUTION", arguments.solution, "Solution file to write; - for standard output")
        ->type_name("FILE.txt");
    add_planner_options(app, arguments);
    app.add_option("--seed", arguments.seed, "Seed of all random draws")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    app.add_option("--time-limit", arguments.time_limit, "Seconds of wall clock for everything")
        ->transform(number_from(0))
        ->capture_default_str();
    add_reading_options(app, arguments.reading);
}

}  // namespace asv::tools
