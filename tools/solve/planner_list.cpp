#include "tools/solve/planner_list.hpp"

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/solve/planner_catalogue.hpp"

namespace asv::tools {

namespace {

constexpr std::string_view introduction =
    R"(# The settings of the planners

This page is what `asv-solve --list-planners --markdown` prints: change the declarations, not the page. Each setting is declared
beside the options that it sets (`core/search/`, `core/space/`). It is given as `asv-solve --planner NAME --set KEY=VALUE`, and to
`asv-bench` as `--planner "NAME KEY=VALUE"`.

A length "in the metric" is: for a chain how far the ASVs move, root mean square, in units in which a broom is 0.05 long; for an
arm radians; for a point the units of its plane. Numbers without a unit are counts and shares. *Reports* are those of earlier
programs for the same problems. A source "own" is ours.
)";

constexpr std::string_view head = R"(
| setting | meaning | range | default | why | source |
|---|---|---|---|---|---|
)";

std::string row(const core::Setting& setting) {
    return "| `" + setting.name + "` | " + setting.meaning + " | " + core::describe_range(setting) +
           " | " + core::describe_value(setting) + " | " + setting.why + " | " + setting.source +
           " |\n";
}

/// The table of what the planner has besides the settings of its sampler.
std::string own_table(core::Planner planner) {
    auto own = core::settings(planner);
    if (core::sampler_options(planner)) {
        core::SamplerOptions sampler;
        own.resize(own.size() - settings_of(sampler).size());  // those of the sampler come last
    }
    std::string table(head);
    for (const core::Setting& setting : own) table += row(setting);
    return table;
}

/// "`sampler=grid` by default": what the planner has of the samplers.
std::string default_sampler(core::Planner planner) {
    const auto all = core::settings(planner);
    const auto sampler = std::ranges::find(all, "sampler", &core::Setting::name);
    return "`sampler=" + core::describe_value(*sampler) + "` by default";
}

/// "Roadmap over a regular grid. Source: Kavraki and others 1996."
std::string introduce(std::string_view planner) {
    std::string summary(core::planner_summary(planner));
    summary[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(summary[0])));
    return summary + ". Source: " + std::string(core::planner_source(planner)) + ".\n";
}

}  // namespace

void list_planners(std::ostream& out) {
    const std::string indent(25, ' ');
    for (const auto name : core::planner_names()) {
        core::Planner planner = core::planner_named(name);
        out << name << ": " << core::planner_summary(name) << " (" << core::planner_source(name)
            << ")\n";
        for (const core::Setting& setting : core::settings(planner))
            out << "    " << std::left << std::setw(20) << setting.name << ' ' << setting.meaning
                << " (" << core::describe_range(setting) << "; default "
                << core::describe_value(setting) << ")\n"
                << indent << "why: " << setting.why << "; source: " << setting.source << '\n';
    }
}

void list_planners_as_markdown(std::ostream& out) {
    out << introduction;
    std::string shown, shown_table;  // the last planner with a table of its own, and that table
    for (const auto name : core::planner_names()) {
        const core::Planner planner = core::planner_named(name);
        const std::string table = own_table(planner);
        out << "\n## " << name << "\n\n" << introduce(name);
        if (table == shown_table) {
            out << "Its settings are those of [" << shown << "](#" << shown << "), with "
                << default_sampler(planner) << ".\n";
            continue;
        }
        if (core::sampler_options(planner))
            out << "It also takes the settings of [samplers](#samplers), with "
                << default_sampler(planner) << ".\n";
        out << table;
        shown = name;
        shown_table = table;
    }
    out << "\n## Samplers\n\nWhat every planner but `auto` takes its samples from.\n" << head;
    core::SamplerOptions sampler;
    for (const core::Setting& setting : settings_of(sampler)) out << row(setting);
}

}  // namespace asv::tools
