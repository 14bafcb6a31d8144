// 16-bit-long arithmetic, logic, shifts and bits, and pointer arithmetic: never in a packet
// (Programming Reference chapters 12 to 15).
#include <isa_sim/isa/semantics.hpp>
#include <isa_sim/isa/table.hpp>

namespace finback::isa {

namespace {

using u32 = std::uint32_t;

constexpr Instruction form(std::string_view syntax, Execute execute) {
  return {.syntax = syntax, .length = 2, .execute = execute};
}
// Pointer arithmetic happens in stage AC and stalls nobody.
constexpr Instruction pointer_form(std::string_view syntax, Execute execute) {
  return {.syntax = syntax, .length = 2, .result = Result::pointer, .execute = execute};
}

template <auto operation>
constexpr auto kLogic = [](ExecutionState& s, const Operation& o) {
  const u32 result = operation(reg(s, o[1]), reg(s, o[2]));
  reg(s, o[0]) = result;
  set_logic_flags(s, result);
};
// reg[0] = operation(reg[0], operand 1), with the flags of logic and shifts.
template <auto operation, bool immediate>
constexpr auto kUpdate = [](ExecutionState& s, const Operation& o) {
  const u32 result = operation(reg(s, o[0]), immediate ? static_cast<u32>(o[1]) : reg(s, o[1]));
  reg(s, o[0]) = result;
  set_az_an(s, result);
  s.v = 0;
};
template <auto operation>
constexpr auto kBit = [](ExecutionState& s, const Operation& o) {
  const u32 result = operation(reg(s, o[0]), u32{1} << o[1]);
  reg(s, o[0]) = result;
  set_logic_flags(s, result);
};

constexpr auto kAnd = [](u32 a, u32 b) { return a & b; };
constexpr auto kOr = [](u32 a, u32 b) { return a | b; };
constexpr auto kXor = [](u32 a, u32 b) { return a ^ b; };
constexpr auto kAndNot = [](u32 a, u32 b) { return a & ~b; };
// Amounts of 32 and more empty the register.
constexpr auto kLeft = [](u32 a, u32 amount) { return amount > 31 ? 0 : a << amount; };
constexpr auto kRight = [](u32 a, u32 amount) { return amount > 31 ? 0 : a >> amount; };
constexpr auto kRightArithmetic = [](u32 a, u32 amount) {
  return static_cast<u32>(static_cast<std::int32_t>(a) >> (amount > 31 ? 31 : amount));
};

template <int shift>
constexpr auto kAddAndShift = [](ExecutionState& s, const Operation& o) {
  const std::int64_t exact = (std::int64_t{signed_reg(s, o[0])} + signed_reg(s, o[1])) << shift;
  const auto result = static_cast<u32>(exact);
  reg(s, o[0]) = result;
  set_az_an(s, result);
  set_overflow(s, exact != static_cast<std::int32_t>(result));
};

// Pd = Pa + (Pb << shift)
template <int shift>
constexpr auto kPointerAdd = [](ExecutionState& s, const Operation& o) {
  reg(s, o[0]) = reg(s, o[1]) + (reg(s, o[2]) << shift);
};
template <int amount>
constexpr auto kPointerLeft =
    [](ExecutionState& s, const Operation& o) { reg(s, o[0]) = reg(s, o[1]) << amount; };
template <int amount>
constexpr auto kPointerRight =
    [](ExecutionState& s, const Operation& o) { reg(s, o[0]) = reg(s, o[1]) >> amount; };
// Signed divide primitives: bit by bit, quotient grows in the low half (Programming Reference, DIVS
// and DIVQ).
u32 divide_step(u32 pair, std::uint16_t remainder, std::uint32_t bit) {
  return (((pair << 1) | bit) & 0x1ffff) | (u32{remainder} << 17);
}
constexpr auto kDivideSign = [](ExecutionState& s, const Operation& o) {
  const auto remainder = static_cast<std::uint16_t>(reg(s, o[0]) >> 16);
  const auto divisor = static_cast<std::uint16_t>(reg(s, o[1]));
  s.aq = static_cast<std::uint8_t>((remainder ^ divisor) >> 15);
  reg(s, o[0]) = divide_step(reg(s, o[0]), remainder, s.aq);
};
constexpr auto kDivideQuotient = [](ExecutionState& s, const Operation& o) {
  const auto upper = static_cast<std::uint16_t>(reg(s, o[0]) >> 16);
  const auto divisor = static_cast<std::uint16_t>(reg(s, o[1]));
  const auto remainder = static_cast<std::uint16_t>(s.aq != 0 ? upper + divisor : upper - divisor);
  s.aq = static_cast<std::uint8_t>((remainder ^ divisor) >> 15);
  reg(s, o[0]) = divide_step(reg(s, o[0]), remainder, s.aq ^ 1u);
};

constexpr Instruction kTable[] = {
    // data registers, three operands
    form("{D!} = {D} + {D}", plain<[](ExecutionState& s, const Operation& o) {
           reg(s, o[0]) = add32(s, reg(s, o[1]), reg(s, o[2]));
         }>),
    form("{D!} = {D} - {D}", plain<[](ExecutionState& s, const Operation& o) {
           reg(s, o[0]) = subtract32(s, reg(s, o[1]), reg(s, o[2]));
         }>),
    form("{D!} = {D} & {D}", plain<kLogic<kAnd>>),
    form("{D!} = {D} | {D}", plain<kLogic<kOr>>),
    form("{D!} = {D} ^ {D}", plain<kLogic<kXor>>),
    // two operands
    form("{D+} += {imm7}", plain<[](ExecutionState& s, const Operation& o) {
           reg(s, o[0]) = add32(s, reg(s, o[0]), static_cast<u32>(o[1]));
         }>),
    form("{D!} = -{D}", plain<[](ExecutionState& s, const Operation& o) {
           reg(s, o[0]) = subtract32(s, 0, reg(s, o[1]));
         }>),
    form("{D!} = ~{D}", plain<[](ExecutionState& s, const Operation& o) {
           reg(s, o[0]) = ~reg(s, o[1]);
           set_logic_flags(s, reg(s, o[0]));
         }>),
    {.syntax = "{D+} *= {D}",
     .length = 2,
     .issue = Issue::multiply32,
     .needs = Needs::ex1,
     .energy = Energy::mac,
     .execute = plain<[](ExecutionState& s, const Operation& o) { reg(s, o[0]) *= reg(s, o[1]); }>,
     .meaning = "32-bit multiply, low word"},
    form("{D+} = ({=0} + {D}) << 1", plain<kAddAndShift<1>>),
    form("{D+} = ({=0} + {D}) << 2", plain<kAddAndShift<2>>),
    form("{D+} <<= {uimm5}", plain<kUpdate<kLeft, true>>),
    form("{D+} >>= {uimm5}", plain<kUpdate<kRight, true>>),
    form("{D+} >>>= {uimm5}", plain<kUpdate<kRightArithmetic, true>>),
    form("{D+} <<= {D}", plain<kUpdate<kLeft, false>>),
    form("{D+} >>= {D}", plain<kUpdate<kRight, false>>),
    form("{D+} >>>= {D}", plain<kUpdate<kRightArithmetic, false>>),
    form("BITSET({D+}, {uimm5})", plain<kBit<kOr>>),
    form("BITCLR({D+}, {uimm5})", plain<kBit<kAndNot>>),
    form("BITTGL({D+}, {uimm5})", plain<kBit<kXor>>),
    {.syntax = "DIVS({D+}, {D})",
     .length = 2,
     .execute = plain<kDivideSign>,
     .meaning = "first step of a signed division"},
    {.syntax = "DIVQ({D+}, {D})",
     .length = 2,
     .execute = plain<kDivideQuotient>,
     .meaning = "one quotient bit"},

    // pointer registers
    pointer_form("{P!} = {P@} + {P@}", plain<kPointerAdd<0>>),
    pointer_form("{P!} = {P@} + ({P@} << 1)", plain<kPointerAdd<1>>),
    pointer_form("{P!} = {P@} + ({P@} << 2)", plain<kPointerAdd<2>>),
    pointer_form("{P@+} = ({=0} + {P@}) << 1", plain<[](ExecutionState& s, const Operation& o) {
                   reg(s, o[0]) = (reg(s, o[0]) + reg(s, o[1])) << 1;
                 }>),
    pointer_form("{P@+} = ({=0} + {P@}) << 2", plain<[](ExecutionState& s, const Operation& o) {
                   reg(s, o[0]) = (reg(s, o[0]) + reg(s, o[1])) << 2;
                 }>),
    pointer_form("{P!} = {P@} << 1", plain<kPointerLeft<1>>),
    pointer_form("{P!} = {P@} << 2", plain<kPointerLeft<2>>),
    pointer_form("{P!} = {P@} >> 1", plain<kPointerRight<1>>),
    pointer_form("{P!} = {P@} >> 2", plain<kPointerRight<2>>),
    pointer_form("{P@+} += {imm7}", plain<[](ExecutionState& s, const Operation& o) {
                   reg(s, o[0]) += static_cast<u32>(o[1]);
                 }>),
    pointer_form(
        "{P@+} -= {P@}",
        plain<[](ExecutionState& s, const Operation& o) { reg(s, o[0]) -= reg(s, o[1]); }>),
    pointer_form("{P@+} += {P@} (BREV)", plain<[](ExecutionState& s, const Operation& o) {
                   reg(s, o[0]) = add_reversed(reg(s, o[0]), reg(s, o[1]));
                 }>),

    // index registers; a 16-bit form that may stand in slot 1
    {.syntax = "{I@+} += {M@}",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) {
       advance_index(s, o[0], signed_reg(s, o[1]));
     }>},
    {.syntax = "{I@+} += {M@} (BREV)",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) {
       reg(s, o[0]) = add_reversed(reg(s, o[0]), reg(s, o[1]));
     }>,
     .meaning = "the carry runs to the right; no circular buffer"},
    {.syntax = "{I@+} -= {M@}",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) {
       retreat_index(s, o[0], signed_reg(s, o[1]));
     }>},
    {.syntax = "{I@+} += 2",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) { advance_index(s, o[0], 2); }>},
    {.syntax = "{I@+} += 4",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) { advance_index(s, o[0], 4); }>},
    {.syntax = "{I@+} -= 2",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) { advance_index(s, o[0], -2); }>},
    {.syntax = "{I@+} -= 4",
     .length = 2,
     .slot = Slot::access,
     .result = Result::pointer,
     .execute = plain<[](ExecutionState& s, const Operation& o) { advance_index(s, o[0], -4); }>},
};

}  // namespace

std::span<const Instruction> arithmetic_instructions() { return kTable; }

}  // namespace finback::isa
