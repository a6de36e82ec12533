#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <optional>
#include <string>

#include "core/model/problem.hpp"
#include "core/solve/prepared_world.hpp"

namespace asv::io {

/// Queries of more bytes than this are refused.
inline constexpr std::size_t longest_query = std::size_t{1} << 26U;

/// A line of a file of queries: from where to where in one world.
struct Query {
    std::size_t line = 0;  ///< of the file, counted from 1
    std::string id;        ///< what the query is called, as JSON; empty where it has no name
    core::WorldQuery ends;
    std::string error;  ///< what is wrong with it, and where; empty where nothing is
};

/// Reads queries as JSON lines (docs/programs.md), each only once it is asked for, so that who
/// writes them into a pipe can wait for an answer before the next one.
class QueryFile {
  public:
    /// "-" is standard input. world says which body has to be placed; it has to live as long.
    /// Throws ReadError.
    QueryFile(const std::filesystem::path& file, const core::Problem& world);
    QueryFile(const QueryFile&) = delete;
    QueryFile& operator=(const QueryFile&) = delete;

    /// None at the end of the file. A line that cannot be understood is a query with an error;
    /// empty lines are passed over. Throws ReadError.
    std::optional<Query> next();

  private:
    bool next_line();
    Query parsed_line() const;

    std::string name_;
    const core::Problem& world_;
    std::ifstream file_;
    std::istream& stream_;
    bool ended_ = false;
    std::size_t number_ = 0;
    std::string line_;  ///< a byte too long where it is too long
};

}  // namespace asv::io
