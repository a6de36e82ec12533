#include "io/benchmark/arena_database.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "io/benchmark/sqlite.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using Row = std::vector<std::string>;

/// The database as another program would open it.
class Reader {
  public:
    explicit Reader(const std::string& bytes) {
        write_file(folder_ / "b.db", bytes);
        sqlite3* opened = nullptr;
        EXPECT_EQ(
            sqlite3_open_v2((folder_ / "b.db").c_str(), &opened, SQLITE_OPEN_READONLY, nullptr),
            SQLITE_OK);
        database_.reset(opened);
    }

    /// All rows as text, NULL as "NULL".
    std::vector<Row> rows(const std::string& sql) const {
        std::vector<Row> result;
        const auto add = [](void* rows, int count, char** values, char**) {
            Row row;
            for (int i = 0; i < count; ++i) row.emplace_back(values[i] ? values[i] : "NULL");
            static_cast<std::vector<Row>*>(rows)->push_back(std::move(row));
            return 0;
        };
        EXPECT_EQ(sqlite3_exec(database_.get(), sql.c_str(), add, &result, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database_.get());
        return result;
    }

    /// "name TYPE" of every column.
    Row columns(const std::string& table) const {
        Row result;
        for (const Row& row : rows("PRAGMA table_info(" + table + ")"))
            result.push_back(row[1] + " " + row[2]);
        return result;
    }

  private:
    test::TemporaryFolder folder_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_{nullptr, sqlite3_close};
};

TEST(ArenaDatabase, HasTheTablesAndColumnsOfOmpl) {
    const Reader reader(arena_database(test::sample_report()));
    EXPECT_EQ(reader.columns("experiments"),
              (Row{"id INTEGER", "name VARCHAR(512)", "totaltime REAL", "timelimit REAL",
                   "memorylimit REAL", "runcount INTEGER", "version VARCHAR(128)",
                   "hostname VARCHAR(1024)", "cpuinfo TEXT", "date DATETIME", "seed VARCHAR(24)",
                   "setup TEXT"}));
    EXPECT_EQ(reader.columns("plannerConfigs"),
              (Row{"id INTEGER", "name VARCHAR(512)", "settings TEXT"}));
    EXPECT_EQ(reader.columns("enums"),
              (Row{"name VARCHAR(512)", "value INTEGER", "description TEXT"}));
    EXPECT_EQ(reader.columns("runs"), (Row{"id INTEGER",
                                           "experimentid INTEGER",
                                           "plannerid INTEGER",
                                           "time REAL",
                                           "memory REAL",
                                           "status ENUM",
                                           "solved BOOLEAN",
                                           "approximate_solution BOOLEAN",
                                           "correct_solution BOOLEAN",
                                           "solution_length REAL",
                                           "simplification_time REAL",
                                           "simplified_solution_length REAL",
                                           "simplified_correct_solution BOOLEAN",
                                           "simplified_solution_segments INTEGER",
                                           "graph_states INTEGER",
                                           "iterations INTEGER",
                                           "state_checks INTEGER",
                                           "edge_checks INTEGER",
                                           "cost_lower_bound REAL",
                                           "cost_ratio REAL",
                                           "time_in_units REAL",
                                           "total_time REAL",
                                           "seed INTEGER"}));
    EXPECT_EQ(reader.columns("progress"), (Row{"runid INTEGER", "time REAL", "best_cost REAL"}));
}

TEST(ArenaDatabase, IsWhole) {
    const Reader reader(arena_database(test::sample_report()));
    EXPECT_EQ(reader.rows("PRAGMA integrity_check"), (std::vector<Row>{{"ok"}}));
    EXPECT_TRUE(reader.rows("PRAGMA foreign_key_check").empty());
}

TEST(ArenaDatabase, HoldsEveryRunOfItsPlannerAndExperiment) {
    const Reader reader(arena_database(test::sample_report()));
    EXPECT_EQ(reader.rows("SELECT name, runcount, version, hostname, timelimit, seed "
                          "FROM experiments WHERE id = 2"),
              (std::vector<Row>{{"first-reversed", "2", "ASV 1.2.3", "host", "10.0", "3"}}));
    EXPECT_EQ(reader.rows("SELECT name FROM plannerConfigs ORDER BY id"),
              (std::vector<Row>{{"auto"}, {"swaps|1"}}));
    const auto settings = reader.rows("SELECT settings FROM plannerConfigs WHERE id = 2");
    EXPECT_NE(settings[0][0].find("swap-limiter = on\n;"), std::string::npos) << settings[0][0];
    EXPECT_EQ(reader.rows("SELECT count(*) FROM runs"), (std::vector<Row>{{"16"}}));
    EXPECT_EQ(reader.rows("SELECT time, memory, description, solved, solution_length, "
                          "simplified_solution_length, graph_states, time_in_units, runs.seed "
                          "FROM runs JOIN enums ON enums.name = 'status' AND value = status "
                          "WHERE experimentid = 1 AND plannerid = 1"),
              (std::vector<Row>{
                  {"0.015625", "3.0", "Exact solution", "1", "3.0", "2.5", "30", "0.0625", "3"},
                  {"0.046875", "3.0", "Exact solution", "1", "3.0", "2.5", "30", "0.1875", "4"}}));
    EXPECT_EQ(reader.rows("SELECT time, memory, description, solved, correct_solution, "
                          "solution_length, cost_ratio FROM runs JOIN enums ON value = status "
                          "WHERE experimentid = 2 AND plannerid = 2 AND seed = 4"),
              (std::vector<Row>{{"10.0", "NULL", "Timeout", "0", "NULL", "NULL", "NULL"}}));
    EXPECT_EQ(reader.rows("SELECT time, best_cost FROM progress WHERE runid = 1 ORDER BY time"),
              (std::vector<Row>{{"0.015625", "3.0"}, {"0.265625", "2.5"}}));
}

TEST(ArenaDatabase, ALabelIsNoStatement) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners[0].label = "a'); DROP TABLE runs; --";
    const Reader reader(arena_database(report));
    EXPECT_EQ(reader.rows("SELECT name FROM plannerConfigs WHERE id = 1"),
              (std::vector<Row>{{"a'); DROP TABLE runs; --"}}));
}

TEST(Sqlite, AWrongStatementIsToldWithItsReason) {
    Database database;
    EXPECT_THROW(database.execute("CREATE TABEL t (a)"), std::runtime_error);
    EXPECT_THROW(Statement(database, "INSERT INTO nothing VALUES (?)"), std::runtime_error);
    database.execute("CREATE TABLE t (a UNIQUE)");
    Statement insert(database, "INSERT INTO t VALUES (?)");
    insert.bind(std::int64_t{1}).run();
    EXPECT_THROW(insert.bind(std::int64_t{1}).run(), std::runtime_error);
}

}  // namespace
}  // namespace asv::io
