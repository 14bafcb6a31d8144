// A copy of the shipped firmware that a test changes; gone with the object.
#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

#include <common/file.hpp>

namespace finback {

class FirmwareCopy {
 public:
  explicit FirmwareCopy(const std::string& what)
      : folder_(std::filesystem::temp_directory_path() /
                fmt::format("finback-{}-{}", what, ::getpid())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(share_folder() / "firmware" / "mesvs2", folder_);
  }
  ~FirmwareCopy() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  FirmwareCopy(const FirmwareCopy&) = delete;
  FirmwareCopy& operator=(const FirmwareCopy&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::string path() const { return folder_.string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace finback
