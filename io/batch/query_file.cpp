#include "io/batch/query_file.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <limits>
#include <string_view>

#include "io/problem/scenario_ends.hpp"
#include "io/problem/scenario_values.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "io/text/json/document.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

using Pointer = JsonDocument::Pointer;

/// As JSON: a text, or a whole number.
std::string read_id(const JsonDocument& document, const Pointer& at) {
    if (document.is_text(at)) return JsonDocument::Json(document.text(at)).dump();
    if (!document.is_number(at)) document.fail(at, "a text or a whole number");
    using Limits = std::numeric_limits<std::int64_t>;
    return std::to_string(document.integer(at, Limits::min(), Limits::max()));
}

core::Placement read_end(const JsonDocument& document, const Pointer& at,
                         const core::Problem& world) {
    if (!document.has(at)) return {};
    if (const auto* arm = std::get_if<core::PlanarArm>(&world.body))
        return {.points = {}, .angles = read_arm_end(document, at, *arm)};
    if (world.body_kind() == core::BodyKind::point)
        return {.points = {read_point(document, at)}, .angles = {}};
    return {.points = read_chain_end(document, at, world.asv_count(), world.requirements),
            .angles = {}};
}

}  // namespace

QueryFile::QueryFile(const std::filesystem::path& file, const core::Problem& world)
    : name_(input_name(file)), world_(world), stream_(file == standard_stream ? std::cin : file_) {
    if (file == standard_stream) return;
    file_.open(file, std::ios::binary);
    if (!file_) throw ReadError(escaped(name_) + ": " + std::strerror(errno));
}

std::optional<Query> QueryFile::next() {
    constexpr std::string_view blanks = " \t\r";
    while (!ended_ && next_line())
        if (line_.size() > longest_query || line_.find_first_not_of(blanks) != std::string::npos)
            return parsed_line();
    return std::nullopt;
}

bool QueryFile::next_line() {
    line_.clear();
    std::streambuf& bytes = *stream_.rdbuf();
    constexpr int end = std::char_traits<char>::eof();
    try {
        int byte = bytes.sbumpc();
        // A terminal would go on behind its end.
        ended_ = byte == end;
        if (ended_) return false;
        for (; byte != end && byte != '\n'; byte = bytes.sbumpc())
            if (line_.size() <= longest_query) line_.push_back(static_cast<char>(byte));
    } catch (const std::ios_base::failure& error) {  // a directory, or a disk that fails
        throw ReadError(escaped(name_) + ": " + error.code().message());
    }
    ++number_;
    return true;
}

Query QueryFile::parsed_line() const {
    Query query;
    query.line = number_;
    try {
        if (line_.size() > longest_query)
            throw ParseError(name_, 1, longest_query + 1,
                             "at most " + std::to_string(longest_query) + " bytes in a line",
                             "more");
        const JsonDocument document(line_, name_);
        const Pointer root;
        document.require_members(root, {}, {"id", "start", "goal"});
        if (document.has(root / "id")) query.id = read_id(document, root / "id");
        query.ends = {read_end(document, root / "start", world_),
                      read_end(document, root / "goal", world_)};
    } catch (const ParseError& error) {
        query.error =
            ParseError(name_, number_, error.column(), error.expected(), error.found()).what();
    }
    return query;
}

}  // namespace asv::io
