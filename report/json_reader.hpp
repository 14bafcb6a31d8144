// Reads a result.json back: the inverse of json_writer.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <report/run_result.hpp>

namespace finback::report {

// Throws InputError naming `file` for text that is no JSON, another schema version, and keys that
// are missing or of the wrong kind (naming them). Keys that are not known are passed over.
[[nodiscard]] RunResult parse_result(std::string_view text, const std::string& file);
[[nodiscard]] RunResult load_result(const std::filesystem::path& path);

}  // namespace finback::report
