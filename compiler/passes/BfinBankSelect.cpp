// Selection leaves 32-bit values in the union of the data and the pointer registers. This pass says
// for each which of the two it lives in, so that the copies between them cost least: a minimal cut
// of the graph of definitions and uses, weighed by how often each block runs.
#include <llvm/CodeGen/MachineBlockFrequencyInfo.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/InitializePasses.h>
#include <map>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "MinCut.hpp"

namespace llvm {
namespace {

using finback::compiler::MinCut;

enum class Bank { kData, kPointer, kEither };

/// The two machine instructions behind a selected one, and whether the pointer form overwrites its
/// first source.
struct Forms {
  unsigned data;
  unsigned pointer;
};

Forms forms_of(unsigned opcode) {
  switch (opcode) {
    case Bfin::ADD_X:
      return {Bfin::ADD, Bfin::ADDP};
    case Bfin::SUB_X:
      return {Bfin::SUB, Bfin::SUBP};
    case Bfin::SHL_X:
      return {Bfin::SHLI, Bfin::SHLP};
    case Bfin::SRL_X:
      return {Bfin::SRLI, Bfin::SRLP};
    case Bfin::CMPEQ_X:
      return {Bfin::CMPEQ, Bfin::CMPEQP};
    case Bfin::CMPLT_X:
      return {Bfin::CMPLT, Bfin::CMPLTP};
    case Bfin::CMPLE_X:
      return {Bfin::CMPLE, Bfin::CMPLEP};
    case Bfin::CMPULT_X:
      return {Bfin::CMPULT, Bfin::CMPULTP};
    case Bfin::CMPULE_X:
      return {Bfin::CMPULE, Bfin::CMPULEP};
    default:
      return {0, 0};
  }
}

bool is_constant(const MachineInstr& inst) {
  switch (inst.getOpcode()) {
    case Bfin::MOVI:
    case Bfin::MOVU:
    case Bfin::LI32:
    case Bfin::LDSYM:
      return true;
    default:
      return false;
  }
}

// Cycles: a move costs its issue; towards the pointers an address use soon after waits, too.
constexpr int kToData = 2;
constexpr int kToPointer = 7;
constexpr int kUnit = 16;  // weight of a block that runs once per call

class BfinBankSelect : public MachineFunctionPass {
 public:
  static char ID;
  BfinBankSelect() : MachineFunctionPass(ID) {
    initializeMachineBlockFrequencyInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin bank selection"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineBlockFrequencyInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  bool is_value(const MachineOperand& operand) const;
  /// Do operands and result share a bank?
  bool is_joined(const MachineInstr& inst) const {
    return inst.isPHI() ? is_value(inst.getOperand(0)) : forms_of(inst.getOpcode()).data != 0;
  }
  int node(Register reg);
  int64_t weight(const MachineBasicBlock& block) const;
  void drop_copies(MachineFunction& function);
  void connect(MachineInstr& inst);
  void connect_copy(MachineInstr& copy);
  void nudge(const MachineInstr& inst, Register def);
  void require(Register reg, Bank bank, int64_t cost);
  void use_at(Register reg, int user);
  Bank operand_bank(const MachineInstr& inst, unsigned index) const;
  void constrain_result(const MachineInstr& inst, unsigned index);
  void rewrite(MachineInstr& inst);
  Register in_bank(Register reg, Bank bank);
  void set_bank(MachineInstr& inst, unsigned index, Bank bank);
  void fold_scaled_adds(MachineFunction& function);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  const MachineBlockFrequencyInfo* frequencies_ = nullptr;
  MinCut cut_;
  std::map<Register, int> nodes_;
  std::map<const MachineInstr*, int> compare_nodes_;
  std::map<Register, std::pair<int, int>> copies_;  // auxiliary nodes: to pointer, to data
  std::map<Register, bool> constrained_;
  std::map<Register, Bank> banks_;
  std::map<std::pair<Register, Bank>, Register> other_bank_;
};

char BfinBankSelect::ID = 0;

bool BfinBankSelect::is_value(const MachineOperand& operand) const {
  return operand.isReg() && operand.getReg().isVirtual() && !operand.isUndef() &&
         Bfin::DPRegClass.hasSubClassEq(regs_->getRegClass(operand.getReg()));
}

int64_t BfinBankSelect::weight(const MachineBasicBlock& block) const {
  double relative = frequencies_->getBlockFreqRelativeToEntryBlock(&block);
  return std::clamp<int64_t>(static_cast<int64_t>(relative * kUnit), 1, int64_t{1} << 30);
}

int BfinBankSelect::node(Register reg) {
  auto [entry, added] = nodes_.try_emplace(reg, 0);
  if (added) {
    entry->second = cut_.add_node();
    // Undecided values go to the data registers, of which there are more.
    cut_.add_edge(MinCut::kSource, entry->second, 1);
  }
  return entry->second;
}

/// Copies between virtual registers carry no meaning any more once banks are chosen anew.
void BfinBankSelect::drop_copies(MachineFunction& function) {
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : make_early_inc_range(block)) {
      if (!inst.isCopy() || !is_value(inst.getOperand(0)) || !is_value(inst.getOperand(1)) ||
          inst.getOperand(0).getSubReg() != 0 || inst.getOperand(1).getSubReg() != 0)
        continue;
      Register to = inst.getOperand(0).getReg();
      Register from = inst.getOperand(1).getReg();
      inst.eraseFromParent();
      regs_->setRegClass(from, &Bfin::DPRegClass);
      regs_->clearKillFlags(from);
      regs_->replaceRegWith(to, from);
      regs_->clearKillFlags(from);
    }
}

void BfinBankSelect::require(Register reg, Bank bank, int64_t cost) {
  constrained_[reg] = true;
  if (bank == Bank::kData)
    cut_.add_edge(MinCut::kSource, node(reg), cost);
  else
    cut_.add_edge(node(reg), MinCut::kSink, cost);
}

/// `user` is a node, or one of the cut's ends. However many users sit in the other bank, one copy
/// behind the definition serves them all: hence the two auxiliary nodes a value.
void BfinBankSelect::use_at(Register reg, int user) {
  constrained_[reg] = true;
  auto [entry, added] = copies_.try_emplace(reg);
  if (added) {
    MachineInstr* def = regs_->getVRegDef(reg);
    int64_t frequency = weight(*def->getParent());
    bool constant = is_constant(*def);
    entry->second = {cut_.add_node(), cut_.add_node()};
    cut_.add_edge(node(reg), entry->second.first, frequency * (constant ? kToData : kToPointer));
    cut_.add_edge(entry->second.second, node(reg), frequency * kToData);
  }
  cut_.add_edge(entry->second.first, user, MinCut::kInfinite);
  cut_.add_edge(user, entry->second.second, MinCut::kInfinite);
}

void BfinBankSelect::connect_copy(MachineInstr& copy) {
  const MachineOperand& to = copy.getOperand(0);
  const MachineOperand& from = copy.getOperand(1);
  int64_t frequency = weight(*copy.getParent());
  if (is_value(to) && from.getReg().isPhysical()) {
    bool pointer = Bfin::PRegClass.contains(from.getReg());
    require(to.getReg(), pointer ? Bank::kPointer : Bank::kData,
            frequency * (pointer ? kToData : kToPointer));
  } else if (is_value(from) && to.getReg().isPhysical()) {
    bool pointer = Bfin::PRegClass.contains(to.getReg());
    require(from.getReg(), pointer ? Bank::kPointer : Bank::kData,
            frequency * (pointer ? kToPointer : kToData));
  }
}

/// What the instruction's table says of one operand.
Bank BfinBankSelect::operand_bank(const MachineInstr& inst, unsigned index) const {
  const MCInstrDesc& desc = inst.getDesc();
  const TargetRegisterClass* wanted = nullptr;
  if (inst.isInlineAsm())
    wanted = inst.getRegClassConstraint(index, tii_, regs_->getTargetRegisterInfo());
  else if (index < desc.getNumOperands() && desc.operands()[index].RegClass >= 0)
    wanted = regs_->getTargetRegisterInfo()->getRegClass(desc.operands()[index].RegClass);
  if (wanted == nullptr)
    return Bank::kEither;
  return Bfin::DRegClass.hasSubClassEq(wanted)   ? Bank::kData
         : Bfin::PRegClass.hasSubClassEq(wanted) ? Bank::kPointer
                                                 : Bank::kEither;
}

/// Decides ties: scaled sums belong to addresses, where one instruction makes them; what is loaded
/// is at hand at once only in a data register.
void BfinBankSelect::nudge(const MachineInstr& inst, Register def) {
  if (inst.getOpcode() == Bfin::ADD_X || inst.getOpcode() == Bfin::SHL_X)
    cut_.add_edge(node(def), MinCut::kSink, 2);
  else if (inst.mayLoad())
    cut_.add_edge(MinCut::kSource, node(def), std::max<int64_t>(4, weight(*inst.getParent()) / 2));
}

void BfinBankSelect::connect(MachineInstr& inst) {
  if (inst.isCopy())
    return connect_copy(inst);
  bool joined = is_joined(inst);
  int user = -1;
  if (joined && inst.getNumExplicitDefs() == 1) {
    user = node(inst.getOperand(0).getReg());
  } else if (joined) {
    user = cut_.add_node();
    cut_.add_edge(MinCut::kSource, user, 1);
    compare_nodes_[&inst] = user;
  }
  for (unsigned i = 0; i < inst.getNumOperands(); ++i) {
    const MachineOperand& operand = inst.getOperand(i);
    if (!is_value(operand))
      continue;
    Bank bank = operand_bank(inst, i);
    if (operand.isDef()) {
      nudge(inst, operand.getReg());
      if (bank != Bank::kEither)
        require(operand.getReg(), bank, MinCut::kInfinite);
      if (joined)
        constrained_[operand.getReg()] = true;
    } else if (bank != Bank::kEither) {
      use_at(operand.getReg(), bank == Bank::kData ? MinCut::kSource : MinCut::kSink);
    } else if (joined) {
      use_at(operand.getReg(), user);
    } else if (operand.isTied()) {
      unsigned def = inst.findTiedOperandIdx(i);
      use_at(operand.getReg(), node(inst.getOperand(def).getReg()));
      constrained_[inst.getOperand(def).getReg()] = true;
    }
  }
}

/// The value in the other bank: the constant made again, or a copy right behind the definition.
Register BfinBankSelect::in_bank(Register reg, Bank bank) {
  if (banks_[reg] == bank || banks_[reg] == Bank::kEither)
    return reg;
  auto [entry, added] = other_bank_.try_emplace({reg, bank});
  if (!added)
    return entry->second;
  Register copy =
      regs_->createVirtualRegister(bank == Bank::kData ? &Bfin::DRegClass : &Bfin::PRegClass);
  entry->second = copy;
  banks_[copy] = bank;
  MachineInstr* def = regs_->getVRegDef(reg);
  MachineBasicBlock& block = *def->getParent();
  auto at = def->isPHI() ? block.getFirstNonPHI() : std::next(def->getIterator());
  if (is_constant(*def)) {
    MachineInstr* again = block.getParent()->CloneMachineInstr(def);
    block.insert(at, again);
    again->getOperand(0).setReg(copy);
  } else {
    BuildMI(block, at, def->getDebugLoc(), tii_->get(TargetOpcode::COPY), copy).addReg(reg);
  }
  regs_->clearKillFlags(reg);
  return copy;
}

void BfinBankSelect::set_bank(MachineInstr& inst, unsigned index, Bank bank) {
  MachineOperand& operand = inst.getOperand(index);
  if (bank != Bank::kEither)
    operand.setReg(in_bank(operand.getReg(), bank));
}

/// Some results come in half of the data registers only.
void BfinBankSelect::constrain_result(const MachineInstr& inst, unsigned index) {
  const TargetRegisterClass* wanted =
      inst.getRegClassConstraint(index, tii_, regs_->getTargetRegisterInfo());
  if (wanted == &Bfin::DEvenRegClass || wanted == &Bfin::DOddRegClass)
    regs_->setRegClass(inst.getOperand(index).getReg(), wanted);
}

void BfinBankSelect::rewrite(MachineInstr& inst) {
  if (inst.isCopy())
    return;
  Forms forms = forms_of(inst.getOpcode());
  bool joined = is_joined(inst);
  Bank own = Bank::kEither;
  if (joined)
    own =
        inst.getNumExplicitDefs() == 1 ? banks_[inst.getOperand(0).getReg()] : banks_[Register(0)];
  for (unsigned i = 0; i < inst.getNumOperands(); ++i) {
    const MachineOperand& operand = inst.getOperand(i);
    if (!is_value(operand))
      continue;
    if (operand.isDef()) {
      constrain_result(inst, i);
      continue;
    }
    Bank bank = operand_bank(inst, i);
    if (bank == Bank::kEither && joined)
      bank = own;
    if (bank == Bank::kEither && operand.isTied())
      bank = banks_[inst.getOperand(inst.findTiedOperandIdx(i)).getReg()];
    set_bank(inst, i, bank);
  }
  if (forms.data == 0)
    return;
  inst.setDesc(tii_->get(own == Bank::kPointer ? forms.pointer : forms.data));
  if (inst.getOpcode() == Bfin::SUBP)
    inst.tieOperands(0, 1);
}

/// Pd = Pa + (Pb << 1 or 2) is one instruction.
void BfinBankSelect::fold_scaled_adds(MachineFunction& function) {
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : make_early_inc_range(block)) {
      if (inst.getOpcode() != Bfin::ADDP)
        continue;
      for (unsigned i : {2U, 1U}) {
        Register scaled = inst.getOperand(i).getReg();
        MachineInstr* shift = scaled.isVirtual() ? regs_->getVRegDef(scaled) : nullptr;
        if (shift == nullptr || shift->getOpcode() != Bfin::SHLP ||
            !regs_->hasOneNonDBGUse(scaled) || shift->getParent() != &block)
          continue;
        Register from = shift->getOperand(1).getReg();
        BuildMI(block, inst, inst.getDebugLoc(), tii_->get(Bfin::ADDSHLP),
                inst.getOperand(0).getReg())
            .addReg(inst.getOperand(3 - i).getReg())
            .addReg(from)
            .addImm(shift->getOperand(2).getImm());
        regs_->clearKillFlags(from);
        shift->eraseFromParent();
        inst.eraseFromParent();
        break;
      }
    }
}

bool BfinBankSelect::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  frequencies_ = &getAnalysis<MachineBlockFrequencyInfoWrapperPass>().getMBFI();
  cut_ = MinCut();
  nodes_.clear();
  compare_nodes_.clear();
  copies_.clear();
  constrained_.clear();
  banks_.clear();
  other_bank_.clear();

  drop_copies(function);
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block) {
      for (const MachineOperand& operand : inst.operands())
        if (is_value(operand))
          node(operand.getReg());
      connect(inst);
    }
  std::vector<bool> data = cut_.source_side();
  for (auto [reg, index] : nodes_) {
    Bank bank = data[static_cast<size_t>(index)] ? Bank::kData : Bank::kPointer;
    if (!constrained_[reg])
      bank = Bank::kEither;
    banks_[reg] = bank;
    regs_->setRegClass(reg, bank == Bank::kData      ? &Bfin::DRegClass
                            : bank == Bank::kPointer ? &Bfin::PRegClass
                                                     : &Bfin::DPRegClass);
  }
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block) {
      auto compare = compare_nodes_.find(&inst);
      if (compare != compare_nodes_.end())
        banks_[Register(0)] =
            data[static_cast<size_t>(compare->second)] ? Bank::kData : Bank::kPointer;
      rewrite(inst);
    }
  fold_scaled_adds(function);
  return true;
}

}  // namespace

FunctionPass* createBfinBankSelect() { return new BfinBankSelect(); }

}  // namespace llvm
