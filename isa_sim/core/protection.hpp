// Memory protection: the CPLBs of data and instructions, their registers, and what the last fault
// was.
//
// Models: 16 data and 16 instruction CPLBs with their rights and how they are cached, DMEM_CONTROL
// and IMEM_CONTROL (the enable bits, which halves are cache), fault status and address, and what
// holds without CPLBs: registers are the supervisor's, and only the first address generator reaches
// them. Does not model: the test registers' access to L1 (they keep what is written). Source:
// Programming Reference, chapter 6.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <common/units.hpp>
#include <memory_model/data_cache.hpp>

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

  // An access that is no register's and that nothing is wrong with, for sure; for others
  // check_data() tells what is.
  [[nodiscard]] bool allows(Address address, bool write, bool supervisor) {
    return (page_of(address).allowed >> right(write, supervisor) & 1U) != 0;
  }
  // No access of `size` bytes in L1 from `base` on can be refused.
  [[nodiscard]] bool open(Address base, std::uint32_t size) const;
  // How the page of `address` is cached, while CPLBs are enabled.
  [[nodiscard]] memory::CachePolicy cache_policy(Address address) {
    return page_of(address).policy;
  }
  // Of DMEM_CONTROL: how many banks are cache in part, and whether bit 23 of an address tells
  // which.
  [[nodiscard]] int cache_banks() const;
  [[nodiscard]] bool cache_high_select() const { return (data_.control >> 4U & 1U) != 0; }
  // As if DMEM_CONTROL had been written so.
  void set_cache_banks(int banks);
  // EXCAUSE of a data access, noted in the fault registers; 0 when nothing is wrong with it.
  [[nodiscard]] int check_data(const Access& access);
  // How the page of code at `address` is cached, while CPLBs are enabled.
  struct CodePage {
    Address number = ~Address{0};
    bool cached = false;
    bool important = false;  // CPLB_LRUPRIO
  };
  [[nodiscard]] const CodePage& code_page(Address address);
  // Of IMEM_CONTROL: IMC, and the ways that are locked.
  [[nodiscard]] bool code_cache() const { return (code_.control >> 2U & 1U) != 0; }
  [[nodiscard]] std::uint32_t locked_ways() const { return code_.control >> 3U & 0xFU; }
  void set_code_cache() { code_.control |= 1U << 2U; }
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
  // What the CPLBs say of one page of the smallest size, remembered until one of them changes.
  struct Page {
    Address number = ~Address{0};
    std::uint8_t allowed = 0;  // one bit for each right()
    memory::CachePolicy policy = memory::CachePolicy::uncached;
  };
  [[nodiscard]] static int right(bool write, bool supervisor) {
    return (write ? 1 : 0) + (supervisor ? 2 : 0);
  }
  [[nodiscard]] const Page& page_of(Address address) {
    const Address number = address >> kSmallestPageShift;
    const Page& page = pages_[number % pages_.size()];
    return page.number == number ? page : look_up_page(number);
  }
  const Page& look_up_page(Address number);
  [[nodiscard]] static bool covers(const Side& side, std::size_t entry, Address address);
  template <class S>
  [[nodiscard]] static auto* find(S& side, Address offset);
  [[nodiscard]] static Hits look_up(const Side& side, const Access& access);
  void note(const Access& access, bool illegal_address, std::uint32_t entries);

  static constexpr int kSmallestPageShift = 10;
  std::array<Page, 64> pages_{};
  CodePage code_page_;  // looked up last
  Side data_;
  Side code_;
};

}  // namespace finback::core
