#include <isa_sim/isa/choice.hpp>
#include <isa_sim/isa/operand.hpp>

namespace finback::isa {
namespace {

constexpr std::int32_t value(MultiplyMode mode) { return static_cast<std::int32_t>(mode); }
using M = MultiplyMode;

// The modes of a unit without M; those with it begin after them in the longer lists below.
constexpr Spelling kAccumulate[] = {{"=", kSet}, {"+=", kAdd}, {"-=", kSubtract}};
constexpr Spelling kAccumulateModes[] = {{"", value(M::fraction)},
                                         {"(FU)", value(M::fu)},
                                         {"(IS)", value(M::is)},
                                         {"(W32)", value(M::w32)},
                                         {"(M)", kMixed + value(M::fraction)},
                                         {"(M, FU)", kMixed + value(M::fu)},
                                         {"(FU, M)", kMixed + value(M::fu)},
                                         {"(M, IS)", kMixed + value(M::is)},
                                         {"(IS, M)", kMixed + value(M::is)},
                                         {"(M, W32)", kMixed + value(M::w32)},
                                         {"(W32, M)", kMixed + value(M::w32)}};
constexpr std::size_t kPlainAccumulateModes = 4;
constexpr Spelling kHalfModes[] = {{"", value(M::fraction)},
                                   {"(FU)", value(M::fu)},
                                   {"(IS)", value(M::is)},
                                   {"(IU)", value(M::iu)},
                                   {"(T)", value(M::t)},
                                   {"(TFU)", value(M::tfu)},
                                   {"(S2RND)", value(M::s2rnd)},
                                   {"(ISS2)", value(M::iss2)},
                                   {"(IH)", value(M::ih)},
                                   {"(M)", kMixed + value(M::fraction)},
                                   {"(M, FU)", kMixed + value(M::fu)},
                                   {"(FU, M)", kMixed + value(M::fu)},
                                   {"(M, IS)", kMixed + value(M::is)},
                                   {"(IS, M)", kMixed + value(M::is)},
                                   {"(M, IU)", kMixed + value(M::iu)},
                                   {"(IU, M)", kMixed + value(M::iu)},
                                   {"(M, T)", kMixed + value(M::t)},
                                   {"(T, M)", kMixed + value(M::t)},
                                   {"(M, TFU)", kMixed + value(M::tfu)},
                                   {"(TFU, M)", kMixed + value(M::tfu)},
                                   {"(M, S2RND)", kMixed + value(M::s2rnd)},
                                   {"(S2RND, M)", kMixed + value(M::s2rnd)},
                                   {"(M, ISS2)", kMixed + value(M::iss2)},
                                   {"(ISS2, M)", kMixed + value(M::iss2)},
                                   {"(M, IH)", kMixed + value(M::ih)},
                                   {"(IH, M)", kMixed + value(M::ih)}};
constexpr std::size_t kPlainHalfModes = 9;
constexpr Spelling kWordModes[] = {{"", value(M::fraction)},
                                   {"(FU)", value(M::fu)},
                                   {"(IS)", value(M::is)},
                                   {"(IU)", value(M::iu)},
                                   {"(S2RND)", value(M::s2rnd)},
                                   {"(ISS2)", value(M::iss2)},
                                   {"(M)", kMixed + value(M::fraction)},
                                   {"(M, FU)", kMixed + value(M::fu)},
                                   {"(FU, M)", kMixed + value(M::fu)},
                                   {"(M, IS)", kMixed + value(M::is)},
                                   {"(IS, M)", kMixed + value(M::is)},
                                   {"(M, IU)", kMixed + value(M::iu)},
                                   {"(IU, M)", kMixed + value(M::iu)},
                                   {"(M, S2RND)", kMixed + value(M::s2rnd)},
                                   {"(S2RND, M)", kMixed + value(M::s2rnd)},
                                   {"(M, ISS2)", kMixed + value(M::iss2)},
                                   {"(ISS2, M)", kMixed + value(M::iss2)}};
constexpr std::size_t kPlainWordModes = 6;
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
      return std::span(kAccumulateModes).first(kPlainAccumulateModes);
    case OperandKind::accumulate_mode_m:
      return kAccumulateModes;
    case OperandKind::half_mode:
      return std::span(kHalfModes).first(kPlainHalfModes);
    case OperandKind::half_mode_m:
      return kHalfModes;
    case OperandKind::word_mode:
      return std::span(kWordModes).first(kPlainWordModes);
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
