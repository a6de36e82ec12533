#include "tools/bench/runs/external_run.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include <stdlib.h>
#include <sys/wait.h>

#include "core/bounds/lower_bound.hpp"
#include "io/benchmark/record/command_words.hpp"
#include "io/benchmark/record/generated_name.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_text.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "io/text/number_text.hpp"
#include "io/text/parse_error.hpp"
#include "tools/bench/runs/process_end.hpp"
#include "tools/bench/runs/supervised_process.hpp"

namespace asv::tools {

namespace {

namespace fs = std::filesystem;
using core::BenchmarkRun;
using core::RunStatus;

/// A new folder that goes with everything in it.
class PrivateFolder {
  public:
    PrivateFolder() {
        std::string name = (fs::temp_directory_path() / "asv-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), name);
        path_ = name;
    }
    ~PrivateFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    fs::path operator/(const char* name) const { return path_ / name; }

  private:
    fs::path path_;
};

void exchange_ends(core::Problem& problem) {
    std::swap(problem.start, problem.goal);
    if (auto* arm = std::get_if<core::PlanarArm>(&problem.body)) std::swap(arm->start, arm->goal);
}

/// In the classic format where that can tell it, since more programs read that.
std::string text_of(const core::Problem& problem) {
    core::Problem plain;
    plain.start = problem.start;
    plain.goal = problem.goal;
    plain.obstacles = problem.obstacles;
    const bool classic = io::problem_digest(plain) == io::problem_digest(problem);
    return classic ? io::format_problem(problem) : io::format_scenario(problem);
}

/// The file itself, or one in the folder where that holds something else.
std::string problem_file_for(const core::BenchmarkProblem& given, const core::Problem& problem,
                             bool reversed, const PrivateFolder& folder) {
    const bool is_file = given.file != io::standard_stream && !io::generator_words(given.file);
    if (!reversed && is_file) return given.file;
    const fs::path file = folder / "problem.txt";
    io::write_file(file, text_of(problem));
    return file.string();
}

void set(BenchmarkRun& run, RunStatus status, std::string reason) {
    run.status = status;
    run.reason = std::move(reason);
}

/// What the program said last, behind what it did.
std::string with_last_words(const std::string& what, const SupervisedEnd& end) {
    return end.last_words.empty() ? what : what + ": " + io::escaped(end.last_words);
}

void take_solution(const core::Problem& problem, const core::Solution& solution,
                   BenchmarkRun& run) {
    set(run, RunStatus::solved, "");
    run.primitive_steps = solution.path.size() - 1;
    core::SolveStatistics& spent = run.spent;
    spent.time_to_first = spent.time_total;
    spent.cost_first = spent.cost_of_search = spent.cost = solution.cost;
    spent.cost_history = {{spent.time_total, solution.cost}};
    const core::CostLowerBound bound = core::cost_lower_bound(problem);
    if (!std::isfinite(bound.total)) return;
    spent.cost_lower_bound = bound.total;
    spent.steps_lower_bound = core::steps_lower_bound(problem, bound);
}

void judge_solution(const core::Problem& problem, const fs::path& file, BenchmarkRun& run) {
    // Told under a name that is the same in every run.
    const std::string name = file.filename().string();
    try {
        const core::Solution solution =
            io::parse_solution(io::read_regular_file(file), problem.asv_count(), name);
        const std::string violation = core::fault_of(problem, solution);
        if (violation.empty())
            take_solution(problem, solution, run);
        else
            set(run, RunStatus::invalid, violation);
    } catch (const io::ReadError&) {
        set(run, RunStatus::invalid, name + ": no file that can be read");
    } catch (const std::exception& error) {
        set(run, RunStatus::invalid, error.what());
    }
}

bool speaks_of_memory(std::string words) {
    std::transform(words.begin(), words.end(), words.begin(),
                   [](unsigned char letter) { return std::tolower(letter); });
    constexpr std::array<std::string_view, 4> signs{"bad_alloc", "memoryerror", "out of memory",
                                                    "cannot allocate memory"};
    return std::any_of(signs.begin(), signs.end(), [&](std::string_view sign) {
        return words.find(sign) != std::string::npos;
    });
}

/// The program has ended in error.
void judge_failure(const SupervisedEnd& end, std::size_t memory_limit, BenchmarkRun& run) {
    const bool memory = ran_out_of_memory(end.status, end.peak_memory, memory_limit) ||
                        (memory_limit > 0 && speaks_of_memory(end.last_words));
    if (memory)
        set(run, RunStatus::memory_limit, memory_reason(memory_limit));
    else
        set(run, RunStatus::crash,
            with_last_words(std::string("it ").append(how_it_ended(end.status)), end));
}

/// The program has ended by itself, without a solution.
void judge_without_solution(const SupervisedEnd& end, const core::BenchmarkPlan& plan,
                            BenchmarkRun& run) {
    // Who keeps to a time limit stops a little before it.
    constexpr double nearly_all = 0.9;
    const bool time_is_over = end.seconds >= nearly_all * plan.time_limit;
    constexpr int done = 0, not_solved = 1, infeasible = 4;  // those of asv-solve
    const int code = WEXITSTATUS(end.status);
    if (time_is_over && (code == done || code == not_solved))
        set(run, RunStatus::timeout, "it gave up at the time limit");
    else if (code == done)
        set(run, RunStatus::no_path, with_last_words("it wrote no solution", end));
    else if (code == infeasible)
        set(run, RunStatus::infeasible, with_last_words("it says that there is no path", end));
    else
        judge_failure(end, plan.memory_limit, run);
}

void judge(const SupervisedEnd& end, const core::BenchmarkPlan& plan, const core::Problem& problem,
           const fs::path& solution, BenchmarkRun& run) {
    run.spent.time_total = end.seconds;
    run.peak_memory_bytes = end.peak_memory;
    std::error_code error;
    if (end.timed_out)
        set(run, RunStatus::timeout, "it went on beyond the time limit and was killed");
    else if (end.called_off)
        set(run, RunStatus::interrupted, "it was called off");
    else if (!WIFEXITED(end.status))
        judge_failure(end, plan.memory_limit, run);
    else if (fs::exists(solution, error))
        judge_solution(problem, solution, run);
    else
        judge_without_solution(end, plan, run);
}

}  // namespace

BenchmarkRun run_external(const core::BenchmarkPlan& plan, const core::RunPlace& place) {
    const core::BenchmarkProblem& given = plan.problems[place.problem];
    core::Problem problem = given.problem;
    const bool reversed = place.direction == core::Direction::reversed;
    if (reversed) exchange_ends(problem);
    const PrivateFolder folder;
    const fs::path solution = folder / "solution.txt";
    io::CommandValues values{problem_file_for(given, problem, reversed, folder), solution.string(),
                             std::to_string(place.seed), ""};
    io::append_number(values.time, plan.time_limit);
    std::vector<std::string> words;
    for (const std::string& word : plan.planners[place.planner].command)
        words.push_back(io::fill_in(word, values));
    BenchmarkRun run;
    run.place = place;
    judge(run_supervised(words, plan.time_limit + grace, plan.memory_limit), plan, problem,
          solution, run);
    return run;
}

}  // namespace asv::tools
