// A page has no files: what reads and writes them in io only says so here.

#include "io/problem/scenario_map.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

constexpr const char* reason = "a page has no files";

}  // namespace

std::string input_name(const std::filesystem::path& file) {
    return file.string();
}

std::string read_file(const std::filesystem::path& file, std::size_t /*limit*/) {
    throw ReadError(file.string() + ": " + reason);
}

void write_file(const std::filesystem::path& file, std::string_view /*content*/) {
    throw WriteError(file.string() + ": " + reason);
}

ScenarioMap read_scenario_map(const JsonDocument& document, const JsonDocument::Pointer& at,
                              const std::filesystem::path& /*folder*/,
                              const ReadOptions& /*options*/) {
    document.fail(at, "no map, since " + std::string(reason));
}

}  // namespace asv::io
