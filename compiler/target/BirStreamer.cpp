#include "BirStreamer.hpp"

#include <llvm/ADT/StringExtras.h>
#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCExpr.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstPrinter.h>
#include <llvm/MC/MCSection.h>
#include <llvm/MC/MCSymbol.h>
#include <llvm/Support/Casting.h>
#include <llvm/Support/ErrorHandling.h>
#include <llvm/Support/raw_ostream.h>

namespace llvm {
namespace {

constexpr size_t kValuesPerLine = 16;

const char* directive_of(unsigned size) {
  switch (size) {
    case 1:
      return ".byte";
    case 2:
      return ".byte2";
    case 4:
      return ".byte4";
    default:
      report_fatal_error("a value of a size that BIR has no directive for");
  }
}

}  // namespace

BirStreamer::BirStreamer(MCContext& context, raw_ostream& out,
                         std::unique_ptr<MCInstPrinter> printer)
    : MCStreamer(context), out_(out), printer_(std::move(printer)) {}

BirStreamer::~BirStreamer() = default;

void BirStreamer::emitRawTextImpl(StringRef text) {
  flush_values();
  if (in_assembly_) {
    text = text.trim();
    if (!text.empty())
      out_ << "  " << text << (text.ends_with(";") ? "\n" : ";\n");
    return;
  }
  out_ << text;
  if (!text.ends_with("\n"))
    out_ << '\n';
}

void BirStreamer::changeSection(MCSection* section, uint32_t subsection) {
  MCStreamer::changeSection(section, subsection);
  flush_values();
  StringRef name = section->getName();
  if (name == ".text" || name == ".data" || name == ".bss")
    out_ << name << '\n';
  else
    out_ << ".section " << name << '\n';
}

void BirStreamer::emitLabel(MCSymbol* symbol, SMLoc loc) {
  flush_values();
  MCStreamer::emitLabel(symbol, loc);
  // LLVM's own notes of where a section or function begins and ends; nobody refers to them.
  if (symbol->getName().empty() || symbol->getName().starts_with(".Lfunc_"))
    return;
  symbol->print(out_, getContext().getAsmInfo());
  out_ << ":\n";
}

void BirStreamer::emitInstruction(const MCInst& inst, const MCSubtargetInfo& subtarget) {
  emitPacket(inst, subtarget);
}

void BirStreamer::emitPacket(ArrayRef<MCInst> insts, const MCSubtargetInfo& subtarget) {
  flush_values();
  out_ << "  ";
  ListSeparator separator(" || ");
  for (const MCInst& inst : insts) {
    std::string text;
    raw_string_ostream stream(text);
    printer_->printInst(&inst, 0, "", subtarget, stream);
    out_ << separator << StringRef(stream.str()).trim();
  }
  if (insts.size() == 2)
    out_ << separator << "NOP";
  out_ << ";\n";
}

void BirStreamer::flush_values() {
  if (values_.empty())
    return;
  out_ << "  " << directive_of(value_size_) << ' ';
  ListSeparator comma(", ");
  for (uint64_t value : values_)
    out_ << comma << value;
  out_ << '\n';
  values_.clear();
}

void BirStreamer::emitIntValue(uint64_t value, unsigned size) {
  if (size == 8) {
    emitIntValue(value & 0xffffffff, 4);
    emitIntValue(value >> 32, 4);
    return;
  }
  if (size != value_size_ || values_.size() == kValuesPerLine)
    flush_values();
  value_size_ = size;
  values_.push_back(size < 8 ? value & ((uint64_t{1} << (8 * size)) - 1) : value);
}

void BirStreamer::emitBytes(StringRef data) {
  StringRef text = data.drop_back(data.ends_with(StringRef("\0", 1)) ? 1 : 0);
  bool readable =
      data.size() > 1 && all_of(text, [](char c) { return isPrint(c) && c != '"' && c != '\\'; });
  if (readable) {
    flush_values();
    out_ << (text.size() == data.size() ? "  .ascii \"" : "  .asciz \"") << text << "\"\n";
    return;
  }
  for (char c : data)
    emitIntValue(static_cast<unsigned char>(c), 1);
}

void BirStreamer::emitValueImpl(const MCExpr* value, unsigned size, SMLoc) {
  if (const auto* constant = dyn_cast<MCConstantExpr>(value)) {
    emitIntValue(static_cast<uint64_t>(constant->getValue()), size);
    return;
  }
  flush_values();
  out_ << "  " << directive_of(size) << ' ';
  value->print(out_, getContext().getAsmInfo());
  out_ << '\n';
}

void BirStreamer::emitFill(const MCExpr& bytes, uint64_t value, SMLoc) {
  flush_values();
  out_ << "  .space ";
  bytes.print(out_, getContext().getAsmInfo());
  if (value != 0)
    out_ << ", " << value;
  out_ << '\n';
}

void BirStreamer::emitValueToAlignment(Align alignment, int64_t, unsigned, unsigned) {
  flush_values();
  out_ << ".align " << alignment.value() << '\n';
}

void BirStreamer::finishImpl() { flush_values(); }

}  // namespace llvm
