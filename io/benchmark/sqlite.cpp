#include "io/benchmark/sqlite.hpp"

#include <stdexcept>

#include <sqlite3.h>

namespace asv::io {

namespace {

[[noreturn]] void fail(sqlite3* database) {
    throw std::runtime_error(std::string("SQLite: ") + sqlite3_errmsg(database));
}

}  // namespace

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close(database);
}

Database::Database() {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open(":memory:", &opened);
    database_.reset(opened);
    if (code != SQLITE_OK) fail(opened);
}

void Database::execute(const std::string& sql) {
    if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        fail(database_.get());
}

std::string Database::bytes() const {
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> content(
        sqlite3_serialize(database_.get(), "main", &size, 0), sqlite3_free);
    if (!content) fail(database_.get());
    return {content.get(), content.get() + size};
}

std::int64_t Database::last_row() const {
    return sqlite3_last_insert_rowid(database_.get());
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(Database& database, const std::string& sql)
    : database_(database.database_.get()) {
    sqlite3_stmt* prepared = nullptr;
    const int code = sqlite3_prepare_v2(database_, sql.c_str(), -1, &prepared, nullptr);
    statement_.reset(prepared);
    check(code);
}

void Statement::check(int code) const {
    if (code != SQLITE_OK && code != SQLITE_DONE) fail(database_);
}

Statement& Statement::bind(std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
    return *this;
}

Statement& Statement::bind(double value) {
    check(sqlite3_bind_double(statement_.get(), ++bound_, value));
    return *this;
}

Statement& Statement::bind(std::string_view text) {
    // A null pointer, with which an empty view may come, would stand for NULL.
    const char* begin = text.empty() ? "" : text.data();
    check(sqlite3_bind_text64(statement_.get(), ++bound_, begin, text.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind_null() {
    check(sqlite3_bind_null(statement_.get(), ++bound_));
    return *this;
}

void Statement::run() {
    check(sqlite3_step(statement_.get()));
    check(sqlite3_reset(statement_.get()));
    bound_ = 0;
}

}  // namespace asv::io
