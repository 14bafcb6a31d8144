// A folder that gets all files of a run or none.
//
// Files are written into a hidden folder inside it and moved when the run is complete. A run that
// fails leaves neither files nor folders that were not there before.
#pragma once

#include <filesystem>
#include <vector>

namespace finback::cli {

class OutputFolder {
 public:
  // Creates `folder`, with those above it, and its hidden folder. Throws InputError naming the path
  // when that cannot be done: so a run learns it before it begins.
  explicit OutputFolder(const std::filesystem::path& folder);
  // Removes everything that was made, unless committed.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write a file that shall be called `name` in the folder.
  [[nodiscard]] std::filesystem::path staged(const std::string& name) const {
    return hidden_ / name;
  }
  // Moves all staged files to their place, over files of the same name. Throws InputError.
  void commit();

 private:
  void clean_up();

  std::filesystem::path folder_;
  std::filesystem::path hidden_;
  std::vector<std::filesystem::path> created_;  // folders that were not there, outermost first
  bool committed_ = false;
};

}  // namespace finback::cli
