// The code of an image as people name it and read it: places, labels, lines, text.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/ir/program.hpp>

namespace finback::tracing {

class Code {
 public:
  // `units` must outlive it; the image is kept.
  Code(const ir::FirmwareUnits& units, ir::Image image);

  [[nodiscard]] const ir::CoreImage& core(CoreId core) const {
    return image_.cores[static_cast<std::size_t>(core)];
  }
  [[nodiscard]] const ir::PlacedPacket& packet(CoreId core, std::uint32_t index) const {
    return this->core(core).packets[index];
  }

  // "R2.L = ONES R2 || R0 = [P0++]", with the symbols and labels it was written with.
  [[nodiscard]] std::string text(CoreId core, std::uint32_t packet);
  // "shd_update_row+0x1c".
  [[nodiscard]] std::string where(CoreId core, std::uint32_t packet) const;
  // "shd.c:72"; "" when nobody told.
  [[nodiscard]] std::string line(CoreId core, std::uint32_t packet) const;
  // "left_image+0x40": the object at `address` as `core` sees it; else "0xffc00014".
  [[nodiscard]] std::string data(CoreId core, Address address) const;

  // The packets of `core` that a place names, in order: an address ("0xffa00040"), a function
  // ("shd_update_row": its first), a label ("shd_update_row:.LBB3_2", or alone where it is unique)
  // or a line of source ("shd.c:72"). None: there is no such place.
  [[nodiscard]] std::vector<std::uint32_t> packets_at(CoreId core, const std::string& place);
  // Names that a place could have meant.
  [[nodiscard]] std::vector<std::string> function_names(CoreId core) const;

 private:
  [[nodiscard]] const ir::Function& written(CoreId core, std::uint32_t function);
  [[nodiscard]] std::vector<std::uint32_t> label(CoreId core, const std::string& name);

  const ir::FirmwareUnits& units_;
  ir::Image image_;
  std::array<std::vector<ir::Function>, kCoreCount>
      written_;  // by function; empty: not yet looked up
};

}  // namespace finback::tracing
