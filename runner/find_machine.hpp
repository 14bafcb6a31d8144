// Machines by name: the files of share/finback/machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace finback::runner {

// Installed machines, in the order of their names.
[[nodiscard]] std::vector<std::string> machine_names();

// The file that `name` means: an installed machine's, or, for what has a point or a slash in it,
// the file of that name. Throws InputError for a machine that is not installed, listing those that
// are.
[[nodiscard]] std::filesystem::path find_machine(const std::string& name);

}  // namespace finback::runner
