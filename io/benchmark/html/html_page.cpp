#include "io/benchmark/html/html_page.hpp"

#include <stdexcept>

#include "io/benchmark/html/assets.hpp"
#include "io/benchmark/html/chart_json.hpp"
#include "io/benchmark/html/colour_text.hpp"
#include "io/benchmark/html/table_markup.hpp"
#include "io/benchmark/table/report_text.hpp"
#include "io/benchmark/wording.hpp"
#include "io/text/markup.hpp"

namespace asv::io {

namespace {

std::string title_of(const BenchmarkReport& report) {
    return plural(report.plan.planners.size(), "planner") + " on " +
           plural(report.plan.problems.size(), "problem");
}

/// The colours of pictures, by their names, for a style sheet.
std::string colours_of(Theme theme) {
    const Palette& colours = palette(theme);
    std::string text;
    const auto add = [&](const char* name, const Colour& colour) {
        text.append("--").append(name).append(": ").append(colour_text(colour)).append("; ");
    };
    add("page", colours.page);
    add("field", colours.field);
    add("ink", colours.ink);
    add("muted", colours.muted);
    add("grid", colours.grid);
    add("full", colours.goal);
    add("violation", colours.violation);
    return text;
}

std::string style() {
    return ":root { " + colours_of(Theme::light) +
           "}\n@media (prefers-color-scheme: dark) { :root { " + colours_of(Theme::dark) + "} }\n" +
           std::string(report_assets::style);
}

std::string paragraphs(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes)
        text.append("<p>").append(words_markup(note)).append("</p>\n");
    return text;
}

std::string tables_markup(const ReportText& text) {
    std::string markup;
    for (const TextTable& table : text.tables) markup += table_markup(table);
    return markup;
}

std::string unsolved(const ReportText& text) {
    if (text.unsolved.empty()) return {};
    std::string markup = "<h2>Not solved</h2>\n<ul>\n";
    for (const std::string& line : text.unsolved)
        markup.append("<li>").append(words_markup(line)).append("</li>\n");
    return markup + "</ul>\n";
}

}  // namespace

bool has_charts() {
    return !report_assets::library.empty();
}

std::string html_page(const BenchmarkReport& report, const Columns& columns) {
    if (!has_charts()) throw std::logic_error("pages of benchmarks are built without charts");
    const ReportText text = report_text(report, columns);
    std::string result;
    append_filled(result, report_assets::page, [&](std::string& page, std::string_view key) {
        if (key == "TITLE") page += title_of(report);
        if (key == "STYLE") page += style();
        if (key == "FACTS") page += words_markup(plan_facts(report.plan));
        if (key == "SPOILT" && !text.spoilt.empty())
            page += "<p class=\"spoilt\">" + words_markup(text.spoilt) + "</p>\n";
        if (key == "NOTES") page += paragraphs(text.notes);
        if (key == "SUCCESS") page += success_markup(report);
        if (key == "TABLES") page += tables_markup(text);
        if (key == "UNSOLVED") page += unsolved(text);
        if (key == "DATA") page += embeddable(chart_json(report));
        if (key == "LIBRARY") page += report_assets::library;
        if (key == "SCRIPT") page += report_assets::script;
    });
    return result;
}

}  // namespace asv::io
