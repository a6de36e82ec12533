// Texts of files in and out: read, write.

#include <sstream>
#include <stdexcept>

#include "core/model/cost.hpp"
#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_file.hpp"
#include "io/problem/scenario_text.hpp"
#include "io/solution/solution_file.hpp"
#include "tools/playground/engine/given_files.hpp"

namespace asv::playground {

namespace {

/// A solution begins with two numbers, its steps and its cost; a problem with one, a scenario with
/// '{'.
bool begins_like_a_solution(const std::string& text) {
    if (io::is_scenario(text)) return false;
    std::string line, word;
    std::getline(std::istringstream(text), line);
    std::istringstream words(line);
    int count = 0;
    while (words >> word) ++count;
    return count > 1;
}

/// Has the classic format room for all of it?
bool is_classic(const core::Problem& problem) {
    const core::Requirements &given = problem.requirements, usual;
    return problem.body_kind() == core::BodyKind::chain &&
           given.broom_length == usual.broom_length && given.max_step == usual.max_step &&
           given.area_radius_per_broom == usual.area_radius_per_broom &&
           given.tolerance == usual.tolerance && given.bounds.low == usual.bounds.low &&
           given.bounds.high == usual.bounds.high;
}

std::string classic_text(const core::Problem& problem) {
    if (!is_classic(problem))
        throw std::invalid_argument(
            "the classic format has ASVs, obstacles and the usual requirements alone; write a "
            "scenario");
    return io::format_problem(problem);
}

std::string solution_text(const core::Problem& problem, const std::vector<double>& states) {
    core::Solution solution{path_of(states, problem.asv_count()), 0};
    solution.cost = core::cost(problem, solution.path);
    return io::format_solution(solution);
}

Answer file(const char* name, std::string text) {
    Answer answer;
    answer.json = {{"name", name}, {"text", std::move(text)}};
    return answer;
}

}  // namespace

Answer read(const Request& request) {
    const std::string name = request.json.value("name", "text");
    const auto text = request.json.at("text").get<std::string>();
    Answer answer;
    const auto given = request.json.find("problem");
    if (given != request.json.end() && given->is_object() && begins_like_a_solution(text)) {
        const core::Problem problem = problem_of(request);
        answer.json["problem"] = *given;
        answer.add("states", numbers_of(io::parse_solution(text, problem.asv_count(), name).path));
    } else {
        const GivenFiles files(request.json.value("files", Json::object()));
        const io::ProblemFile file = io::is_scenario(text) ? io::parse_scenario(text, name, "")
                                                           : io::parse_problem(text, name);
        answer.json["problem"] = io::scenario_json(file.problem);
        answer.json["states"] = nullptr;
        answer.json["maps"] = Json::array();
        for (const auto& map : file.maps) answer.json["maps"].push_back(map.filename().string());
    }
    return answer;
}

Answer write(const Request& request) {
    const auto what = request.json.at("what").get<std::string>();
    const core::Problem problem = problem_of(request);
    if (what == "problem") return file("problem.txt", classic_text(problem));
    if (what == "scenario") return file("scenario.json", io::format_scenario(problem));
    if (what == "solution") return file("solution.txt", solution_text(problem, request.states));
    throw std::invalid_argument("nothing to write is called " + what);
}

}  // namespace asv::playground
