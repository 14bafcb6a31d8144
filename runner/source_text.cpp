#include <fstream>
#include <system_error>

#include <common/file.hpp>
#include <runner/source_text.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

const std::vector<std::string>& SourceText::lines_of(const std::string& file) {
  const auto known = files_.find(file);
  if (known != files_.end()) {
    return known->second;
  }
  std::vector<std::string>& lines = files_[file];
  for (const fs::path& folder : folders_) {
    std::error_code error;
    const fs::path path = folder / file;
    if (!fs::is_regular_file(path, error)) {
      continue;
    }
    std::ifstream stream(path);
    for (std::string text; std::getline(stream, text);) {
      if (text.ends_with('\r')) {
        text.pop_back();
      }
      lines.push_back(std::move(text));
    }
    break;
  }
  return lines;
}

std::optional<std::string> SourceText::line(const std::string& file, int number) {
  const std::vector<std::string>& lines = lines_of(file);
  if (number < 1 || static_cast<std::size_t>(number) > lines.size()) {
    return std::nullopt;
  }
  return lines[static_cast<std::size_t>(number) - 1];
}

std::vector<fs::path> source_folders(const std::string& firmware_path) {
  const fs::path folder = fs::absolute(firmware_path).parent_path();
  return {folder, folder.parent_path(), folder.parent_path().parent_path(), fs::current_path(),
          share_folder() / "firmware"};
}

}  // namespace finback::runner
