// The registry of counters: each is registered once, under a dotted name, and every output reads it
// here.
//
// Components count in plain integers of their own, at full speed; the registry only knows where to
// read them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace finback {

struct CounterReading {
  std::uint64_t value = 0;
  std::string unit;     // "cycles", "bytes", "accesses", "instructions", "events"
  std::string meaning;  // one sentence
};

class CounterRegistry {
 public:
  // Registers `name`, e.g. "core_b.stall.load_use.cycles". `read` is called at every snapshot.
  // Throws std::logic_error when the name is taken.
  void add(const std::string& name, const std::string& unit, const std::string& meaning,
           std::function<std::uint64_t()> read);
  void add(const std::string& name, const std::string& unit, const std::string& meaning,
           const std::uint64_t* value) {
    add(name, unit, meaning, [value] { return *value; });
  }

  // All counters now, ordered by name.
  [[nodiscard]] std::map<std::string, CounterReading> snapshot() const;

 private:
  struct Entry {
    std::string unit;
    std::string meaning;
    std::function<std::uint64_t()> read;
  };
  std::map<std::string, Entry> entries_;
};

}  // namespace finback
