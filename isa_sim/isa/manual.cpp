#include <fmt/format.h>
#include <string>
#include <vector>

#include <isa_sim/isa/instruction.hpp>
#include <isa_sim/isa/manual.hpp>

namespace finback::isa {

namespace {

constexpr const char* kHead =
    R"(# Instructions

Every instruction that Finback knows, in the order in which the assembler tries them: where two
forms read the same text, the first whose immediates fit is taken. This page is generated from the
table in `isa_sim/isa/table_*.cpp`: `finback isa` prints it. The names of operand kinds (`D` a data
register, `Dl` its low half, `off4x4` a multiple of 4 from 0 to 60, ...) are explained in
[bir.md](bir.md).

**slot**: where it may stand in a packet: `dsp` first, `access` second, `index_access` second or
third. **cycles**: 1, or the parameter that says ([machine-parameters.md](machine-parameters.md)).
**result**: when others can use it: `alu` at the end of EX2, `load` at the start of EX1, `move` late
for addresses, `pointer` at once. **needs**: the stage in which it wants its data operands.

| instruction | bytes | slot | cycles | result | needs | meaning |
|---|---|---|---|---|---|---|
)";

std::string_view slot_name(Slot slot) {
  switch (slot) {
    case Slot::alone:
      return "alone";
    case Slot::dsp:
      return "dsp";
    case Slot::access:
      return "access";
    case Slot::index_access:
      return "index_access";
    case Slot::nop:
      return "nop";
  }
  return "";
}

std::string_view cycles_text(const Instruction& info) {
  switch (info.issue) {
    case Issue::one:
      break;
    case Issue::multiply32:
      return "`core.issue.multiply32_cycles`";
    case Issue::link:
      return "`core.issue.link_cycles`";
    case Issue::unlink:
      return "`core.issue.unlink_cycles`";
    case Issue::core_sync:
      return "`core.issue.csync_cycles`";
    case Issue::system_sync:
      return "`core.issue.ssync_cycles`";
    case Issue::event:
      return "`core.issue.event_cycles`";
    case Issue::test_and_set:
      return "`core.issue.testset_cycles`";
    case Issue::register_list:
      return "one a register";
  }
  switch (info.flow) {
    case Flow::none:
    case Flow::loop_setup:
    case Flow::idle:
    case Flow::event:
      return "1";
    case Flow::branch:
      return "1, or `core.branch.mispredicted_cycles` when taken";
    case Flow::branch_predicted:
      return "`core.branch.taken_cycles`, or `core.branch.mispredicted_cycles` when not taken";
    default:
      return "`core.branch.taken_cycles`";
  }
}

std::string_view result_name(Result result) {
  switch (result) {
    case Result::alu:
      return "alu";
    case Result::load:
      return "load";
    case Result::move:
      return "move";
    case Result::pointer:
      return "pointer";
  }
  return "";
}

// A pattern as people write it: "{D!} = [{P@+}++]" becomes "D = [P++]", "{=0}" the name of operand
// 0; `|` is escaped for the table.
std::string readable(std::string_view syntax) {
  std::string text;
  std::vector<std::string> names;
  while (!syntax.empty()) {
    if (syntax.front() != '{') {
      text += syntax.front() == '|' ? "\\|" : std::string(1, syntax.front());
      syntax.remove_prefix(1);
      continue;
    }
    std::string inside(syntax.substr(1, syntax.find('}') - 1));
    syntax.remove_prefix(inside.size() + 2);
    std::erase_if(inside, [](char c) { return c == '!' || c == '+' || c == '@' || c == '?'; });
    if (const auto kind = kind_by_name(inside); kind && is_choice(*kind)) {
      text += text.ends_with(' ') ? "" : " ";
      inside = fmt::format("<{}>", inside);
    }
    if (inside.starts_with('=')) {
      inside = names.at(static_cast<std::size_t>(inside[1] - '0'));
    } else {
      names.push_back(inside);
    }
    text += inside;
  }
  return text;
}

}  // namespace

std::string instructions_as_markdown() {
  std::string page = kHead;
  for (const Instruction& info : instruction_table()) {
    page +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", readable(info.syntax), info.length,
                    slot_name(info.slot), cycles_text(info), result_name(info.result),
                    info.needs == Needs::ex1 ? "EX1" : "EX2", info.meaning);
  }
  return page;
}

}  // namespace finback::isa
