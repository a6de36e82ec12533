#include "io/benchmark/record/runs_file.hpp"

#include <set>
#include <utility>

#include "io/benchmark/record/journal_text.hpp"
#include "io/benchmark/record/record_json.hpp"
#include "io/benchmark/record/record_reader.hpp"
#include "io/text/atomic_file.hpp"

namespace asv::io {

BenchmarkReport parse_runs(std::string_view text, const std::string& name) {
    if (!text.empty() && is_journal(text))
        if (std::optional<JournalText> journal = parse_journal(text, name))
            return std::move(journal->report);
    const JsonDocument document(text, name);
    RecordReader reader;
    reader.read_plan(document, runs_format);
    const JsonDocument::Pointer runs("/runs");
    std::set<core::RunPlace> places;
    for (std::size_t i = 0; i < document.array(runs).size(); ++i) {
        reader.report.runs.push_back(reader.read_run(document, runs / i));
        if (!places.insert(reader.report.runs.back().place).second)
            document.fail(runs / i / "seed", "a run that is not there already");
    }
    core::sort_as_told(reader.report.runs);
    return std::move(reader.report);
}

BenchmarkReport read_runs(const std::filesystem::path& file) {
    return parse_runs(read_file(file), input_name(file));
}

}  // namespace asv::io
