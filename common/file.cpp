#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unistd.h>

#include <common/error.hpp>
#include <common/file.hpp>

namespace finback {

namespace fs = std::filesystem;

std::string read_text_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder, a file is wanted", path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_file_whole(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  fs::path temporary = path;
  temporary.replace_filename(
      fmt::format(".{}.{}{}", path.stem().string(), ::getpid(), path.extension().string()));
  std::error_code error;
  try {
    write(temporary);
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw InputError(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
  }
}

void write_file_whole(const fs::path& path, std::string_view content) {
  write_file_whole(path, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
      throw InputError(
          fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
    }
  });
}

fs::path share_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  for (const fs::path& candidate : {program.parent_path().parent_path() / "share" / "finback",
                                    program.parent_path() / "share" / "finback"}) {
    if (fs::is_directory(candidate)) {
      return candidate;
    }
  }
  throw InputError(fmt::format("{}: no share/finback folder beside it; install Finback again",
                               program.string()));
}

fs::path library_folder() { return share_folder().parent_path().parent_path() / "lib" / "finback"; }

}  // namespace finback
