#include "tools/families/generator.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tools/families/likeness.hpp"
#include "tools/families/option_kinds.hpp"
#include "tools/families/solvability.hpp"

namespace asv::tools {

namespace {

void add_chain_options(CLI::App& app, core::ChainOptions& chain) {
    add_choice<core::Orientation>(app, "--orientation", chain.orientation, "Of start and goal",
                                  {{"random", core::Orientation::random},
                                   {"cw", core::Orientation::clockwise},
                                   {"ccw", core::Orientation::counter_clockwise}});
    add_choice<core::Obstruction>(
        app, "--infeasible", chain.obstruction,
        "Make that there is no path for certain: the goal turns the other "
        "way, or a fence is around it",
        {{"no", core::Obstruction::none},
         {"turned", core::Obstruction::turned},
         {"fenced", core::Obstruction::fenced}});
    add_number(app, "--clearance", chain.clearance, {0, 0.1},
               "Least distance of start and goal to obstacles and bounds");
    add_number(app, "--area-margin", chain.area_margin, {0, 0.2},
               "How far start and goal are above the minimum area, as a share of it");
    add_number(app, "--least-turn", chain.min_turn, {0, 0.01},
               "Least turn at every ASV of start and goal, in radians");
    add_number(app, "--least-closing", chain.min_closing_side, {0, 0.05},
               "Least distance of the first to the last ASV of start and goal");
}

/// What the start decides where one is given.
constexpr std::array options_of_starts{"--asvs", "--orientation"};

/// Those that say nothing about what is drawn, but which of it.
constexpr std::array options_of_files{"--output", "--from", "--attempts", "--seed"};

template <class Names>
bool is_among(const CLI::Option& option, const Names& names) {
    return std::find(names.begin(), names.end(), option.get_name()) != names.end();
}

/// The options of the family, if there is one, and of the chain with the values that they were
/// given or have anyway.
std::vector<std::pair<std::string, std::string>> parameters(const CLI::App& app,
                                                            const CLI::App* command) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const CLI::App* part : {command, &app}) {
        if (part == nullptr) continue;
        for (const CLI::Option* option : part->get_options()) {
            if (option->get_items_expected_max() == 0 || is_among(*option, options_of_files) ||
                (command == nullptr && is_among(*option, options_of_starts)))
                continue;
            const std::string name = option->get_lnames().front();
            const std::string value =
                option->count() > 0 ? option->results().front() : option->get_default_str();
            found.emplace_back(name, value.empty() ? "default" : value);
        }
    }
    return found;
}

}  // namespace

Generator::Generator(CLI::App& app) : app_(app) {
    // What is not understood is told in our own words: see require_understood().
    app.require_subcommand(0, 1)->allow_extras();
    app.add_option("-n,--asvs", chain_.asv_count, "Number of ASVs, but two; required")
        ->transform(whole_number(1, 200));
    app.add_option("--seed", seed_, "Seed of all random draws")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    add_chain_options(app, chain_);
    app.add_flag("--solvable", solvable_,
                 "Check whether a path is certain to exist, or that there is none, and write the "
                 "verdict, solvable, infeasible or unknown, with all parameters to OUTPUT.json "
                 "(nowhere where OUTPUT is -)");
    add_count(
        app, "--attempts", attempts_, {1, 1'000'000},
        "With --solvable: draw up to so many problems until one is solvable for certain, else "
        "keep the last");
    families_ = add_families(app);
}

const Family* Generator::named_family() const {
    const auto named = std::find_if(families_.begin(), families_.end(),
                                    [](const Family& family) { return family.command->parsed(); });
    return named == families_.end() ? nullptr : &*named;
}

void Generator::require_understood() const {
    std::vector<std::string> names;
    for (const Family& family : families_) names.push_back(family.command->get_name());
    const Family* named = named_family();
    const std::vector<std::string> rest = app_.remaining(true);
    if (!named) {
        const bool a_word = !rest.empty() && rest.front().front() != '-';
        throw UsageError(
            (a_word ? "'" + rest.front() + "' is no family" : "a family has to be named") +
            "; there are " + listed_by_likeness(names, a_word ? rest.front() : ""));
    }
    if (!rest.empty()) throw UsageError(named->command->get_name() + " takes no " + rest.front());
    if (app_.get_option("--asvs")->count() == 0) throw UsageError("--asvs is required");
}

void Generator::require_understood_with_start() const {
    const Family* named = named_family();
    if (named) throw UsageError("--from takes no family, but found " + named->command->get_name());
    const std::vector<std::string> rest = app_.remaining(true);
    if (!rest.empty()) throw UsageError("--from takes no " + rest.front());
    for (const char* name : options_of_starts)
        if (app_.get_option(name)->count() > 0)
            throw UsageError(std::string(name) +
                             " has no place beside --from: the start decides it");
}

GeneratedProblem Generator::draw() const {
    const Family& family = *named_family();
    return drawn(family.command->get_name(), family.command,
                 [&](core::Rng& rng) { return family.draw(chain_, rng); });
}

GeneratedProblem Generator::draw_goal(const core::Problem& problem) const {
    return drawn("from", nullptr, [&](core::Rng& rng) {
        core::Problem made = problem;
        core::draw_goal(made, chain_, rng);
        return made;
    });
}

GeneratedProblem Generator::drawn(const std::string& name, const CLI::App* command,
                                  const std::function<core::Problem(core::Rng&)>& draw) const {
    core::Rng rng(seed_);
    GeneratedProblem made;
    Solvability known;
    std::size_t attempt = 0;
    try {
        const std::size_t attempts = solvable_ ? attempts_ : 1;
        while (attempt < attempts && known.verdict != Solvability::Verdict::solvable) {
            ++attempt;
            made.problem = draw(rng);
            if (solvable_) known = solvability(made.problem, seed_);
        }
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    } catch (const core::NoRoom& error) {
        throw UsageError(error.what());
    }
    made.generation = {
        "",           name,       made.problem.asv_count(),  made.problem.obstacles.size(),
        seed_,        attempt,    parameters(app_, command), tools::name(known.verdict),
        known.reason, ASV_VERSION};
    return made;
}

GeneratedProblem generated(const std::vector<std::string>& words) {
    CLI::App app;
    // There is nobody to read it.
    app.set_help_flag();
    const Generator generator(app);
    try {
        // The library wants the last word first.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    generator.require_understood();
    return generator.draw();
}

}  // namespace asv::tools
