#include <algorithm>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

#include <cli/output_folder.hpp>
#include <common/error.hpp>

namespace finback::cli {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& folder)
    : folder_(fs::absolute(folder)), hidden_(folder_ / fmt::format(".finback-{}", ::getpid())) {
  std::error_code error;
  const auto refuse = [&](const std::string& why) {
    clean_up();
    throw InputError(
        fmt::format("{}: cannot be written as output folder: {}", folder.string(), why));
  };
  if (fs::exists(folder_, error) && !fs::is_directory(folder_, error)) {
    refuse("it is a file");
  }
  std::vector<fs::path> wanted = {hidden_};
  for (fs::path path = folder_; !fs::exists(path, error) && path.has_relative_path();
       path = path.parent_path()) {
    wanted.push_back(path);
  }
  std::reverse(wanted.begin(), wanted.end());
  for (const fs::path& path : wanted) {
    // A path that ends in a slash names its folder twice; the second time it is there.
    if (!fs::create_directory(path, error)) {
      if (error) {
        refuse(error.message());
      }
      continue;
    }
    created_.push_back(path);
  }
}

OutputFolder::~OutputFolder() {
  if (!committed_) {
    clean_up();
  }
}

void OutputFolder::clean_up() {
  std::error_code ignored;
  fs::remove_all(hidden_, ignored);
  // Only folders that are empty again: others may have put files there meanwhile.
  for (auto path = created_.rbegin(); path != created_.rend(); ++path) {
    fs::remove(*path, ignored);
  }
}

void OutputFolder::commit() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(hidden_)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const fs::path place = folder_ / file.filename();
    std::error_code error;
    fs::rename(file, place, error);
    if (error) {
      throw InputError(fmt::format("{}: cannot be written: {}", place.string(), error.message()));
    }
  }
  committed_ = true;
  std::error_code ignored;
  fs::remove(hidden_, ignored);
}

}  // namespace finback::cli
