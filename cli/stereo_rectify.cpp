// `finback stereo rectify` and `finback stereo tables`: what a calibration is good for.
#include <fmt/format.h>
#include <memory>

#include <cli/output_folder.hpp>
#include <cli/stereo_command.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/calibration_file.hpp>
#include <stereo_reference/firmware_tables.hpp>

namespace finback::cli {

namespace {

using namespace stereo_reference;

struct RectifyOptions {
  std::string calibration;
  std::string left;
  std::string right;
  std::string out;
  int subsample = 4;
  bool tangential = false;     // tables
  bool no_tangential = false;  // rectify
};

scenes::ByteImage load(const std::string& path, const StereoCalibration& calibration,
                       const std::string& file) {
  scenes::ByteImage image = scenes::load_luma(path);
  if (image.width() != calibration.width || image.height() != calibration.height) {
    throw InputError(fmt::format("{}: {}x{} pixels, but {} is of cameras with {}x{}", path,
                                 image.width(), image.height(), file, calibration.width,
                                 calibration.height));
  }
  return image;
}

int rectify(const RectifyOptions& options) {
  const StereoCalibration c = load_calibration(options.calibration);
  const RectifiedPair pair = stereo_reference::rectify(c);
  const auto rectified = [&](const std::string& path, const Intrinsics& camera,
                             const Eigen::Matrix3d& rotation, const Intrinsics& seen) {
    return remap(load(path, c, options.calibration),
                 pixel_map(camera, rotation, seen, c.width, c.height, !options.no_tangential));
  };
  OutputFolder output(options.out);
  scenes::write_png(rectified(options.left, c.left, pair.left_rotation, pair.left),
                    output.staged("left.png"));
  scenes::write_png(rectified(options.right, c.right, pair.right_rotation, pair.right),
                    output.staged("right.png"));
  output.commit();
  const Eigen::Index across = pair.vertical ? 1 : 0;
  fmt::print("focal length {} pixels, baseline {:.4g}{}\n", pair.left.focal[across],
             pair.translation.norm(), pair.vertical ? ", one camera above the other" : "");
  fmt::print("depth = {:.4g} / (disparity - {:.2f})\n",
             pair.left.focal[across] * pair.translation.norm(),
             pair.left.principal[across] - pair.right.principal[across]);
  return kFine;
}

void print_errors(const char* name, const TableErrors& errors, bool tangential) {
  fmt::print(
      "{:<5}  {:5.1f} % seen; against exact rectification {:.2f} greys on average, {} at most",
      name, errors.seen_percent, errors.mean, errors.largest);
  if (!tangential) {
    fmt::print("; of it without tangential distortion {:.2f} on average, up to {:.3f} pixels",
               errors.tangential_mean, errors.tangential_shift);
  }
  fmt::print("\n");
}

int tables(const RectifyOptions& options) {
  const FirmwareTables made =
      firmware_tables(load_calibration(options.calibration), options.subsample, options.tangential);
  write_file_whole(options.out,
                   options.out.ends_with(".c") ? tables_as_c(made) : tables_as_flash(made));
  fmt::print("{}x{} pixels, {} bytes in all four tables\n", made.left.width, made.left.height,
             2 * made.left.weights.size() * (2 + sizeof(made.left.weights.front())));
  print_errors("left", made.left_errors, options.tangential);
  print_errors("right", made.right_errors, options.tangential);
  return kFine;
}

void add_calibration(CLI::App& command, RectifyOptions& options) {
  command.add_option("calibration", options.calibration, "As finback stereo calibrate wrote it")
      ->type_name("RIG.toml")
      ->required();
}

}  // namespace

void add_stereo_rectify(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<RectifyOptions>();
  CLI::App* command =
      stereo.add_subcommand("rectify", "Make matching points of two photographs lie in one row");
  add_calibration(*command, *options);
  command->add_option("--left", options->left, "The left camera's photograph")
      ->type_name("IMAGE")
      ->required();
  command->add_option("--right", options->right, "The right camera's")
      ->type_name("IMAGE")
      ->required();
  command->add_option("--out", options->out, "Folder for left.png and right.png")
      ->type_name("DIR")
      ->required();
  command->add_flag("--no-tangential", options->no_tangential,
                    "Leave out tangential distortion, as the firmware does");
  command->footer(
      "Example: finback stereo rectify rig.toml --left l.png --right r.png --out out/rectified");
  command->callback([&action, options] { action = [options] { return rectify(*options); }; });
}

void add_stereo_tables(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<RectifyOptions>();
  CLI::App* command = stereo.add_subcommand(
      "tables", "Make the firmware's rectification tables, and say how exact");
  add_calibration(*command, *options);
  command
      ->add_option("--out", options->out, "What to write: FILE.c: C; any other: an image for flash")
      ->type_name("FILE")
      ->required();
  command->add_option("--subsample", options->subsample, "Every n-th pixel of every n-th row")
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--tangential", options->tangential,
                    "With tangential distortion, which the firmware leaves out");
  command->footer(
      "Example: finback stereo tables rig.toml --out tables.bin, then finback run --flash "
      "tables.bin");
  command->callback([&action, options] { action = [options] { return tables(*options); }; });
}

}  // namespace finback::cli
