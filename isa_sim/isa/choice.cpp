#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/operand.hpp>

namespace finback::isa {
namespace {

using M = MultiplyMode;

constexpr Spelling kAccumulate[] = {{"=", kSet}, {"+=", kAdd}, {"-=", kSubtract}};

// A mode by itself, with M before it, and with M behind it.
struct ModeSpellings {
  MultiplyMode mode;
  std::string_view alone;
  std::string_view mixed;
  std::string_view mixed_behind;
};
constexpr ModeSpellings kModes[] = {{M::fraction, "", "(M)", "(M)"},
                                    {M::fu, "(FU)", "(M, FU)", "(FU, M)"},
                                    {M::is, "(IS)", "(M, IS)", "(IS, M)"},
                                    {M::iu, "(IU)", "(M, IU)", "(IU, M)"},
                                    {M::t, "(T)", "(M, T)", "(T, M)"},
                                    {M::tfu, "(TFU)", "(M, TFU)", "(TFU, M)"},
                                    {M::s2rnd, "(S2RND)", "(M, S2RND)", "(S2RND, M)"},
                                    {M::iss2, "(ISS2)", "(M, ISS2)", "(ISS2, M)"},
                                    {M::ih, "(IH)", "(M, IH)", "(IH, M)"},
                                    {M::w32, "(W32)", "(M, W32)", "(W32, M)"}};

// The spellings of some modes: first those without M.
template <MultiplyMode... modes>
constexpr auto spellings_of() {
  constexpr std::size_t kCount = sizeof...(modes);
  std::array<Spelling, 3 * kCount> result{};
  std::size_t i = 0;
  for (const MultiplyMode mode : {modes...}) {
    const ModeSpellings& texts = kModes[static_cast<std::size_t>(mode)];
    const auto value = static_cast<std::int32_t>(mode);
    result[i] = {texts.alone, value};
    result[kCount + i] = {texts.mixed, kMixed + value};
    result[2 * kCount + i] = {texts.mixed_behind, kMixed + value};
    ++i;
  }
  return result;
}
constexpr auto kAccumulateModes = spellings_of<M::fraction, M::fu, M::is, M::w32>();
constexpr auto kHalfModes =
    spellings_of<M::fraction, M::fu, M::is, M::iu, M::t, M::tfu, M::s2rnd, M::iss2, M::ih>();
constexpr auto kWordModes = spellings_of<M::fraction, M::fu, M::is, M::iu, M::s2rnd, M::iss2>();
// Without M: the first third.
template <std::size_t count>
constexpr std::span<const Spelling> alone(const std::array<Spelling, count>& all) {
  return std::span(all).first(count / 3);
}

constexpr Spelling kMixedOnly[] = {{"", 0}, {"(M)", kMixed}};

constexpr Spelling kLanes[] = {{"+|+", 0},
                               {"+|-", kSubtractLow},
                               {"-|+", kSubtractHigh},
                               {"-|-", kSubtractHigh | kSubtractLow}};
constexpr Spelling kLaneModes[] = {{"", 0},
                                   {"(S)", kSaturate},
                                   {"(CO)", kCross},
                                   {"(SCO)", kSaturate | kCross},
                                   {"(ASR)", kHalve},
                                   {"(S, ASR)", kSaturate | kHalve},
                                   {"(ASR, S)", kSaturate | kHalve},
                                   {"(CO, ASR)", kCross | kHalve},
                                   {"(ASR, CO)", kCross | kHalve},
                                   {"(SCO, ASR)", kSaturate | kCross | kHalve},
                                   {"(ASR, SCO)", kSaturate | kCross | kHalve},
                                   {"(ASL)", kDouble},
                                   {"(S, ASL)", kSaturate | kDouble},
                                   {"(ASL, S)", kSaturate | kDouble},
                                   {"(CO, ASL)", kCross | kDouble},
                                   {"(ASL, CO)", kCross | kDouble},
                                   {"(SCO, ASL)", kSaturate | kCross | kDouble},
                                   {"(ASL, SCO)", kSaturate | kCross | kDouble}};
constexpr std::size_t kPlainLaneModes = 4;
constexpr Spelling kWideSaturate[] = {{"", 0}, {"(NS)", 0}, {"(S)", kSaturate}};
constexpr Spelling kWideAccumulate[] = {{"", 0}, {"(W32)", 1}};

constexpr Spelling kByteOrders[] = {{"", 0}, {"(R)", kReverse}};
constexpr Spelling kByteAverages[] = {{"", 0},
                                      {"(R)", kReverse},
                                      {"(T)", kTruncate},
                                      {"(T, R)", kTruncate | kReverse},
                                      {"(R, T)", kTruncate | kReverse}};
constexpr Spelling kByteRounds[] = {{"(RNDL)", 0},
                                    {"(RNDL, R)", kReverse},
                                    {"(RNDH)", kHigh},
                                    {"(RNDH, R)", kHigh | kReverse},
                                    {"(TL)", kTruncate},
                                    {"(TL, R)", kTruncate | kReverse},
                                    {"(TH)", kHigh | kTruncate},
                                    {"(TH, R)", kHigh | kTruncate | kReverse}};
constexpr Spelling kByteHalves[] = {
    {"(LO)", 0}, {"(LO, R)", kReverse}, {"(HI)", kHigh}, {"(HI, R)", kHigh | kReverse}};
constexpr Spelling kRelations[] = {
    {"(GT)", kGreater}, {"(GE)", kGreaterEqual}, {"(LT)", kLess}, {"(LE)", kLessEqual}};
constexpr Spelling kShiftSides[] = {{"(ASL)", kToLeft}, {"(ASR)", kToRight}};
constexpr Spelling kStatusFlags[] = {{"AZ", 0},   {"AN", 1},      {"AC0_COPY", 2}, {"V_COPY", 3},
                                     {"AQ", 6},   {"RND_MOD", 8}, {"AC0", 12},     {"AC1", 13},
                                     {"AV0", 16}, {"AV0S", 17},   {"AV1", 18},     {"AV1S", 19},
                                     {"V", 24},   {"VS", 25}};
constexpr Spelling kFlagUpdates[] = {
    {"=", kFlagSet}, {"|=", kFlagOr}, {"&=", kFlagAnd}, {"^=", kFlagXor}};

}  // namespace

std::span<const Spelling> spellings(OperandKind kind) {
  switch (kind) {
    case OperandKind::accumulate:
      return kAccumulate;
    case OperandKind::accumulate_mode:
      return alone(kAccumulateModes);
    case OperandKind::accumulate_mode_m:
      return kAccumulateModes;
    case OperandKind::half_mode:
      return alone(kHalfModes);
    case OperandKind::half_mode_m:
      return kHalfModes;
    case OperandKind::word_mode:
      return alone(kWordModes);
    case OperandKind::word_mode_m:
      return kWordModes;
    case OperandKind::mixed:
      return kMixedOnly;
    case OperandKind::lanes:
      return kLanes;
    case OperandKind::lane_mode:
      return std::span(kLaneModes).first(kPlainLaneModes);
    case OperandKind::lane_shift_mode:
      return kLaneModes;
    case OperandKind::wide_saturate:
      return kWideSaturate;
    case OperandKind::wide_accumulate:
      return kWideAccumulate;
    case OperandKind::byte_order:
      return kByteOrders;
    case OperandKind::byte_average:
      return kByteAverages;
    case OperandKind::byte_round:
      return kByteRounds;
    case OperandKind::byte_half:
      return kByteHalves;
    case OperandKind::relation:
      return kRelations;
    case OperandKind::shift_side:
      return kShiftSides;
    case OperandKind::status_flag:
      return kStatusFlags;
    case OperandKind::flag_update:
      return kFlagUpdates;
    default:
      return {};
  }
}

}  // namespace finback::isa
