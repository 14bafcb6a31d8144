// For each number of cycles from the least that might do: the longest ways between instructions say
// how far apart any two must be, and a search with backtracking places one after another, where
// packets have room. It gives up after some steps, and begins again in another order.
#include "ModuloSchedule.hpp"

#include <optional>

#include "../target/BfinSubtarget.hpp"
#include "PacketSlots.hpp"

namespace llvm {
namespace {

constexpr unsigned kSteps = 2000;  // of the search, for each number of cycles
constexpr int kNever = -1000000;

/// In which order instructions are placed, and where each is tried first.
enum class Order { kLeastChoiceEarly, kLeastChoiceLate, kProgramEarly, kProgramLate };

class ScheduleSearch {
 public:
  ScheduleSearch(const LoopDependences& loop, const BfinInstrInfo& tii, unsigned cycles,
                 unsigned stages, const std::vector<IndexStream>& streams);

  /// Whether every circle fits the cycles.
  bool prepare();
  /// The times; nothing where none was found.
  std::optional<std::vector<unsigned>> run(Order order);

 private:
  struct Window {
    int earliest;
    int latest;
  };

  bool find_distances();
  [[nodiscard]] std::optional<size_t> next_to_place(const std::vector<Window>& windows) const;
  bool place_rest(const std::vector<Window>& windows);
  void sink_loads();
  bool try_at(size_t i, int time, std::vector<Window> windows);
  bool has_room(size_t i, int time) const;
  bool stages_agree(size_t i, int time) const;
  [[nodiscard]] size_t slot(int time) const { return static_cast<size_t>(time % cycles_); }
  [[nodiscard]] int length(size_t i) const {
    return static_cast<int>(BfinSubtarget::issueCycles(*insts_[i]));
  }

  const LoopDependences& loop_;
  const std::vector<MachineInstr*>& insts_;
  int cycles_;
  int last_time_;
  unsigned steps_ = kSteps;
  Order order_ = Order::kLeastChoiceEarly;
  std::vector<unsigned> slots_of_;           // what each instruction can fill
  std::vector<std::vector<int>> distances_;  // from one to another, at least
  std::vector<std::optional<int>> times_;
  std::vector<std::vector<size_t>> table_;  // what issues in each cycle of the loop
};

ScheduleSearch::ScheduleSearch(const LoopDependences& loop, const BfinInstrInfo& tii,
                               unsigned cycles, unsigned stages,
                               const std::vector<IndexStream>& streams)
    : loop_(loop),
      insts_(loop.instructions()),
      cycles_(static_cast<int>(cycles)),
      last_time_(static_cast<int>(stages * cycles) - 1),
      times_(insts_.size()),
      table_(cycles) {
  for (MachineInstr* inst : insts_) {
    const bool indexed = any_of(
        streams, [&](const IndexStream& stream) { return is_contained(stream.accesses, inst); });
    slots_of_.push_back(indexed ? unsigned{BfinII::kIndexSlot} : slot_of(*inst, tii));
  }
}

/// Longest ways. False: some circle is longer than the passes it goes round allow.
bool ScheduleSearch::find_distances() {
  const size_t count = insts_.size();
  distances_.assign(count, std::vector<int>(count, kNever));
  for (const LoopDependence& dependence : loop_.all()) {
    int& distance = distances_[dependence.from][dependence.to];
    distance = std::max(distance, dependence.latency - cycles_ * dependence.distance);
  }
  for (size_t k = 0; k < count; ++k)
    for (size_t i = 0; i < count; ++i)
      for (size_t j = 0; j < count && distances_[i][k] != kNever; ++j)
        if (distances_[k][j] != kNever)
          distances_[i][j] = std::max(distances_[i][j], distances_[i][k] + distances_[k][j]);
  for (size_t i = 0; i < count; ++i)
    if (distances_[i][i] > 0)
      return false;
  return true;
}

bool ScheduleSearch::has_room(size_t i, int time) const {
  for (int k = 0; k < length(i); ++k) {
    PacketSlots slots;
    for (const size_t member : table_[slot(time + k)])
      slots.add(*insts_[member], slots_of_[member]);
    if (!slots.add(*insts_[i], slots_of_[i]))
      return false;
  }
  return true;
}

bool ScheduleSearch::stages_agree(size_t i, int time) const {
  return all_of(loop_.same_stage(), [&](const auto& pair) {
    if (pair.first != i && pair.second != i)
      return true;
    const std::optional<int>& other = times_[pair.first == i ? pair.second : pair.first];
    return !other || (*other < cycles_) == (time < cycles_);
  });
}

bool ScheduleSearch::try_at(size_t i, int time, std::vector<Window> windows) {
  for (size_t j = 0; j < insts_.size(); ++j) {
    if (distances_[i][j] != kNever)
      windows[j].earliest = std::max(windows[j].earliest, time + distances_[i][j]);
    if (distances_[j][i] != kNever)
      windows[j].latest = std::min(windows[j].latest, time - distances_[j][i]);
    if (windows[j].earliest > windows[j].latest)
      return false;
  }
  windows[i] = {time, time};
  times_[i] = time;
  for (int k = 0; k < length(i); ++k)
    table_[slot(time + k)].push_back(i);
  if (place_rest(windows))
    return true;
  times_[i].reset();
  for (int k = 0; k < length(i); ++k)
    table_[slot(time + k)].pop_back();
  return false;
}

std::optional<size_t> ScheduleSearch::next_to_place(const std::vector<Window>& windows) const {
  const auto choice = [&](size_t i) { return windows[i].latest - windows[i].earliest; };
  const bool least_choice = order_ == Order::kLeastChoiceEarly || order_ == Order::kLeastChoiceLate;
  std::optional<size_t> next;
  for (size_t i = 0; i < insts_.size(); ++i) {
    const bool better =
        !next || (least_choice ? choice(i) < choice(*next) : order_ == Order::kProgramLate);
    if (!times_[i] && better)
      next = i;
  }
  return next;
}

bool ScheduleSearch::place_rest(const std::vector<Window>& windows) {
  const std::optional<size_t> next = next_to_place(windows);
  if (!next)
    return true;
  const auto [earliest, latest] = windows[*next];
  const bool late = order_ == Order::kLeastChoiceLate || order_ == Order::kProgramLate;
  for (int i = 0; i <= latest - earliest; ++i) {
    const int time = late ? latest - i : earliest + i;
    if (!has_room(*next, time) || !stages_agree(*next, time))
      continue;
    if (steps_ == 0)
      return false;
    --steps_;
    if (try_at(*next, time, windows))
      return true;
  }
  return false;
}

/// Loads as late as their readers allow: their registers are free until then.
void ScheduleSearch::sink_loads() {
  std::vector<size_t> loads;
  for (size_t i = 0; i < insts_.size(); ++i)
    if (insts_[i]->mayLoad() && !insts_[i]->mayStore())
      loads.push_back(i);
  stable_sort(loads, [&](size_t a, size_t b) { return *times_[a] > *times_[b]; });
  for (const size_t i : loads) {
    int latest = *times_[i] < cycles_ ? cycles_ - 1 : last_time_;
    for (size_t j = 0; j < insts_.size(); ++j)
      if (j != i && distances_[i][j] != kNever)
        latest = std::min(latest, *times_[j] - distances_[i][j]);
    llvm::erase(table_[slot(*times_[i])], i);
    while (latest > *times_[i] && !(has_room(i, latest) && stages_agree(i, latest)))
      --latest;
    times_[i] = std::max(latest, *times_[i]);
    table_[slot(*times_[i])].push_back(i);
  }
}

bool ScheduleSearch::prepare() {
  for (size_t i = 0; i < insts_.size(); ++i)
    if (length(i) > cycles_)
      return false;
  return find_distances();
}

std::optional<std::vector<unsigned>> ScheduleSearch::run(Order order) {
  order_ = order;
  steps_ = kSteps;
  times_.assign(insts_.size(), std::nullopt);
  table_.assign(static_cast<size_t>(cycles_), {});
  std::vector<Window> windows(insts_.size(), {0, last_time_});
  for (size_t i = 0; i < insts_.size(); ++i)
    for (size_t j = 0; j < insts_.size(); ++j)
      if (distances_[i][j] != kNever) {
        windows[j].earliest = std::max(windows[j].earliest, distances_[i][j]);
        windows[i].latest = std::min(windows[i].latest, last_time_ - distances_[i][j]);
      }
  if (!place_rest(windows))
    return std::nullopt;
  sink_loads();
  std::vector<unsigned> times;
  for (const std::optional<int>& time : times_)
    times.push_back(static_cast<unsigned>(*time));
  return times;
}

}  // namespace

static bool is_allowed(const LoopDependences& loop, const ModuloSchedule& schedule,
                       unsigned stages) {
  return all_of(schedule.times, [&](unsigned time) { return time < stages * schedule.cycles; }) &&
         all_of(loop.same_stage(), [&](const auto& pair) {
           return schedule.in_first_stage(pair.first) == schedule.in_first_stage(pair.second);
         });
}

/// What there is one of in each packet takes as many cycles.
static unsigned least_cycles(const LoopDependences& loop, const BfinInstrInfo& tii) {
  unsigned cycles = 0;
  for (const MachineInstr* inst : loop.instructions()) {
    const unsigned slot = slot_of(*inst, tii);
    if (slot == BfinII::kDspSlot || slot == BfinII::kAlone)
      cycles += BfinSubtarget::issueCycles(*inst);
  }
  return std::max(cycles, 1U);
}

/// The times as a schedule; cycles are 0 where stages do not allow it.
static ModuloSchedule begun_early(const LoopDependences& loop, const std::vector<unsigned>& times,
                                  unsigned cycles, unsigned stages) {
  const unsigned first = *std::min_element(times.begin(), times.end());
  // Where the second stage begins is free; it shall begin early, so that little runs ahead.
  for (unsigned shift = stages == 1 ? 1 : cycles; shift-- > 0;) {
    ModuloSchedule schedule{cycles, {}};
    for (const unsigned time : times)
      schedule.times.push_back(time - first + shift);
    if (is_allowed(loop, schedule, stages))
      return schedule;
  }
  return {};
}

ModuloSchedule schedule_loop(const LoopDependences& loop, const BfinInstrInfo& tii, unsigned stages,
                             unsigned most, const std::vector<IndexStream>& streams,
                             function_ref<bool(const ModuloSchedule&)> allowed) {
  for (unsigned cycles = least_cycles(loop, tii); cycles <= most; ++cycles) {
    ScheduleSearch search(loop, tii, cycles, stages, streams);
    if (!search.prepare())
      continue;
    for (const Order order : {Order::kLeastChoiceEarly, Order::kProgramEarly, Order::kProgramLate,
                              Order::kLeastChoiceLate}) {
      const std::optional<std::vector<unsigned>> times = search.run(order);
      if (!times)
        continue;
      ModuloSchedule schedule = begun_early(loop, *times, cycles, stages);
      if (schedule.cycles != 0 && allowed(schedule))
        return schedule;
    }
  }
  return {};
}

std::vector<size_t> kernel_order(const LoopDependences& loop, const ModuloSchedule& schedule) {
  const size_t count = loop.instructions().size();
  const auto stage = [&](size_t i) { return schedule.in_first_stage(i) ? 0 : 1; };
  // Of one cycle, what overwrites its operands comes last: the others read them, too. A sequence,
  // which reads until its last part, stands there: what issues beside it gets registers apart.
  const auto place = [&](size_t i) {
    const MachineInstr& inst = *loop.instructions()[i];
    const unsigned last =
        schedule.times[i] % schedule.cycles + BfinSubtarget::issueCycles(inst) - 1;
    const auto overwritten =
        count_if(inst.all_uses(), [](const MachineOperand& use) { return use.isTied(); });
    return std::pair(std::min(last, schedule.cycles - 1), overwritten);
  };
  std::vector<size_t> order;
  std::vector<bool> placed(count, false);
  while (order.size() < count) {
    std::optional<size_t> next;
    for (size_t i = 0; i < count; ++i) {
      const bool ready = none_of(loop.all(), [&](const LoopDependence& dependence) {
        return dependence.to == i && dependence.from != i && !placed[dependence.from] &&
               dependence.distance + stage(i) - stage(dependence.from) == 0;
      });
      if (!placed[i] && ready && (!next || place(i) < place(*next)))
        next = i;
    }
    if (!next)
      return {};  // in a circle
    placed[*next] = true;
    order.push_back(*next);
  }
  return order;
}

}  // namespace llvm
