// A cache line on its way in: when which of its words arrives.
//
// Models: the word that the core waits for comes first, then the others in the order of their
// addresses, from the line's end on with its beginning. Source: hardware.md 2.3, 2.4.
#pragma once

#include <clock_model/clock_ratio.hpp>
#include <common/units.hpp>

namespace finback::memory {

inline constexpr Address kLineBytes = 32;

[[nodiscard]] constexpr Address line_of(Address address) { return address & ~(kLineBytes - 1); }

struct LineFill {
  Cycles first = 0;  // when the first beat has arrived
  Cycles beat = 0;   // from one beat to the next, in cycles of `clock`
  Cycles beat_bytes = kLineBytes;
  clock::ClockRatio clock = 1;

  [[nodiscard]] Cycles done() const {
    return first + clock.cycles((kLineBytes / beat_bytes - 1) * beat);
  }
  // When the beat with `address` has arrived, of a fill that began with that of `critical`.
  [[nodiscard]] Cycles arrival(Address critical, Address address) const {
    const Cycles beats = kLineBytes / beat_bytes;
    const Cycles distance =
        (address % kLineBytes / beat_bytes + beats - critical % kLineBytes / beat_bytes) % beats;
    return first + clock.cycles(distance * beat);
  }
};

}  // namespace finback::memory
