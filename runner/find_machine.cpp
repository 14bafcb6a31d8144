#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

#include <common/error.hpp>
#include <common/file.hpp>
#include <common/parameter.hpp>
#include <runner/find_machine.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

std::vector<std::string> machine_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(share_folder() / "machines", error)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

fs::path find_machine(const std::string& name) {
  if (name.find_first_of("./") != std::string::npos) {
    return name;
  }
  const std::vector<std::string> known = machine_names();
  if (std::ranges::find(known, name) == known.end()) {
    const std::string near = nearest_name(name, known);
    throw InputError(fmt::format(
        "machine '{}' is not installed{}; known: {}; or give the path of a machine file, NAME.toml",
        name, near.empty() ? "" : fmt::format(", did you mean '{}'", near),
        fmt::join(known, ", ")));
  }
  return share_folder() / "machines" / (name + ".toml");
}

}  // namespace finback::runner
