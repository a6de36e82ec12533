// The door between JavaScript and C++: one call, JSON and an array of numbers in, an Answer out.

#include <stdexcept>

#include <emscripten.h>

#include "io/problem/scenario_file.hpp"
#include "io/text/parse_error.hpp"
#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

core::Problem problem_of(const Request& request) {
    const std::string text = request.json.at("problem").dump();
    return io::parse_scenario(text, "problem", "").problem;
}

std::vector<double> numbers_of(const core::Path& path) {
    std::vector<double> numbers;
    numbers.reserve(2 * path.points().size());
    for (const geometry::Point& point : path.points())
        numbers.insert(numbers.end(), {point.x, point.y});
    return numbers;
}

core::Path path_of(const std::vector<double>& numbers, std::size_t asv_count) {
    if (asv_count == 0 || numbers.empty() || numbers.size() % (2 * asv_count) != 0)
        throw std::invalid_argument("the states are not those of " + std::to_string(asv_count) +
                                    " ASVs");
    core::Path path(asv_count);
    path.reserve(numbers.size() / (2 * asv_count));
    std::vector<geometry::Point> state;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        state.push_back({numbers[i], numbers[i + 1]});
        if (state.size() < asv_count) continue;
        path.push_back(state);
        state.clear();
    }
    return path;
}

namespace {

using Function = Answer (*)(const Request&);

Function function_for(const std::string& kind) {
    if (kind == "check") return check;
    if (kind == "plan") return plan;
    if (kind == "validate") return validate;
    if (kind == "profile") return profile;
    if (kind == "planners") return planners;
    if (kind == "read") return read;
    if (kind == "write") return write;
    throw std::invalid_argument("no message is called " + kind);
}

Answer error(const std::string& message) {
    Answer answer;
    answer.json["error"] = {{"message", message}, {"line", nullptr}, {"column", nullptr}};
    return answer;
}

Answer answer_to(const Request& request) {
    try {
        return function_for(request.json.at("kind").get<std::string>())(request);
    } catch (const io::ParseError& failure) {
        Answer answer = error(failure.what());
        answer.json["error"]["line"] = failure.line();
        answer.json["error"]["column"] = failure.column();
        return answer;
    } catch (const std::exception& failure) {
        return error(failure.what());
    }
}

}  // namespace
}  // namespace asv::playground

using asv::playground::Answer;

extern "C" {

/// The caller frees the answer.
EMSCRIPTEN_KEEPALIVE Answer* asv_call(const char* json, const double* states, std::size_t count) {
    using asv::playground::Json;
    auto* answer = new Answer(
        asv::playground::answer_to({Json::parse(json), std::vector(states, states + count)}));
    for (const auto& [member, numbers] : answer->arrays)
        answer->json["arrays"].push_back({member, numbers.size()});
    answer->text = answer->json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return answer;
}

EMSCRIPTEN_KEEPALIVE const char* asv_text(const Answer* answer) {
    return answer->text.c_str();
}

EMSCRIPTEN_KEEPALIVE const double* asv_array(const Answer* answer, std::size_t index) {
    return answer->arrays[index].second.data();
}

EMSCRIPTEN_KEEPALIVE const char* asv_version() {
    return ASV_VERSION;
}

EMSCRIPTEN_KEEPALIVE void asv_free(const Answer* answer) {
    delete answer;
}
}
