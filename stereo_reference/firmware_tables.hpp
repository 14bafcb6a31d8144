// The firmware's rectification tables of a calibration, as C or for its flash, and what they cost
// in greys.
//
// Models: pictures of every n-th pixel, as the firmware sub-samples; indices of a byte and
// fractions of 1.15 (rectification_table), without tangential distortion unless asked for; the
// difference from the exact rectification of the same picture. Does not model: where the firmware
// keeps them.
#pragma once

#include <string>

#include <stereo_reference/rectification.hpp>

namespace finback::stereo_reference {

struct TableErrors {
  double seen_percent = 0;  // pixels that the camera saw
  // Greys, of the pixels that both ways give; on a picture whose every pixel differs from its
  // neighbours at random, the hardest there is.
  double mean = 0;
  int largest = 0;
  // The same with exact arithmetic: what leaving the tangential part out alone does. 0 where it is
  // in.
  double tangential_mean = 0;
  double tangential_shift = 0;  // and how far it moves a pixel at most, pixels
};

struct FirmwareTables {
  RectificationTable left;
  RectificationTable right;
  TableErrors left_errors;
  TableErrors right_errors;
};

// Throws InputError where n does not divide the size or 256 columns or rows do not hold the result.
[[nodiscard]] FirmwareTables firmware_tables(const StereoCalibration& calibration, int n,
                                             bool tangential);

// A C file of four constant arrays: indices and weights of the left and of the right camera.
[[nodiscard]] std::string tables_as_c(const FirmwareTables& tables);

// What the firmware looks for at the beginning of flash (firmware/mesvs2/rectify.h): the word
// 0x54434552 ("RECT"), width and height in 16 bits each; then, row by row, the left camera's table
// before the right one's, each row's indices before its weights. Little-endian.
[[nodiscard]] std::string tables_as_flash(const FirmwareTables& tables);

}  // namespace finback::stereo_reference
