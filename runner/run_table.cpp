#include <fmt/format.h>

#include <runner/run_table.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

std::string named_in(const fs::path& folder, const std::string& name) {
  return name.find_first_of("/.") != std::string::npos ? (folder / name).string() : name;
}

RunRequest read_run_request(const TomlReader& reader, const toml::table& table) {
  reader.check_keys(table, "[run]",
                    {"firmware", "scene", "left", "right", "frames", "machine", "placement",
                     "power", "place", "set", "max_seconds"});
  const fs::path folder = fs::path(reader.file()).parent_path();
  const auto path = [&](std::string_view key) {
    const std::string text = reader.string(table, key);
    return text.empty() ? text : (folder / text).string();
  };
  RunRequest request;
  if (const std::string name = reader.string(table, "firmware"); !name.empty()) {
    request.firmware = named_in(folder, name);
  }
  if (const std::string name = reader.string(table, "scene"); !name.empty()) {
    request.scene = name;
  }
  request.left = path("left");
  request.right = path("right");
  if (request.left.empty() != request.right.empty()) {
    reader.fail(table, "[run] has one of left and right: a pair needs both");
  }
  request.machine = named_in(folder, reader.string(table, "machine"));
  request.placement = path("placement");
  request.power = path("power");
  if (const toml::node* node = table.get("place")) {
    request.moves = reader.strings(*node, "place");
  }
  if (const toml::node* node = table.get("set")) {
    request.settings = reader.strings(*node, "set");
  }
  if (const toml::node* node = table.get("frames")) {
    const auto frames = node->value_exact<std::int64_t>();
    if (!frames || *frames < 1 || *frames > kMostFrames) {
      reader.fail(*node, fmt::format("frames wants a whole number from 1 to {}", kMostFrames));
    }
    request.frames = static_cast<std::uint32_t>(*frames);
  }
  if (const toml::node* node = table.get("max_seconds")) {
    const auto seconds = node->value<double>();
    if (!seconds || !(*seconds > 0)) {
      reader.fail(*node, "max_seconds wants a number above 0");
    }
    request.max_seconds = *seconds;
  }
  return request;
}

}  // namespace finback::runner
