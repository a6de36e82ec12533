#include "tools/solve/batch/batch_program.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/solve/prepared_world.hpp"
#include "io/batch/answer.hpp"
#include "io/batch/query_file.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/solve/batch/answer_file.hpp"
#include "tools/solve/run_report.hpp"

namespace asv::tools {

namespace {

/// How the queries so far have ended.
struct Tally {
    std::size_t solved = 0, unsolved = 0, errors = 0;
};

struct Answer {
    std::string line;
    std::size_t Tally::*counts_as = nullptr;
};

/// What the work throws; null where it throws nothing.
template <class Work>
std::exception_ptr failure_of(const Work& work) {
    try {
        work();
        return nullptr;
    } catch (...) {
        return std::current_exception();
    }
}

std::filesystem::path solution_file(const std::filesystem::path& folder, std::size_t line) {
    return folder / (std::to_string(line) + ".txt");
}

/// For all that will be written. Throws io::WriteError.
void require_places(const SolveArguments& arguments) {
    io::require_writable(arguments.solution);
    if (!arguments.solutions.empty()) io::require_writable(solution_file(arguments.solutions, 1));
}

void report(const Tally& tally, double seconds) {
    const std::size_t all = tally.solved + tally.unsolved + tally.errors;
    std::cerr << "asv-solve: " << all << " queries, " << tally.solved << " solved";
    if (tally.unsolved > 0) std::cerr << ", " << tally.unsolved << " without a path";
    if (tally.errors > 0) std::cerr << ", " << tally.errors << " not understood or not valid";
    std::cerr << ", in " << std::setprecision(4) << seconds << " s\n";
}

/// Threads that each take the next query, answer it, and wait with the answer for its turn.
class Batch {
  public:
    Batch(const SolveArguments& arguments, FileRoles roles, core::Problem problem)
        : arguments_(arguments),
          roles_(std::move(roles)),
          world_(std::move(problem)),
          queries_(arguments.batch, world_.problem()),
          answers_(arguments.solution),
          options_(arguments.solve) {
        options_.threads = 1;
        options_.find_bounds = false;  // no answer tells them
    }

    /// Answers all. Throws what any of the threads has met first.
    Tally run(std::size_t threads) {
        std::vector<std::jthread> others;
        try {
            while (others.size() + 1 < threads) others.emplace_back([this] { work(); });
        } catch (const std::system_error&) {
            // The system grants no more: those that are there share the work.
        }
        work();
        others.clear();  // waits for them
        if (failure_) std::rethrow_exception(failure_);
        return tally_;
    }

  private:
    void work() {
        while (answer_next()) continue;
    }

    /// False where there is nothing more to do. What goes wrong does so in its turn, so that the
    /// answers before it are there.
    bool answer_next() {
        std::size_t turn = 0;
        std::optional<io::Query> query;
        Answer answer;
        std::exception_ptr failure;
        {
            const std::lock_guard lock(reading_);
            turn = taken_++;
            failure = failure_of([&] { query = queries_.next(); });
        }
        if (!query && !failure) return false;
        if (query) failure = failure_of([&] { answer = answer_to(*query); });
        std::unique_lock lock(writing_);
        turn_.wait(lock, [&] { return written_ == turn || failure_; });
        if (failure_) return false;
        if (!failure) failure = failure_of([&] { answers_.write(answer.line); });
        failure_ = failure;
        if (!failure_) ++(tally_.*answer.counts_as);
        ++written_;
        turn_.notify_all();
        return !failure_;
    }

    Answer answer_to(const io::Query& query) const {
        if (!query.error.empty()) return {io::refusal_text(query, query.error), &Tally::errors};
        try {
            const core::SolveResult result = world_.solve(query.ends, options_);
            if (result.solution && !arguments_.solutions.empty())
                write_solution(query.line, *result.solution);
            return {io::answer_text(query, result, world_.problem().body_kind()),
                    result.solution ? &Tally::solved : &Tally::unsolved};
        } catch (const core::InvalidEnds& invalid) {
            std::string why;
            for (const core::InvalidEnd& end : invalid.ends())
                why += (why.empty() ? "" : "; ") + text_of(end);
            const std::string place = io::escaped(io::input_name(arguments_.batch)) + ':' +
                                      std::to_string(query.line) + ": ";
            return {io::refusal_text(query, place + why), &Tally::errors};
        }
    }

    void write_solution(std::size_t line, const core::Solution& solution) const {
        const std::filesystem::path file = solution_file(arguments_.solutions, line);
        FileRoles roles = roles_;
        roles.add_output("a file of --solutions", file);
        roles.require_distinct();
        io::write_solution(file, solution);
    }

    const SolveArguments& arguments_;
    FileRoles roles_;
    core::PreparedWorld world_;
    io::QueryFile queries_;
    AnswerFile answers_;
    core::SolveOptions options_;

    std::mutex reading_;
    std::size_t taken_ = 0;

    std::mutex writing_;
    std::condition_variable turn_;
    std::size_t written_ = 0;
    Tally tally_;
    std::exception_ptr failure_;
};

}  // namespace

ExitCode answer_batch(const CommandLine& command_line, const SolveArguments& arguments) {
    FileRoles roles;
    roles.add_input("PROBLEM", arguments.problem);
    roles.add_input("--batch", arguments.batch);
    roles.add_output("SOLUTION", arguments.solution);
    roles.require_distinct();
    io::ProblemFile file = io::read_problem(arguments.problem, arguments.reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    require_places(arguments);
    require_usable_planner(arguments, file.problem.body_kind());
    warn_of_idle_settings(arguments, file.problem);
    const Tally tally =
        Batch(arguments, roles, std::move(file.problem)).run(arguments.solve.threads);
    if (!command_line.quiet())
        report(tally,
               std::chrono::duration<double>(core::Clock::now() - arguments.started).count());
    if (tally.errors > 0) return ExitCode::bad_input;
    return tally.unsolved > 0 ? ExitCode::no : ExitCode::done;
}

}  // namespace asv::tools
