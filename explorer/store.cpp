#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <explorer/store.hpp>

namespace finback::explorer {

namespace fs = std::filesystem;

namespace {

constexpr int kApplicationId = 0x46424558;  // "FBEX"

// {}: "" for the file itself, "fresh." for the copy that finish() makes.
constexpr const char* kSchema =
    "CREATE TABLE {0}metrics (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, unit TEXT NOT "
    "NULL);"
    "CREATE TABLE {0}runs (id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, fault TEXT NOT NULL, "
    "tool_version TEXT NOT NULL, firmware TEXT NOT NULL, firmware_hash TEXT NOT NULL, image_hash "
    "TEXT NOT NULL, machine_hash TEXT NOT NULL, power_hash TEXT NOT NULL, scene TEXT NOT NULL, "
    "scene_hash TEXT NOT NULL, frames INTEGER NOT NULL, cycle_limit INTEGER NOT NULL);"
    "CREATE TABLE {0}results (run INTEGER NOT NULL, metric INTEGER NOT NULL, value REAL NOT NULL, "
    "PRIMARY KEY (run, metric)) WITHOUT ROWID;"
    "PRAGMA {0}application_id = {1};"
    "PRAGMA {0}user_version = {2};";

// Numbers rows by their names, so that the order in which they came is forgotten.
constexpr const char* kCopy =
    "INSERT INTO fresh.metrics SELECT row_number() OVER (ORDER BY name), name, unit FROM "
    "main.metrics ORDER BY name;"
    "INSERT INTO fresh.runs SELECT row_number() OVER (ORDER BY key), key, fault, tool_version, "
    "firmware, firmware_hash, image_hash, machine_hash, power_hash, scene, scene_hash, frames, "
    "cycle_limit FROM main.runs ORDER BY key;"
    "INSERT INTO fresh.results SELECT new_run.id, new_metric.id, results.value FROM main.results "
    "JOIN main.runs old_run ON old_run.id = results.run "
    "JOIN fresh.runs new_run ON new_run.key = old_run.key "
    "JOIN main.metrics old_metric ON old_metric.id = results.metric "
    "JOIN fresh.metrics new_metric ON new_metric.name = old_metric.name "
    "ORDER BY new_run.id, new_metric.id;";

std::string schema_of(const char* prefix) {
  return fmt::format(kSchema, prefix, kApplicationId, kStoreSchemaVersion);
}

// Whether a file is a store of this schema, whole in itself.
void check(const Database& database, const fs::path& path) {
  if (database.number("PRAGMA application_id") != kApplicationId) {
    throw InputError(fmt::format(
        "{}: is the database of another program, not of finback explore; give --db another file",
        path.string()));
  }
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version != kStoreSchemaVersion) {
    throw InputError(
        fmt::format("{}: has schema {}, written by another version of Finback; this "
                    "one knows schema {}: give --db another file",
                    path.string(), version, kStoreSchemaVersion));
  }
  Statement sound = database.prepare("PRAGMA quick_check(1)");
  if (!sound.step() || sound.text(0) != "ok") {
    throw InputError(
        fmt::format("{}: is a damaged database; give --db another file, or remove it to begin anew",
                    path.string()));
  }
}

std::set<std::string> keys_of(const Database& database) {
  std::set<std::string> keys;
  Statement statement = database.prepare("SELECT key FROM runs");
  while (statement.step()) {
    keys.insert(statement.text(0));
  }
  return keys;
}

}  // namespace

// Keeps other explorations from the file. SQLite's own locks would keep readers away, too.
class Store::Lock {
 public:
  explicit Lock(const fs::path& path)
      : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ < 0) {
      throw InputError(
          fmt::format("{}: cannot be written: {}; give --db a file where you may write",
                      path.string(), std::strerror(errno)));
    }
    struct stat mine = {};
    struct stat named = {};
    // When the other has finished meanwhile, the name stands for its new file.
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 || ::fstat(file_, &mine) != 0 ||
        ::stat(path.c_str(), &named) != 0 || mine.st_ino != named.st_ino) {
      ::close(file_);
      throw InputError(
          fmt::format("{}: another finback explore works on it; wait for its end, or give --db "
                      "another file",
                      path.string()));
    }
  }
  ~Lock() { ::close(file_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

Store::Store(const fs::path& path) : path_(path) {
  std::error_code error;
  if (path.has_parent_path()) {
    fs::create_directories(path.parent_path(), error);
  }
  if (error) {
    throw InputError(
        fmt::format("{}: the folder cannot be made: {}; give --db a file where you "
                    "may write",
                    path.string(), error.message()));
  }
  lock_ = std::make_unique<Lock>(path);
  database_ = std::make_unique<Database>(path);
  // Reading rolls back what a killed exploration had begun, even the making of the file.
  if (database_->number("PRAGMA page_count") == 0) {
    database_->run(("BEGIN IMMEDIATE;" + schema_of("") + "COMMIT").c_str());
  } else {
    check(*database_, path);
    database_->run("BEGIN IMMEDIATE; COMMIT");  // may it be written?
  }
}

Store::~Store() {
  database_.reset();
  lock_.reset();
}

std::set<std::string> Store::peek(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error) || (fs::is_regular_file(path, error) && fs::file_size(path) == 0)) {
    return {};
  }
  const Database database(path);
  check(database, path);
  return keys_of(database);
}

std::set<std::string> Store::keys() const { return keys_of(*database_); }

void Store::put(const Identity& identity, const Result& result) {
  database_->run("BEGIN IMMEDIATE");
  try {
    write(identity, result);
    database_->run("COMMIT");
  } catch (...) {
    try {
      database_->run("ROLLBACK");
    } catch (const InputError&) {
      // SQLite has rolled back by itself; the first error is the one to tell.
    }
    throw;
  }
}

void Store::write(const Identity& identity, const Result& result) {
  Statement run = database_->prepare(
      "INSERT INTO runs (key, fault, tool_version, firmware, firmware_hash, image_hash, "
      "machine_hash, power_hash, scene, scene_hash, frames, cycle_limit) VALUES (?1, ?2, ?3, ?4, "
      "?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12) RETURNING id");
  run.bind(1, identity.key).bind(2, result.fault).bind(3, identity.tool_version);
  run.bind(4, identity.firmware).bind(5, identity.firmware_hash).bind(6, identity.image_hash);
  run.bind(7, identity.machine_hash).bind(8, identity.power_hash).bind(9, identity.scene);
  run.bind(10, identity.scene_hash).bind(11, static_cast<std::int64_t>(identity.frames));
  run.bind(12, static_cast<std::int64_t>(identity.cycle_limit));
  run.step();
  const std::int64_t id = run.number(0);
  run.reset();
  Statement name = database_->prepare("INSERT OR IGNORE INTO metrics (name, unit) VALUES (?1, ?2)");
  Statement value = database_->prepare(
      "INSERT INTO results (run, metric, value) SELECT ?1, id, ?2 FROM metrics WHERE name = ?3");
  for (const auto& [metric, reading] : result.metrics) {
    name.bind(1, metric).bind(2, reading.unit).execute();
    value.bind(1, id).bind_real(2, reading.value).bind(3, metric).execute();
  }
}

Result Store::get(const std::string& key, const std::vector<std::string>& metrics) const {
  Result result;
  Statement run = database_->prepare("SELECT id, fault FROM runs WHERE key = ?1");
  if (!run.bind(1, key).step()) {
    throw std::logic_error("the store has no " + key);
  }
  const std::int64_t id = run.number(0);
  result.fault = run.text(1);
  Statement value = database_->prepare(
      "SELECT value, unit FROM results JOIN metrics ON metrics.id = metric WHERE run = ?1 AND name "
      "= ?2");
  for (const std::string& metric : metrics) {
    if (value.bind(1, id).bind(2, metric).step()) {
      result.metrics[metric] = {value.real(0), value.text(1)};
    }
    value.reset();
  }
  return result;
}

std::vector<std::string> Store::metric_names() const {
  std::vector<std::string> names;
  Statement statement = database_->prepare("SELECT name FROM metrics ORDER BY name");
  while (statement.step()) {
    names.push_back(statement.text(0));
  }
  return names;
}

void Store::finish() {
  write_file_whole(path_, [&](const fs::path& copy) {
    write_file_whole(copy, "");  // ATTACH wants a file that is there
    database_->prepare("ATTACH ?1 AS fresh").bind(1, copy.string()).execute();
    database_->run("PRAGMA fresh.journal_mode = OFF");  // a copy that fails is thrown away
    database_->run(("BEGIN;" + schema_of("fresh.") + kCopy + "COMMIT; DETACH fresh").c_str());
    database_.reset();
  });
  lock_.reset();
}

}  // namespace finback::explorer
