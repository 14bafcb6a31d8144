// What light and cameras do to one view and not to the other: the changes under which matching is
// tried.
//
// Models: vignetting, scale, Gaussian noise and gamma (Ahuja 2009, A.23 to A.26) on grey pictures,
// rounded and kept within 0..255. Noise is the sum of twelve uniform numbers of a generator with a
// seed: the same picture gets the same noise on every host. Does not model: colour, noise that
// depends on the light.
#pragma once

#include <cstdint>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

// Darker with the distance from the centre, linearly, to `level` (0 < level <= 1) in the corners.
[[nodiscard]] scenes::ByteImage vignette(const scenes::ByteImage& image, double level);

// Every grey times `factor` (> 0); the listing's level is a tenth of it.
[[nodiscard]] scenes::ByteImage scale_greys(const scenes::ByteImage& image, double factor);

// Greys stretched to 0..1, to the power of 1 / gamma (> 0), and back to 0..255.
[[nodiscard]] scenes::ByteImage change_gamma(const scenes::ByteImage& image, double gamma);

// Adds noise of that variance, for greys of 0..1 (>= 0).
[[nodiscard]] scenes::ByteImage add_noise(const scenes::ByteImage& image, double variance,
                                          std::uint32_t seed);
// The variance at which noise is so many decibels below the picture's mean square.
[[nodiscard]] double noise_variance(const scenes::ByteImage& image, double snr_decibel);

// All throw InputError for an empty picture and for levels outside the ranges given.

}  // namespace finback::stereo_reference
