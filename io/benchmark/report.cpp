#include "io/benchmark/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "io/benchmark/record/command_words.hpp"
#include "io/benchmark/record/generated_name.hpp"
#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

/// As it is where a shell would not touch it, else in single quotes.
std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string result = "'";
    for (const char letter : word) {
        if (letter == '\'')
            result += "'\\''";
        else
            result += letter;
    }
    return result + "'";
}

std::string number(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
    return text;
}

/// What makes the problem of these words, for a shell.
std::string generator_command(const std::vector<std::string>& words, const std::string& output) {
    std::string text = "asv-generate";
    for (const std::string& word : words) text.append(" ").append(quoted(word));
    return text.append(" -o ").append(output);
}

std::string external_command(const core::BenchmarkPlan& plan, const core::RunPlace& place) {
    const bool reversed = place.direction == core::Direction::reversed;
    const std::string& file = plan.problems[place.problem].file;
    const auto words = generator_words(file);
    const std::string made = "problem.txt";
    const CommandValues values{reversed ? "reversed.txt" : (words ? made : file), "solution.txt",
                               std::to_string(place.seed), number(plan.time_limit)};
    std::string text;
    if (words && !reversed) text = generator_command(*words, made).append(" &&");
    for (const std::string& word : plan.planners[place.planner].command)
        text.append(text.empty() ? "" : " ").append(quoted(fill_in(word, values)));
    return text;
}

}  // namespace

BenchmarkSession joined(std::vector<BenchmarkSession> sessions) {
    std::vector<BenchmarkSession> parts;
    for (BenchmarkSession& session : sessions) {
        if (session.parts.empty())
            parts.push_back(std::move(session));
        else
            parts.insert(parts.end(), session.parts.begin(), session.parts.end());
    }
    BenchmarkSession whole = parts.front();
    if (parts.size() == 1) return whole;
    whole.total = whole.unit_before = whole.unit_after = 0;
    std::vector<std::string> hosts, cpus;
    const auto add = [](std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    const auto count = static_cast<double>(parts.size());
    for (const BenchmarkSession& part : parts) {
        add(hosts, part.host);
        add(cpus, part.cpu);
        whole.processors = std::max(whole.processors, part.processors);
        whole.started = std::min(whole.started, part.started);
        whole.total += part.total;
        whole.unit_before += part.unit_before / count;
        whole.unit_after += part.unit_after / count;
    }
    whole.host = listed(hosts);
    whole.cpu = listed(cpus);
    whole.parts = std::move(parts);
    return whole;
}

std::string planner_text(const core::BenchmarkPlanner& planner) {
    if (planner.external()) return std::string("exec ").append(join_command(planner.command));
    std::string text{core::name(planner.planner)};
    for (const auto& [key, value] : planner.settings) text += " " + key + "=" + value;
    return text;
}

std::string solve_command(const core::BenchmarkPlan& plan, const core::RunPlace& place) {
    const core::BenchmarkPlanner& planner = plan.planners[place.planner];
    if (planner.external()) return external_command(plan, place);
    const std::string& file = plan.problems[place.problem].file;
    const auto words = generator_words(file);
    std::string text = words ? generator_command(*words, "-").append(" | ") : "";
    text += "asv-solve " + (words ? "-" : quoted(file)) + " solution.txt" + " --planner " +
            std::string(core::name(planner.planner));
    for (const auto& [key, value] : planner.settings) text += " --set " + quoted(key + "=" + value);
    text += " --seed " + std::to_string(place.seed) + " --time-limit " + number(plan.time_limit) +
            " --optimize " + number(plan.optimize) + " --threads " + std::to_string(plan.threads);
    if (place.direction == core::Direction::reversed) text += " --reverse";
    return text;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%F %T", &parts);
    return text.data();
}

std::string short_number(double value) {
    const double magnitude = std::abs(value);
    int decimals = 0;
    // 9.9996 is already 10.00.
    for (double scale = 1000; magnitude != 0 && magnitude < scale * (1 - 5e-5) && decimals < 12;
         scale /= 10)
        ++decimals;
    if (magnitude == 0 || magnitude < 1e-8) return "0";
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

}  // namespace asv::io
