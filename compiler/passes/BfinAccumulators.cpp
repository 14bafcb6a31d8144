// Sums of products of halves live in the accumulators while their loop runs: multiply and add are
// one instruction, and two products of the same two registers, one for each accumulator, are one,
// too. Looks at loops of one block on a loop counter, and takes the two sums with the most
// products.
//
// The accumulators have 40 bits and saturate, C's sums have 32 and wrap: only sums are taken that
// must not overflow (nsw), or whose maker knows that 40 bits hold them (SUM_X), or 32 (SUMFITS_X).
// Handlers of interrupts do without: they would have to save the accumulators.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <map>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

/// The instructions of one accumulator.
struct Accumulator {
  MCRegister reg;
  unsigned clear;
  unsigned set;
  unsigned multiply_add;
  unsigned multiply_get;
  unsigned get;
  const TargetRegisterClass* results;
};
const Accumulator kAccumulators[] = {
    {Bfin::A0, Bfin::CLRA0, Bfin::SETA0, Bfin::MAC0, Bfin::MACGET0, Bfin::GETA0,
     &Bfin::DEvenRegClass},
    {Bfin::A1, Bfin::CLRA1, Bfin::SETA1, Bfin::MAC1, Bfin::MACGET1, Bfin::GETA1,
     &Bfin::DOddRegClass},
};

struct Product {
  MachineInstr* inst;
  bool taken_off;
};

/// sum = PHI(start, next); next = sum + products, all within one loop.
struct Sum {
  MachineInstr* phi = nullptr;
  Register start;
  std::vector<MachineInstr*> adds;  // the last one first
  std::vector<Product> products;
  bool found_phi = false;
  bool used_within = false;

  [[nodiscard]] Register result() const { return adds.front()->getOperand(0).getReg(); }
};

/// A loop of one block on a loop counter, with what lies before and behind it.
struct SumLoop {
  MachineBasicBlock* block = nullptr;
  MachineBasicBlock* before = nullptr;
  MachineBasicBlock* after = nullptr;
};

class BfinAccumulators : public MachineFunctionPass {
 public:
  static char ID;
  BfinAccumulators() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin accumulators"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  bool visit(SumLoop& loop);
  bool find_sum(MachineInstr& phi, Sum& sum) const;
  bool collect(Register reg, bool taken_off, Sum& sum) const;
  bool only_user(Register reg, const MachineInstr& user) const;
  bool is_zero(Register reg) const;
  void convert(Sum& sum, const Accumulator& accumulator, const SumLoop& loop);
  void fetch(Sum& sum, const Accumulator& accumulator, const SumLoop& loop);
  void join_pairs(MachineBasicBlock& block);
  void join_clears(MachineBasicBlock& before);
  void plain_sums(MachineFunction& function);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
};

char BfinAccumulators::ID = 0;

bool BfinAccumulators::only_user(Register reg, const MachineInstr& user) const {
  return all_of(regs_->use_nodbg_instructions(reg),
                [&](const MachineInstr& use) { return &use == &user; });
}

bool BfinAccumulators::is_zero(Register reg) const {
  const MachineInstr* def = regs_->getVRegDef(reg);
  return def->getOpcode() == Bfin::MOVI && def->getOperand(1).getImm() == 0;
}

/// The tree of sums above `reg`, down to the sum of the pass before and to products.
bool BfinAccumulators::collect(Register reg, bool taken_off, Sum& sum) const {
  if (!reg.isVirtual())
    return false;
  if (reg == sum.phi->getOperand(0).getReg()) {
    const bool first = !sum.found_phi;
    sum.found_phi = true;
    return first && !taken_off;
  }
  MachineInstr& inst = *regs_->getVRegDef(reg);
  if (inst.getParent() != sum.phi->getParent())
    return false;
  const unsigned opcode = inst.getOpcode();
  if (opcode == Bfin::MULIS) {
    sum.products.push_back({&inst, taken_off});
    return true;
  }
  const bool is_sum =
      opcode == Bfin::SUM_X || opcode == Bfin::SUMFITS_X ||
      ((opcode == Bfin::ADD_X || opcode == Bfin::SUB_X) && inst.getFlag(MachineInstr::NoSWrap));
  if (!is_sum)
    return false;
  sum.adds.push_back(&inst);
  for (const unsigned i : {1U, 2U}) {
    const Register operand = inst.getOperand(i).getReg();
    if (!operand.isVirtual() || !only_user(operand, inst) ||
        !collect(operand, taken_off != (opcode == Bfin::SUB_X && i == 2), sum))
      return false;
  }
  return inst.getOperand(1).getReg() != inst.getOperand(2).getReg();
}

bool BfinAccumulators::find_sum(MachineInstr& phi, Sum& sum) const {
  MachineBasicBlock& block = *phi.getParent();
  if (phi.getNumOperands() != 5)
    return false;
  const unsigned own = phi.getOperand(2).getMBB() == &block ? 1 : 3;
  sum.phi = &phi;
  sum.start = phi.getOperand(own == 1 ? 3 : 1).getReg();
  if (!collect(phi.getOperand(own).getReg(), false, sum) || !sum.found_phi || sum.adds.empty())
    return false;
  sum.used_within =
      any_of(regs_->use_nodbg_instructions(sum.result()),
             [&](const MachineInstr& use) { return &use != &phi && use.getParent() == &block; });
  // To fetch the sum in each pass pays from two products on, and fetching saturates.
  return !sum.used_within ||
         (sum.products.size() >= 2 && sum.adds.front()->getOpcode() != Bfin::SUM_X);
}

/// Where the sum is read: behind the loop, or with the last product of each pass.
void BfinAccumulators::fetch(Sum& sum, const Accumulator& accumulator, const SumLoop& loop) {
  MachineInstr& last = *sum.adds.front();
  const Register result = sum.result();
  regs_->clearKillFlags(result);
  if (!sum.used_within) {
    regs_->setRegClass(result, &Bfin::DRegClass);
    auto get = BuildMI(*loop.after, loop.after->getFirstNonPHI(), last.getDebugLoc(),
                       tii_->get(accumulator.get), result);
    // BfinFetches may let it saturate.
    if (none_of(sum.adds, [](const MachineInstr* add) { return add->getOpcode() == Bfin::SUM_X; }))
      get->setFlag(MachineInstr::NoSWrap);
    return;
  }
  const Product product = sum.products.back();
  sum.products.pop_back();
  regs_->setRegClass(result, accumulator.results);
  auto inst =
      BuildMI(*loop.block, last, last.getDebugLoc(), tii_->get(accumulator.multiply_get), result)
          .addImm(product.taken_off);
  for (const unsigned i : {1U, 2U, 3U, 4U})
    inst.add(product.inst->getOperand(i));
  product.inst->eraseFromParent();
}

void BfinAccumulators::convert(Sum& sum, const Accumulator& accumulator, const SumLoop& loop) {
  const auto entry = loop.before->getFirstTerminator();
  const DebugLoc loc = sum.adds.front()->getDebugLoc();
  if (is_zero(sum.start)) {
    BuildMI(*loop.before, entry, loc, tii_->get(accumulator.clear));
  } else {
    const Register data = regs_->createVirtualRegister(&Bfin::DRegClass);
    BuildMI(*loop.before, entry, loc, tii_->get(TargetOpcode::COPY), data).addReg(sum.start);
    BuildMI(*loop.before, entry, loc, tii_->get(accumulator.set)).addReg(data);
  }
  fetch(sum, accumulator, loop);
  for (const Product& product : sum.products) {
    auto inst = BuildMI(*loop.block, product.inst, product.inst->getDebugLoc(),
                        tii_->get(accumulator.multiply_add))
                    .addImm(product.taken_off);
    for (const unsigned i : {1U, 2U, 3U, 4U})
      inst.add(product.inst->getOperand(i));
    product.inst->eraseFromParent();
  }
  regs_->clearKillFlags(sum.start);
  sum.phi->eraseFromParent();
  for (MachineInstr* add : sum.adds)
    add->eraseFromParent();
}

/// Whether two products are of the same two registers, perhaps the other way round.
bool same_registers(const MachineInstr& a, const MachineInstr& b, bool swapped) {
  const auto reg = [](const MachineInstr& inst, unsigned i) { return inst.getOperand(i).getReg(); };
  return reg(a, 1) == reg(b, swapped ? 3 : 1) && reg(a, 3) == reg(b, swapped ? 1 : 3);
}

/// The pair stands where the first of the two stood: so it comes before either sum is fetched.
void BfinAccumulators::join_pairs(MachineBasicBlock& block) {
  std::vector<MachineInstr*> singles[2];
  std::map<const MachineInstr*, size_t> places;
  for (MachineInstr& inst : block)
    for (const unsigned i : {0U, 1U})
      if (inst.getOpcode() == kAccumulators[i].multiply_add) {
        singles[i].push_back(&inst);
        places[&inst] = places.size();
      }
  for (MachineInstr* first : singles[0]) {
    const auto second = find_if(singles[1], [&](const MachineInstr* other) {
      return same_registers(*first, *other, false) || same_registers(*first, *other, true);
    });
    if (second == singles[1].end())
      continue;
    MachineInstr& other = **second;
    const bool swapped = !same_registers(*first, other, false);
    MachineInstr* at = places[first] < places[&other] ? first : &other;
    auto both = BuildMI(block, at, at->getDebugLoc(), tii_->get(Bfin::MACMAC));
    for (const unsigned i : {0U, 1U, 2U, 3U, 4U})
      both.add(other.getOperand(i == 0 || !swapped ? i : (i + 1) % 4 + 1));
    for (const unsigned i : {0U, 1U, 2U, 3U, 4U})
      both.add(first->getOperand(i));
    for (const MachineOperand& use : both->all_uses())
      if (use.getReg().isVirtual())
        regs_->clearKillFlags(use.getReg());
    first->eraseFromParent();
    other.eraseFromParent();
    singles[1].erase(second);
  }
}

/// Both accumulators are cleared by one instruction.
void BfinAccumulators::join_clears(MachineBasicBlock& before) {
  MachineInstr* clears[2] = {};
  for (MachineInstr& inst : before)
    for (const unsigned i : {0U, 1U})
      if (inst.getOpcode() == kAccumulators[i].clear)
        clears[i] = &inst;
  if (clears[0] == nullptr || clears[1] == nullptr)
    return;
  BuildMI(before, before.getFirstTerminator(), clears[0]->getDebugLoc(), tii_->get(Bfin::CLRAA));
  clears[0]->eraseFromParent();
  clears[1]->eraseFromParent();
}

bool BfinAccumulators::visit(SumLoop& loop) {
  std::vector<Sum> sums;
  for (MachineInstr& phi : loop.block->phis()) {
    Sum sum;
    if (find_sum(phi, sum))
      sums.push_back(std::move(sum));
  }
  stable_sort(sums,
              [](const Sum& a, const Sum& b) { return a.products.size() > b.products.size(); });
  // The results are fetched where only this loop leads.
  if (!sums.empty() && loop.after->pred_size() != 1)
    loop.after = loop.block->SplitCriticalEdge(loop.after, *this);
  if (sums.empty() || loop.after == nullptr)
    return false;
  sums.resize(std::min(sums.size(), std::size(kAccumulators)));
  for (const auto& [sum, accumulator] : zip(sums, kAccumulators))
    convert(sum, accumulator, loop);
  join_pairs(*loop.block);
  join_clears(*loop.before);
  return true;
}

/// What stayed outside of the accumulators is an ordinary sum.
void BfinAccumulators::plain_sums(MachineFunction& function) {
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block)
      if (inst.getOpcode() == Bfin::SUM_X || inst.getOpcode() == Bfin::SUMFITS_X)
        inst.setDesc(tii_->get(Bfin::ADD_X));
}

bool uses_accumulators(const MachineBasicBlock& block) {
  return any_of(block, [](const MachineInstr& inst) {
    return any_of(kAccumulators, [&](const Accumulator& accumulator) {
      return inst.readsRegister(accumulator.reg, nullptr) ||
             inst.modifiesRegister(accumulator.reg, nullptr);
    });
  });
}

bool BfinAccumulators::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  if (!isInterruptHandler(function.getFunction()))
    for (MachineBasicBlock& block : make_early_inc_range(function)) {
      const auto end = block.getFirstTerminator();
      if (end == block.end() || end->getOpcode() != Bfin::ENDLOOP ||
          end->getOperand(0).getMBB() != &block || block.succ_size() != 2 ||
          block.pred_size() != 2 || uses_accumulators(block))
        continue;
      const auto is_other = [&](const MachineBasicBlock* other) { return other != &block; };
      SumLoop loop{&block, *find_if(block.predecessors(), is_other),
                   *find_if(block.successors(), is_other)};
      visit(loop);
    }
  plain_sums(function);
  return true;
}

}  // namespace

FunctionPass* createBfinAccumulators() { return new BfinAccumulators(); }

}  // namespace llvm
