// A window of what the cores of one run issued.
//
// Records and filters, and knows when the window is over; what a packet cost is told by the cores
// themselves (isa_sim/core/trace.hpp). A window between places is looked for on each core by
// itself: it opens when the first of `from` is issued and closes when, later, one of `to` would be.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tracing/code.hpp>
#include <vector>

#include <isa_sim/core/trace.hpp>
#include <isa_sim/machine/machine.hpp>

namespace finback::tracing {

// A place is a cycle ("12000") or what Code::packets_at takes.
struct Window {
  std::string from;            // "": from the start
  std::string to;              // exclusive; "": to the end
  std::string function;        // only packets of functions that match this pattern; "": all
  std::optional<CoreId> core;  // only this one
  std::uint64_t limit = 0;     // records of each core; 0: as many as there are
};

struct Recorded {
  CoreId core = CoreId::a;
  core::TraceRecord record;
};

class Recorder {
 public:
  // Throws InputError for a place or a function that no recorded core has.
  Recorder(const Window& window, Code& code);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() = default;

  // Before the run, which it must outlive.
  void attach(machine::Machine& machine);

  // Nothing that happens from `now` on will be recorded.
  [[nodiscard]] bool done(Cycles now) const;
  // Some core had more to tell than the limit.
  [[nodiscard]] bool limited() const;
  // In order of time; of equal times core A's first.
  [[nodiscard]] std::vector<Recorded> take();

 private:
  // One end of the window: a time, or packets, the first of which counts.
  struct Edge {
    std::optional<Cycles> cycle;
    std::vector<bool> packets;  // by index; empty: no place
    [[nodiscard]] bool at(const core::TraceRecord& record) const {
      return !packets.empty() && packets[record.packet];
    }
  };
  struct Track {
    bool wanted = false;
    Edge from;
    Edge to;
    std::vector<bool> functions;  // by index; empty: all
    bool open = false;
    bool closed = false;
    bool limited = false;
    std::vector<core::TraceRecord> records;
  };

  void record(CoreId core, const core::TraceRecord& record);
  void set_edge(const std::string& place, Edge Track::*edge);
  void set_functions(const std::string& pattern);
  [[noreturn]] void fail_unknown(const std::string& what, const std::string& name) const;

  Code& code_;
  std::uint64_t limit_;
  std::array<Track, kCoreCount> tracks_;
};

}  // namespace finback::tracing
