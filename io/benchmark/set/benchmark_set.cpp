#include "io/benchmark/set/benchmark_set.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <stdexcept>

#include <fnmatch.h>

#include "io/benchmark/set/assets.hpp"

namespace asv::io {

namespace {

constexpr std::string_view titles = "name,words,n,feasible,best_cost,lower_bound";
constexpr std::size_t columns = 6;

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

[[noreturn]] void refuse(std::string_view line) {
    throw std::invalid_argument("no line of the benchmark set: " + std::string(line));
}

/// All of the text as a number; none where it is empty.
template <class Number>
std::optional<Number> number_in(std::string_view text, std::string_view line) {
    if (text.empty()) return std::nullopt;
    Number number{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end) refuse(line);
    return number;
}

SetProblem problem_of(std::string_view line) {
    const std::vector<std::string_view> parts = parts_of(line, ',');
    if (parts.size() != columns || parts[0].empty() || parts[1].empty()) refuse(line);
    const auto asv_count = number_in<std::size_t>(parts[2], line);
    const bool feasible = parts[3] == "feasible";
    if (!asv_count || (!feasible && parts[3] != "infeasible")) refuse(line);
    return {std::string(parts[0]),
            std::string(parts[1]),
            *asv_count,
            feasible,
            number_in<double>(parts[4], line),
            number_in<double>(parts[5], line),
            std::string(line)};
}

}  // namespace

std::vector<SetProblem> parse_set(std::string_view text) {
    std::vector<SetProblem> problems;
    std::vector<std::string_view> lines = parts_of(text, '\n');
    if (lines.front() != titles) refuse(lines.front());
    // Behind the last end of a line there is nothing.
    if (lines.back().empty()) lines.pop_back();
    for (std::size_t i = 1; i < lines.size(); ++i) problems.push_back(problem_of(lines[i]));
    return problems;
}

const std::vector<SetProblem>& benchmark_set() {
    static const std::vector<SetProblem> set = parse_set(set_assets::problems);
    return set;
}

std::vector<SetProblem> chosen_of_set(const std::string& pattern) {
    const auto fits = [&](const std::string& name) {
        return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    };
    std::vector<SetProblem> chosen;
    std::copy_if(benchmark_set().begin(), benchmark_set().end(), std::back_inserter(chosen),
                 [&](const SetProblem& problem) {
                     return fits(problem.name) || fits(std::string(problem.family()));
                 });
    return chosen;
}

std::string format_set(const std::vector<SetProblem>& problems) {
    std::string text{titles};
    text += '\n';
    for (const SetProblem& problem : problems) text += problem.line + '\n';
    return text;
}

}  // namespace asv::io
