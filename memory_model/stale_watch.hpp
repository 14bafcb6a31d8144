// Who saw old data because of a cache: what the chip does not tell, and a run can.
//
// There is no coherence between the cores' caches, or with DMA: software has to flush. Noted are
// reads of bytes that a core's cache holds and others have changed, reads of memory of which a
// cache holds newer bytes, and write-backs and shutdowns of the cache by which bytes are lost. Each
// combination of object and places is one report, however often it happens. Does not model
// anything: the chip does the same without a word. A core that runs ahead of the other
// (docs/architecture.md) may be told late: what is noted is right, some cycles' worth may be
// missing.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

#include <common/units.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::memory {

inline constexpr std::uint32_t kNoSite = ~std::uint32_t{0};

// Who touches memory, and where in its code: the number of a core's packet, kNoSite for others.
struct Accessor {
  Initiator initiator = Initiator::host;
  std::uint32_t site = kNoSite;
  bool operator==(const Accessor&) const = default;
  [[nodiscard]] bool operator<(const Accessor& other) const {
    return std::tie(initiator, site) < std::tie(other.initiator, other.site);
  }
};

enum class StaleKind : std::uint8_t {
  old_in_cache,   // a core read its cache's old copy; `other` has changed it since
  old_in_memory,  // memory was read while `other`, a core, had newer bytes in its cache
  overwritten,    // a core wrote a line back over what `other` had changed in memory
  dropped,        // a core turned its cache off and lost what `other`, itself, had stored
};
inline constexpr int kStaleKinds = 4;
inline constexpr std::array<std::string_view, kStaleKinds> kStaleKindNames = {
    "old_in_cache", "old_in_memory", "overwritten", "dropped"};

struct StaleReport {
  StaleKind kind = StaleKind::old_in_cache;
  std::uint32_t object = 0;  // index into MemorySystem::objects()
  Accessor reader;           // or who wrote back, or turned the cache off
  Accessor other;
  Address address = 0;  // where it happened first, and when
  Cycles at = 0;
  std::uint64_t times = 0;
};

class StaleWatch {
 public:
  void note(const StaleReport& report) {
    ++counts_[static_cast<std::size_t>(report.kind)];
    const auto [entry, is_new] = index_.try_emplace(
        {report.kind, report.object, report.reader, report.other}, reports_.size());
    if (is_new) {
      reports_.push_back(report);
    }
    ++reports_[entry->second].times;
  }
  // In the order in which each happened first.
  [[nodiscard]] const std::vector<StaleReport>& reports() const { return reports_; }
  [[nodiscard]] const std::uint64_t& count(StaleKind kind) const {
    return counts_[static_cast<std::size_t>(kind)];
  }

 private:
  std::array<std::uint64_t, kStaleKinds> counts_{};
  std::vector<StaleReport> reports_;
  std::map<std::tuple<StaleKind, std::uint32_t, Accessor, Accessor>, std::size_t> index_;
};

}  // namespace finback::memory
