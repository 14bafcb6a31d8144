#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mutex>
#include <thread>

#include <common/error.hpp>
#include <explorer/exploration.hpp>

namespace finback::explorer {

namespace {

constexpr auto kWatchTime = std::chrono::milliseconds(100);

class Workers {
 public:
  Workers(const Space& space, const std::vector<Candidate>& candidates, const Plan& plan,
          Store& store, const Observer& observer)
      : space_(space), candidates_(candidates), plan_(plan), store_(store), observer_(observer) {}

  std::size_t run(unsigned jobs) {
    const std::size_t count = std::clamp<std::size_t>(jobs, 1, plan_.to_simulate.size());
    std::vector<std::jthread> threads;
    busy_ = count;
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back([this] { work(); });
    }
    watch();
    threads.clear();  // joins
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return done_;
  }

 private:
  // The calling thread's part: lets the observer look on until all are done.
  void watch() {
    std::unique_lock lock(mutex_);
    while (!all_done_.wait_for(lock, kWatchTime, [this] { return busy_ == 0; })) {
      const std::size_t done = done_;
      lock.unlock();
      if (observer_.watch && observer_.watch(done)) {
        stop_ = true;
      }
      lock.lock();
    }
  }

  // A thread's part: one point after the other, as long as there are any.
  void work() {
    try {
      while (!stop_) {
        const std::size_t next = next_++;
        if (next >= plan_.to_simulate.size() || !simulate_one(plan_.to_simulate[next])) {
          break;
        }
      }
    } catch (...) {
      stop_ = true;
      const std::lock_guard lock(mutex_);
      failure_ = failure_ ? failure_ : std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    --busy_;
    all_done_.notify_one();
  }

  // False: stopped on the way.
  bool simulate_one(std::size_t index) {
    const Candidate& candidate = candidates_[index];
    Result result;
    try {
      runner::RunObserver run;
      run.cancelled = [this](Cycles, std::uint32_t) { return stop_.load(); };
      const runner::RunOutcome outcome =
          runner::run_firmware(inputs_of(space_, candidate.point), run);
      if (outcome.cancelled) {
        return false;
      }
      result.metrics = report::metrics_of(outcome.result);
    } catch (const InputError& error) {
      const std::string text = without_folders(space_, error.what());
      result.fault = text.substr(0, text.find('\n'));
    }
    const std::lock_guard lock(mutex_);
    store_.put(candidate.identity, result);
    ++done_;
    if (observer_.finished) {
      observer_.finished(candidate, result);
    }
    return true;
  }

  const Space& space_;
  const std::vector<Candidate>& candidates_;
  const Plan& plan_;
  Store& store_;
  const Observer& observer_;

  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;  // of all below, and of the store
  std::condition_variable all_done_;
  std::size_t busy_ = 0;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::string Plan::to_string() const {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) {
      parts.push_back(fmt::format("{} {}", count, what));
    }
  };
  add(misfits, misfits == 1 ? "does not fit" : "do not fit");
  add(equal, "equal to another");
  add(known, "known");
  parts.push_back(fmt::format("{} to simulate", to_simulate.size()));
  return fmt::format("{} point{}: {}", points, points == 1 ? "" : "s", fmt::join(parts, ", "));
}

Plan plan_of(const std::vector<Candidate>& candidates, const std::set<std::string>& known) {
  Plan plan;
  plan.points = candidates.size();
  std::set<std::string> seen;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (!candidate.misfit.empty()) {
      ++plan.misfits;
    } else if (!seen.insert(candidate.identity.key).second) {
      ++plan.equal;
    } else if (known.contains(candidate.identity.key)) {
      ++plan.known;
    } else {
      plan.to_simulate.push_back(i);
    }
  }
  return plan;
}

std::size_t simulate(const Space& space, const std::vector<Candidate>& candidates, const Plan& plan,
                     Store& store, unsigned jobs, const Observer& observer) {
  if (plan.to_simulate.empty()) {
    return 0;
  }
  return Workers(space, candidates, plan, store, observer).run(jobs);
}

}  // namespace finback::explorer
