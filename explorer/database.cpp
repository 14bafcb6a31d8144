#include <fmt/format.h>
#include <sqlite3.h>

#include <common/error.hpp>
#include <explorer/database.hpp>

namespace finback::explorer {

namespace {

// How long another program may hold the file, in milliseconds: to read it, or to write a row.
constexpr int kPatience = 2000;

}  // namespace

void Database::Closer::operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }

void Statement::Finaliser::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Database::Database(const std::filesystem::path& path) : path_(path) {
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &connection, SQLITE_OPEN_READWRITE, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) {
    fail(code);
  }
  sqlite3_busy_timeout(connection, kPatience);
}

void Database::fail(int code) const {
  std::string what;
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      what =
          "is locked by another program that writes to it; close that, or give --db another "
          "file, and run again: what is finished is kept";
      break;
    case SQLITE_NOTADB:
      what = "is no SQLite database; give --db another file";
      break;
    case SQLITE_CORRUPT:
      what = "is a damaged database; give --db another file, or remove it to begin anew";
      break;
    case SQLITE_FULL:
      what = "cannot grow: the disk is full; make room and run again: what is finished is kept";
      break;
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
    case SQLITE_IOERR:
      what = fmt::format("cannot be written ({}); give --db a file where you may write",
                         sqlite3_errstr(code));
      break;
    default:
      what = fmt::format("SQLite: {}", sqlite3_errmsg(connection_.get()));
  }
  throw InputError(fmt::format("{}: {}", path_.string(), what));
}

void Database::run(const char* sql) const {
  const int code = sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) {
    fail(code);
  }
}

Statement Database::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                                      &statement, nullptr);
  if (code != SQLITE_OK) {
    fail(code);
  }
  return {*this, statement};
}

std::int64_t Database::number(const char* pragma) const {
  Statement statement = prepare(pragma);
  return statement.step() ? statement.number(0) : 0;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text(statement_.get(), parameter, text.data(), static_cast<int>(text.size()),
                    SQLITE_TRANSIENT);
  return *this;
}

Statement& Statement::bind(int parameter, std::int64_t number) {
  sqlite3_bind_int64(statement_.get(), parameter, number);
  return *this;
}

Statement& Statement::bind_real(int parameter, double number) {
  sqlite3_bind_double(statement_.get(), parameter, number);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    sqlite3_reset(statement_.get());
    database_->fail(code);
  }
  return code == SQLITE_ROW;
}

void Statement::execute() {
  step();
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

}  // namespace finback::explorer
