#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <tracing/code.hpp>
#include <utility>

#include <isa_sim/ir/printer.hpp>
#include <isa_sim/isa/syntax.hpp>
#include <runner/written_code.hpp>

namespace finback::tracing {

namespace {

std::size_t index_of(CoreId core) { return static_cast<std::size_t>(core); }

std::string with_offset(const std::string& name, std::uint32_t offset) {
  return offset == 0 ? name : fmt::format("{}+{:#x}", name, offset);
}

}  // namespace

Code::Code(const ir::FirmwareUnits& units, ir::Image image)
    : units_(units), image_(std::move(image)) {
  for (std::size_t core = 0; core < written_.size(); ++core) {
    written_[core].resize(image_.cores[core].functions.size());
  }
}

const ir::Function& Code::written(CoreId core, std::uint32_t function) {
  ir::Function& known = written_[index_of(core)][function];
  if (known.packets.empty()) {
    known = runner::written_function(units_.cores[index_of(core)].units,
                                     this->core(core).functions[function], this->core(core));
  }
  return known;
}

std::string Code::text(CoreId core, std::uint32_t packet) {
  const std::uint32_t function = this->packet(core, packet).function;
  const std::size_t first = this->core(core).functions[function].first_packet;
  return ir::print(written(core, function).packets[packet - first], isa::instruction_syntax());
}

std::string Code::where(CoreId core, std::uint32_t packet) const {
  const ir::PlacedPacket& placed = this->packet(core, packet);
  const ir::PlacedFunction& function = this->core(core).functions[placed.function];
  return with_offset(function.name, placed.address - function.address);
}

std::string Code::line(CoreId core, std::uint32_t packet) const {
  const ir::PlacedPacket& placed = this->packet(core, packet);
  return placed.line <= 0
             ? ""
             : fmt::format("{}:{}",
                           this->core(core).source_files[static_cast<std::size_t>(placed.file)],
                           placed.line);
}

std::string Code::data(CoreId core, Address address) const {
  for (const ir::PlacedObject& object : image_.objects) {
    const bool seen =
        object.owner == ir::Owner::shared || object.owner == static_cast<ir::Owner>(core);
    if (seen && address >= object.address && address - object.address < object.size) {
      return with_offset(object.name, address - object.address);
    }
  }
  return fmt::format("{:#010x}", address);
}

std::vector<std::uint32_t> Code::packets_at(CoreId core, const std::string& place) {
  const ir::CoreImage& image = this->core(core);
  std::vector<std::uint32_t> found;
  const auto collect = [&](const auto& matches) {
    for (std::uint32_t i = 0; i < image.packets.size(); ++i) {
      if (matches(image.packets[i])) {
        found.push_back(i);
      }
    }
  };
  Address address = 0;
  const char* end = place.data() + place.size();
  if (place.starts_with("0x") &&
      std::from_chars(place.data() + 2, end, address, 16) == std::from_chars_result{end, {}}) {
    collect([&](const ir::PlacedPacket& packet) { return packet.address == address; });
    return found;
  }
  for (const ir::PlacedFunction& function : image.functions) {
    if (function.name == place && function.packet_count > 0) {
      found.push_back(static_cast<std::uint32_t>(function.first_packet));
    }
  }
  if (!found.empty()) {
    return found;
  }
  const std::size_t colon = place.rfind(':');
  int line = 0;
  if (colon != std::string::npos &&
      std::from_chars(place.data() + colon + 1, end, line) == std::from_chars_result{end, {}}) {
    // The file by its name, or by as many of its folders as were written.
    const std::string file = place.substr(0, colon);
    collect([&](const ir::PlacedPacket& packet) {
      const std::string& name = image.source_files[static_cast<std::size_t>(packet.file)];
      return packet.line == line && (name == file || name.ends_with("/" + file));
    });
    return found;
  }
  return label(core, place);
}

std::vector<std::uint32_t> Code::label(CoreId core, const std::string& name) {
  const ir::CoreImage& image = this->core(core);
  const std::size_t colon = name.find(':');
  const std::string function_name = colon == std::string::npos ? "" : name.substr(0, colon);
  const std::string label = colon == std::string::npos ? name : name.substr(colon + 1);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < image.functions.size(); ++i) {
    const ir::PlacedFunction& function = image.functions[i];
    if (!function_name.empty() && function.name != function_name) {
      continue;
    }
    const auto& labels = written(core, i).labels;
    const auto at = labels.find(label);
    if (at != labels.end() && at->second < function.packet_count) {
      found.push_back(static_cast<std::uint32_t>(function.first_packet + at->second));
    }
  }
  return found;
}

std::vector<std::string> Code::function_names(CoreId core) const {
  std::vector<std::string> names;
  for (const ir::PlacedFunction& function : this->core(core).functions) {
    names.push_back(function.name);
  }
  return names;
}

}  // namespace finback::tracing
