// Thin wrapper of the part of SQLite that the store's record needs; errors
// become exceptions. A database and its queries may be used by one thread at a
// time.

#ifndef KG_CORE_RDF_SQLITE_H_
#define KG_CORE_RDF_SQLITE_H_

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace kg_core {

class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& what);
  bool is_busy() const;
  bool is_corrupt() const;

 private:
  int code_;
};

// A prepared statement. Usage: Bind..., Step until false (or Run), Reset.
class SqliteQuery {
 public:
  SqliteQuery(sqlite3* database, const char* sql);

  // Parameters count from 1 and columns from 0, as in SQLite. Bound bytes must
  // live until the query is reset.
  SqliteQuery& Bind(int parameter, std::int64_t value);
  SqliteQuery& Bind(int parameter, std::string_view bytes);
  bool Step();  // True: a row is available.
  void Run();   // Steps to the end and resets, also on an error.
  void Reset();

  std::int64_t Integer(int column) const;
  std::string Bytes(int column) const;

 private:
  void Check(int code) const;

  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

class SqliteDatabase {
 public:
  // Opens an existing file; also creates it if `create`.
  SqliteDatabase(const std::string& path, bool create);

  void Execute(const char* sql);
  SqliteQuery Prepare(const char* sql);
  std::int64_t changed_rows() const;  // By the most recent statement.
  bool in_transaction() const;

 private:
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_SQLITE_H_
