// Writes BIR text: sections, labels, values. What a line means is GNU as's business; nothing here
// knows an encoding.
#pragma once

#include <llvm/MC/MCStreamer.h>

namespace llvm {

class MCInstPrinter;

class BirStreamer : public MCStreamer {
 public:
  BirStreamer(MCContext& context, raw_ostream& out, std::unique_ptr<MCInstPrinter> printer);
  ~BirStreamer() override;

  bool hasRawTextSupport() const override { return true; }
  void emitRawTextImpl(StringRef text) override;
  void initSections(bool, const MCSubtargetInfo&) override {}
  void changeSection(MCSection* section, uint32_t subsection) override;
  void emitLabel(MCSymbol* symbol, SMLoc loc) override;
  void emitInstruction(const MCInst& inst, const MCSubtargetInfo& subtarget) override;
  bool emitSymbolAttribute(MCSymbol*, MCSymbolAttr) override { return true; }
  void emitCommonSymbol(MCSymbol*, uint64_t, Align) override {}
  void emitZerofill(MCSection*, MCSymbol*, uint64_t, Align, SMLoc) override {}
  void emitBytes(StringRef data) override;
  void emitIntValue(uint64_t value, unsigned size) override;
  void emitValueImpl(const MCExpr* value, unsigned size, SMLoc loc) override;
  void emitFill(const MCExpr& bytes, uint64_t value, SMLoc loc) override;
  void emitValueToAlignment(Align alignment, int64_t value, unsigned value_size,
                            unsigned max_bytes) override;
  void emitCodeAlignment(Align, const MCSubtargetInfo*, unsigned) override {}
  void finishImpl() override;

  /// Between them, raw text is instructions that somebody wrote by hand.
  void begin_assembly() { in_assembly_ = true; }
  void end_assembly() { in_assembly_ = false; }

  /// The packet's instructions, joined; an empty slot 2 is written as NOP.
  void emitPacket(ArrayRef<MCInst> insts, const MCSubtargetInfo& subtarget);

 private:
  void flush_values();

  raw_ostream& out_;
  std::unique_ptr<MCInstPrinter> printer_;
  // Numbers of one size that share a line.
  SmallVector<uint64_t, 16> values_;
  unsigned value_size_ = 0;
  bool in_assembly_ = false;
};

}  // namespace llvm
