// Files written whole or not at all, and the folder of what Finback installs beside its programs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace finback {

// The whole file as text. Throws InputError "PATH: ..." when it is missing, a folder or unreadable.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

// Writes to a temporary name in the same folder and renames, so that a reader sees the old file or
// the new one. Throws InputError naming the path when that cannot be done; the temporary file is
// then gone.
void write_file_whole(const std::filesystem::path& path, std::string_view content);

// The same for writers that want a file name: `write` gets the temporary path, whose extension is
// that of `path` (image encoders choose the format by it), and reports failure by throwing.
void write_file_whole(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

// share/finback beside this program's bin folder (machines, firmware, scenes), in the build tree as
// in an installed one.
[[nodiscard]] std::filesystem::path share_folder();

// lib/finback beside share (modules loaded on demand); it need not be there.
[[nodiscard]] std::filesystem::path library_folder();

}  // namespace finback
