#include "tools/bench/records/journal.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/benchmark/record/journal_text.hpp"
#include "io/benchmark/record/plan_facts.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/write_all.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

namespace {

/// The system's words for what failed last.
std::string reason() {
    return std::generic_category().message(errno);
}

/// A new file is on the disk only when its name is.
void flush_folder_of(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

Journal::Journal(const std::filesystem::path& file, const io::BenchmarkReport& planned)
    : file_(file) {
    // A pipe is not waited for: it is no journal.
    constexpr int flags = O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;
    descriptor_ = ::open(file.c_str(), flags, 0666);
    if (descriptor_ < 0) fail_to_write();
    try {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode))
            throw UsageError("--resume " + file.string() + ": not a regular file");
        // Held until the process ends, however it does.
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
            throw UsageError("--resume " + file.string() + ": another asv-bench is writing it");
        take_over(io::read_regular_file(file), planned);
        flush_folder_of(file);
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

Journal::~Journal() {
    ::close(descriptor_);
}

void Journal::take_over(const std::string& text, const io::BenchmarkReport& planned) {
    const std::string name = file_.string();
    if (!io::is_journal(text))
        throw UsageError("--resume " + name + ": this file is no journal of asv-bench");
    std::optional<io::JournalText> found = io::parse_journal(text, name);
    const std::size_t whole = found ? found->size : 0;
    if (found) {
        // As a file would tell it, which need not be to the byte what was given.
        const auto here = io::parse_journal(io::journal_head(planned), name);
        const auto differing = io::differing_plans(here->report, found->report);
        std::string list;
        for (const std::string& difference : differing) list += "\n  " + io::escaped(difference);
        if (!list.empty())
            throw UsageError("--resume " + name + ": the journal is of another benchmark:" + list);
    }
    if (::ftruncate(descriptor_, static_cast<off_t>(whole)) != 0) fail_to_write();
    if (!found) return;
    empty_ = false;
    runs_ = std::move(found->report.runs);
    const io::BenchmarkSession& session = found->report.session;
    sessions_ = session.parts.empty() ? std::vector{session} : session.parts;
}

void Journal::begin(const io::BenchmarkReport& report) {
    append(empty_ ? io::journal_head(report) : io::journal_session(report));
    empty_ = false;
}

void Journal::add(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    append(io::journal_run(plan, run));
}

void Journal::end(const io::BenchmarkReport& report) {
    append(io::journal_session_end(report));
}

void Journal::append(const std::string& line) {
    if (!io::write_all(descriptor_, line) || ::fdatasync(descriptor_) != 0) fail_to_write();
}

void Journal::fail_to_write() const {
    throw io::WriteError(file_.string() + ": " + reason());
}

}  // namespace asv::tools
