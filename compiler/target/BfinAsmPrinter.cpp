#include "BfinAsmPrinter.hpp"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/CodeGen/MachineInstr.h>
#include <llvm/CodeGen/MachineJumpTableInfo.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Module.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCExpr.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstBuilder.h>
#include <llvm/MC/MCSectionELF.h>
#include <llvm/MC/MCSymbol.h>
#include <map>

#include "BfinInstPrinter.hpp"
#include "BfinMCTargetDesc.hpp"
#include "BfinSubtarget.hpp"
#include "BirStreamer.hpp"

namespace llvm {
namespace {

class BfinAsmPrinter : public AsmPrinter {
 public:
  BfinAsmPrinter(TargetMachine& machine, std::unique_ptr<BirStreamer> streamer)
      : AsmPrinter(machine, std::move(streamer)) {}

  StringRef getPassName() const override { return "BIR printer"; }
  void emitStartOfAsmFile(Module& module) override;
  void emitGlobalVariable(const GlobalVariable* global) override;
  void emitFunctionEntryLabel() override;
  void emitFunctionBodyEnd() override;
  void emitLinkage(const GlobalValue*, MCSymbol*) const override {}
  void emitInstruction(const MachineInstr* inst) override;
  void emitInlineAsmStart() const override { bir().begin_assembly(); }
  void emitInlineAsmEnd(const MCSubtargetInfo&, const MCSubtargetInfo*) const override {
    bir().end_assembly();
  }
  void emitJumpTableInfo() override;
  bool PrintAsmOperand(const MachineInstr* inst, unsigned index, const char* modifier,
                       raw_ostream& out) override;
  bool PrintAsmMemoryOperand(const MachineInstr* inst, unsigned index, const char* modifier,
                             raw_ostream& out) override;
  void emitImplicitDef(const MachineInstr*) const override {}

 private:
  BirStreamer& bir() const { return static_cast<BirStreamer&>(*OutStreamer); }
  void write(const Twine& line) { OutStreamer->emitRawText(line); }
  void write_name(const GlobalValue& global, const MCSymbol& symbol, StringRef type, Align align);
  void add_file(StringRef path);
  void write_location(const MachineInstr& inst);
  void write_place(StringRef path, unsigned line, unsigned column);
  MCSymbol* jump_table(unsigned index);
  MCInst lower(const MachineInstr& inst);
  MCOperand lower_operand(const MachineOperand& operand);

  std::map<std::string, unsigned, std::less<>> files_;
  std::tuple<unsigned, unsigned, unsigned> last_location_;
};

void BfinAsmPrinter::add_file(StringRef path) {
  auto [entry, added] = files_.try_emplace(path.str(), files_.size() + 1);
  if (added)
    write(".file " + Twine(entry->second) + " \"" + entry->first + "\"");
}

void BfinAsmPrinter::emitStartOfAsmFile(Module& module) {
  write(".bir 1");
  // The C file itself first, then the headers that left code in it.
  for (const DICompileUnit* unit : module.debug_compile_units())
    add_file(unit->getFilename());
  for (const Function& function : module) {
    if (const DISubprogram* subprogram = function.getSubprogram();
        subprogram != nullptr && !function.isDeclaration())
      add_file(subprogram->getFilename());
    for (const BasicBlock& block : function)
      for (const Instruction& inst : block)
        if (const DILocation* location = inst.getDebugLoc().get())
          add_file(location->getFilename());
  }
}

void BfinAsmPrinter::write_name(const GlobalValue& global, const MCSymbol& symbol, StringRef type,
                                Align align) {
  if (global.hasWeakLinkage() || global.hasLinkOnceLinkage())
    write(".weak " + symbol.getName());
  else if (!global.hasLocalLinkage())
    write(".global " + symbol.getName());
  write(".type " + symbol.getName() + ", @" + type);
  write(".align " + Twine(align.value()));
}

static StringRef section_of(const GlobalVariable& global) {
  if (global.hasSection())
    return global.getSection();
  if (global.isConstant())
    return ".rodata";
  return global.getInitializer()->isNullValue() ? ".bss" : ".data";
}

void BfinAsmPrinter::emitGlobalVariable(const GlobalVariable* global) {
  if (!global->hasInitializer() || global->hasAvailableExternallyLinkage() ||
      global->getSection() == "llvm.metadata" || global->getName().starts_with("llvm."))
    return;
  const DataLayout& layout = getDataLayout();
  MCSymbol* symbol = getSymbol(global);
  OutStreamer->switchSection(
      OutContext.getELFSection(section_of(*global), ELF::SHT_PROGBITS, ELF::SHF_ALLOC));
  write_name(*global, *symbol, "object", getGVAlignment(global, layout));
  OutStreamer->emitLabel(symbol);
  // An empty struct takes a byte, as in C++: every object has an address of its own.
  uint64_t size = layout.getTypeAllocSize(global->getValueType());
  if (size != 0)
    emitGlobalConstant(layout, global->getInitializer());
  else
    OutStreamer->emitZeros(1);
  write(".size " + symbol->getName() + ", " + Twine(std::max<uint64_t>(size, 1)));
}

void BfinAsmPrinter::emitFunctionEntryLabel() {
  last_location_ = {};
  write_name(MF->getFunction(), *CurrentFnSym, "function", MF->getAlignment());
  OutStreamer->emitLabel(CurrentFnSym);
  // The prologue has no place of its own in the source: it belongs to the function's line.
  if (const DISubprogram* subprogram = MF->getFunction().getSubprogram())
    write_place(subprogram->getFilename(), subprogram->getLine(), 0);
}

void BfinAsmPrinter::emitFunctionBodyEnd() {
  write(".size " + CurrentFnSym->getName() + ", .-" + CurrentFnSym->getName());
}

void BfinAsmPrinter::write_location(const MachineInstr& inst) {
  if (const DILocation* location = inst.getDebugLoc().get())
    write_place(location->getFilename(), location->getLine(), location->getColumn());
}

void BfinAsmPrinter::write_place(StringRef path, unsigned line, unsigned column) {
  auto file = files_.find(path);
  if (line == 0 || file == files_.end())
    return;
  std::tuple place(file->second, line, column);
  if (place == last_location_)
    return;
  last_location_ = place;
  write("  .loc " + Twine(file->second) + " " + Twine(line) + " " + Twine(column));
}

/// No C name has a dot.
MCSymbol* BfinAsmPrinter::jump_table(unsigned index) {
  return OutContext.getOrCreateSymbol(CurrentFnSym->getName() + ".jumps" + Twine(index));
}

/// Objects of their own, so that each can be placed: addresses of the function's labels.
void BfinAsmPrinter::emitJumpTableInfo() {
  const MachineJumpTableInfo* info = MF->getJumpTableInfo();
  if (info == nullptr)
    return;
  for (const auto& [index, table] : enumerate(info->getJumpTables())) {
    if (table.MBBs.empty())
      continue;
    MCSymbol* symbol = jump_table(static_cast<unsigned>(index));
    OutStreamer->switchSection(
        OutContext.getELFSection(".rodata", ELF::SHT_PROGBITS, ELF::SHF_ALLOC));
    write(".type " + symbol->getName() + ", @object");
    write(".align 4");
    OutStreamer->emitLabel(symbol);
    for (const MachineBasicBlock* block : table.MBBs)
      OutStreamer->emitValue(MCSymbolRefExpr::create(block->getSymbol(), OutContext), 4);
    write(".size " + symbol->getName() + ", " + Twine(4 * table.MBBs.size()));
  }
}

MCOperand BfinAsmPrinter::lower_operand(const MachineOperand& operand) {
  const MCSymbol* symbol = nullptr;
  int64_t offset = 0;
  switch (operand.getType()) {
    case MachineOperand::MO_Register:
      return MCOperand::createReg(operand.getReg());
    case MachineOperand::MO_Immediate:
      return MCOperand::createImm(operand.getImm());
    case MachineOperand::MO_MachineBasicBlock:
      symbol = operand.getMBB()->getSymbol();
      break;
    case MachineOperand::MO_GlobalAddress:
      symbol = getSymbol(operand.getGlobal());
      offset = operand.getOffset();
      break;
    case MachineOperand::MO_ExternalSymbol:
      symbol = GetExternalSymbolSymbol(operand.getSymbolName());
      break;
    case MachineOperand::MO_MCSymbol:
      symbol = operand.getMCSymbol();
      break;
    case MachineOperand::MO_JumpTableIndex:
      symbol = jump_table(static_cast<unsigned>(operand.getIndex()));
      break;
    case MachineOperand::MO_BlockAddress:
      symbol = GetBlockAddressSymbol(operand.getBlockAddress());
      offset = operand.getOffset();
      break;
    case MachineOperand::MO_ConstantPoolIndex:
      symbol = GetCPISymbol(static_cast<unsigned>(operand.getIndex()));
      break;
    default:
      report_fatal_error("an operand that BIR has no text for");
  }
  const MCExpr* value = MCSymbolRefExpr::create(symbol, OutContext);
  if (offset != 0)
    value = MCBinaryExpr::createAdd(value, MCConstantExpr::create(offset, OutContext), OutContext);
  return MCOperand::createExpr(value);
}

MCInst BfinAsmPrinter::lower(const MachineInstr& inst) {
  MCInst result;
  result.setOpcode(inst.getOpcode());
  for (const MachineOperand& operand : inst.operands())
    if (!operand.isRegMask() && !(operand.isReg() && operand.isImplicit()))
      result.addOperand(lower_operand(operand));
  return result;
}

void BfinAsmPrinter::emitInstruction(const MachineInstr* inst) {
  if (inst->getOpcode() == Bfin::ENDLOOP)
    return;  // the loop's end is a label
  SmallVector<MCInst, 3> packet;
  if (!inst->isBundle()) {
    write_location(*inst);
    packet.push_back(lower(*inst));
  } else {
    auto it = std::next(inst->getIterator());
    write_location(*it);
    for (; it != inst->getParent()->instr_end() && it->isInsideBundle(); ++it)
      packet.push_back(lower(*it));
    // Within the bundle reads stand before writes; the text has the slots in their order.
    const auto slot = [&](const MCInst& one) {
      return BfinII::getSlot(MF->getSubtarget().getInstrInfo()->get(one.getOpcode()));
    };
    stable_sort(packet, [&](const MCInst& a, const MCInst& b) { return slot(a) < slot(b); });
    if (slot(packet.front()) != BfinII::kDspSlot)
      packet.insert(packet.begin(), MCInstBuilder(Bfin::MNOP));
  }
  bir().emitPacket(packet, getSubtargetInfo());
}

/// Modifiers as GCC has them: %h0 is the low half of a register, %d0 the high one. True: an error.
bool BfinAsmPrinter::PrintAsmOperand(const MachineInstr* inst, unsigned index, const char* modifier,
                                     raw_ostream& out) {
  const MachineOperand& operand = inst->getOperand(index);
  const char which = modifier == nullptr ? 0 : modifier[0];
  if (which == 0 && !operand.isReg()) {
    const MCOperand value = lower_operand(operand);
    if (value.isImm())
      out << value.getImm();
    else
      value.getExpr()->print(out, MAI);
    return false;
  }
  if (!operand.isReg() || (which != 0 && which != 'h' && which != 'd'))
    return AsmPrinter::PrintAsmOperand(inst, index, modifier, out);
  out << BfinInstPrinter::getRegisterName(operand.getReg())
      << (which == 'h'   ? ".L"
          : which == 'd' ? ".H"
                         : "");
  return false;
}

bool BfinAsmPrinter::PrintAsmMemoryOperand(const MachineInstr* inst, unsigned index,
                                           const char* modifier, raw_ostream& out) {
  if (modifier != nullptr)
    return true;
  out << '[' << BfinInstPrinter::getRegisterName(inst->getOperand(index).getReg()) << ']';
  return false;
}

}  // namespace

AsmPrinter* createBfinAsmPrinter(TargetMachine& machine, std::unique_ptr<BirStreamer> streamer) {
  return new BfinAsmPrinter(machine, std::move(streamer));
}

}  // namespace llvm
