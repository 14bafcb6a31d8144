// Random transfers against the plain reference: the same bytes in the end, and at every interrupt.
#include <random>

#include "dma_fixture.hpp"
#include "dma_reference.hpp"

namespace finback::dma {
namespace {

// Where the halves of a transfer live; descriptors of both sides in L2.
constexpr Address kFrom = 0x100000, kTo = 0xFF800000, kDescriptors = 0xFEB00000;
constexpr std::uint32_t kFromBytes = 0x4000, kToBytes = 0x4000;

struct Unit {
  std::uint32_t x_count = 1, y_count = 1;
  std::int32_t x_modify = 0, y_modify = 0;
  bool two_dimensional = false;
  bool by_row = false;
  bool interrupt = false;

  [[nodiscard]] std::uint32_t elements() const { return x_count * y_count; }
};

class RandomTransfer : public DmaTest {
 protected:
  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  std::int32_t modify(std::int32_t width) {
    return (static_cast<std::int32_t>(draw(21)) - 10) * width;
  }

  Unit draw_unit(std::int32_t width) {
    Unit unit;
    unit.x_count = 1 + draw(40);
    unit.x_modify = draw(3) == 0 ? modify(width) : width;
    unit.two_dimensional = draw(2) == 0;
    if (unit.two_dimensional) {
      unit.y_count = 1 + draw(7);
      unit.y_modify = modify(4 * width);
      unit.by_row = draw(2) == 0;
    }
    unit.interrupt = draw(3) != 0;
    return unit;
  }
  // Units that have `elements` in all.
  std::vector<Unit> cut(std::uint32_t elements, std::int32_t width) {
    std::vector<Unit> units;
    while (elements > 0) {
      Unit unit = draw_unit(width);
      if (unit.elements() > elements || units.size() == 5) {
        unit.two_dimensional = unit.by_row = false;
        unit.y_count = 1;
        unit.x_count = elements;
        unit.x_modify = width;
      }
      elements -= unit.elements();
      units.push_back(unit);
    }
    return units;
  }
  // A start from which the unit stays within `size` bytes at `base`.
  Address place(const Unit& unit, std::uint32_t width, Address base, std::uint32_t size) {
    std::int64_t at = 0, low = 0, high = 0;
    for (std::uint32_t i = 0; i < unit.elements(); ++i) {
      low = std::min(low, at);
      high = std::max(high, at);
      at += (i + 1) % unit.x_count == 0 && unit.two_dimensional ? unit.y_modify : unit.x_modify;
    }
    const std::int64_t room = std::int64_t{size} - (high - low) - width;
    EXPECT_GE(room, 0);
    return base + static_cast<Address>(-low) +
           draw(static_cast<std::uint32_t>(room / width) + 1) * width;
  }

  // Writes a chain as descriptors at `at` or, when it is one unit, into registers; starts it.
  ReferenceRegisters chain(const std::vector<Unit>& units, std::uint32_t common, Address base,
                           std::uint32_t size, Address at) {
    const std::uint32_t width = 1U << (common >> 2 & 3);
    const std::uint32_t flow =
        units.size() == 1 && draw(2) == 0 ? 0 : std::array{4U, 6U, 7U}[draw(3)];
    const std::uint32_t head = flow == 7 ? 2 : flow == 6 ? 1 : 0;
    const auto config_of = [&](std::size_t i, bool next) {
      const std::uint32_t more = next ? flow << 12 | (flow == 0 ? 0 : head + 7) << 8 : 0;
      if (i == units.size()) {
        return static_cast<std::uint16_t>(common | more);
      }
      const Unit& u = units[i];
      return static_cast<std::uint16_t>(common | more | (u.two_dimensional ? 0x10U : 0U) |
                                        (u.by_row ? 0x40U : 0U) | (u.interrupt ? 0x80U : 0U));
    };
    ReferenceRegisters registers;
    if (flow == 0) {
      const Unit& u = units[0];
      registers = {.start = place(u, width, base, size),
                   .config = config_of(0, false),
                   .x_count = static_cast<std::uint16_t>(u.x_count),
                   .y_count = static_cast<std::uint16_t>(u.y_count),
                   .x_modify = static_cast<std::int16_t>(u.x_modify),
                   .y_modify = static_cast<std::int16_t>(u.y_modify)};
      return registers;
    }
    registers.config = config_of(units.size(), true);
    registers.next_descriptor = registers.current_descriptor = at;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Unit& u = units[i];
      const bool last = i + 1 == units.size();
      // Arrays lie close, lists apart.
      const Address next = at + (flow == 4 ? 14 : 32);
      std::vector<std::uint32_t> words;
      if (head > 0) {
        words.push_back(next & 0xFFFF);
      }
      if (head > 1) {
        words.push_back(next >> 16);
      }
      const Address start = place(u, width, base, size);
      for (const std::uint32_t word :
           {start & 0xFFFF, start >> 16, std::uint32_t{config_of(i, !last)}, u.x_count,
            static_cast<std::uint32_t>(u.x_modify), u.y_count,
            static_cast<std::uint32_t>(u.y_modify)}) {
        words.push_back(word);
      }
      std::vector<std::uint8_t> bytes;
      for (const std::uint32_t word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
      }
      memory_->store_bytes(at, bytes);
      at = next;
    }
    return registers;
  }
  void load(std::uint32_t channel, const ReferenceRegisters& r) {
    dma1_->write(channel + kNextDescriptorPointer, 4, r.next_descriptor, 0);
    dma1_->write(channel + kCurrentDescriptorPointer, 4, r.current_descriptor, 0);
    dma1_->write(channel + kStartAddress, 4, r.start, 0);
    dma1_->write(channel + kXCount, 2, r.x_count, 0);
    dma1_->write(channel + kXModify, 2, static_cast<std::uint16_t>(r.x_modify), 0);
    dma1_->write(channel + kYCount, 2, r.y_count, 0);
    dma1_->write(channel + kYModify, 2, static_cast<std::uint16_t>(r.y_modify), 0);
  }
  std::uint16_t half_at(Address address) {
    const auto bytes = memory_->view_bytes(address, 2);
    return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
  }

  std::mt19937 random_{1};  // NOLINT: the same in every run
};

TEST_F(RandomTransfer, AgreesWithTheReferenceAtEveryInterrupt) {
  int interrupts = 0;
  for (int round = 0; round < 400; ++round) {
    parameters_.burst_elements.set(static_cast<double>(1 + draw(20)));
    build();
    dma1_->write(DmaController::kTrafficPeriods, 2, draw(4) == 0 ? draw(0x10000) : 0, 0);
    const std::uint32_t bits = draw(3) << 2;
    const std::uint32_t width = 1U << (bits >> 2);
    memory_->store_bytes(kFrom, pattern(kFromBytes, static_cast<std::uint32_t>(round)));
    const auto to_units = cut(1 + draw(600), static_cast<std::int32_t>(width));
    std::uint32_t elements = 0;
    for (const Unit& unit : to_units) {
      elements += unit.elements();
    }
    auto from_units = cut(elements, static_cast<std::int32_t>(width));
    for (Unit& unit : from_units) {
      unit.interrupt = false;  // the line tells of the destination alone
    }
    const auto to = chain(to_units, bits | kEnable | kWriteMemory, kTo, kToBytes, kDescriptors);
    const auto from = chain(from_units, bits | kEnable, kFrom, kFromBytes, kDescriptors + 0x1000);
    load(kS0, from);
    load(kD0, to);
    dma1_->write(kS0 + kConfig, 2, from.config, 0);
    dma1_->write(kD0 + kConfig, 2, to.config, 0);

    const auto read_half = [this](Address at) { return half_at(at); };
    ReferenceChannel reads(from, read_half), writes(to, read_half);
    std::vector<std::uint8_t> expected(kToBytes);
    std::uint32_t moved = 0;
    const auto run_to_interrupt = [&] {
      while (writes.running()) {
        for (std::uint32_t i = 0; i < width; ++i) {
          expected[writes.address() - kTo + i] = memory_->view_bytes(reads.address() + i, 1)[0];
        }
        ++moved;
        reads.step();
        if (writes.step()) {
          return true;
        }
      }
      return false;
    };
    while (dma1_->next_event_time() != kNever) {
      dma1_->advance(dma1_->next_event_time());
      if (!lines_.empty() && lines_.back().level) {
        ++interrupts;
        ASSERT_TRUE(run_to_interrupt()) << round;
        ASSERT_EQ(bytes_at(kTo, kToBytes), expected) << round << " element " << moved;
        dma1_->write(kD0 + kIrqStatus, 2, kDone, lines_.back().at);
      }
    }
    ASSERT_FALSE(run_to_interrupt()) << round;
    ASSERT_EQ(moved, elements) << round;
    ASSERT_EQ(bytes_at(kTo, kToBytes), expected) << round;
    ASSERT_EQ(status(*dma1_, kD0) & kRun, 0U) << round;
    ASSERT_EQ(status(*dma1_, kS0) & kRun, 0U) << round;
    using memory::Direction;
    using memory::Initiator;
    using memory::Level;
    ASSERT_EQ(memory_->level_traffic(Level::l3, Initiator::mdma1_0, Direction::read).bytes,
              Bytes{elements} * width);
    ASSERT_EQ(memory_->level_traffic(Level::l1, Initiator::mdma1_0, Direction::write).bytes,
              Bytes{elements} * width);
  }
  EXPECT_GT(interrupts, 1000);
}

}  // namespace
}  // namespace finback::dma
