// A thin layer over SQLite: a connection and prepared statements that close themselves and throw.
//
// Knows nothing of what is stored. Results other than success are InputErrors that name the file
// and say what to do: a database is a file of the user's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace finback::explorer {

class Statement;

class Database {
 public:
  // Opens a file that exists, to read and, where that is allowed, to write. Throws InputError.
  explicit Database(const std::filesystem::path& path);

  // One or more statements without results. Throws InputError: locked, damaged, not SQLite, full.
  void run(const char* sql) const;
  [[nodiscard]] Statement prepare(std::string_view sql) const;
  [[nodiscard]] std::int64_t number(const char* pragma) const;
  [[noreturn]] void fail(int code) const;

 private:
  friend class Statement;
  struct Closer {
    void operator()(sqlite3* connection) const;
  };
  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Closer> connection_;
};

// Runs again after reset(). Parameters and columns count as in SQLite: from 1 and from 0.
class Statement {
 public:
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::int64_t number);
  Statement& bind_real(int parameter, double number);
  // True: there is a row. Throws as Database does.
  bool step();
  // For statements without rows: does them once and makes ready for the next time.
  void execute();
  void reset();
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::int64_t number(int column) const;
  [[nodiscard]] double real(int column) const;

 private:
  friend class Database;
  struct Finaliser {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(const Database& database, sqlite3_stmt* statement)
      : database_(&database), statement_(statement) {}
  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finaliser> statement_;
};

}  // namespace finback::explorer
