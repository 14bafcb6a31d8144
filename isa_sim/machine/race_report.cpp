#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/ir/placement.hpp>
#include <isa_sim/machine/race_report.hpp>

namespace finback::machine {

namespace {

std::string object_at(const ir::Image& image, Address address) {
  const auto found = std::ranges::find_if(image.objects, [address](const ir::PlacedObject& object) {
    return address - object.address < object.size;
  });
  if (found == image.objects.end()) {
    return fmt::format("{:#010x}", address);
  }
  return fmt::format("{}+{} of {} ({:#010x})", found->name, address - found->address,
                     ir::owner_name(found->owner), address);
}

}  // namespace

std::vector<races::Range> flags_of(const ir::Image& image) {
  std::vector<races::Range> ranges;
  for (const ir::PlacedObject& object : image.objects) {
    if (object.flag) {
      ranges.push_back({object.address, object.size});
    }
  }
  return ranges;
}

RaceReport describe(const races::Race& race, const ir::Image& image,
                    const std::function<std::string(int core, std::uint32_t packet)>& place_of) {
  const auto side = [&](const races::RaceSide& access) {
    const auto actor = static_cast<std::size_t>(access.actor);
    std::string text =
        fmt::format("{} {}", memory::kInitiatorNames[actor],
                    access.direction == memory::Direction::read ? "reads" : "writes");
    if (access.place.core < 0) {
      return text;
    }
    if (actor >= kCoreCount) {
      text += fmt::format(", commanded by {}", name_of(static_cast<CoreId>(access.place.core)));
    }
    return text + " in " + place_of(access.place.core, access.place.packet);
  };
  return {.object = object_at(image, race.address),
          .earlier = side(race.earlier),
          .later = side(race.later),
          .at = race.at,
          .bytes = race.bytes};
}

}  // namespace finback::machine
