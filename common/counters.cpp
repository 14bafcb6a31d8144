#include <stdexcept>
#include <utility>

#include <common/counters.hpp>

namespace finback {

void CounterRegistry::add(const std::string& name, const std::string& unit,
                          const std::string& meaning, std::function<std::uint64_t()> read) {
  const bool added = entries_.emplace(name, Entry{unit, meaning, std::move(read)}).second;
  if (!added) {
    throw std::logic_error("counter registered twice: " + name);
  }
}

std::map<std::string, CounterReading> CounterRegistry::snapshot() const {
  std::map<std::string, CounterReading> readings;
  for (const auto& [name, entry] : entries_) {
    readings[name] = CounterReading{entry.read(), entry.unit, entry.meaning};
  }
  return readings;
}

}  // namespace finback
