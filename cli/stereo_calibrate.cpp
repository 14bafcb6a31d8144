// `finback stereo calibrate`: two cameras from photographs of a checkerboard.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <thread>

#include <cli/stereo_command.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <stereo_reference/calibration.hpp>
#include <stereo_reference/calibration_file.hpp>

namespace finback::cli {

namespace {

using namespace stereo_reference;

constexpr double kDegrees = 57.29577951308232;

struct CalibrateOptions {
  std::vector<std::string> left;
  std::vector<std::string> right;
  std::string board = "9x6";
  double square = 1;
  std::string out;
};

int calibrate(const CalibrateOptions& options) {
  if (!(options.square > 0) || !std::isfinite(options.square)) {
    throw InputError(fmt::format("--square {}: a length is wanted", options.square));
  }
  Board board = parse_board(options.board);
  board.square = options.square;
  const BoardPairs found = find_board_pairs(options.left, options.right, board,
                                            std::max(1U, std::thread::hardware_concurrency()));
  for (const std::string& path : found.left_out) {
    fmt::print(stderr, "{}: no board of {} corners; the pair is left out\n", path, options.board);
  }
  const CalibrationFit fit =
      stereo_reference::calibrate(found.pairs, board, found.width, found.height);
  const StereoCalibration& c = fit.calibration;
  const RowErrors rows = row_errors(c, found.pairs);
  write_file_whole(options.out, calibration_text(c));
  fmt::print("{} of {} pairs with the whole board, {} corners each\n", found.pairs.size(),
             options.left.size(), board.corners());
  fmt::print("error (RMS)   left {:.3f}, right {:.3f}, both together {:.3f} pixels\n", fit.left_rms,
             fit.right_rms, fit.rms);
  fmt::print("focal length  left {:.1f}, right {:.1f} pixels\n", c.left.focal.mean(),
             c.right.focal.mean());
  fmt::print("baseline      {:.4g}, turned by {:.2f} degrees\n", c.left_to_right.translation.norm(),
             c.left_to_right.rotation.norm() * kDegrees);
  fmt::print(
      "rectified     rows of a corner differ by {:.3f} pixels RMS, {:.3f} on average, {:.2f} "
      "at most\n",
      rows.rms, std::abs(rows.mean), rows.largest);
  return kFine;
}

}  // namespace

void add_stereo_calibrate(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command =
      stereo.add_subcommand("calibrate", "Measure two cameras by photographs of a checkerboard");
  command->add_option("--left", options->left, "The left camera's photographs")
      ->type_name("IMAGE...")
      ->required();
  command->add_option("--right", options->right, "The right camera's, in the same order")
      ->type_name("IMAGE...")
      ->required();
  command->add_option("--board", options->board, "Inner corners")
      ->type_name("COLUMNSxROWS")
      ->capture_default_str();
  command->add_option("--square", options->square, "A square's side: the unit of the baseline")
      ->type_name("LENGTH")
      ->capture_default_str();
  command->add_option("--out", options->out, "The calibration to write")
      ->type_name("FILE.toml")
      ->required();
  command->footer(
      "Example: finback stereo calibrate --left left*.png --right right*.png --square 25 "
      "--out rig.toml");
  command->callback([&action, options] { action = [options] { return calibrate(*options); }; });
}

}  // namespace finback::cli
