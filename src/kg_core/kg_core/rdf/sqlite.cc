#include "kg_core/rdf/sqlite.h"

#include <sqlite3.h>

namespace kg_core {
namespace {

[[noreturn]] void Throw(sqlite3* database, int code) {
  const char* what =
      database == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(database);
  throw SqliteError(code, what);
}

}  // namespace

SqliteError::SqliteError(int code, const std::string& what)
    : std::runtime_error(what), code_(code) {}

bool SqliteError::is_busy() const {
  return (code_ & 0xFF) == SQLITE_BUSY || (code_ & 0xFF) == SQLITE_LOCKED;
}

bool SqliteError::is_corrupt() const {
  return (code_ & 0xFF) == SQLITE_CORRUPT || (code_ & 0xFF) == SQLITE_NOTADB;
}

SqliteQuery::SqliteQuery(sqlite3* database, const char* sql)
    : statement_(nullptr, sqlite3_finalize) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(
      database, sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) Throw(database, code);
}

void SqliteQuery::Check(int code) const {
  if (code != SQLITE_OK) Throw(sqlite3_db_handle(statement_.get()), code);
}

SqliteQuery& SqliteQuery::Bind(int parameter, std::int64_t value) {
  Check(sqlite3_bind_int64(statement_.get(), parameter, value));
  return *this;
}

SqliteQuery& SqliteQuery::Bind(int parameter, std::string_view bytes) {
  // A null pointer would bind NULL instead of an empty blob.
  const char* data = bytes.empty() ? "" : bytes.data();
  Check(sqlite3_bind_blob64(statement_.get(), parameter, data, bytes.size(),
                            SQLITE_STATIC));
  return *this;
}

bool SqliteQuery::Step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) Throw(sqlite3_db_handle(statement_.get()), code);
  return false;
}

void SqliteQuery::Run() {
  try {
    while (Step()) {
    }
  } catch (...) {
    Reset();
    throw;
  }
  Reset();
}

void SqliteQuery::Reset() { sqlite3_reset(statement_.get()); }

std::int64_t SqliteQuery::Integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string SqliteQuery::Bytes(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return size == 0 ? "" : std::string(static_cast<const char*>(bytes), size);
}

SqliteDatabase::SqliteDatabase(const std::string& path, bool create)
    : database_(nullptr, sqlite3_close_v2) {
  sqlite3* database = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX |
                    (create ? SQLITE_OPEN_CREATE : 0);
  const int code = sqlite3_open_v2(path.c_str(), &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) Throw(database, code);
  sqlite3_extended_result_codes(database, 1);
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

void SqliteDatabase::Execute(const char* sql) {
  const int code =
      sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) Throw(database_.get(), code);
}

SqliteQuery SqliteDatabase::Prepare(const char* sql) {
  return SqliteQuery(database_.get(), sql);
}

std::int64_t SqliteDatabase::changed_rows() const {
  return sqlite3_changes64(database_.get());
}

bool SqliteDatabase::in_transaction() const {
  return sqlite3_get_autocommit(database_.get()) == 0;
}

}  // namespace kg_core
