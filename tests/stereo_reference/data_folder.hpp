// Where the real data sets are: $FINBACK_SHARED_DATA, or ../shared/data beside the project.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace finback::stereo_reference {

inline std::filesystem::path data_folder() {
  const char* chosen = std::getenv("FINBACK_SHARED_DATA");
  return chosen != nullptr ? std::filesystem::path(chosen)
                           : std::filesystem::path(FINBACK_DEFAULT_DATA);
}

}  // namespace finback::stereo_reference

// Ends a test that needs this folder of the data sets where it is not there.
#define FINBACK_NEEDS_DATA(folder)                                                         \
  if (!std::filesystem::exists(folder)) {                                                  \
    GTEST_SKIP() << (folder) << " is not there; set FINBACK_SHARED_DATA to a data folder"; \
  }                                                                                        \
  static_assert(true)
