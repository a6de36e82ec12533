#include "io/benchmark/ompl_log.hpp"

#include <algorithm>
#include <cmath>

#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

std::string number(double value) {
    std::string text;
    if (std::isfinite(value)) append_number(text, value);
    return text;
}

struct ValueText {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return number(value); }
};

std::string preamble(const BenchmarkReport& report, const Experiment& experiment) {
    const core::BenchmarkPlan& plan = report.plan;
    const BenchmarkSession& session = report.session;
    std::string text =
        "ASV version " + session.version + "\nExperiment " + experiment.name +
        "\n0 experiment properties\nRunning on " +
        (session.host.empty() ? "unknown" : without_blanks(session.host)) + "\nStarting at " +
        utc_text(session.started) + "\n<<<|\n" + setup_text(report, experiment) + "|>>>\n<<<|\n" +
        session.cpu + ", " + std::to_string(session.processors) + " processors\n|>>>\n" +
        std::to_string(plan.first_seed) + " is the random seed\n" + number(plan.time_limit) +
        " seconds per run\n0 MB per run\n" + std::to_string(plan.seeds) + " runs per planner\n" +
        number(session.total) + " seconds spent to collect the data\n1 enum type\nstatus";
    for (const std::string_view word : status_words()) text.append("|").append(word);
    return text + "\n";
}

std::string progress(const std::vector<const core::BenchmarkRun*>& runs) {
    std::string text = "2 progress properties for each run\ntime REAL\nbest cost REAL\n" +
                       std::to_string(runs.size()) + " runs\n";
    for (const core::BenchmarkRun* run : runs) {
        for (const auto& [time, cost] : run->spent.cost_history)
            text += number(time) + "," + number(cost) + ",;";
        text += "\n";
    }
    return text;
}

std::string planner_part(const BenchmarkReport& report, const core::BenchmarkPlanner& planner,
                         const std::vector<const core::BenchmarkRun*>& runs) {
    const std::vector<std::string> settings = setting_lines(planner);
    std::string text =
        planner.label + "\n" + std::to_string(settings.size()) + " common properties\n";
    for (const std::string& setting : settings) text += setting + "\n";
    text += std::to_string(run_attributes().size()) + " properties for each run\n";
    for (const Attribute& attribute : run_attributes())
        text += std::string(attribute.name) + " " + std::string(attribute.type) + "\n";
    text += std::to_string(runs.size()) + " runs\n";
    for (const core::BenchmarkRun* run : runs) {
        for (const Attribute& attribute : run_attributes())
            text += std::visit(ValueText{}, attribute.value(report, *run)) + "; ";
        text += "\n";
    }
    return text + progress(runs) + ".\n";
}

}  // namespace

std::string ompl_log(const BenchmarkReport& report, const Experiment& experiment) {
    std::string parts;
    std::size_t planners = 0;
    for (std::size_t planner = 0; planner < report.plan.planners.size(); ++planner) {
        const auto runs = runs_of(report, experiment, planner);
        if (runs.empty()) continue;
        ++planners;
        parts += planner_part(report, report.plan.planners[planner], runs);
    }
    return preamble(report, experiment) + std::to_string(planners) + " planners\n" + parts;
}

std::filesystem::path ompl_log_file(const std::filesystem::path& file, const Experiment& experiment,
                                    bool several) {
    if (!several) return file;
    std::string name = file.stem().string() + "-" + experiment.name;
    std::replace(name.begin(), name.end(), '/', '_');
    return file.parent_path() / (name + file.extension().string());
}

}  // namespace asv::io
