// A linked image: every function and object at its address, every operand a number.
//
// Two name spaces: what belongs to one core and what both share. A core's symbol hides a shared
// one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <common/units.hpp>
#include <isa_sim/isa/operand.hpp>

namespace finback::ir {

enum class Owner : std::uint8_t { core_a = 0, core_b = 1, shared = 2 };

struct PlacedInstruction {
  int instruction = -1;  // index in isa::instruction_table()
  std::array<std::int32_t, isa::kMaxOperands> operand{};
};

struct PlacedPacket {
  Address address = 0;
  std::uint8_t length = 0;  // bytes: 2, 4 or 8
  std::uint8_t count = 0;
  std::array<PlacedInstruction, 3> slots;
  std::uint32_t function = 0;  // index into CoreImage::functions
  int file = 0;                // index into CoreImage::source_files
  int line = 0;
};

struct PlacedFunction {
  std::string name;  // C name: without the leading underscore
  std::string region;
  Address address = 0;
  std::uint32_t size = 0;
  std::size_t first_packet = 0;  // into CoreImage::packets
  std::size_t packet_count = 0;
};

// The name of a core's stack among the objects.
inline constexpr std::string_view kStackName = "stack";

struct PlacedObject {
  std::string name;  // C name; kStackName for a core's stack
  Owner owner = Owner::shared;
  std::string region;  // as the machine's map names it
  Address address = 0;
  std::uint32_t size = 0;
  std::vector<std::uint8_t> initial;  // relocated; shorter than size: zeros follow
  bool flag = false;                  // actors synchronise through it by plain loads and stores
};

struct CoreImage {
  bool present = false;  // false: the core never starts
  std::vector<std::string> source_files;
  std::vector<PlacedFunction> functions;  // ordered by address
  std::vector<PlacedPacket> packets;      // ordered by address
  Address entry = 0;
  Address stack_top = 0;
};

struct Image {
  std::array<CoreImage, kCoreCount> cores;
  std::vector<PlacedObject> objects;  // ordered by (owner, address)

  // A core's stack, or nullptr when the core is not there.
  [[nodiscard]] const PlacedObject* stack_of(Owner owner) const {
    const auto found = std::ranges::find_if(objects, [owner](const PlacedObject& object) {
      return object.owner == owner && object.name == kStackName;
    });
    return found == objects.end() ? nullptr : &*found;
  }
};

}  // namespace finback::ir
