#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <stereo_reference/parallel.hpp>

namespace finback::stereo_reference {

namespace {

constexpr auto kWatchTime = std::chrono::milliseconds(100);

class Workers {
 public:
  Workers(std::size_t count, const std::function<void(std::size_t)>& work)
      : work_(work), failures_(count) {}

  bool run(const Parallel& how) {
    const std::size_t threads = std::clamp<std::size_t>(how.jobs, 1, failures_.size());
    busy_ = threads;
    std::vector<std::jthread> running;
    for (std::size_t i = 0; i < threads; ++i) {
      running.emplace_back([this] { take_pieces(); });
    }
    look_on(how.watch);
    running.clear();  // joins
    for (const std::exception_ptr& failure : failures_) {
      if (failure) {
        std::rethrow_exception(failure);
      }
    }
    return done_ == failures_.size();
  }

 private:
  void look_on(const Watch& watch) {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, kWatchTime, [this] { return busy_ == 0; })) {
      lock.unlock();
      if (watch && watch(done_, failures_.size())) {
        stop_ = true;
      }
      lock.lock();
    }
  }

  void take_pieces() {
    for (std::size_t piece = next_++; piece < failures_.size() && !stop_; piece = next_++) {
      try {
        work_(piece);
        ++done_;
      } catch (...) {
        failures_[piece] = std::current_exception();
        stop_ = true;
      }
    }
    const std::lock_guard lock(mutex_);
    --busy_;
    ended_.notify_one();
  }

  const std::function<void(std::size_t)>& work_;
  std::vector<std::exception_ptr> failures_;  // by piece
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t busy_ = 0;
};

}  // namespace

bool run_all(std::size_t count, const Parallel& how, const std::function<void(std::size_t)>& work) {
  return count == 0 || Workers(count, work).run(how);
}

}  // namespace finback::stereo_reference
