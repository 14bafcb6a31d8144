#include <algorithm>

#include <isa_sim/core/exception_cause.hpp>
#include <isa_sim/core/protection.hpp>

namespace finback::core {

namespace {

// Offsets within the registers of one side; those of instructions begin kCodeSide higher.
constexpr Address kProtectionControl = 0x004, kFaultStatus = 0x008, kFaultAddress = 0x00C;
constexpr Address kEntryAddress = 0x100, kEntryRights = 0x200;
constexpr Address kTestCommand = 0x300, kTestData = 0x400;
constexpr Address kCodeSide = 0x1000;
constexpr Address kL1Base = 0xFF800000;  // SRAM_BASE_ADDRESS, read-only

// Rights of a CPLB.
constexpr std::uint32_t kValid = 1U << 0, kUserRead = 1U << 2, kUserWrite = 1U << 3,
                        kSupervisorWrite = 1U << 4, kDirty = 1U << 7, kCacheable = 1U << 12,
                        kWriteThrough = 1U << 14;
constexpr std::uint32_t kAllocateOnWrite = 1U << 15;
constexpr std::uint32_t kImportant = 1U << 8;  // of instructions
constexpr int kPageShift = 16;
constexpr std::array<std::uint32_t, 4> kPageBytes = {0x400, 0x1000, 0x100000, 0x400000};

// DMC of DMEM_CONTROL: no cache; bank A; banks A and B.
constexpr int kCacheShift = 2;
constexpr std::array<std::uint32_t, 3> kCacheBanks = {0, 2, 3};

// Fault status.
constexpr int kWriteBit = 16, kSupervisorBit = 17, kSecondBit = 18, kIllegalBit = 19;

constexpr Address kRegisters = 0xFFC00000;
constexpr Address kLevel1 = 0xFF000000;
constexpr Address kInstructionMask = 0xFFF00000;

bool is_l1_code(Address address) {
  return (address & kInstructionMask) == 0xFFA00000 || (address & kInstructionMask) == 0xFF600000;
}

}  // namespace

template <class S>
auto* Protection::find(S& side, Address offset) {
  decltype(&side.control) word = nullptr;
  if (offset == kProtectionControl) {
    word = &side.control;
  } else if (offset - kEntryAddress < 4 * kEntries) {
    word = &side.address[(offset - kEntryAddress) / 4];
  } else if (offset - kEntryRights < 4 * kEntries) {
    word = &side.rights[(offset - kEntryRights) / 4];
  } else if (offset == kTestCommand) {
    word = &side.test_command;
  } else if (offset - kTestData < 4 * side.test_data.size()) {
    word = &side.test_data[(offset - kTestData) / 4];
  }
  return word;
}

bool Protection::read(Address address, std::uint32_t& value) const {
  const bool code = address - kFirstRegister >= kCodeSide;
  const Side& side = code ? code_ : data_;
  const Address offset = address - kFirstRegister - (code ? kCodeSide : 0);
  if (const std::uint32_t* word = find(side, offset)) {
    value = *word;
    return true;
  }
  switch (offset) {
    case 0:
      value = code ? 0 : kL1Base;
      return true;
    case kFaultStatus:
      value = side.fault_status;
      return true;
    case kFaultAddress:
      value = side.fault_address;
      return true;
    default:
      return false;
  }
}

bool Protection::write(Address address, std::uint32_t value) {
  const bool code = address - kFirstRegister >= kCodeSide;
  const Address offset = address - kFirstRegister - (code ? kCodeSide : 0);
  if (std::uint32_t* word = find(code ? code_ : data_, offset)) {
    *word = value;
    pages_ = {};
    code_page_ = {};
    return true;
  }
  return offset == 0 || offset == kFaultStatus || offset == kFaultAddress;  // read-only
}

bool Protection::covers(const Side& side, std::size_t entry, Address address) {
  const std::uint32_t rights = side.rights[entry];
  const Address page = kPageBytes[rights >> kPageShift & 3U];
  return (rights & kValid) != 0 && ((address ^ side.address[entry]) & ~(page - 1)) == 0;
}

const Protection::Page& Protection::look_up_page(Address number) {
  Page& page = pages_[number % pages_.size()];
  page = Page{.number = number};
  Access access{.address = number << kSmallestPageShift, .bytes = 1};
  for (const bool write : {false, true}) {
    for (const bool supervisor : {false, true}) {
      access.write = write;
      access.supervisor = supervisor;
      const Hits hits = look_up(data_, access);
      const bool enough = hits.count == 1 || (hits.count == 0 && access.address >= kLevel1);
      if (enough && !hits.refused && access.address < kRegisters) {
        page.allowed |= static_cast<std::uint8_t>(1U << right(write, supervisor));
      }
    }
  }
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::uint32_t rights = data_.rights[i];
    if (covers(data_, i, access.address) && (rights & kCacheable) != 0) {
      page.policy = (rights & kWriteThrough) == 0      ? memory::CachePolicy::write_back
                    : (rights & kAllocateOnWrite) != 0 ? memory::CachePolicy::write_through_allocate
                                                       : memory::CachePolicy::write_through;
    }
  }
  return page;
}

const Protection::CodePage& Protection::code_page(Address address) {
  const Address number = address >> kSmallestPageShift;
  if (code_page_.number != number) {
    code_page_ = CodePage{.number = number};
    for (std::size_t i = 0; i < kEntries; ++i) {
      if (covers(code_, i, address)) {
        code_page_.cached |= (code_.rights[i] & kCacheable) != 0;
        code_page_.important |= (code_.rights[i] & kImportant) != 0;
      }
    }
  }
  return code_page_;
}

bool Protection::open(Address base, std::uint32_t size) const {
  constexpr std::uint32_t kAll = kUserRead | kUserWrite | kSupervisorWrite;
  int covering = 0;
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::uint32_t rights = data_.rights[i];
    const Address page = kPageBytes[rights >> kPageShift & 3U];
    const Address start = data_.address[i] & ~(page - 1);
    const bool overlaps = start - base < size || base - start < page;
    if ((rights & kValid) == 0 || !overlaps) {
      continue;
    }
    ++covering;
    if (covering > 1 || (rights & kAll) != kAll || (rights & kCacheable) != 0) {
      return false;
    }
  }
  return true;
}

int Protection::cache_banks() const {
  const auto* const known = std::ranges::find(kCacheBanks, data_.control >> kCacheShift & 3U);
  return known == kCacheBanks.end() ? 0 : static_cast<int>(known - kCacheBanks.begin());
}

void Protection::set_cache_banks(int banks) {
  data_.control |= kCacheBanks[static_cast<std::size_t>(banks)] << kCacheShift;
}

Protection::Hits Protection::look_up(const Side& side, const Access& access) {
  Hits hits;
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::uint32_t rights = side.rights[i];
    if (!covers(side, i, access.address)) {
      continue;
    }
    ++hits.count;
    hits.entries |= 1U << i;
    if (access.write) {
      const bool clean = (rights & (kWriteThrough | kCacheable | kDirty)) == kCacheable;
      hits.refused |= (rights & (access.supervisor ? kSupervisorWrite : kUserWrite)) == 0 || clean;
    } else {
      hits.refused |= !access.supervisor && (rights & kUserRead) == 0;
    }
  }
  return hits;
}

int Protection::check_data(const Access& access) {
  constexpr std::array kCauses = {kDataMiss, kDataProtection, kDataMultipleHits};
  Hits hits = guards_data() ? look_up(data_, access) : Hits{1, 0, false};
  if (!hits.refused && hits.count < 2) {
    if ((access.address & static_cast<Address>(access.bytes - 1)) != 0) {
      note(access, false, hits.entries);
      return kMisalignedAccess;
    }
    const bool registers = access.address >= kRegisters;
    if (registers && (!access.supervisor || access.second)) {
      hits.count = 1;
    } else if (registers || access.address >= kLevel1 || hits.count == 1) {
      return 0;
    }
  }
  note(access, hits.count == 0, hits.entries);
  return kCauses[static_cast<std::size_t>(std::min(hits.count, 2))];
}

int Protection::check_fetch(Address address, bool supervisor) {
  constexpr std::array kCauses = {kFetchMiss, kFetchProtection, kFetchMultipleHits};
  const Access access{.address = address, .bytes = 2, .supervisor = supervisor};
  const Hits hits = look_up(code_, access);
  if (!hits.refused && hits.count < 2) {
    if ((address >= kLevel1 && is_l1_code(address)) || (address < kLevel1 && hits.count == 1)) {
      return 0;
    }
  }
  code_.fault_address = address;
  code_.fault_status = static_cast<std::uint32_t>(hits.count == 0) << kIllegalBit |
                       static_cast<std::uint32_t>(supervisor) << kSupervisorBit | hits.entries;
  return kCauses[static_cast<std::size_t>(std::min(hits.count, 2))];
}

void Protection::note_data_fault(const Access& access, bool illegal_address) {
  note(access, illegal_address, 0);
}

void Protection::note(const Access& access, bool illegal_address, std::uint32_t entries) {
  data_.fault_address = access.address;
  data_.fault_status = static_cast<std::uint32_t>(illegal_address) << kIllegalBit |
                       static_cast<std::uint32_t>(access.second) << kSecondBit |
                       static_cast<std::uint32_t>(access.supervisor) << kSupervisorBit |
                       static_cast<std::uint32_t>(access.write) << kWriteBit | entries;
}

void Protection::note_instruction(Address address, bool supervisor) {
  code_.fault_address = address;
  code_.fault_status = static_cast<std::uint32_t>(supervisor) << kSupervisorBit;
}

}  // namespace finback::core
