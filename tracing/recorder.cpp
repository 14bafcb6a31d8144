#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <tracing/recorder.hpp>
#include <utility>

#include <common/error.hpp>
#include <common/parameter.hpp>
#include <common/pattern.hpp>

namespace finback::tracing {

namespace {

constexpr std::array kCores = {CoreId::a, CoreId::b};

std::optional<Cycles> as_cycle(const std::string& text) {
  Cycles cycle = 0;
  const char* end = text.data() + text.size();
  const bool number =
      !text.empty() && std::from_chars(text.data(), end, cycle) == std::from_chars_result{end, {}};
  return number ? std::optional(cycle) : std::nullopt;
}

}  // namespace

Recorder::Recorder(const Window& window, Code& code) : code_(code), limit_(window.limit) {
  for (const CoreId core : kCores) {
    Track& track = tracks_[static_cast<std::size_t>(core)];
    track.wanted = code.core(core).present && (!window.core || *window.core == core);
    track.open = window.from.empty();
  }
  set_edge(window.from, &Track::from);
  set_edge(window.to, &Track::to);
  set_functions(window.function);
}

void Recorder::set_edge(const std::string& place, Edge Track::*edge) {
  if (place.empty()) {
    return;
  }
  const std::optional<Cycles> cycle = as_cycle(place);
  bool found = cycle.has_value();
  for (const CoreId core : kCores) {
    Track& track = tracks_[static_cast<std::size_t>(core)];
    (track.*edge).cycle = cycle;
    if (cycle || !track.wanted) {
      continue;
    }
    const std::vector<std::uint32_t> packets = code_.packets_at(core, place);
    track.wanted = !packets.empty();  // the other core may have it
    found = found || track.wanted;
    std::vector<bool>& marks = (track.*edge).packets;
    marks.resize(code_.core(core).packets.size());
    for (const std::uint32_t packet : packets) {
      marks[packet] = true;
    }
  }
  if (!found) {
    fail_unknown("place", place);
  }
}

void Recorder::set_functions(const std::string& pattern) {
  if (pattern.empty()) {
    return;
  }
  bool found = false;
  for (const CoreId core : kCores) {
    Track& track = tracks_[static_cast<std::size_t>(core)];
    bool here = false;
    for (const std::string& name : code_.function_names(core)) {
      track.functions.push_back(matches_pattern(pattern, name));
      here = here || track.functions.back();
    }
    track.wanted = track.wanted && here;
    found = found || track.wanted;
  }
  if (!found) {
    fail_unknown("function", pattern);
  }
}

void Recorder::fail_unknown(const std::string& what, const std::string& name) const {
  std::vector<std::string> names;
  for (const CoreId core : kCores) {
    const std::vector<std::string> of_core = code_.function_names(core);
    names.insert(names.end(), of_core.begin(), of_core.end());
  }
  const std::string near = nearest_name(name, names);
  throw InputError(fmt::format(
      "there is no {} {} in what is traced{}", what, name,
      near.empty() ? ": write a function, FUNCTION:LABEL, FILE:LINE, 0xADDRESS or a cycle"
                   : fmt::format(", did you mean {}?", near)));
}

void Recorder::attach(machine::Machine& machine) {
  for (const CoreId core : kCores) {
    if (tracks_[static_cast<std::size_t>(core)].wanted) {
      machine.trace(core, [this, core](const core::TraceRecord& r) { record(core, r); });
    }
  }
}

void Recorder::record(CoreId core, const core::TraceRecord& record) {
  Track& track = tracks_[static_cast<std::size_t>(core)];
  if (track.closed) {
    return;
  }
  const bool was_open = track.open;
  track.open =
      was_open || (track.from.cycle ? record.end() > *track.from.cycle : track.from.at(record));
  if (!track.open) {
    return;
  }
  const bool over =
      track.to.cycle ? record.begin >= *track.to.cycle : was_open && track.to.at(record);
  track.limited = !over && limit_ != 0 && track.records.size() == limit_;
  track.closed = over || track.limited;
  if (track.closed) {
    return;
  }
  const std::uint32_t function = code_.packet(core, record.packet).function;
  if (track.functions.empty() || track.functions[function]) {
    track.records.push_back(record);
  }
}

bool Recorder::done(Cycles now) const {
  return std::ranges::all_of(tracks_, [now](const Track& track) {
    return !track.wanted || track.closed || (track.to.cycle && now >= *track.to.cycle);
  });
}

bool Recorder::limited() const {
  return std::ranges::any_of(tracks_, [](const Track& track) { return track.limited; });
}

std::vector<Recorded> Recorder::take() {
  std::vector<Recorded> all;
  for (const CoreId core : kCores) {
    for (core::TraceRecord& record : tracks_[static_cast<std::size_t>(core)].records) {
      all.push_back({core, std::move(record)});
    }
  }
  std::ranges::stable_sort(all, {}, [](const Recorded& r) { return r.record.begin; });
  return all;
}

}  // namespace finback::tracing
