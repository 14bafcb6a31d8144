#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

#include <common/file.hpp>
#include <common/parameter.hpp>
#include <common/toml_reader.hpp>
#include <runner/ladder.hpp>
#include <runner/source_text.hpp>

namespace finback::runner {

namespace fs = std::filesystem;

namespace {

fs::path labs_folder() { return share_folder() / "firmware" / "labs"; }

std::vector<std::string> names_of(const std::vector<Rung>& ladder) {
  std::vector<std::string> names;
  names.reserve(ladder.size());
  for (const Rung& rung : ladder) {
    names.push_back(rung.name);
  }
  return names;
}

// By name of file; the head of a diff shows `name`.
using Sources = std::map<std::string, NamedText>;

void add(Sources& sources, const fs::path& file) {
  const fs::path shown = fs::absolute(file).lexically_proximate(labs_folder());
  const bool installed = *shown.begin() != "..";
  sources.try_emplace(
      file.filename().string(),
      NamedText{installed ? shown.string() : fs::proximate(file).string(), read_text_file(file)});
}

// The sources that a unit was compiled from, where they are found; a unit that was written by hand.
void add_unit(Sources& sources, const ir::Program& unit, const std::string& manifest) {
  const fs::path path = unit.path;
  std::error_code error;
  if (fs::exists(share_folder() / "runtime" / path.filename(), error)) {
    return;
  }
  bool compiled = false;
  for (const std::string& source : unit.source_files) {
    if (source.empty() || path.filename() == source) {
      continue;
    }
    compiled = true;
    for (const fs::path& place : source_folders(manifest)) {
      if (fs::is_regular_file(place / source, error)) {
        add(sources, place / source);
        break;
      }
    }
  }
  if (!compiled) {
    add(sources, path);
  }
}

// A manifest without the line that tells the firmware's name.
std::string without_name(const std::string& manifest) {
  const std::size_t at = manifest.starts_with("name = ") ? 0 : manifest.find("\nname = ") + 1;
  const bool found = manifest.compare(at, 7, "name = ") == 0;
  return found ? manifest.substr(0, at) + manifest.substr(manifest.find('\n', at) + 1) : manifest;
}

std::size_t different_pixels(const machine::PublishedMap& one, const machine::PublishedMap& other) {
  if (one.bytes.size() != other.bytes.size()) {
    return std::max(one.bytes.size(), other.bytes.size());
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < one.bytes.size(); ++i) {
    count += one.bytes[i] != other.bytes[i] ? 1U : 0U;
  }
  return count;
}

}  // namespace

std::vector<Rung> load_ladder() {
  const fs::path file = labs_folder() / "ladder.toml";
  const TomlReader reader(read_text_file(file), file.string());
  reader.check_keys(reader.root(), "a ladder", {"rungs"});
  const toml::table* rungs = reader.table(reader.root(), "rungs");
  std::vector<Rung> ladder;
  if (rungs != nullptr) {
    for (const auto& [name, node] : TomlReader::in_order(*rungs)) {
      ladder.push_back({name, reader.string(*rungs, name), (labs_folder() / name).string()});
    }
  }
  if (ladder.empty()) {
    throw InputError(file.string() + ": has no [rungs]");
  }
  return ladder;
}

Rung find_rung(const std::vector<Rung>& ladder, const std::string& name) {
  const auto found = std::ranges::find(ladder, name, &Rung::name);
  if (found != ladder.end()) {
    return *found;
  }
  if (name.find('/') != std::string::npos) {
    return {name, "", name};
  }
  const std::vector<std::string> names = names_of(ladder);
  const std::string near = nearest_name(name, names);
  throw InputError(fmt::format(
      "there is no rung '{}'{}; the rungs are {}; or give the path of a firmware's folder", name,
      near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(names, ", ")));
}

std::vector<NamedText> sources_of(const Rung& rung) {
  const ir::FirmwareUnits units = find_firmware(rung.firmware, {}).firmware.units;
  const fs::path folder = fs::absolute(units.path).parent_path();
  Sources sources;
  for (const char* name : {"firmware.toml", "placement.toml"}) {
    std::error_code error;
    if (fs::is_regular_file(folder / name, error)) {
      add(sources, folder / name);
    }
  }
  for (const ir::CoreUnits& core : units.cores) {
    for (const ir::Unit& unit : core.units) {
      add_unit(sources, *unit, units.path);
    }
  }
  for (const ir::Unit& unit : units.shared) {
    add_unit(sources, *unit, units.path);
  }
  std::vector<NamedText> list;
  for (auto& [name, source] : sources) {
    list.push_back({source.name, std::move(source.text)});
  }
  return list;
}

std::string rung_diff(const Rung& before, const Rung& after) {
  const auto by_file = [](const Rung& rung) {
    Sources sources;
    for (NamedText& source : sources_of(rung)) {
      if (source.name.ends_with("firmware.toml")) {
        source.text = without_name(source.text);  // which differs in any case
      }
      sources.emplace(fs::path(source.name).filename().string(), std::move(source));
    }
    return sources;
  };
  const Sources old_files = by_file(before);
  const Sources new_files = by_file(after);
  std::set<std::string> names;
  for (const Sources* side : {&old_files, &new_files}) {
    for (const auto& [name, source] : *side) {
      names.insert(name);
    }
  }
  std::string text;
  for (const std::string& name : names) {
    const auto one = old_files.find(name);
    const auto other = new_files.find(name);
    text += unified_diff(one == old_files.end() ? NamedText{} : one->second,
                         other == new_files.end() ? NamedText{} : other->second);
  }
  return text;
}

std::string differing_maps(const std::vector<std::string>& names,
                           const std::vector<std::vector<machine::PublishedMap>>& maps) {
  for (std::size_t run = 1; run < maps.size(); ++run) {
    for (std::size_t frame = 0; frame < std::min(maps[run].size(), maps[0].size()); ++frame) {
      const std::size_t count = different_pixels(maps[0][frame], maps[run][frame]);
      if (count > 0) {
        return fmt::format("the map of {} differs from that of {} in {} pixels of frame {}",
                           names[run], names[0], count, frame);
      }
    }
  }
  return "";
}

}  // namespace finback::runner
