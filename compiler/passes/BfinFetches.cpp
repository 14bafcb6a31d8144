// A sum that is known to fit comes to its register with its last product, where that stands in the
// same block (BfinUnrollLoops put it there) or behind the loop (BfinRotateLoops did):
// R3 = (A1 += R0.H * R1.L), R2 = (A0 += R0.L * R1.L). It begins with its first ones, not with zero.
// Works before allocation, in front of the rotation and behind it. The two results of one
// instruction are in neighbours, which allocation knows nothing of: they get registers here, and
// are copied from there. Does not look further back than one block, and leaves sums alone that may
// wrap: the instruction saturates.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

class BfinFetches : public MachineFunctionPass {
 public:
  static char ID;
  BfinFetches() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin fetches of sums"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  /// Fetches of A0 and A1 at the head of a block, null where there is none.
  using Gets = std::array<MachineInstr*, 2>;

  bool begin_with_products(MachineBasicBlock& block);
  bool fetch_within(MachineBasicBlock& block);
  bool fetch_from_before(MachineBasicBlock& block);
  void join_one(MachineInstr& product, MachineInstr& get, unsigned number);
  void join_both(MachineInstr& products, const Gets& gets);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
};

char BfinFetches::ID = 0;

constexpr MCPhysReg kAccumulatorRegisters[] = {Bfin::A0, Bfin::A1};
constexpr unsigned kGet[] = {Bfin::GETA0, Bfin::GETA1};
constexpr unsigned kMultiplyAdd[] = {Bfin::MAC0, Bfin::MAC1};
constexpr unsigned kOtherSign = 5;  // the operand of MACMAC that says what A0 does
constexpr unsigned kMultiplyGet[] = {Bfin::MACGET0, Bfin::MACGET1};

/// The first of the instructions that reads or writes accumulator `number`.
template <typename Range>
MachineInstr* first_access(Range instructions, unsigned number) {
  for (MachineInstr& inst : instructions)
    if (inst.readsRegister(kAccumulatorRegisters[number], nullptr) ||
        inst.modifiesRegister(kAccumulatorRegisters[number], nullptr))
      return &inst;
  return nullptr;
}

MachineInstr* last_access(MachineBasicBlock& block, unsigned number) {
  return first_access(reverse(block), number);
}

void BfinFetches::join_one(MachineInstr& product, MachineInstr& get, unsigned number) {
  const Register result = get.getOperand(0).getReg();
  const Register fetched =
      regs_->createVirtualRegister(number == 0 ? &Bfin::DEvenRegClass : &Bfin::DOddRegClass);
  MachineBasicBlock& block = *product.getParent();
  auto inst =
      BuildMI(block, product, product.getDebugLoc(), tii_->get(kMultiplyGet[number]), fetched);
  for (const MachineOperand& operand : product.explicit_operands())
    inst.add(operand);
  BuildMI(block, product, product.getDebugLoc(), tii_->get(TargetOpcode::COPY), result)
      .addReg(fetched);
  product.eraseFromParent();
  get.eraseFromParent();
}

void BfinFetches::join_both(MachineInstr& products, const Gets& gets) {
  MachineBasicBlock& block = *products.getParent();
  const DebugLoc& loc = products.getDebugLoc();
  auto inst = BuildMI(block, products, loc, tii_->get(Bfin::MACGETS));
  for (const MachineOperand& operand : products.explicit_operands())
    inst.add(operand);
  constexpr MCPhysReg kResults[] = {Bfin::R2, Bfin::R3};
  for (const unsigned i : {0U, 1U}) {
    BuildMI(block, products, loc, tii_->get(TargetOpcode::COPY), gets[i]->getOperand(0).getReg())
        .addReg(kResults[i]);
    gets[i]->eraseFromParent();
  }
  products.eraseFromParent();
}

/// Products behind a zero take its place.
bool BfinFetches::begin_with_products(MachineBasicBlock& block) {
  constexpr int64_t kSet = 2;
  bool changed = false;
  for (MachineInstr& inst : make_early_inc_range(block)) {
    const bool both = inst.getOpcode() == Bfin::CLRAA;
    if (!both && inst.getOpcode() != Bfin::CLRA0 && inst.getOpcode() != Bfin::CLRA1)
      continue;
    const unsigned number = inst.getOpcode() == Bfin::CLRA1 ? 1 : 0;
    const auto behind = make_range(std::next(MachineBasicBlock::iterator(inst)), block.end());
    MachineInstr* product = first_access(behind, number);
    if (product == nullptr || product->getOperand(0).getImm() != 0)
      continue;
    if (product->getOpcode() != (both ? unsigned{Bfin::MACMAC} : kMultiplyAdd[number]))
      continue;
    if (both &&
        (product->getOperand(kOtherSign).getImm() != 0 || first_access(behind, 1) != product))
      continue;
    product->getOperand(0).setImm(kSet);
    if (both)
      product->getOperand(kOtherSign).setImm(kSet);
    inst.eraseFromParent();
    changed = true;
  }
  return changed;
}

/// Both sums of a block's last products.
bool BfinFetches::fetch_within(MachineBasicBlock& block) {
  Gets gets = {};
  std::array<MachineInstr*, 2> products = {};
  for (MachineInstr& inst : reverse(block)) {
    const auto* which = find(kGet, inst.getOpcode());
    if (which == std::end(kGet) || !inst.getFlag(MachineInstr::NoSWrap))
      continue;
    const auto number = static_cast<unsigned>(which - std::begin(kGet));
    gets[number] = &inst;
    products[number] = first_access(
        make_range(std::next(MachineBasicBlock::reverse_iterator(inst)), block.rend()), number);
  }
  if (products[0] == nullptr || products[0] != products[1] ||
      products[0]->getOpcode() != Bfin::MACMAC)
    return false;
  join_both(*products[0], gets);
  return true;
}

bool BfinFetches::fetch_from_before(MachineBasicBlock& block) {
  if (block.pred_size() != 1 || (*block.pred_begin())->succ_size() != 1)
    return false;
  MachineBasicBlock& before = **block.pred_begin();
  Gets gets = {};
  for (MachineInstr& inst : block) {
    if (inst.isPHI())
      continue;
    const auto* which = find(kGet, inst.getOpcode());
    if (which == std::end(kGet) || !inst.getFlag(MachineInstr::NoSWrap))
      break;
    gets[static_cast<size_t>(which - std::begin(kGet))] = &inst;
  }
  std::array<MachineInstr*, 2> products = {};
  for (const unsigned i : {0U, 1U})
    products[i] = gets[i] == nullptr ? nullptr : last_access(before, i);
  if (products[0] != nullptr && products[0] == products[1] &&
      products[0]->getOpcode() == Bfin::MACMAC) {
    join_both(*products[0], gets);
    return true;
  }
  bool changed = false;
  for (const unsigned i : {0U, 1U})
    if (products[i] != nullptr && products[i]->getOpcode() == kMultiplyAdd[i]) {
      join_one(*products[i], *gets[i], i);
      changed = true;
    }
  return changed;
}

bool BfinFetches::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  bool changed = false;
  for (MachineBasicBlock& block : function) {
    changed |= begin_with_products(block);
    changed |= fetch_within(block);
    changed |= fetch_from_before(block);
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinFetches() { return new BfinFetches(); }

}  // namespace llvm
