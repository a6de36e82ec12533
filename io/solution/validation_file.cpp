#include "io/solution/validation_file.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"

namespace asv::io {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const ValidatedPart& part, core::Check check, const core::Offender& offender) {
    const std::optional<std::size_t> line = part.line(check, offender);
    ordered_json object = {{"state", offender.state},
                           {"line", line ? ordered_json(*line) : ordered_json(nullptr)}};
    const auto add = [&](const char* key, const std::optional<std::size_t>& index) {
        if (index) object[key] = *index + 1;
    };
    add("asv", offender.asv);
    add("broom", offender.broom);
    add("obstacle", offender.obstacle);
    if (offender.time) object["time"] = *offender.time;
    object["room"] = offender.room;
    return object;
}

ordered_json to_json(const ValidatedPart& part, const std::vector<core::CheckResult>& results) {
    ordered_json array = ordered_json::array();
    for (const core::CheckResult& result : results) {
        ordered_json offenders = ordered_json::array();
        for (const core::Offender& offender : result.offenders) {
            offenders.push_back(to_json(part, result.check, offender));
        }
        array.push_back({{"check", core::name(result.check)},
                         {"ok", result.ok()},
                         {"states", result.states},
                         {"failures", result.failures},
                         {"worst", result.worst ? to_json(part, result.check, *result.worst)
                                                : ordered_json(nullptr)},
                         {"offenders", std::move(offenders)}});
    }
    return array;
}

}  // namespace

bool ValidationSummary::valid() const {
    return std::all_of(parts.begin(), parts.end(),
                       [](const ValidatedPart& part) { return part.report.valid(); });
}

void write_validation(const std::filesystem::path& file, const ValidationSummary& summary) {
    ordered_json root = {{"problem", summary.problem},
                         {"solution", summary.solution.empty() ? ordered_json(nullptr)
                                                               : ordered_json(summary.solution)},
                         {"tolerance", summary.tolerance},
                         {"valid", summary.valid()},
                         {"parts", ordered_json::array()}};
    for (const ValidatedPart& part : summary.parts) {
        root["parts"].push_back({{"name", part.name},
                                 {"valid", part.report.valid()},
                                 {"cost", part.report.cost},
                                 {"checks", to_json(part, part.report.checks)},
                                 {"motion", to_json(part, part.report.motion)}});
    }
    // File names need not be UTF-8, as JSON is.
    write_file(file, root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace asv::io
