#include <algorithm>
#include <array>

#include <isa_sim/isa/operand.hpp>

namespace finback::isa {
namespace {

struct Kind {
  OperandKind kind;
  std::string_view name;
  std::optional<ImmediateRange> range;
};

constexpr std::int32_t kMega = 1 << 20;

// Bits, sign and scale as in the encodings of the Blackfin Programming Reference, although nothing
// is encoded here: they are what fits.
constexpr std::array kKinds = {
    Kind{OperandKind::data, "D", {}},
    Kind{OperandKind::data_low, "Dl", {}},
    Kind{OperandKind::data_high, "Dh", {}},
    Kind{OperandKind::data_half, "Dx", {}},
    Kind{OperandKind::data_byte, "Db", {}},
    Kind{OperandKind::data_even, "Deven", {}},
    Kind{OperandKind::data_odd, "Dodd", {}},
    Kind{OperandKind::pointer, "P", {}},
    Kind{OperandKind::index, "I", {}},
    Kind{OperandKind::modify, "M", {}},
    Kind{OperandKind::pointer_low, "Pl", {}},
    Kind{OperandKind::pointer_high, "Ph", {}},
    Kind{OperandKind::any, "G", {}},
    Kind{OperandKind::system, "S", {}},
    Kind{OperandKind::address, "IMBL", {}},
    Kind{OperandKind::data_pair, "DD", {}},
    Kind{OperandKind::data_list, "Dlist", {}},
    Kind{OperandKind::pointer_list, "Plist", {}},
    Kind{OperandKind::accumulate, "acc", {}},
    Kind{OperandKind::accumulate_mode, "amode", {}},
    Kind{OperandKind::accumulate_mode_m, "amode_m", {}},
    Kind{OperandKind::half_mode, "hmode", {}},
    Kind{OperandKind::half_mode_m, "hmode_m", {}},
    Kind{OperandKind::word_mode, "wmode", {}},
    Kind{OperandKind::word_mode_m, "wmode_m", {}},
    Kind{OperandKind::mixed, "m", {}},
    Kind{OperandKind::lanes, "lanes", {}},
    Kind{OperandKind::lane_mode, "sco", {}},
    Kind{OperandKind::lane_shift_mode, "sco_sft", {}},
    Kind{OperandKind::wide_saturate, "ns", {}},
    Kind{OperandKind::wide_accumulate, "w32", {}},
    Kind{OperandKind::byte_order, "r", {}},
    Kind{OperandKind::byte_average, "avg", {}},
    Kind{OperandKind::byte_round, "rnd", {}},
    Kind{OperandKind::byte_half, "lohi", {}},
    Kind{OperandKind::relation, "rel", {}},
    Kind{OperandKind::shift_side, "side", {}},
    Kind{OperandKind::status_flag, "flag", {}},
    Kind{OperandKind::flag_update, "upd", {}},
    Kind{OperandKind::imm3, "imm3", ImmediateRange{-4, 3, 1}},
    Kind{OperandKind::imm4, "imm4", ImmediateRange{-8, 7, 1}},
    Kind{OperandKind::imm6, "imm6", ImmediateRange{-32, 31, 1}},
    Kind{OperandKind::imm7, "imm7", ImmediateRange{-64, 63, 1}},
    Kind{OperandKind::imm16, "imm16", ImmediateRange{-32768, 32767, 1}},
    Kind{OperandKind::uimm3, "uimm3", ImmediateRange{0, 7, 1}},
    Kind{OperandKind::uimm4, "uimm4", ImmediateRange{0, 15, 1}},
    Kind{OperandKind::uimm5, "uimm5", ImmediateRange{0, 31, 1}},
    Kind{OperandKind::uimm6, "uimm6", ImmediateRange{0, 63, 1}},
    Kind{OperandKind::uimm16, "uimm16", ImmediateRange{0, 65535, 1}},
    Kind{OperandKind::any16, "any16", ImmediateRange{-32768, 65535, 1}},
    Kind{OperandKind::offset4x2, "off4x2", ImmediateRange{0, 30, 2}},
    Kind{OperandKind::offset4x4, "off4x4", ImmediateRange{0, 60, 4}},
    Kind{OperandKind::offset5x4neg, "off5n4", ImmediateRange{-128, -4, 4}},
    Kind{OperandKind::offset16, "off16", ImmediateRange{-32768, 32767, 1}},
    Kind{OperandKind::offset16x2, "off16x2", ImmediateRange{-65536, 65534, 2}},
    Kind{OperandKind::offset16x4, "off16x4", ImmediateRange{-131072, 131068, 4}},
    Kind{OperandKind::frame18x4, "frame", ImmediateRange{0, 262140, 4}},
    Kind{OperandKind::pc10, "pc10", ImmediateRange{-1024, 1022, 2}},
    Kind{OperandKind::pc12, "pc12", ImmediateRange{-4096, 4094, 2}},
    Kind{OperandKind::pc24, "pc24", ImmediateRange{-16 * kMega, 16 * kMega - 2, 2}},
    Kind{OperandKind::loop_top, "ltop", ImmediateRange{4, 30, 2}},
    Kind{OperandKind::loop_bottom, "lbottom", ImmediateRange{4, 2046, 2}},
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (static_cast<std::size_t>(kKinds[i].kind) != i) {
      return false;
    }
  }
  return true;
}
static_assert(is_in_order() && kKinds.back().kind == OperandKind::loop_bottom);

}  // namespace

std::string_view kind_name(OperandKind kind) {
  return kKinds.at(static_cast<std::size_t>(kind)).name;
}

std::optional<OperandKind> kind_by_name(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, &Kind::name);
  return found == kKinds.end() ? std::nullopt : std::optional(found->kind);
}

std::optional<ImmediateRange> immediate_range(OperandKind kind) {
  return kKinds.at(static_cast<std::size_t>(kind)).range;
}

}  // namespace finback::isa
