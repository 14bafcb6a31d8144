#include "CircularBuffers.hpp"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinNamedInstructions.hpp"
#include "CircularIndex.hpp"
#include "LoopCopy.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr size_t kMostRings = 2;          // of a loop: two index registers are left
constexpr unsigned kLeastRingRounds = 4;  // fewer are not worth the registers' set-up

/// Where elements are that an index says: a circle of its own for each.
struct Place {
  Value* pointer;
  int64_t offset;  // of the first element from the pointer, in bytes
  unsigned scale;  // bytes of an element
  SmallVector<GetElementPtrInst*, 4> at_phi;
  SmallVector<GetElementPtrInst*, 4> at_next;
};

struct Circle {
  CircularIndex index;
  SmallVector<Place, 2> places;  // of an index; none of a pointer
  bool reads_next = false;       // are the loop's addresses those of the next value?
  bool ahead = false;            // only those: the ring then runs a step ahead of the phi
};

struct LoopAnalyses {
  LoopInfo& loops;
  DominatorTree& dominators;
  ScalarEvolution& scev;
  AssumptionCache& assumptions;
};

Value* call_ring(IRBuilder<>& builder, StringRef name, ArrayRef<Value*> arguments) {
  SmallVector<Type*, 4> types;
  for (const Value* argument : arguments)
    types.push_back(argument->getType());
  const FunctionCallee callee = builder.GetInsertBlock()->getModule()->getOrInsertFunction(
      ("__builtin_bfin_ring_" + name).str(),
      FunctionType::get(builder.getPtrTy(), types, /*isVarArg=*/false));
  CallInst* call = builder.CreateCall(callee, arguments);
  call->setDoesNotThrow();
  return call;
}

/// Instructions that become calls, or have uses of their own for index registers.
bool allows_rings(const Instruction& inst) {
  if (const auto* call = dyn_cast<CallBase>(&inst)) {
    const Function* function = call->getCalledFunction();
    if (isNamedInstruction(function)) {
      const BfinNamedInstruction* named = findNamedInstruction(function->getName());
      return named != nullptr && !named->types.contains("lp");
    }
    return isa<IntrinsicInst>(call) && !isa<MemIntrinsic>(call) &&
           !call->getType()->isFPOrFPVectorTy();
  }
  const bool floats =
      inst.getType()->isFPOrFPVectorTy() ||
      any_of(inst.operands(), [](const Use& use) { return use->getType()->isFPOrFPVectorTy(); });
  switch (inst.getOpcode()) {
    case Instruction::SDiv:
    case Instruction::UDiv:
    case Instruction::SRem:
    case Instruction::URem: {
      const auto* divisor = dyn_cast<ConstantInt>(inst.getOperand(1));
      return divisor != nullptr && divisor->getValue().isPowerOf2();
    }
    case Instruction::Load:
    case Instruction::Store:
    case Instruction::PHI:
    case Instruction::Select:
      return !inst.isAtomic();
    case Instruction::AtomicRMW:
    case Instruction::AtomicCmpXchg:
    case Instruction::Fence:
    case Instruction::IndirectBr:
    case Instruction::Invoke:
      return false;
    default:
      return !floats;
  }
}

/// Files an address under its place; false where it is none that a ring could be.
bool add_address(Circle& circle, User* user, Value* value, const Loop& loop) {
  auto* address = dyn_cast<GetElementPtrInst>(user);
  if (address == nullptr || !loop.contains(address))
    return false;
  const DataLayout& layout = address->getModule()->getDataLayout();
  const unsigned width = layout.getIndexTypeSizeInBits(address->getType());
  MapVector<Value*, APInt> variable;
  APInt constant(width, 0);
  if (!cast<GEPOperator>(address)->collectOffset(layout, width, variable, constant) ||
      variable.size() != 1 || variable.front().first != value ||
      !loop.isLoopInvariant(address->getPointerOperand()))
    return false;
  const uint64_t scale = variable.front().second.getZExtValue();
  if ((scale != 1 && scale != 2 && scale != 4) || !all_of(address->users(), [&](const User* use) {
        return getLoadStorePointerOperand(use) == address &&
               (!isa<StoreInst>(use) || cast<StoreInst>(use)->getValueOperand() != address);
      }))
    return false;
  auto place = find_if(circle.places, [&](const Place& one) {
    return one.pointer == address->getPointerOperand() && one.offset == constant.getSExtValue() &&
           one.scale == scale;
  });
  if (place == circle.places.end()) {
    circle.places.push_back({address->getPointerOperand(),
                             constant.getSExtValue(),
                             static_cast<unsigned>(scale),
                             {},
                             {}});
    place = std::prev(circle.places.end());
  }
  (value == circle.index.value ? place->at_phi : place->at_next).push_back(address);
  return true;
}

/// What a ring's address may be used for: not to go on under another name.
bool may_read_ring(const User* user) {
  return isa<LoadInst>(user) || isa<StoreInst>(user) || isa<GetElementPtrInst>(user) ||
         isa<ICmpInst>(user) || isa<PtrToIntInst>(user);
}

/// Looks at all uses of the index and of its next value; false where one stands against a ring.
bool find_uses(Circle& circle, const Loop& loop) {
  CircularIndex& index = circle.index;
  const bool masked = index.start != nullptr;
  bool reads_value = false;
  bool wanted_behind = false;
  for (Value* value : {index.value, index.next}) {
    if (value == nullptr)
      continue;
    for (User* user : value->users()) {
      if (user == index.phi || is_contained(index.chain, user))
        continue;
      const bool is_value = value == index.value;
      if (!loop.contains(cast<Instruction>(user))) {
        if (is_value && !masked)
          return false;
        wanted_behind = true;
        continue;
      }
      if (index.base == nullptr ? !add_address(circle, user, value, loop) : !may_read_ring(user))
        return false;
      (is_value ? reads_value : circle.reads_next) = true;
    }
  }
  circle.ahead = circle.reads_next && !reads_value && !wanted_behind;
  return masked ? reads_value && !circle.reads_next : reads_value || circle.reads_next;
}

bool stands_in_chain(const Instruction& inst, ArrayRef<Circle> circles) {
  return any_of(circles, [&](const Circle& circle) {
    return circle.index.value == &inst || is_contained(circle.index.chain, &inst);
  });
}

/// Candidates: what the phis and the sums of the loop are, whatever they are used for.
SmallVector<CircularIndex, 4> find_indices(const Loop& loop, ScalarEvolution& scev) {
  SmallVector<CircularIndex, 4> indices;
  for (PHINode& phi : loop.getHeader()->phis())
    if (std::optional<CircularIndex> index = match_circular_index(phi, loop))
      indices.push_back(std::move(*index));
  for (BasicBlock* block : loop.blocks())
    for (Instruction& inst : *block)
      if (std::optional<CircularIndex> index = match_masked_index(inst, loop, scev))
        indices.push_back(std::move(*index));
  return indices;
}

/// The circles of a loop, whose addresses become rings.
SmallVector<Circle, 2> find_circles(const Loop& loop, ScalarEvolution& scev) {
  SmallVector<Circle, 2> circles;
  size_t rings = 0;
  for (CircularIndex& index : find_indices(loop, scev)) {
    Circle circle;
    circle.index = std::move(index);
    if (!find_uses(circle, loop) ||
        stands_in_chain(*cast<Instruction>(circle.index.value), circles))
      continue;
    const size_t more = std::max<size_t>(1, circle.places.size());
    if (rings + more > kMostRings)
      continue;
    rings += more;
    circles.push_back(std::move(circle));
  }
  for (const BasicBlock* block : loop.blocks())
    for (const Instruction& inst : *block)
      if (!allows_rings(inst) && !stands_in_chain(inst, circles))
        return {};
  return circles;
}

Value* start_of(const CircularIndex& index, const Loop& loop) {
  return index.phi->getIncomingValueForBlock(loop.getLoopPreheader());
}

/// What must be asked before the loop: that the index begins in the circle, and that this is one.
/// Null: nothing.
Value* write_start_test(const CircularIndex& index, const Loop& loop, ScalarEvolution& scev) {
  if (index.vouched || index.start != nullptr)
    return nullptr;
  IRBuilder<> builder(loop.getLoopPreheader()->getTerminator());
  Value* start = start_of(index, loop);
  if (auto* size = dyn_cast_or_null<ConstantInt>(index.size)) {
    const SCEV* from = scev.getSCEV(start);
    const SCEV* to = scev.getSCEV(size);
    const bool known =
        computeConstantRange(start, /*ForSigned=*/false).getUnsignedMax().ult(size->getValue()) ||
        scev.isKnownPredicate(ICmpInst::ICMP_ULT, from, to) ||
        scev.isLoopEntryGuardedByCond(&loop, ICmpInst::ICMP_ULT, from, to);
    return known ? nullptr : builder.CreateICmpULT(start, size, "within");
  }
  if (index.size_less_one != nullptr)
    return builder.CreateAnd(
        builder.CreateICmpULE(start, index.size_less_one, "within"),
        builder.CreateICmpULT(index.size_less_one, builder.getInt32(kLargestCircle)));
  Value* test =
      builder.CreateAnd(builder.CreateICmpULT(start, index.size, "within"),
                        builder.CreateICmpULT(index.size, builder.getInt32(kLargestCircle)));
  if (cast<ConstantInt>(index.step)->getSExtValue() > 1)
    test = builder.CreateAnd(test, builder.CreateICmpULE(index.step, index.size));
  return test;
}

/// A copy of the loop for the answer no.
void add_slow_copy(Loop& loop, Value* test, const LoopAnalyses& analyses) {
  formLCSSA(loop, analyses.dominators, &analyses.loops, &analyses.scev);
  BasicBlock* exit = loop.getExitBlock();
  ValueToValueMapTy map;
  const LoopCopy slow = copy_beside(loop, ".wide", analyses.loops, analyses.dominators, map);
  IRBuilder<>(slow.before_both).CreateCondBr(test, slow.preheader_of_original, slow.preheader);
  slow.before_both->eraseFromParent();
  analyses.dominators.recalculate(*exit->getParent());
}

/// Puts a ring into the loop. What the ring is behind the loop.
Value* write_ring(const Circle& circle, const Place* place, Loop& loop, Value* start) {
  const CircularIndex& index = circle.index;
  IRBuilder<> before(loop.getLoopPreheader()->getTerminator());
  Value* base = index.base;
  Value* bytes = index.size;
  Value* step = index.step;
  if (place != nullptr) {
    const auto times = [&](Value* value) { return before.CreateShl(value, Log2_32(place->scale)); };
    if (bytes == nullptr)
      bytes = before.CreateAdd(index.size_less_one, before.getInt32(1));
    base =
        before.CreatePtrAdd(place->pointer, before.getInt32(static_cast<uint32_t>(place->offset)));
    start = before.CreatePtrAdd(base, times(start));
    bytes = times(bytes);
    step = times(step);
  }
  Value* begin = call_ring(before, "begin", {start, base, bytes, step});
  IRBuilder<> head(&loop.getHeader()->front());
  PHINode* ring = head.CreatePHI(head.getPtrTy(), 2, "ring");
  const bool in_between = circle.reads_next && !circle.ahead;
  IRBuilder<> then(in_between ? cast<Instruction>(index.next)
                              : loop.getLoopLatch()->getTerminator());
  Value* next = call_ring(then, "next", {ring});
  ring->addIncoming(begin, loop.getLoopPreheader());
  ring->addIncoming(next, loop.getLoopLatch());
  Value* at_next = circle.ahead ? static_cast<Value*>(ring) : next;
  if (place != nullptr) {
    for (GetElementPtrInst* address : place->at_phi)
      address->replaceAllUsesWith(ring);
    for (GetElementPtrInst* address : place->at_next)
      address->replaceAllUsesWith(at_next);
  } else {
    const auto reads = [&](const Use& use) {
      return use.getUser() != index.phi && !is_contained(index.chain, use.getUser()) &&
             loop.contains(cast<Instruction>(use.getUser()));
    };
    index.phi->replaceUsesWithIf(ring, reads);
    index.next->replaceUsesWithIf(at_next, reads);
  }
  BasicBlock* exit = loop.getExitBlock();
  IRBuilder<> behind(exit, exit->getFirstInsertionPt());
  Value* end = call_ring(behind, "done", {next});
  if (place == nullptr)
    return end;
  Value* distance = behind.CreateSub(behind.CreatePtrToInt(end, behind.getInt32Ty()),
                                     behind.CreatePtrToInt(base, behind.getInt32Ty()));
  return behind.CreateLShr(distance, Log2_32(place->scale));
}

/// What the phi is one step on, in front of the loop.
Value* one_step_on(const CircularIndex& index, Loop& loop) {
  ValueToValueMapTy map;
  map[index.phi] = start_of(index, loop);
  Instruction* at = loop.getLoopPreheader()->getTerminator();
  for (Instruction* inst : index.chain) {
    Instruction* copy = inst->clone();
    copy->insertBefore(at);
    RemapInstruction(copy, map, RF_NoModuleLevelChanges | RF_IgnoreMissingLocals);
    map[inst] = copy;
  }
  return map[index.next];
}

Value* masked_start(const CircularIndex& index, Loop& loop, ScalarEvolution& scev) {
  Instruction* at = loop.getLoopPreheader()->getTerminator();
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "ring");
  IRBuilder<> builder(at);
  return builder.CreateAnd(expander.expandCodeFor(index.start, index.size->getType(), at),
                           builder.CreateSub(index.size, builder.getInt32(1)));
}

/// Behind the loop the ring is a step further than the masked value was in the last round.
void write_behind_mask(const CircularIndex& index, const Loop& loop, Value* ring) {
  const auto outside = [&](const Use& use) {
    return !loop.contains(cast<Instruction>(use.getUser()));
  };
  auto* at = cast<Instruction>(ring)->getNextNode();
  IRBuilder<> builder(at);
  Value* last = builder.CreateAnd(builder.CreateSub(ring, index.step),
                                  builder.CreateSub(index.size, builder.getInt32(1)));
  if (index.next != nullptr) {
    Value* sum = builder.CreateAdd(last, index.step);
    index.next->replaceUsesWithIf(sum, outside);
  }
  index.value->replaceUsesWithIf(last, outside);
}

void write_circle(const Circle& circle, Loop& loop, ScalarEvolution& scev) {
  const CircularIndex& index = circle.index;
  const bool masked = index.start != nullptr;
  Value* start = masked         ? masked_start(index, loop, scev)
                 : circle.ahead ? one_step_on(index, loop)
                                : start_of(index, loop);
  SmallVector<const Place*, 2> places;
  for (const Place& place : circle.places)
    places.push_back(&place);
  if (places.empty())
    places.push_back(nullptr);
  Value* behind = nullptr;
  for (const Place* place : places) {
    Value* found = write_ring(circle, place, loop, start);
    behind = behind == nullptr ? found : behind;
  }
  if (masked)
    write_behind_mask(index, loop, behind);
  else
    index.next->replaceUsesWithIf(
        behind, [&](const Use& use) { return !loop.contains(cast<Instruction>(use.getUser())); });
  for (const Place& place : circle.places)
    for (const auto& addresses : {place.at_phi, place.at_next})
      for (GetElementPtrInst* address : addresses)
        address->eraseFromParent();
  if (index.phi == nullptr) {
    RecursivelyDeleteTriviallyDeadInstructions(index.value);
    return;
  }
  index.phi->replaceAllUsesWith(PoisonValue::get(index.phi->getType()));
  index.phi->eraseFromParent();
  RecursivelyDeleteTriviallyDeadInstructions(index.next);
}

/// Whether the loop runs often enough, and has one way in and out.
bool is_candidate(const Loop& loop, const LoopAnalyses& analyses) {
  const unsigned rounds = analyses.scev.getSmallConstantTripCount(&loop);
  if (loop.getLoopLatch() == nullptr || loop.getExitingBlock() != loop.getLoopLatch() ||
      loop.getExitBlock() == nullptr || (rounds != 0 && rounds < kLeastRingRounds))
    return false;
  return loop.getLoopPredecessor() != nullptr;
}

bool use_rings(Loop& loop, const LoopAnalyses& analyses, bool may_copy) {
  if (!is_candidate(loop, analyses))
    return false;
  const SmallVector<Circle, 2> circles = find_circles(loop, analyses.scev);
  if (circles.empty() ||
      (loop.getLoopPreheader() == nullptr &&
       InsertPreheaderForLoop(&loop, &analyses.dominators, &analyses.loops, nullptr,
                              /*PreserveLCSSA=*/false) == nullptr))
    return false;
  Value* test = nullptr;
  for (const Circle& circle : circles)
    if (Value* one = write_start_test(circle.index, loop, analyses.scev))
      test = test == nullptr
                 ? one
                 : IRBuilder<>(loop.getLoopPreheader()->getTerminator()).CreateAnd(test, one);
  if (test != nullptr && !may_copy) {
    RecursivelyDeleteTriviallyDeadInstructions(test);
    return false;
  }
  if (test != nullptr)
    add_slow_copy(loop, test, analyses);
  if (loop.getExitBlock()->getSinglePredecessor() == nullptr)
    SplitEdge(loop.getExitingBlock(), loop.getExitBlock(), &analyses.dominators, &analyses.loops);
  FoldSingleEntryPHINodes(loop.getExitBlock());
  for (const Circle& circle : circles)
    write_circle(circle, loop, analyses.scev);
  analyses.scev.forgetLoop(&loop);
  return true;
}

Value* expand_index(IRBuilder<>& builder, Value* index, Value* step, Value* size) {
  Value* sum = builder.CreateAdd(index, step);
  Value* low = builder.CreateICmpSLT(sum, builder.getInt32(0));
  Value* high = builder.CreateICmpSGE(sum, size);
  return builder.CreateSelect(low, builder.CreateAdd(sum, size),
                              builder.CreateSelect(high, builder.CreateSub(sum, size), sum));
}

/// What is left of circindex and circptr.
bool expand_calls(Function& function) {
  SmallVector<CallInst*, 8> calls;
  for (Instruction& inst : instructions(function))
    if (auto* call = dyn_cast<CallInst>(&inst);
        call != nullptr && isNamedInstruction(call->getCalledFunction()))
      if (const BfinNamedInstruction* named =
              findNamedInstruction(call->getCalledFunction()->getName());
          named != nullptr && named->kind == BfinNamedInstruction::Kind::circular)
        calls.push_back(call);
  for (CallInst* call : calls) {
    IRBuilder<> builder(call);
    Value* result = nullptr;
    if (call->arg_size() == 3) {
      result = expand_index(builder, call->getArgOperand(0), call->getArgOperand(1),
                            call->getArgOperand(2));
    } else {
      Type* word = builder.getInt32Ty();
      Value* base = call->getArgOperand(2);
      Value* distance = builder.CreateSub(builder.CreatePtrToInt(call->getArgOperand(0), word),
                                          builder.CreatePtrToInt(base, word));
      result = builder.CreatePtrAdd(
          base, expand_index(builder, distance, call->getArgOperand(1), call->getArgOperand(3)));
    }
    call->replaceAllUsesWith(result);
    call->eraseFromParent();
  }
  return !calls.empty();
}

}  // namespace

PreservedAnalyses CircularBuffersPass::run(Function& function, FunctionAnalysisManager& manager) {
  bool changed = false;
  if (!function.hasOptNone() && !isInterruptHandler(function)) {
    auto& loops = manager.getResult<LoopAnalysis>(function);
    const LoopAnalyses analyses{loops, manager.getResult<DominatorTreeAnalysis>(function),
                                manager.getResult<ScalarEvolutionAnalysis>(function),
                                manager.getResult<AssumptionAnalysis>(function)};
    SmallVector<Loop*, 8> innermost;
    for (Loop* loop : loops.getLoopsInPreorder())
      if (loop->isInnermost())
        innermost.push_back(loop);
    for (Loop* loop : innermost)
      changed |= use_rings(*loop, analyses, !function.hasOptSize());
  }
  changed |= expand_calls(function);
  return changed ? PreservedAnalyses::none() : PreservedAnalyses::all();
}

}  // namespace finback::compiler
