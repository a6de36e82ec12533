#include "io/solution/run_facts.hpp"

#include "io/text/atomic_file.hpp"
#include "io/text/json/document.hpp"

namespace asv::io {
namespace {

using Pointer = JsonDocument::Pointer;

}  // namespace

RunFacts parse_run_facts(std::string_view text, const std::string& name) {
    const JsonDocument document(text, name);
    RunFacts facts;
    if (document.has(Pointer("/planner"))) facts.planner = document.text(Pointer("/planner"));
    const Pointer bound("/cost_lower_bound");
    if (document.has(bound) && !document.is_null(bound)) {
        const double value = document.number(bound);
        if (value > 0) facts.lower_bound = value;
    }
    return facts;
}

RunFacts read_run_facts(const std::filesystem::path& file) {
    return parse_run_facts(read_file(file), file.string());
}

}  // namespace asv::io
