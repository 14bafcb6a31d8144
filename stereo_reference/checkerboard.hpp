// The corners of a checkerboard in a photograph.
//
// Models: OpenCV's detector, with corners refined to a fraction of a pixel; the order of the
// corners row by row, the same in both views of a pair. Does not model: boards that are only partly
// seen, circles, markers. OpenCV decides the last digits: they may differ from version to version.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scenes/image.hpp>
#include <stereo_reference/projection.hpp>

namespace finback::stereo_reference {

// Inner corners, where four squares meet.
struct Board {
  int columns = 9;
  int rows = 6;
  double square = 1;  // side of a square, in the unit that lengths shall have

  [[nodiscard]] int corners() const { return columns * rows; }
  // The corners in the board's own plane, row by row.
  [[nodiscard]] Points3 points() const;
};

// "9x6" as a board of unit squares. Throws InputError for other text and for fewer than 3 corners
// in a direction.
[[nodiscard]] Board parse_board(const std::string& text);

// None when the board is not wholly seen.
[[nodiscard]] std::optional<Points2> find_corners(const scenes::ByteImage& image,
                                                  const Board& board);

struct BoardPair {
  Points2 left;
  Points2 right;
};

struct BoardPairs {
  int width = 0;  // of all photographs
  int height = 0;
  std::vector<BoardPair> pairs;       // those with the whole board in both views
  std::vector<std::string> left_out;  // of the others, the photograph without it
};
// Reads photographs of a pair of cameras, in the same order, and finds the boards. Throws
// InputError for lists of different lengths, photographs that cannot be read, and different sizes.
[[nodiscard]] BoardPairs find_board_pairs(const std::vector<std::string>& left,
                                          const std::vector<std::string>& right, const Board& board,
                                          unsigned jobs);

}  // namespace finback::stereo_reference
