// `finback stereo evaluate`: a disparity map against ground truth.
#include <fmt/format.h>
#include <memory>

#include <cli/stereo_command.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/map_file.hpp>

namespace finback::cli {

namespace {

using namespace stereo_reference;

constexpr double kHair = 1e-3;  // greys

struct EvaluateOptions {
  std::string map;
  std::string truth;
  std::string mask;
  int scale = 1;
  int truth_scale = 1;
  int border = 0;
  double delta = 1;
  bool scaled = false;  // as the listing of A.15: delta and errors in greys of the truth
};

int evaluate(const EvaluateOptions& options) {
  const scenes::ByteImage map = load_map(options.map, options.scale);
  const scenes::FloatImage truth = load_truth(options.truth, options.truth_scale);
  const Region region = inner_region(map.width(), map.height(), options.border);
  const double unit = options.scaled ? options.truth_scale : 1;  // a pixel
  // Errors are whole greys then: a hair above decides nothing but what division has rounded.
  const double delta = options.scaled ? (options.delta + kHair) / unit : options.delta;
  const MapQuality quality =
      options.mask.empty()
          ? stereo_reference::evaluate(map, truth, region, delta)
          : stereo_reference::evaluate(map, truth, region, scenes::load_luma(options.mask), delta);
  fmt::print("compared      {} pixels whose truth is known\n", quality.compared);
  fmt::print("no disparity  {:.2f} %\n",
             quality.compared == 0 ? 0.0 : 100.0 * quality.invalid / quality.compared);
  fmt::print("bad           {:.2f} % of all, {:.2f} % of those with a disparity\n",
             quality.bad_percent(), quality.wrong_percent());
  fmt::print("RMS error     {:.3f} {}, {:.3f} of those with a disparity\n",
             unit * quality.rms_error, options.scaled ? "greys" : "pixels",
             unit * quality.rms_error_valid);
  return kFine;
}

}  // namespace

void add_stereo_evaluate(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = stereo.add_subcommand("evaluate", "Hold a map against ground truth");
  command->add_option("--map", options->map, "The map")->type_name("IMAGE")->required();
  command->add_option("--truth", options->truth, "The truth; grey 0 is unknown")
      ->type_name("IMAGE")
      ->required();
  command->add_option("--mask", options->mask, "Only look where this picture is not black")
      ->type_name("IMAGE");
  command->add_option("--scale", options->scale, "Greys of the map a pixel of disparity")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--truth-scale", options->truth_scale, "Greys of the truth a pixel")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--border", options->border, "Pixels to leave out on every side")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--delta", options->delta, "Bad is what is off by more pixels")
      ->type_name("D")
      ->capture_default_str();
  command->add_flag("--scaled", options->scaled,
                    "As the listing of A.15: --delta and errors in greys of the truth");
  command->footer(
      "Example: finback stereo evaluate --map map.png --truth disp1.png --truth-scale 3");
  command->callback([&action, options] { action = [options] { return evaluate(*options); }; });
}

}  // namespace finback::cli
