// Memory protection: the CPLBs of data and instructions, their registers, and what the last fault
// was.
//
// Models: 16 data and 16 instruction CPLBs with their rights, DMEM_CONTROL and IMEM_CONTROL (the
// enable bits), fault status and address, and what holds without CPLBs: registers are the
// supervisor's, and only the first address generator reaches them. Does not model: caches, the test
// registers' access to L1 (they keep what is written). Source: Programming Reference, chapter 6.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <common/units.hpp>

namespace finback::core {

class Protection {
 public:
  static constexpr Address kFirstRegister = 0xFFE00000;
  static constexpr Address kLastRegister = 0xFFE01404;

  struct Access {
    Address address = 0;
    int bytes = 0;
    bool write = false;
    bool supervisor = true;
    bool second = false;  // by the second address generator
  };

  // CPLBs are enabled: every access must be checked.
  [[nodiscard]] bool guards_data() const { return (data_.control & kEnable) != 0; }
  [[nodiscard]] bool guards_fetch() const { return (code_.control & kEnable) != 0; }

  // EXCAUSE of a data access, noted in the fault registers; 0 when nothing is wrong with it.
  [[nodiscard]] int check_data(const Access& access);
  // EXCAUSE of the fetch of the instruction at `address`; 0 when nothing is wrong with it.
  [[nodiscard]] int check_fetch(Address address, bool supervisor);
  // A fault that others found.
  void note_data_fault(const Access& access, bool illegal_address);
  void note_instruction(Address address, bool supervisor);

  // Registers, multiples of 4. False: there is none.
  [[nodiscard]] bool read(Address address, std::uint32_t& value) const;
  [[nodiscard]] bool write(Address address, std::uint32_t value);

 private:
  static constexpr std::uint32_t kEnable = 0x2;
  static constexpr std::size_t kEntries = 16;
  struct Side {
    std::uint32_t control = 0;
    std::uint32_t fault_status = 0;
    Address fault_address = 0;
    std::array<Address, kEntries> address{};
    std::array<std::uint32_t, kEntries> rights{};
    std::uint32_t test_command = 0;
    std::array<std::uint32_t, 2> test_data{};
  };
  struct Hits {
    int count = 0;
    std::uint32_t entries = 0;  // bit n: CPLB n
    bool refused = false;
  };
  template <class S>
  [[nodiscard]] static auto* find(S& side, Address offset);
  [[nodiscard]] static Hits look_up(const Side& side, const Access& access);
  void note(const Access& access, bool illegal_address, std::uint32_t entries);

  Side data_;
  Side code_;
};

}  // namespace finback::core
