#include <fmt/format.h>
#include <iterator>

#include <report/run_result.hpp>
#include <runner/identity.hpp>

namespace finback::runner {

namespace {

template <class Parameters>
std::string values_text(const Parameters& parameters) {
  std::string text;
  for (const ParameterBase* parameter : parameters) {
    fmt::format_to(std::back_inserter(text), "{} = {}\n", parameter->declaration().name,
                   parameter->value());
  }
  return text;
}

}  // namespace

std::string machine_hash(const machine::MachineDescription& machine) {
  std::string text = values_text(machine.parameters());
  for (const memory::Region& region : machine.map.regions) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} {} {}\n", region.core,
                   region.name, region.base, region.size, static_cast<int>(region.level),
                   region.code, region.data, region.dma_reachable, region.read_only);
  }
  return report::content_hash(text);
}

std::string power_hash(const power::PowerParameters& parameters) {
  return report::content_hash(values_text(parameters.parameters()));
}

std::string scene_hash(const scenes::Scene& scene) {
  std::string bytes;
  for (const scenes::ByteImage* image : {&scene.left, &scene.right}) {
    bytes.append(image->pixels().begin(), image->pixels().end());
  }
  for (const float disparity : scene.truth.pixels()) {
    fmt::format_to(std::back_inserter(bytes), "{} ", disparity);
  }
  return report::content_hash(bytes);
}

std::string view_hash(const scenes::Scene& scene,
                      const std::array<std::vector<peripheral::FrameTrouble>, 2>& troubles) {
  std::string text = scene_hash(scene);
  const std::size_t alone = text.size();
  for (std::size_t side = 0; side < troubles.size(); ++side) {
    for (const peripheral::FrameTrouble& trouble : troubles[side]) {
      fmt::format_to(std::back_inserter(text), "\n{} {} {} {}", side, trouble.frame,
                     trouble.dropped, trouble.late_us);
    }
  }
  return text.size() == alone ? text : report::content_hash(text);
}

}  // namespace finback::runner
