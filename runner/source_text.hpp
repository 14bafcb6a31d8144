// The text of source files that a program was compiled from, found by the names that it uses.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace finback::runner {

class SourceText {
 public:
  // `folders`: where names are looked up, in this order.
  explicit SourceText(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  // Line `number` (from 1) of `file`; nothing when the file is not found or shorter.
  [[nodiscard]] std::optional<std::string> line(const std::string& file, int number);
  [[nodiscard]] bool found(const std::string& file) { return !lines_of(file).empty(); }

 private:
  const std::vector<std::string>& lines_of(const std::string& file);

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, std::vector<std::string>> files_;  // empty: not found
};

// Where the sources of a firmware lie by themselves: in its folder (that of its manifest or BIR
// file), in the two above, which may hold what firmwares share, in the current folder, and among
// the installed sources of runtime, drivers and firmwares.
[[nodiscard]] std::vector<std::filesystem::path> source_folders(const std::string& firmware_path);

}  // namespace finback::runner
