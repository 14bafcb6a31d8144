#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include <common/error.hpp>
#include <common/file.hpp>
#include <report/json_reader.hpp>
#include <report/json_writer.hpp>

namespace finback::report {

namespace {

using Json = nlohmann::ordered_json;

// A value with its path in the document, for messages.
class Value {
 public:
  Value(const Json& json, std::string path, const std::string& file)
      : json_(json), path_(std::move(path)), file_(file) {}

  [[nodiscard]] Value operator[](const std::string& key) const {
    want(json_.is_object(), "an object");
    const auto found = json_.find(key);
    if (found == json_.end()) {
      throw InputError(
          fmt::format("{}: {} is missing: this is no result of finback run, or one of "
                      "an older version",
                      file_, inner(key)));
    }
    return {*found, inner(key), file_};
  }
  [[nodiscard]] bool has(const std::string& key) const {
    return json_.is_object() && json_.contains(key);
  }
  [[nodiscard]] bool is_null() const { return json_.is_null(); }
  [[nodiscard]] std::string text() const {
    want(json_.is_string(), "a text");
    return json_.get<std::string>();
  }
  [[nodiscard]] double number() const {
    want(json_.is_number(), "a number");
    return json_.get<double>();
  }
  [[nodiscard]] std::uint64_t count() const {
    want(json_.is_number_unsigned(), "a whole number, not below 0");
    return json_.get<std::uint64_t>();
  }
  [[nodiscard]] int small_count() const {
    const std::uint64_t value = count();
    want(value <= static_cast<std::uint64_t>(std::numeric_limits<int>::max()), "a smaller number");
    return static_cast<int>(value);
  }
  [[noreturn]] void refuse(std::string_view wanted) const {
    throw InputError(fmt::format("{}: {} wants {}", file_, path_, wanted));
  }
  [[nodiscard]] bool flag() const {
    want(json_.is_boolean(), "true or false");
    return json_.get<bool>();
  }
  // body(Value) for each element of a list.
  template <class Body>
  void each(const Body& body) const {
    want(json_.is_array(), "a list");
    for (std::size_t i = 0; i < json_.size(); ++i) {
      body(Value(json_[i], fmt::format("{}[{}]", path_, i), file_));
    }
  }
  // body(key, Value) for each member of an object, in the order of the text.
  template <class Body>
  void each_member(const Body& body) const {
    want(json_.is_object(), "an object");
    for (const auto& [key, value] : json_.items()) {
      body(key, Value(value, inner(key), file_));
    }
  }

 private:
  [[nodiscard]] std::string inner(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }
  void want(bool right, std::string_view what) const {
    if (!right) {
      throw InputError(
          fmt::format("{}: {} wants {}", file_, path_.empty() ? "the document" : path_, what));
    }
  }

  const Json& json_;
  std::string path_;
  const std::string& file_;
};

Ingredient read_ingredient(const Value& value) {
  return {value["name"].text(), value["hash"].text()};
}

Provenance read_provenance(const Value& value) {
  return {value["tool_version"].text(),        read_ingredient(value["firmware"]),
          read_ingredient(value["placement"]), read_ingredient(value["machine"]),
          read_ingredient(value["power"]),     read_ingredient(value["scene"])};
}

std::vector<std::pair<std::string, std::uint64_t>> read_counts(const Value& value) {
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  value.each_member([&](const std::string& name, const Value& count) {
    counts.emplace_back(name, count.count());
  });
  return counts;
}

CyclesByCause read_causes(const Value& owner) {
  CyclesByCause causes = {{"issue", owner["issue_cycles"].count()}};
  owner["stall_cycles"].each_member([&](const std::string& cause, const Value& cycles) {
    causes.emplace_back(cause, cycles.count());
  });
  return causes;
}

void read_cores(const Value& value, RunResult& result) {
  value.each_member([&](const std::string& name, const Value& row) {
    Core core;
    core.name = name;
    core.started = row["started"].flag();
    core.cycles = row["cycles"].count();
    core.instructions = row["instructions"].count();
    core.packets = row["packets"].count();
    core.causes = read_causes(row);
    core.operations = read_counts(row["operations"]);
    core.code_bytes = row["code_bytes"].count();
    core.stack_bytes = row["stack_bytes"].count();
    core.stack_used_bytes = row["stack_used_bytes"].count();
    result.cores.push_back(std::move(core));
  });
}

void read_program(const Value& root, RunResult& result) {
  root["stages"].each([&](const Value& row) {
    result.stages.push_back({row["name"].text(), row["core"].text(), row["function"].text(),
                             row["cycles"].count(), row["cycles_per_frame"].number()});
  });
  root["functions"].each([&](const Value& row) {
    result.functions.push_back({row["core"].text(), row["name"].text(), row["calls"].count(),
                                row["instructions"].count(), row["inclusive_cycles"].count(),
                                row["exclusive_cycles"].count(), read_causes(row),
                                row["code_bytes"].count(), read_counts(row["bytes"])});
  });
  root["lines"].each([&](const Value& row) {
    Line line{row["core"].text(),        row["function"].text(),     row["file"].text(),
              row["line"].small_count(), row["executions"].count(),  row["packets"].count(),
              row["cycles"].count(),     read_counts(row["causes"]), read_counts(row["bytes"])};
    result.lines.push_back(std::move(line));
  });
}

void read_memory(const Value& root, RunResult& result) {
  root["traffic"].each_member([&](const std::string& level, const Value& initiators) {
    initiators.each_member([&](const std::string& initiator, const Value& bytes) {
      result.traffic.push_back(
          {level, initiator, bytes["read_bytes"].count(), bytes["write_bytes"].count()});
    });
  });
  root["memory"].each([&](const Value& row) {
    result.regions.push_back({row["core"].is_null() ? "" : row["core"].text(), row["name"].text(),
                              row["level"].text(), row["used_bytes"].count(),
                              row["size_bytes"].count()});
  });
  root["objects"].each([&](const Value& row) {
    Object object{row["name"].text(),  row["owner"].text(), row["region"].text(),
                  row["level"].text(), row["size"].count(), {}};
    row["accesses"].each_member([&](const std::string& initiator, const Value& access) {
      object.accesses.push_back({initiator, access["reads"].count(), access["writes"].count(),
                                 access["read_bytes"].count(), access["write_bytes"].count(),
                                 access["stall_cycles"].count()});
    });
    result.objects.push_back(std::move(object));
  });
}

power::PowerEstimate read_power(const Value& value) {
  power::PowerEstimate power;
  power.watts = value["watts"].number();
  power.amperes = value["amperes"].number();
  power.core_volts = value["core_volts"].number();
  power.bus_utilisation = value["bus_utilisation"].number();
  for (std::size_t core = 0; core < power.activity.size(); ++core) {
    power.activity[core] = value["activity_factor"][name_of(static_cast<CoreId>(core))].number();
  }
  value["components"].each([&](const Value& row) {
    const std::string certainty = row["certainty"].text();
    power.components.push_back({row["name"].text(), row["volts"].number(), row["amperes"].number(),
                                row["watts"].number(), certainty.empty() ? 'E' : certainty[0],
                                row["source"].text()});
  });
  return power;
}

std::optional<Accuracy> read_accuracy(const Value& value) {
  if (value.is_null()) {
    return std::nullopt;
  }
  Accuracy accuracy;
  accuracy.frame = static_cast<std::uint32_t>(value["frame"].small_count());
  accuracy.delta = value["delta_pixels"].number();
  accuracy.border = value["border_pixels"].small_count();
  accuracy.compared = value["compared_pixels"].small_count();
  accuracy.density = value["density_percent"].number();
  accuracy.bad = value["bad_percent"].number();
  accuracy.wrong = value["wrong_percent"].number();
  return accuracy;
}

clock::OperatingPoint read_point(const Value& row) {
  const std::string name = row["mode"].text();
  const auto known = std::ranges::find(clock::kModeNames, name);
  if (known == clock::kModeNames.end()) {
    row["mode"].refuse("a mode such as full_on or sleep");
  }
  return {static_cast<clock::Mode>(known - clock::kModeNames.begin()), row["core_hertz"].number(),
          row["system_hertz"].number(), row["core_volts"].number()};
}

void read_clocks(const Value& value, RunResult& result) {
  value["segments"].each(
      [&](const Value& row) { result.clocks.change(row["from_cycle"].count(), read_point(row)); });
  value["points"].each([&](const Value& row) {
    result.points.push_back(
        {read_point(row), row["cycles"].count(), row["seconds"].number(), row["watts"].number()});
  });
}

std::string unit_of_target(const std::string& name) {
  return name == "power_watts" ? "W" : name == "frames_per_second" ? "fps" : "";
}

RunResult read_result(const Value& root) {
  RunResult result;
  result.provenance = read_provenance(root["provenance"]);
  result.stopped = root["stopped"].text();
  root["targets"].each_member([&](const std::string& name, const Value& row) {
    result.targets.push_back({name, row["comparison"].text(), row["limit"].number(),
                              row["value"].number(), unit_of_target(name)});
  });
  result.accuracy = read_accuracy(root["accuracy"]);
  result.core_hertz = root["core_hertz"].number();
  result.system_hertz = root["system_hertz"].number();
  result.cycles = root["cycles"].count();
  if (root.has("clocks")) {  // not in results of older versions, whose clocks did not change
    read_clocks(root["clocks"], result);
  }
  root["frames"].each([&](const Value& row) {
    result.frames.push_back({static_cast<std::uint32_t>(row["number"].small_count()),
                             row["grabbed_cycle"].count(), row["published_cycle"].count()});
  });
  read_cores(root["cores"], result);
  read_program(root, result);
  read_memory(root, result);
  result.power = read_power(root["power"]);
  root["counters"].each_member(
      [&](const std::string& name, const Value& value) { result.counters[name] = value.count(); });
  return result;
}

}  // namespace

RunResult parse_result(std::string_view text, const std::string& file) {
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format(
        "{}: no JSON (at byte {}): give a result.json that finback run wrote", file, error.byte));
  }
  const Value root(document, "", file);
  const int version = root["schema_version"].small_count();
  if (version != kResultSchemaVersion) {
    throw InputError(
        fmt::format("{}: schema_version is {}, this program reads {}; run again to get "
                    "a new result",
                    file, version, kResultSchemaVersion));
  }
  return read_result(root);
}

RunResult load_result(const std::filesystem::path& path) {
  return parse_result(read_text_file(path), path.string());
}

}  // namespace finback::report
