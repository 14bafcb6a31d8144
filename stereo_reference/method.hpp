// What is compared and how, by one name: "census3", "rank5", "ncc".
//
// Models: the combinations that the thesis compares: grey values by SAD, SSD or NCC, ranks of 3x3
// and 5x5 by SAD, census of 3x3 and 5x5 by SHD. Does not model: ranks by SSD, other windows.
#pragma once

#include <string>
#include <vector>

#include <stereo_reference/matching.hpp>

namespace finback::stereo_reference {

enum class Method : std::uint8_t { census3, census5, rank3, rank5, sad, ssd, ncc };

[[nodiscard]] const std::vector<std::string>& method_names();
[[nodiscard]] const std::string& name_of(Method method);
// Throws InputError naming those that there are.
[[nodiscard]] Method parse_method(const std::string& name);

// Both maps of a pair of grey pictures. Throws what the matchers throw.
[[nodiscard]] DisparityPair match(Method method, const ByteImage& left, const ByteImage& right,
                                  const MatchParameters& parameters);

}  // namespace finback::stereo_reference
