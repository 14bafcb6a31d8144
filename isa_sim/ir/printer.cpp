#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>

#include <isa_sim/ir/printer.hpp>
#include <isa_sim/isa/pattern.hpp>

namespace finback::ir {
namespace {

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c < ' ' || c > '~') {
      result += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

class Printer {
 public:
  explicit Printer(const isa::Syntax& syntax) : syntax_(syntax) {}

  std::string run(const Program& program) {
    line(".bir 1");
    for (std::size_t i = 1; i < program.source_files.size(); ++i) {
      if (!program.source_files[i].empty()) {
        line(".file {} {}", i, quoted_text(program.source_files[i]));
      }
    }
    for (const Function& function : program.functions) {
      print_function(function);
    }
    for (const Object& object : program.objects) {
      print_object(object);
    }
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  void enter(const std::string& section, bool code) {
    if (section == section_ && code == section_code_) {
      return;
    }
    section_ = section;
    section_code_ = code;
    static constexpr std::array<std::string_view, 3> kNamed = {".text", ".data", ".bss"};
    if (std::ranges::count(kNamed, section) > 0 && (section == ".text") == code) {
      line("{}", section);
    } else if (section == ".rodata" && !code) {
      line(".section .rodata");
    } else {
      line(".section {},\"{}\"", section, code ? "ax" : "aw");
    }
  }

  void print_head(const std::string& name, Binding binding, std::uint32_t align,
                  std::string_view type) {
    if (binding != Binding::local) {
      line("{} {}", binding == Binding::weak ? ".weak" : ".global", name);
    }
    line(".type {}, @{}", name, type);
    line(".align {}", align);
    line("{}:", name);
  }

  void print_function(const Function& function) {
    enter(function.section, true);
    print_head(function.name, function.binding, function.align, "function");
    std::vector<std::vector<std::string_view>> labels(function.packets.size() + 1);
    for (const auto& [label, packet] : function.labels) {
      labels[packet].push_back(label);
    }
    int file = 0;
    int source_line = 0;
    for (std::size_t i = 0; i <= function.packets.size(); ++i) {
      for (const std::string_view label : labels[i]) {
        line("{}:", label);
      }
      if (i == function.packets.size()) {
        break;
      }
      const Packet& packet = function.packets[i];
      if (packet.file != file || packet.line != source_line) {
        file = packet.file;
        source_line = packet.line;
        line("  .loc {} {}", file, source_line);
      }
      line("  {};", print(packet, syntax_));
    }
    line(".size {}, .-{}", function.name, function.name);
  }

  void print_object(const Object& object) {
    enter(object.section, false);
    print_head(object.name, object.binding, object.align, "object");
    std::uint32_t offset = 0;
    for (const Relocation& relocation : object.relocations) {
      print_bytes(object, offset, relocation.offset);
      const OperandValue value{relocation.addend, relocation.symbol};
      line("  .byte4 {}", isa::print_operand(isa::OperandKind::pc24, value));
      offset = relocation.offset + 4;
    }
    print_bytes(object, offset, object.size);
    line(".size {}, {}", object.name, object.size);
  }

  // The initial bytes of [offset, end), sixteen a line, then what is zero.
  void print_bytes(const Object& object, std::uint32_t offset, std::uint32_t end) {
    const auto given = static_cast<std::uint32_t>(object.initial.size());
    while (offset < end && offset < given) {
      const std::uint32_t count = std::min({16u, end - offset, given - offset});
      const auto from = object.initial.begin() + offset;
      line("  .byte {}", fmt::join(from, from + count, ","));
      offset += count;
    }
    if (offset < end) {
      line("  .space {}", end - offset);
    }
  }

  const isa::Syntax& syntax_;
  std::string text_;
  std::string section_;
  bool section_code_ = false;
};

}  // namespace

std::string print(const Packet& packet, const isa::Syntax& syntax) {
  std::string text;
  for (const ParsedInstruction& instruction : packet.slots) {
    text += text.empty() ? "" : " || ";
    text += syntax.print(instruction);
  }
  return text;
}

std::string print(const Program& program, const isa::Syntax& syntax) {
  return Printer(syntax).run(program);
}

std::string print(const Program& program) { return print(program, isa::instruction_syntax()); }

}  // namespace finback::ir
