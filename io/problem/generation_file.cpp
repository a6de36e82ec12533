#include "io/problem/generation_file.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "io/text/json/document.hpp"

namespace asv::io {

void write_generation(const std::filesystem::path& file, const Generation& generation) {
    using nlohmann::ordered_json;
    ordered_json parameters = ordered_json::object();
    for (const auto& [name, value] : generation.parameters) {
        const ordered_json parsed = ordered_json::parse(value, nullptr, false);
        parameters[name] = parsed.is_number() ? parsed : ordered_json(value);
    }
    const ordered_json json = {{"problem", generation.problem},
                               {"family", generation.family},
                               {"asv_count", generation.asv_count},
                               {"obstacle_count", generation.obstacle_count},
                               {"seed", generation.seed},
                               {"attempt", generation.attempt},
                               {"parameters", std::move(parameters)},
                               {"verdict", generation.verdict},
                               {"reason", generation.reason},
                               {"version", generation.version}};
    write_file(file, json.dump(2) + '\n');
}

std::vector<std::pair<std::string, double>> number_parameters(
    const std::vector<std::pair<std::string, std::string>>& parameters) {
    std::vector<std::pair<std::string, double>> numbers;
    for (const auto& [name, value] : parameters) {
        const nlohmann::json parsed = nlohmann::json::parse(value, nullptr, false);
        if (parsed.is_number()) numbers.emplace_back(name, parsed.get<double>());
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<std::pair<std::string, double>> read_parameters(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    const JsonDocument document(text, file.string());
    const JsonDocument::Pointer at("/parameters");
    std::vector<std::pair<std::string, double>> parameters;
    for (const std::string& name : document.members(at))
        if (document.is_number(at / name))
            parameters.emplace_back(name, document.number(at / name));
    return parameters;
}

}  // namespace asv::io
