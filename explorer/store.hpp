// The finished simulations of one or many spaces, in an SQLite file that survives everything.
//
// Each result is committed as a whole before put() returns; a process that is killed loses at most
// what it was simulating. All metrics of a result are kept, so that any of them can be asked for
// later. finish() rewrites the file in one order: its bytes then say what is in it, not how it came
// there. One process at a time writes to a file; readers may look on (docs/finback-explore.md has
// the tables). Not for use by several threads at once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <explorer/candidate.hpp>
#include <explorer/database.hpp>
#include <report/metrics.hpp>

namespace finback::explorer {

// Raised when a table changes its meaning.
inline constexpr int kStoreSchemaVersion = 1;

struct Result {
  std::string fault;  // what the program did that the machine cannot; "": it ended well
  std::map<std::string, report::Metric> metrics;
};

class Store {
 public:
  // Opens or makes `path` (and the folders above it) and keeps other processes from writing to it.
  // Throws InputError: in use by another exploration, no SQLite database, a database of another
  // program, damaged, of another schema, not writable. Such a file is left as it is.
  explicit Store(const std::filesystem::path& path);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // The keys of what a file holds, without making or changing it; none when it is not there.
  [[nodiscard]] static std::set<std::string> peek(const std::filesystem::path& path);

  [[nodiscard]] std::set<std::string> keys() const;
  // Throws InputError as the constructor does; the store is then as before.
  void put(const Identity& identity, const Result& result);
  // The result of `key`, which must be there, with those of `metrics` that it has.
  [[nodiscard]] Result get(const std::string& key, const std::vector<std::string>& metrics) const;
  [[nodiscard]] std::vector<std::string> metric_names() const;

  // Rewrites the file in its final order and closes it. Throws InputError; the file then holds
  // what it held.
  void finish();

 private:
  class Lock;
  void write(const Identity& identity, const Result& result);

  std::filesystem::path path_;
  std::unique_ptr<Lock> lock_;  // outlives the connection
  std::unique_ptr<Database> database_;
};

}  // namespace finback::explorer
