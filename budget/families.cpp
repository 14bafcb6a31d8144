#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <budget/families.hpp>

namespace finback::budget {

namespace {

struct Membership {
  std::string_view cause;
  std::string_view family;
};

constexpr std::array kMembers = {
    Membership{"l2_read", "l2"},
    Membership{"l2_write", "l2"},
    Membership{"l3_read", "l3"},
    Membership{"l3_write", "l3"},
    Membership{"branch_taken", "branches"},
    Membership{"branch_mispredict", "branches"},
    Membership{"hazard_address", "hazards"},
    Membership{"hazard_ex1", "hazards"},
};

struct Words {
  std::string_view family;
  std::string_view text;
};

constexpr std::array kWords = {
    Words{"issue", "work (issue)"},
    Words{"l2", "waiting for data in L2 (l2_read, l2_write)"},
    Words{"l3", "waiting for data in L3 (l3_read, l3_write)"},
    Words{"fetch", "waiting for code (fetch)"},
    Words{"sub_bank", "meeting in one L1 sub-bank (sub_bank)"},
    Words{"store_buffer", "loading what was just stored (store_buffer)"},
    Words{"branches", "jumping (branch_taken, branch_mispredict)"},
    Words{"hazards", "waiting for own results (hazard_address, hazard_ex1)"},
    Words{"multi_cycle", "long instructions (multi_cycle)"},
    Words{"device", "waiting for device registers (device)"},
    Words{"interrupt_entry", "entering interrupt handlers (interrupt_entry)"},
    Words{"idle", "time asleep (idle)"},
};

}  // namespace

std::string family_of(std::string_view cause) {
  const auto found = std::ranges::find(kMembers, cause, &Membership::cause);
  return std::string(found == kMembers.end() ? cause : found->family);
}

std::string family_text(std::string_view family, bool growth) {
  const auto found = std::ranges::find(kWords, family, &Words::family);
  return fmt::format("{} {}", growth ? "more" : "less",
                     found == kWords.end() ? family : found->text);
}

}  // namespace finback::budget
