#include "io/benchmark/record/record_reader.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "io/benchmark/record/command_words.hpp"
#include "io/benchmark/record/record_json.hpp"
#include "io/problem/reading.hpp"

namespace asv::io {

namespace {

using Pointer = JsonDocument::Pointer;

/// Obstacles and ASVs of all problems together, 32 bytes each: what stands for a problem has as
/// many of them as the problem.
constexpr std::size_t most_in_all = 10'000'000;

/// Of what has no bound of its own.
constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();

std::size_t count(const JsonDocument& document, const Pointer& at, std::size_t low,
                  std::size_t high) {
    return static_cast<std::size_t>(
        document.integer(at, static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
}

double number_or_zero(const JsonDocument& document, const Pointer& at) {
    return document.is_null(at) ? 0 : document.number(at);
}

/// Which of the words stands there.
template <class Words>
std::size_t choice(const JsonDocument& document, const Pointer& at, const Words& words) {
    const std::string text = document.text(at);
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for (const std::string_view word : words)
        list.append(list.empty() ? "\"" : "\" or \"").append(word);
    document.fail(at, list + "\"");
}

std::chrono::system_clock::time_point utc_time(const JsonDocument& document, const Pointer& at) {
    const std::string text = document.text(at);
    std::tm parts{};
    const char* end = ::strptime(text.c_str(), "%Y-%m-%d %H:%M:%S", &parts);
    if (end == nullptr || *end != '\0') document.fail(at, "a time YYYY-MM-DD hh:mm:ss");
    return std::chrono::system_clock::from_time_t(::timegm(&parts));
}

BenchmarkSession session_part(const JsonDocument& document, const Pointer& at) {
    constexpr double least_unit = std::numeric_limits<double>::min();
    constexpr double greatest = std::numeric_limits<double>::max();
    BenchmarkSession session;
    session.started = utc_time(document, at / "started_utc");
    session.host = document.text(at / "host");
    session.cpu = document.text(at / "cpu");
    session.processors = count(document, at / "processors", 0, most);
    session.total = document.number(at / "total_s", 0, greatest);
    session.unit_before = document.number(at / "unit_before_s", least_unit, greatest);
    session.unit_after = document.number(at / "unit_after_s", least_unit, greatest);
    return session;
}

core::Direction direction(const JsonDocument& document, const Pointer& at) {
    constexpr std::array<std::string_view, 2> words{"forward", "reversed"};
    return choice(document, at, words) == 0 ? core::Direction::forward : core::Direction::reversed;
}

/// Everything of the plan but problems and planners.
void read_limits(const JsonDocument& document, const Pointer& at, core::BenchmarkPlan& plan) {
    constexpr double greatest = std::numeric_limits<double>::max();
    plan.time_limit = document.number(at / "time_limit_s", 0, greatest);
    plan.optimize = document.number(at / "optimize_s", 0, greatest);
    plan.threads = count(document, at / "threads", 1, most);
    plan.jobs = count(document, at / "jobs", 1, most);
    const Pointer memory = at / "memory_limit_mb";
    plan.memory_limit = document.is_null(memory) ? 0 : count(document, memory, 1, most);
    plan.first_seed = document.count(at / "first_seed");
    plan.seeds = count(document, at / "seeds", 1, most);
    plan.directions.clear();
    for (std::size_t i = 0; i < document.array(at / "directions").size(); ++i)
        plan.directions.push_back(direction(document, at / "directions" / i));
}

/// A problem of this kind and size whose coordinates nobody knows.
core::Problem outline(core::BodyKind body, std::size_t asv_count, std::size_t obstacle_count) {
    core::Problem problem;
    problem.start.resize(asv_count);
    problem.goal.resize(asv_count);
    problem.obstacles.resize(obstacle_count);
    if (body == core::BodyKind::arm) problem.body = core::PlanarArm{};
    if (body == core::BodyKind::point) problem.body = core::PointBody{};
    return problem;
}

std::vector<std::pair<std::string, double>> read_parameters(const JsonDocument& document,
                                                            const Pointer& at) {
    std::vector<std::pair<std::string, double>> parameters;
    for (const std::string& name : document.members(at))
        parameters.emplace_back(name, document.number(at / name));
    return parameters;
}

core::BenchmarkProblem read_problem(const JsonDocument& document, const Pointer& at) {
    const auto body = static_cast<core::BodyKind>(choice(document, at / "body", body_names));
    // An arm has one point more than links.
    return {document.text(at / "name"), document.text(at / "file"),
            outline(body, count(document, at / "asv_count", 1, max_asvs + 1),
                    count(document, at / "obstacle_count", 0, max_obstacles)),
            document.text(at / "digest"),
            document.has(at / "parameters") ? read_parameters(document, at / "parameters")
                                            : core::BenchmarkProblem{}.parameters};
}

std::vector<std::string> read_command(const JsonDocument& document, const Pointer& at) {
    const std::size_t size = document.array(at).size();
    if (size == 0) document.fail(at, "the words of a command");
    std::vector<std::string> words;
    for (std::size_t i = 0; i < size; ++i) {
        words.push_back(document.text(at / i));
        try {
            static_cast<void>(fill_in(words.back(), {}));
        } catch (const std::invalid_argument& error) {
            document.fail(at / i, std::string("a word of a command (") + error.what() + ")");
        }
    }
    return words;
}

core::BenchmarkPlanner read_planner(const JsonDocument& document, const Pointer& at) {
    core::BenchmarkPlanner planner;
    planner.label = document.text(at / "label");
    Pointer place = at / "planner";
    if (document.is_text(place) && document.text(place) == external_name) {
        planner.command = read_command(document, at / "command");
        return planner;
    }
    try {
        planner.planner = core::planner_named(document.text(place));
        for (std::size_t i = 0; i < document.array(at / "given").size(); ++i) {
            place = at / "given" / i;
            const std::string setting = document.text(place);
            const std::size_t equals = setting.find('=');
            if (equals == std::string::npos) document.fail(place, "KEY=VALUE");
            planner.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
            core::set(planner.planner, planner.settings.back().first,
                      planner.settings.back().second);
        }
    } catch (const std::invalid_argument& error) {
        document.fail(place, std::string("something that there is (") + error.what() + ")");
    }
    return planner;
}

core::RunStatus read_status(const JsonDocument& document, const Pointer& at) {
    std::vector<std::string_view> words;
    for (const core::RunStatus status : core::all_run_statuses) words.push_back(name(status));
    return core::all_run_statuses[choice(document, at, words)];
}

core::SolveStatistics read_statistics(const JsonDocument& document, const Pointer& at) {
    core::SolveStatistics spent;
    spent.time_to_first = number_or_zero(document, at / "time_to_first_s");
    spent.time_total = document.number(at / "time_total_s");
    spent.cost_first = number_or_zero(document, at / "cost_first");
    spent.cost_of_search = number_or_zero(document, at / "cost_of_search");
    spent.cost = number_or_zero(document, at / "cost");
    spent.cost_lower_bound = number_or_zero(document, at / "cost_lower_bound");
    spent.optimal = !document.is_null(at / "optimal") && document.boolean(at / "optimal");
    const Pointer steps = at / "primitive_steps_lower_bound";
    spent.steps_lower_bound = document.is_null(steps) ? 0 : document.count(steps);
    for (const std::size_t tree : {0U, 1U})
        spent.tree_nodes[tree] = document.count(at / "tree_nodes" / tree);
    spent.iterations = document.count(at / "iterations");
    spent.state_checks = document.count(at / "state_checks");
    spent.edge_checks = document.count(at / "edge_checks");
    const Pointer history = at / "cost_history";
    for (std::size_t i = 0; i < document.array(history).size(); ++i)
        spent.cost_history.emplace_back(document.number(history / i / 0),
                                        document.number(history / i / 1));
    return spent;
}

/// Its place in the list of that name; fails where it is none of them.
std::size_t index_of(const JsonDocument& document, const Pointer& at,
                     const std::unordered_map<std::string, std::size_t>& names,
                     const std::string& list) {
    const auto found = names.find(document.text(at));
    if (found == names.end()) document.fail(at, "one of the " + list);
    return found->second;
}

}  // namespace

void RecordReader::read_plan(const JsonDocument& document, std::string_view format) {
    const Pointer root;
    document.require_object(root);
    if (!document.is_text(root / "format") || document.text(root / "format") != format)
        document.fail(root / "format", "\"" + std::string(format) + "\"");
    report.session = read_session(document, root / "session");
    read_limits(document, root / "session", report.plan);
    const Pointer problems = root / "problems", planners = root / "planners";
    std::size_t in_all = 0;
    for (std::size_t i = 0; i < document.array(problems).size(); ++i) {
        report.plan.problems.push_back(read_problem(document, problems / i));
        const core::Problem& problem = report.plan.problems[i].problem;
        in_all += problem.obstacles.size() + problem.asv_count();
        if (in_all > most_in_all)
            document.fail(
                problems / i / "obstacle_count",
                "at most " + std::to_string(most_in_all) + " obstacles and ASVs in all problems");
        if (!problems_.emplace(report.plan.problems[i].name, i).second)
            document.fail(problems / i / "name", "a name that no other problem has");
    }
    for (std::size_t i = 0; i < document.array(planners).size(); ++i) {
        report.plan.planners.push_back(read_planner(document, planners / i));
        if (!planners_.emplace(report.plan.planners[i].label, i).second)
            document.fail(planners / i / "label", "a label that no other planner has");
    }
}

BenchmarkSession RecordReader::read_session(const JsonDocument& document, const Pointer& at) const {
    BenchmarkSession session = session_part(document, at);
    session.version = document.text(at / "version");
    for (std::size_t i = 0; i < document.array(at / "parts").size(); ++i) {
        session.parts.push_back(session_part(document, at / "parts" / i));
        session.parts.back().version = session.version;
    }
    return session;
}

core::BenchmarkRun RecordReader::read_run(const JsonDocument& document, const Pointer& at) const {
    document.require_object(at);
    const core::BenchmarkPlan& plan = report.plan;
    core::BenchmarkRun run;
    run.place.problem = index_of(document, at / "problem", problems_, "problems");
    run.place.planner = index_of(document, at / "planner", planners_, "planners");
    run.place.direction = direction(document, at / "direction");
    if (std::find(plan.directions.begin(), plan.directions.end(), run.place.direction) ==
        plan.directions.end())
        document.fail(at / "direction", "one of the directions of the session");
    run.place.seed = document.count(at / "seed");
    if (run.place.seed < plan.first_seed || run.place.seed - plan.first_seed >= plan.seeds)
        document.fail(at / "seed", "one of the seeds of the session");
    run.status = read_status(document, at / "status");
    run.reason = document.text(at / "reason");
    run.spent = read_statistics(document, at);
    run.primitive_steps = document.count(at / "primitive_steps");
    const Pointer memory = at / "peak_memory_bytes";
    if (!document.is_null(memory)) run.peak_memory_bytes = document.count(memory);
    return run;
}

}  // namespace asv::io
