#include "io/benchmark/arena_database.hpp"

#include <cmath>
#include <vector>

#include "io/benchmark/experiment.hpp"
#include "io/benchmark/sqlite.hpp"

namespace asv::io {

namespace {

constexpr const char* tables = R"(
CREATE TABLE experiments
    (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512),
    totaltime REAL, timelimit REAL, memorylimit REAL, runcount INTEGER,
    version VARCHAR(128), hostname VARCHAR(1024), cpuinfo TEXT,
    date DATETIME, seed VARCHAR(24), setup TEXT);
CREATE TABLE plannerConfigs
    (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL, settings TEXT);
CREATE TABLE enums
    (name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY (name, value));
CREATE TABLE progress
    (runid INTEGER, time REAL, best_cost REAL, PRIMARY KEY (runid, time),
    FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE);
)";

std::string table_of_runs() {
    std::string sql =
        "CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, "
        "experimentid INTEGER, plannerid INTEGER";
    for (const Attribute& attribute : run_attributes())
        sql += ", " + column_name(attribute.name) + " " + std::string(attribute.type);
    return sql +
           ", FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE"
           ", FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE)";
}

std::string insertion_of_run() {
    std::string names = "experimentid, plannerid", places = "?, ?";
    for (const Attribute& attribute : run_attributes()) {
        names += ", " + column_name(attribute.name);
        places += ", ?";
    }
    return "INSERT INTO runs (" + names + ") VALUES (" + places + ")";
}

/// Fills the tables of one database.
class Writer {
  public:
    Writer(const BenchmarkReport& report, Database& database)
        : report_(report),
          database_(database),
          experiment_(database,
                      "INSERT INTO experiments (name, totaltime, timelimit, memorylimit, runcount, "
                      "version, hostname, cpuinfo, date, seed, setup) "
                      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
          planner_(database, "INSERT INTO plannerConfigs (name, settings) VALUES (?, ?)"),
          enum_(database, "INSERT INTO enums VALUES ('status', ?, ?)"),
          run_(database, insertion_of_run()),
          // Two costs of one moment: the later one, which is the better one, stays.
          progress_(database, "INSERT OR REPLACE INTO progress VALUES (?, ?, ?)") {}

    void write() {
        std::int64_t value = 0;
        for (const std::string_view word : status_words()) enum_.bind(value++).bind(word).run();
        for (const core::BenchmarkPlanner& planner : report_.plan.planners)
            planner_ids_.push_back(add_planner(planner));
        for (const Experiment& experiment : experiments(report_)) {
            const std::int64_t id = add_experiment(experiment);
            for (std::size_t planner = 0; planner < planner_ids_.size(); ++planner)
                for (const core::BenchmarkRun* run : runs_of(report_, experiment, planner))
                    add_run(id, planner_ids_[planner], *run);
        }
    }

  private:
    std::int64_t add_planner(const core::BenchmarkPlanner& planner) {
        std::string settings;
        // As OMPL's script strings the lines of a log together.
        for (const std::string& line : setting_lines(planner)) settings += line + "\n;";
        planner_.bind(std::string_view(planner.label)).bind(std::string_view(settings)).run();
        return database_.last_row();
    }

    std::int64_t add_experiment(const Experiment& experiment) {
        const core::BenchmarkPlan& plan = report_.plan;
        const BenchmarkSession& session = report_.session;
        const std::string cpu =
            session.cpu + ", " + std::to_string(session.processors) + " processors\n";
        experiment_.bind(std::string_view(experiment.name))
            .bind(session.total)
            .bind(plan.time_limit)
            .bind(0.0)
            .bind(static_cast<std::int64_t>(plan.seeds))
            .bind(std::string_view("ASV " + session.version))
            .bind(std::string_view(session.host))
            .bind(std::string_view(cpu))
            .bind(std::string_view(utc_text(session.started)))
            .bind(std::string_view(std::to_string(plan.first_seed)))
            .bind(std::string_view(setup_text(report_, experiment)))
            .run();
        return database_.last_row();
    }

    void bind(const AttributeValue& value) {
        if (const auto* count = std::get_if<std::int64_t>(&value))
            run_.bind(*count);
        else if (const auto* real = std::get_if<double>(&value); real && std::isfinite(*real))
            run_.bind(*real);
        else
            run_.bind_null();
    }

    void add_run(std::int64_t experiment, std::int64_t planner, const core::BenchmarkRun& run) {
        run_.bind(experiment).bind(planner);
        for (const Attribute& attribute : run_attributes()) bind(attribute.value(report_, run));
        run_.run();
        const std::int64_t id = database_.last_row();
        for (const auto& [time, cost] : run.spent.cost_history)
            progress_.bind(id).bind(time).bind(cost).run();
    }

    const BenchmarkReport& report_;
    Database& database_;
    Statement experiment_, planner_, enum_, run_, progress_;
    std::vector<std::int64_t> planner_ids_;
};

}  // namespace

std::string arena_database(const BenchmarkReport& report) {
    Database database;
    database.execute("PRAGMA foreign_keys = ON; BEGIN;");
    database.execute(table_of_runs());
    database.execute(tables);
    Writer(report, database).write();
    database.execute("COMMIT");
    return database.bytes();
}

}  // namespace asv::io
