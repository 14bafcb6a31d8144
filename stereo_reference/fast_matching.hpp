// Matching of bytes at speed: what experiments on many pictures run on.
//
// Models: the maps of match_by for SHD and SAD on bytes (census 3x3, ranks, greys), equal in every
// pixel. A row of all disparities is in hand at a time, sums have 16 bits, and costs, sums and
// comparisons are loops that compilers make vectors of. Where 16 bits do not hold a window's sum,
// it is match_by that runs. Does not model: the other measures; how the firmware does it
// (match_recursive does).
#pragma once

#include <stereo_reference/measures.hpp>

namespace finback::stereo_reference {

// Throws InputError for another measure than SHD and SAD, and what match_by throws.
[[nodiscard]] DisparityPair match_bytes(Measure measure, const ByteImage& left,
                                        const ByteImage& right, const MatchParameters& parameters);

}  // namespace finback::stereo_reference
