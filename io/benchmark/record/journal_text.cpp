#include "io/benchmark/record/journal_text.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/benchmark/record/record_json.hpp"
#include "io/benchmark/record/record_reader.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

using nlohmann::ordered_json;
using Pointer = JsonDocument::Pointer;

std::string line_of(const ordered_json& json) {
    // A file name need not be UTF-8.
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// Reads one line after the other.
class JournalReader {
  public:
    explicit JournalReader(std::string name) : name_(std::move(name)) {}

    /// Without its end. Throws ParseError.
    void read(std::string_view line) {
        ++lines_;
        try {
            const JsonDocument document(line, name_);
            if (lines_ == 1)
                begin(document);
            else if (document.has(Pointer("/session")))
                sessions_.push_back(reader_.read_session(document, Pointer("/session")));
            else if (document.has(Pointer("/session_end")))
                sessions_.back() = reader_.read_session(document, Pointer("/session_end"));
            else
                add_run(document);
        } catch (const ParseError& error) {
            throw ParseError(error.file(), lines_, error.column(), error.expected(), error.found());
        }
    }

    BenchmarkReport end() {
        BenchmarkReport report = std::move(reader_.report);
        report.runs = std::move(runs_);
        core::sort_as_told(report.runs);
        report.session = joined(std::move(sessions_));
        return report;
    }

  private:
    void begin(const JsonDocument& document) {
        reader_.read_plan(document, journal_format);
        sessions_.push_back(reader_.report.session);
    }

    void add_run(const JsonDocument& document) {
        core::BenchmarkRun run = reader_.read_run(document, Pointer());
        if (!places_.insert(run.place).second)
            document.fail(Pointer("/seed"), "a run that is not there already");
        runs_.push_back(std::move(run));
    }

    std::string name_;
    std::size_t lines_ = 0;
    RecordReader reader_;
    std::vector<BenchmarkSession> sessions_;
    std::vector<core::BenchmarkRun> runs_;
    std::set<core::RunPlace> places_;
};

}  // namespace

std::string journal_head(const BenchmarkReport& report) {
    ordered_json json = plan_record(report);
    json["format"] = journal_format;
    return line_of(json);
}

std::string journal_session(const BenchmarkReport& report) {
    return line_of({{"session", session_record(report)}});
}

std::string journal_session_end(const BenchmarkReport& report) {
    return line_of({{"session_end", session_record(report)}});
}

std::string journal_run(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    return line_of(run_record(plan, run));
}

bool is_journal(std::string_view text) {
    const std::string beginning = R"({"format":")" + std::string(journal_format) + '"';
    return beginning.starts_with(text.substr(0, beginning.size()));
}

std::optional<JournalText> parse_journal(std::string_view text, const std::string& name) {
    JournalReader reader(name);
    std::size_t begin = 0;
    while (true) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string_view::npos) break;
        const bool last = end + 1 == text.size();
        try {
            reader.read(text.substr(begin, end - begin));
        } catch (const ParseError&) {
            // After a loss of power a file may have grown by bytes that never reached the disk.
            if (!last || begin == 0) throw;
            break;
        }
        begin = end + 1;
    }
    if (begin == 0) return std::nullopt;
    return JournalText{reader.end(), begin};
}

}  // namespace asv::io
