#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace asv::io {

/// A database in memory, written by statements. The only file that knows SQLite. Everything throws
/// std::runtime_error when SQLite fails (out of memory, or a statement that is wrong).
class Database {
  public:
    Database();

    /// One or more statements without parameters and results.
    void execute(const std::string& sql);

    /// The bytes of the database file.
    std::string bytes() const;

    /// Of the row that was inserted last.
    std::int64_t last_row() const;

  private:
    friend class Statement;
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> database_;
};

/// An INSERT with parameters, which is run once for each row.
class Statement {
  public:
    /// The database has to outlive it.
    Statement(Database& database, const std::string& sql);

    /// Binds the values to the parameters in turn: run() puts them in.
    Statement& bind(std::int64_t value);
    Statement& bind(double value);
    Statement& bind(std::string_view text);
    Statement& bind_null();
    void run();

  private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    void check(int code) const;

    sqlite3* database_;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    int bound_ = 0;
};

}  // namespace asv::io
