#include <algorithm>

#include <isa_sim/machine/clock_log.hpp>

namespace finback::machine {

namespace {

void add_difference(ChipWork& sum, const ChipWork& now, const ChipWork& before) {
  for (std::size_t core = 0; core < sum.cores.size(); ++core) {
    core::CoreWork& work = sum.cores[core];
    // A wake-up that a change of clock has cut short may have been counted ahead.
    work.busy += now.cores[core].busy - std::min(now.cores[core].busy, before.cores[core].busy);
    for (std::size_t i = 0; i < work.by_energy_class.size(); ++i) {
      work.by_energy_class[i] +=
          now.cores[core].by_energy_class[i] - before.cores[core].by_energy_class[i];
    }
  }
  sum.external_transfers += now.external_transfers - before.external_transfers;
}

}  // namespace

void ClockLog::settle(Cycles at, const ChipWork& now) {
  PointUse& use = uses_[current_];
  if (at > counted_to_) {
    use.cycles += at - counted_to_;
    use.seconds += static_cast<double>(at - counted_to_) / use.point.core_hertz;
    counted_to_ = at;
  }
  add_difference(use.work, now, counted_);
  counted_ = now;
}

void ClockLog::change(Cycles at, const clock::OperatingPoint& point, const ChipWork& now) {
  settle(at, now);
  history_.change(at, point);
  const auto known = std::ranges::find(uses_, point, &PointUse::point);
  current_ = static_cast<std::size_t>(known - uses_.begin());
  if (known == uses_.end()) {
    uses_.push_back({point, 0, 0, {}});
  }
}

}  // namespace finback::machine
