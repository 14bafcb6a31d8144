# Run by the build: writes HEADER, which names the state of the sources in LIST (a file with one path
# a line) by a hash, and only when it differs from what is there.
#   cmake -D LIST=... -D ROOT=... -D HEADER=... -P SourceHash.cmake
file(STRINGS ${LIST} sources)
set(all "")
foreach(source ${sources})
  file(SHA256 ${ROOT}/${source} hash)
  string(APPEND all "${source} ${hash}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 hash)
file(CONFIGURE OUTPUT ${HEADER} CONTENT [[// Made by the build (cmake/SourceHash.cmake).
#pragma once

#include <string_view>

namespace finback {

// Names the state of the sources that decide what a run finds out.
inline constexpr std::string_view kSourceHash = "@hash@";

}  // namespace finback
]] @ONLY)
