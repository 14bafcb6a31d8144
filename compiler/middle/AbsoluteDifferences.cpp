#include "AbsoluteDifferences.hpp"

#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/PatternMatch.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

#include "../target/BfinMachineFunctionInfo.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace llvm::PatternMatch;

/// A row or a block: what the loops add up. The differences are those of bytes at `a` and `b`.
struct Block {
  Loop* loop;     // all of it
  PHINode* sum;   // in the loop's head
  Value* result;  // what the sum is at its end
  const SCEV* a;  // the first bytes
  const SCEV* b;
  const SCEV* step_a;
  const SCEV* step_b;
  const SCEV* columns;
  const SCEV* rows;
};

/// Fewer are not worth the call.
constexpr uint64_t kLeastBytes = 16;

const SCEV* rounds_of(const Loop& loop, ScalarEvolution& scev) {
  const SCEV* again = scev.getBackedgeTakenCount(&loop);
  if (isa<SCEVCouldNotCompute>(again) || again->getType()->getScalarSizeInBits() > 32)
    return nullptr;
  Type* word = Type::getInt32Ty(loop.getHeader()->getContext());
  return scev.getAddExpr(scev.getZeroExtendExpr(again, word), scev.getOne(word));
}

/// The bytes, widened, whose absolute difference a value is.
bool match_difference(Value* value, Value*& a, Value*& b) {
  if (match(value,
            m_Intrinsic<Intrinsic::abs>(m_Sub(m_ZExt(m_Value(a)), m_ZExt(m_Value(b))), m_Value())))
    return true;
  // a > b ? a - b : b - a, compared as bytes or widened.
  ICmpInst::Predicate predicate = CmpInst::ICMP_EQ;
  Value* left = nullptr;
  Value* right = nullptr;
  if (!match(value, m_Select(m_ICmp(predicate, m_Value(left), m_Value(right)),
                             m_Sub(m_ZExt(m_Value(a)), m_ZExt(m_Value(b))),
                             m_Sub(m_ZExt(m_Deferred(b)), m_ZExt(m_Deferred(a))))))
    return false;
  const auto is = [](Value* compared, Value* byte) {
    return compared == byte || match(compared, m_ZExt(m_Specific(byte)));
  };
  if (is(left, b) && is(right, a))
    predicate = CmpInst::getSwappedPredicate(predicate);
  else if (!is(left, a) || !is(right, b))
    return false;
  const bool widened = left->getType()->getScalarSizeInBits() > 8;
  return predicate == CmpInst::ICMP_UGT || predicate == CmpInst::ICMP_UGE ||
         (widened && (predicate == CmpInst::ICMP_SGT || predicate == CmpInst::ICMP_SGE));
}

/// The address of the first byte, where a value is the loop's next byte in each round.
const SCEV* first_byte(Value* byte, const Loop& loop, ScalarEvolution& scev) {
  auto* load = dyn_cast<LoadInst>(byte);
  if (load == nullptr || !load->isSimple() || !load->getType()->isIntegerTy(8) ||
      load->getPointerAddressSpace() != 0)
    return nullptr;
  const auto* address = dyn_cast<SCEVAddRecExpr>(scev.getSCEV(load->getPointerOperand()));
  if (address == nullptr || address->getLoop() != &loop || !address->isAffine() ||
      !address->getStepRecurrence(scev)->isOne())
    return nullptr;
  return address->getStart();
}

/// Does anything happen in the loop beyond computing, and reading what may be read at any time?
bool only_computes(const Loop& loop) {
  for (const BasicBlock* block : loop.blocks())
    for (const Instruction& inst : *block)
      if (inst.mayHaveSideEffects() || (isa<LoadInst>(inst) && cast<LoadInst>(inst).isVolatile()))
        return false;
  return true;
}

/// The phi's value behind the loop: what comes round, when only the phi and what lies behind the
/// loop want it.
Value* carried(PHINode& phi, const Loop& loop) {
  Value* next = phi.getIncomingValueForBlock(loop.getLoopLatch());
  const auto* inst = dyn_cast<Instruction>(next);
  if (inst == nullptr || !loop.contains(inst))
    return nullptr;
  for (const User* user : inst->users())
    if (user != &phi && loop.contains(cast<Instruction>(user)))
      return nullptr;
  return next;
}

std::optional<Block> match_row(Loop& loop, ScalarEvolution& scev) {
  if (loop.getNumBlocks() != 1 || loop.getLoopPreheader() == nullptr ||
      loop.getExitBlock() == nullptr || !only_computes(loop))
    return std::nullopt;
  const SCEV* columns = rounds_of(loop, scev);
  if (columns == nullptr)
    return std::nullopt;
  const SCEV* none = scev.getZero(columns->getType());
  for (PHINode& sum : loop.getHeader()->phis()) {
    if (!sum.getType()->isIntegerTy(32) || !sum.hasOneUse())
      continue;
    Value* next = carried(sum, loop);
    Value* difference = nullptr;
    Value* bytes[2] = {};
    if (next == nullptr || !match(next, m_c_Add(m_Specific(&sum), m_Value(difference))) ||
        !match_difference(difference, bytes[0], bytes[1]))
      continue;
    const SCEV* a = first_byte(bytes[0], loop, scev);
    const SCEV* b = first_byte(bytes[1], loop, scev);
    if (a != nullptr && b != nullptr)
      return Block{&loop, &sum, next, a, b, none, none, columns, scev.getOne(columns->getType())};
  }
  return std::nullopt;
}

/// The way from a row's first byte to the next row's, `start` becoming the first row's.
const SCEV* step_of(const SCEV*& start, const Loop& rows, ScalarEvolution& scev) {
  if (scev.isLoopInvariant(start, &rows))
    return scev.getZero(Type::getInt32Ty(rows.getHeader()->getContext()));
  const auto* address = dyn_cast<SCEVAddRecExpr>(start);
  if (address == nullptr || address->getLoop() != &rows || !address->isAffine())
    return nullptr;
  start = address->getStart();
  return address->getStepRecurrence(scev);
}

/// The nest around a row, where it only goes from row to row.
std::optional<Block> match_rows(const Block& row, ScalarEvolution& scev) {
  Loop* rows = row.loop->getParentLoop();
  if (rows == nullptr || rows->getSubLoops().size() != 1 || rows->getLoopPreheader() == nullptr ||
      rows->getLoopLatch() == nullptr || rows->getExitBlock() == nullptr || !only_computes(*rows) ||
      rows->getExitingBlock() != rows->getLoopLatch() ||
      // Every round goes through the row: there is one way.
      rows->getHeader()->getSingleSuccessor() == nullptr ||
      (row.loop->getLoopPreheader() != rows->getHeader() &&
       row.loop->getLoopPreheader()->getSinglePredecessor() != rows->getHeader()))
    return std::nullopt;
  auto* sum = dyn_cast<PHINode>(row.sum->getIncomingValueForBlock(row.loop->getLoopPreheader()));
  if (sum == nullptr || sum->getParent() != rows->getHeader() || !sum->hasOneUse())
    return std::nullopt;
  Block block = row;
  block.loop = rows;
  block.sum = sum;
  // Of the row's sum, behind its loop, in this round.
  block.result = carried(*sum, *rows);
  const auto* behind = dyn_cast_or_null<PHINode>(block.result);
  if (behind == nullptr || behind->getNumIncomingValues() != 1 ||
      behind->getIncomingValue(0) != row.result || !row.result->hasNUses(2))
    return std::nullopt;
  block.rows = rounds_of(*rows, scev);
  block.step_a = step_of(block.a, *rows, scev);
  block.step_b = step_of(block.b, *rows, scev);
  if (block.rows == nullptr || block.step_a == nullptr || block.step_b == nullptr ||
      !scev.isLoopInvariant(block.columns, rows))
    return std::nullopt;
  return block;
}

bool is_worth_a_call(const Block& block) {
  const auto* columns = dyn_cast<SCEVConstant>(block.columns);
  const auto* rows = dyn_cast<SCEVConstant>(block.rows);
  if (columns == nullptr || rows == nullptr)
    return true;
  return columns->getAPInt().getZExtValue() * rows->getAPInt().getZExtValue() >= kLeastBytes;
}

FunctionCallee callee(Module& module) {
  LLVMContext& context = module.getContext();
  Type* word = Type::getInt32Ty(context);
  Type* pointer = PointerType::getUnqual(context);
  AttributeList attributes;
  for (const Attribute::AttrKind kind :
       {Attribute::NoUnwind, Attribute::WillReturn, Attribute::NoSync, Attribute::NoFree})
    attributes = attributes.addFnAttribute(context, kind);
  attributes = attributes.addFnAttribute(
      context,
      Attribute::getWithMemoryEffects(context, MemoryEffects::argMemOnly(ModRefInfo::Ref)));
  return module.getOrInsertFunction("__absolute_differences", attributes, word, pointer, pointer,
                                    word, word, word, word);
}

/// Is there anything in the frame that the bytes could be?
bool has_locals(const Function& function) {
  return any_of(function.getEntryBlock(),
                [](const Instruction& inst) { return isa<AllocaInst>(inst); });
}

/// False: an operand cannot be had before the loop.
bool replace(const Block& block, ScalarEvolution& scev) {
  Instruction* before = block.loop->getLoopPreheader()->getTerminator();
  SCEVExpander expander(scev, before->getModule()->getDataLayout(), "rows");
  const SCEV* const operands[] = {block.a,      block.b,       block.step_a,
                                  block.step_b, block.columns, block.rows};
  for (const SCEV* operand : operands)
    if (!expander.isSafeToExpandAt(operand, before) || !scev.isLoopInvariant(operand, block.loop))
      return false;
  SmallVector<Value*, 6> arguments;
  for (const SCEV* operand : operands)
    arguments.push_back(expander.expandCodeFor(operand, operand->getType(), before));
  IRBuilder<> builder(before);
  builder.SetCurrentDebugLocation(block.loop->getStartLoc());
  CallInst* differences = builder.CreateCall(callee(*before->getModule()), arguments);
  differences->setCallingConv(kInRegisters);
  differences->setTailCall(!has_locals(*before->getFunction()));
  Value* first = block.sum->getIncomingValueForBlock(block.loop->getLoopPreheader());
  Value* sum = builder.CreateAdd(first, differences);
  scev.forgetTopmostLoop(block.loop);
  block.result->replaceUsesWithIf(
      sum, [&](const Use& use) { return !block.loop->contains(cast<Instruction>(use.getUser())); });
  // Nothing wants what the loop computes: it goes.
  block.sum->setIncomingValueForBlock(block.loop->getLoopLatch(), first);
  return true;
}

}  // namespace

PreservedAnalyses AbsoluteDifferencesPass::run(Loop& loop, LoopAnalysisManager&,
                                               LoopStandardAnalysisResults& analyses, LPMUpdater&) {
  const std::optional<Block> row = match_row(loop, analyses.SE);
  if (!row)
    return PreservedAnalyses::all();
  std::optional<Block> rows = match_rows(*row, analyses.SE);
  const Block& block = rows ? *rows : *row;
  if (!is_worth_a_call(block) || !replace(block, analyses.SE))
    return PreservedAnalyses::all();
  return getLoopPassPreservedAnalyses();
}

}  // namespace finback::compiler
