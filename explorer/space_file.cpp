// Reading a space (TOML): every axis is checked against the firmware and the machine that it names.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include <common/file.hpp>
#include <common/parameter.hpp>
#include <explorer/points.hpp>
#include <explorer/space.hpp>
#include <memory_model/memory_system.hpp>
#include <power_model/power_model.hpp>
#include <runner/run_table.hpp>

namespace finback::explorer {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCoreClock = "clock.cclk_mhz";
constexpr const char* kSystemClock = "clock.sclk_mhz";
constexpr const char* kPairs = "a list of pairs [CCLK, SCLK], e.g. [[600, 120], [300, 100]]";
constexpr std::int64_t kLongestRange = 10'000;

using Entry = std::pair<std::string, const toml::node*>;

Axis new_axis(AxisKind kind, const std::string& name) {
  Axis axis;
  axis.kind = kind;
  axis.name = name;
  return axis;
}

Choice new_choice(const std::string& text, const SourcePlace& written) {
  Choice choice;
  choice.text = text;
  choice.written = written;
  return choice;
}

class SpaceReader {
 public:
  SpaceReader(std::string_view text, const std::string& file) : reader_(text, file) {
    space_.file = file;
  }

  Space read() {
    const toml::table& root = reader_.root();
    reader_.check_keys(
        root, "a space",
        {"run", "firmware", "placement", "machine", "clock", "sample", "goal", "table"});
    read_run();
    read_placements();
    read_machine();
    read_clock();
    check_axes();
    read_sample();
    read_goal();
    read_columns();
    return std::move(space_);
  }

 private:
  // --- what is common ---

  // Does `work`; what goes wrong is told as of `node`.
  template <class Work>
  auto at(const toml::node& node, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      reader_.fail(node, error.what());
    }
  }

  // The values under `table` by their dotted names, in the order of the text: "a.b" = 1, a.b = 1
  // and [a] b = 1 are the same.
  static void collect(const toml::table& table, const std::string& prefix,
                      std::vector<Entry>& entries) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      const toml::table* inner = node.as_table();
      const bool range = inner != nullptr && (inner->contains("from") || inner->contains("to") ||
                                              inner->contains("step"));
      if (inner != nullptr && !range) {
        collect(*inner, name + ".", entries);
      } else {
        entries.emplace_back(name, &node);
      }
    }
  }

  [[nodiscard]] std::vector<Entry> entries_of(std::string_view key) const {
    std::vector<Entry> entries;
    if (const toml::table* table = reader_.table(reader_.root(), key)) {
      collect(*table, "", entries);
    }
    std::ranges::sort(entries, {}, [](const Entry& entry) {
      const toml::source_position begin = entry.second->source().begin;
      return std::pair(begin.line, begin.column);
    });
    for (std::size_t i = 0; i < entries.size(); ++i) {
      for (std::size_t earlier = 0; earlier < i; ++earlier) {
        if (entries[i].first == entries[earlier].first) {
          reader_.fail(*entries[i].second,
                       fmt::format("{} stands in [{}] twice", entries[i].first, key));
        }
      }
    }
    return entries;
  }

  // Adds an axis unless something is wrong with its choices as such.
  void add(Axis axis, const toml::node& node) {
    axis.written = reader_.place(node);
    if (axis.choices.empty()) {
      reader_.fail(node,
                   fmt::format("{} has no value: write at least one between [ and ]", axis.name));
    }
    std::set<std::string> seen;
    for (const Choice& choice : axis.choices) {
      if (!seen.insert(choice.text).second) {
        throw InputError(choice.written,
                         fmt::format("{} has the value {} twice", axis.name, choice.text));
      }
    }
    space_.axes.push_back(std::move(axis));
  }

  // A list of strings, or one; an empty list is left to add().
  [[nodiscard]] std::vector<Choice> text_choices(const toml::node& node,
                                                 const std::string& name) const {
    std::vector<Choice> choices;
    const toml::array* array = node.as_array();
    if (array != nullptr && array->empty()) {
      return choices;
    }
    const std::vector<std::string> texts = reader_.strings(node, name);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      choices.push_back(
          new_choice(texts[i], reader_.place(array == nullptr ? node : *array->get(i))));
    }
    return choices;
  }

  // --- [run] and [firmware] ---

  void read_run() {
    const toml::table empty;
    const toml::table* run = reader_.table(reader_.root(), "run");
    space_.request = runner::read_run_request(reader_, run == nullptr ? empty : *run);
    const toml::table* firmware = reader_.table(reader_.root(), "firmware");
    if (firmware != nullptr) {
      read_variants(*firmware, run != nullptr && run->contains("firmware"));
    } else {
      space_.firmware_names = {space_.request.firmware};
    }
    for (const std::string& name : space_.firmware_names) {
      runner::RunRequest request = space_.request;
      request.firmware = name;
      runner::RunInputs inputs =
          at(run == nullptr ? reader_.root() : *run, [&] { return runner::load_inputs(request); });
      space_.firmwares.push_back(inputs.firmware);
      if (space_.firmwares.size() == 1) {
        space_.base = std::move(inputs);
        space_.request.firmware = name;
      }
    }
  }

  void read_variants(const toml::table& table, bool also_in_run) {
    reader_.check_keys(table, "[firmware]", {"variants"});
    const toml::node* node = table.get("variants");
    if (node == nullptr) {
      reader_.fail(table, "[firmware] wants variants = [...], a list of firmwares");
    }
    if (also_in_run) {
      reader_.fail(*node, "the firmware is given in [run] and in [firmware]: keep one of them");
    }
    Axis axis = new_axis(AxisKind::firmware, "firmware");
    axis.choices = text_choices(*node, "variants");
    for (Choice& choice : axis.choices) {
      const std::string name =
          runner::named_in(fs::path(reader_.file()).parent_path(), choice.text);
      try {
        static_cast<void>(runner::find_firmware(name, std::nullopt));
      } catch (const InputError& error) {
        throw InputError(choice.written, error.what());
      }
      choice.firmware = space_.firmware_names.size();
      space_.firmware_names.push_back(name);
    }
    add(std::move(axis), *node);
  }

  // --- [placement] ---

  void read_placements() {
    for (const auto& [name, node] : entries_of("placement")) {
      Axis axis = new_axis(AxisKind::placement, name);
      const runner::Move named = runner::parse_movable(name, reader_.place(*node));
      bool functions = false;
      for (const runner::LoadedFirmware& loaded : space_.firmwares) {
        runner::Movables movables = runner::find_movables(loaded.firmware.units, named);
        functions = movables.functions;
        axis.things.push_back(std::move(movables.things));
      }
      axis.choices = text_choices(*node, name);
      for (Choice& choice : axis.choices) {
        choice.region = choice.text;
        runner::check_region(space_.base.machine->map, named.owner, choice.region, functions,
                             choice.written);
      }
      check_things(axis, *node);
      add(std::move(axis), *node);
    }
  }

  static std::string name_of(const runner::Move& thing) {
    return fmt::format("{}.{}", ir::owner_name(thing.owner), thing.name);
  }

  // Nothing may be placed by two axes, or by one and by [run].
  void check_things(const Axis& axis, const toml::node& node) const {
    for (std::size_t firmware = 0; firmware < axis.things.size(); ++firmware) {
      for (const runner::Move& thing : axis.things[firmware]) {
        for (const std::string& move : space_.request.moves) {
          if (move.starts_with(name_of(thing) + "=")) {
            reader_.fail(node, fmt::format("{} is placed here and by place in [run]: keep one",
                                           name_of(thing)));
          }
        }
        for (const Axis& other : space_.axes) {
          if (other.kind == AxisKind::placement &&
              std::ranges::any_of(other.things[firmware], [&](const runner::Move& its) {
                return name_of(its) == name_of(thing);
              })) {
            reader_.fail(node, fmt::format("{} is placed by {} and by {}: keep one", name_of(thing),
                                           other.name, axis.name));
          }
        }
      }
    }
  }

  // --- [machine] and [clock] ---

  void read_machine() {
    for (const auto& [name, node] : entries_of("machine")) {
      Axis axis = new_axis(AxisKind::machine, name);
      at(*node, [this, &axis] { return space_.base.machine->get(axis.name); });  // is it known?
      const toml::table* range = node->as_table();
      if (range != nullptr) {
        add_range(name, *range, axis);
      } else {
        add_values(name, *node, axis);
      }
      check_settings(name, *node);
      for (const Choice& choice : axis.choices) {
        check_machine(choice);
      }
      add(std::move(axis), *node);
    }
    check_clock_parameters();
  }

  static Choice value_choice(const std::string& name, double value, const SourcePlace& written) {
    Choice choice = new_choice(number_text(value), written);
    choice.settings = {{name, value}};
    return choice;
  }

  void add_values(const std::string& name, const toml::node& node, Axis& axis) const {
    const toml::array* array = node.as_array();
    const auto add_value = [&](const toml::node& value) {
      if (!value.is_number()) {
        reader_.fail(value, fmt::format("{} wants numbers: [7, 9], or a range {{ from = 7, to = "
                                        "9, step = 1 }}",
                                        name));
      }
      axis.choices.push_back(value_choice(name, *value.value<double>(), reader_.place(value)));
    };
    if (array == nullptr) {
      add_value(node);
      return;
    }
    for (const toml::node& value : *array) {
      add_value(value);
    }
  }

  // from, from + step, ... up to `to`.
  void add_range(const std::string& name, const toml::table& range, Axis& axis) const {
    reader_.check_keys(range, "a range", {"from", "to", "step"});
    const auto number = [&](std::string_view key) {
      const toml::node* node = range.get(key);
      if (node == nullptr || !node->is_number()) {
        reader_.fail(node == nullptr ? range : *node,
                     fmt::format("the range of {} wants a number {}: {{ from = 7, to = 9, step = 1 "
                                 "}}",
                                 name, key));
      }
      return *node->value<double>();
    };
    const double from = number("from");
    const double to = number("to");
    const double step = range.contains("step") ? number("step") : 1;
    const double steps = std::floor((to - from) / step + 1e-9);
    if (!(step > 0) || !(to >= from) || !(steps < kLongestRange)) {
      reader_.fail(range, fmt::format("the range of {} from {} to {} by {} is {}", name,
                                      number_text(from), number_text(to), number_text(step),
                                      !(step > 0)     ? "endless: step is above 0"
                                      : !(to >= from) ? "empty: from is the smaller one"
                                                      : "longer than 10000 values"));
    }
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
      // 0.1 + 2 x 0.1 is 0.3 to everybody who writes such a range.
      const double value = std::stod(fmt::format("{:.12g}", from + i * step));
      axis.choices.push_back(value_choice(name, value, reader_.place(range)));
    }
  }

  void check_settings(const std::string& parameter, const toml::node& node) const {
    for (const std::string& setting : space_.request.settings) {
      if (setting.starts_with(parameter + "=")) {
        reader_.fail(node, fmt::format("{} is set here and by set in [run]: keep one", parameter));
      }
    }
  }

  // Whether a machine can be built with this choice. A single clock waits for its companion.
  void check_machine(const Choice& choice) const {
    try {
      const auto machine = space_.base.machine->clone();
      bool clock = false;
      for (const Setting& setting : choice.settings) {
        machine->set(setting.parameter, setting.value);
        clock = clock || setting.parameter.starts_with("clock.");
      }
      if (!clock || choice.settings.size() > 1) {
        static_cast<void>(machine->clock.ratio());
        check_supply(*machine);
        const memory::MemorySystem probe(machine->map, machine->memory, machine->clock, {});
      }
    } catch (const InputError& error) {
      throw InputError(choice.written, error.what());
    }
  }

  // Whether the power model knows a supply for this clock: found out before the simulation.
  void check_supply(const machine::MachineDescription& machine) const {
    if (!(space_.base.power->core_volts > 0)) {
      static_cast<void>(power::lowest_core_volts(machine.clock.cclk_mhz * 1e6));
    }
  }

  // Clocks that are axes of their own: every pair that can meet.
  void check_clock_parameters() const {
    const auto choices_of = [&](const char* parameter) {
      const auto axis = std::ranges::find(space_.axes, parameter, &Axis::name);
      return axis != space_.axes.end() ? axis->choices
                                       : std::vector<Choice>{value_choice(
                                             parameter, space_.base.machine->get(parameter), {})};
    };
    for (const Choice& core : choices_of(kCoreClock)) {
      for (const Choice& system : choices_of(kSystemClock)) {
        Choice pair = core.written.file.empty() ? system : core;
        if (!pair.written.file.empty()) {
          pair.settings = {core.settings[0], system.settings[0]};
          check_machine(pair);
        }
      }
    }
  }

  void read_clock() {
    const toml::table* table = reader_.table(reader_.root(), "clock");
    if (table == nullptr) {
      return;
    }
    reader_.check_keys(*table, "[clock]", {"mhz"});
    const toml::node* node = table->get("mhz");
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr) {
      reader_.fail(node == nullptr ? *table : *node, fmt::format("[clock] wants mhz, {}", kPairs));
    }
    for (const char* parameter : {kCoreClock, kSystemClock}) {
      check_settings(parameter, *node);
      if (std::ranges::find(space_.axes, parameter, &Axis::name) != space_.axes.end()) {
        reader_.fail(*node, fmt::format("{} is set in [machine] and by [clock]: keep one of them",
                                        parameter));
      }
    }
    Axis axis = new_axis(AxisKind::clock, "clock");
    for (const toml::node& element : *list) {
      const toml::array* pair = element.as_array();
      if (pair == nullptr || pair->size() != 2 || !pair->get(0)->is_number() ||
          !pair->get(1)->is_number()) {
        reader_.fail(element, fmt::format("mhz is {}", kPairs));
      }
      const double core = *pair->get(0)->value<double>();
      const double system = *pair->get(1)->value<double>();
      Choice choice =
          new_choice(number_text(core) + "/" + number_text(system), reader_.place(element));
      choice.settings = {{kCoreClock, core}, {kSystemClock, system}};
      check_machine(choice);
      axis.choices.push_back(std::move(choice));
    }
    add(std::move(axis), *node);
  }

  // --- the rest ---

  void check_axes() const {
    if (space_.axes.empty()) {
      throw InputError(SourcePlace{space_.file},
                       "there is nothing to choose from: it wants at least one of [placement], "
                       "[machine], [clock] and [firmware]");
    }
  }

  void read_sample() {
    const toml::table* table = reader_.table(reader_.root(), "sample");
    if (table == nullptr) {
      return;
    }
    reader_.check_keys(*table, "[sample]", {"points", "seed"});
    const auto number = [&](std::string_view key, std::int64_t least, std::int64_t most) {
      const toml::node* node = table->get(key);
      const auto value = node == nullptr ? std::nullopt : node->value_exact<std::int64_t>();
      if (!value || *value < least || *value > most) {
        reader_.fail(
            node == nullptr ? *table : *node,
            fmt::format("[sample] wants {}, a whole number from {} to {}", key, least, most));
      }
      return static_cast<std::uint64_t>(*value);
    };
    Sample sample;
    sample.points = number("points", 1, static_cast<std::int64_t>(kMostPoints));
    if (table->contains("seed")) {
      sample.seed = number("seed", 0, std::numeric_limits<std::int64_t>::max());
    }
    space_.sample = sample;
  }

  void read_goal() {
    for (const auto& [name, node] : entries_of("goal")) {
      Requirement requirement{name, true, 0, reader_.place(*node)};
      if (name == "frames_per_second" && node->is_number()) {
        requirement.limit = *node->value<double>();
      } else if (!read_bound(*node, requirement)) {
        reader_.fail(*node,
                     fmt::format("the goal {0} is a bound: {0} = \">= 20\" or \"<= 20\"", name));
      }
      space_.goal.push_back(std::move(requirement));
    }
  }

  // ">= 20" or "<= 20".
  static bool read_bound(const toml::node& node, Requirement& requirement) {
    const std::string text = node.value_exact<std::string>().value_or("");
    requirement.at_least = text.starts_with(">=");
    if (!requirement.at_least && !text.starts_with("<=")) {
      return false;
    }
    const std::size_t begin = text.find_first_not_of(' ', 2);
    const char* end = text.data() + text.size();
    if (begin == std::string::npos) {
      return false;
    }
    const auto read = std::from_chars(text.data() + begin, end, requirement.limit);
    return read.ec == std::errc() && read.ptr == end && std::isfinite(requirement.limit);
  }

  void read_columns() {
    const toml::table* table = reader_.table(reader_.root(), "table");
    if (table == nullptr) {
      return;
    }
    reader_.check_keys(*table, "[table]", {"columns"});
    if (const toml::node* node = table->get("columns")) {
      for (const std::string& name : reader_.strings(*node, "columns")) {
        space_.columns.push_back({name, reader_.place(*node)});
      }
    }
  }

  TomlReader reader_;
  Space space_;
};

}  // namespace

Space parse_space(std::string_view text, const std::string& file) {
  return SpaceReader(text, file).read();
}

Space load_space(const fs::path& path) { return parse_space(read_text_file(path), path.string()); }

std::string number_text(double value) { return fmt::format("{}", value); }

}  // namespace finback::explorer
