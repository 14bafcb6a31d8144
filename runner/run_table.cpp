#include <fmt/format.h>

#include <runner/run_table.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

std::string named_in(const fs::path& folder, const std::string& name) {
  return name.find_first_of("/.") != std::string::npos ? (folder / name).string() : name;
}

namespace {

// As many numbers as `form` says, "[k1, k2]".
std::vector<double> numbers(const TomlReader& reader, const toml::table& table,
                            std::string_view key, std::size_t count, std::string_view form) {
  std::vector<double> values;
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    return values;
  }
  if (const toml::array* array = node->as_array()) {
    for (const toml::node& entry : *array) {
      if (const auto value = entry.value<double>()) {
        values.push_back(*value);
      }
    }
  }
  if (values.size() != count) {
    reader.fail(*node, fmt::format("{} wants {}", key, form));
  }
  return values;
}

void read_cameras(const TomlReader& reader, const toml::table& table, const fs::path& folder,
                  RunRequest& request) {
  if (const std::string from = reader.string(table, "frames_from"); !from.empty()) {
    const std::size_t comma = from.find(',');
    request.frames_from = from == "moving" ? from
                          : comma == std::string::npos
                              ? (folder / from).string()
                              : fmt::format("{},{}", (folder / from.substr(0, comma)).string(),
                                            (folder / from.substr(comma + 1)).string());
  }
  if (const toml::node* node = table.get("camera_rate")) {
    const auto rate = node->value<double>();
    if (!rate || !(*rate > 0)) {
      reader.fail(*node, "camera_rate wants frames a second, a number above 0");
    }
    request.camera_rate = *rate;
  }
  request.distortion = numbers(reader, table, "distort", 2, "[k1, k2]");
  request.misalignment = numbers(reader, table, "misalign", 3, "[degrees, right, down]");
  if (const toml::node* node = table.get("drop_frame")) {
    request.dropped = reader.strings(*node, "drop_frame");
  }
  if (const toml::node* node = table.get("late_frame")) {
    request.late = reader.strings(*node, "late_frame");
  }
}

}  // namespace

RunRequest read_run_request(const TomlReader& reader, const toml::table& table) {
  reader.check_keys(table, "[run]",
                    {"firmware", "scene", "left", "right", "frames", "machine", "placement",
                     "power", "place", "set", "max_seconds", "flash", "frames_from", "camera_rate",
                     "distort", "misalign", "drop_frame", "late_frame"});
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
  read_cameras(reader, table, folder, request);
  if (const toml::node* node = table.get("flash")) {
    for (const std::string& file : reader.strings(*node, "flash")) {
      const std::size_t equals = file.find('=');
      const std::size_t begin = equals == std::string::npos ? 0 : equals + 1;
      request.flash.push_back(file.substr(0, begin) + (folder / file.substr(begin)).string());
    }
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
