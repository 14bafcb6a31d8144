// `finback stereo match`, `check` and `postprocess`: disparity maps of pictures, step by step.
#include <fmt/format.h>
#include <memory>

#include <cli/stereo_command.hpp>
#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/map_file.hpp>
#include <stereo_reference/method.hpp>
#include <stereo_reference/texture.hpp>

namespace finback::cli {

namespace {

using namespace stereo_reference;

struct MatchOptions {
  std::string left;
  std::string right;
  std::string method = "census3";
  MatchParameters parameters;
  int scale = 1;
  std::string out;
  std::string right_out;
};

struct LrcOptions {
  std::string left;
  std::string right;
  int threshold = 1;
  int scale = 1;
  std::string out;
};

struct PostOptions {
  std::string map;
  std::string image;
  PostProcessing how;
  int scale = 1;
  std::string out;
};

int valid_percent(const scenes::ByteImage& map) {
  const auto& pixels = map.pixels();
  const auto none = std::ranges::count(pixels, 0);
  return static_cast<int>(100 * (pixels.size() - static_cast<std::size_t>(none)) / pixels.size());
}

void print_map(const std::string& path, const scenes::ByteImage& map) {
  fmt::print("{}: {}x{} pixels, {} % with a disparity\n", path, map.width(), map.height(),
             valid_percent(map));
}

int match(const MatchOptions& options) {
  const DisparityPair maps =
      stereo_reference::match(parse_method(options.method), scenes::load_luma(options.left),
                              scenes::load_luma(options.right), options.parameters);
  write_map(maps.left, options.scale, options.out);
  print_map(options.out, maps.left);
  if (!options.right_out.empty()) {
    write_map(maps.right, options.scale, options.right_out);
    print_map(options.right_out, maps.right);
  }
  return kFine;
}

int check(const LrcOptions& options) {
  const scenes::ByteImage map = check_left_right(
      {load_map(options.left, options.scale), load_map(options.right, options.scale)},
      options.threshold);
  write_map(map, options.scale, options.out);
  print_map(options.out, map);
  return kFine;
}

int post(const PostOptions& options) {
  const scenes::ByteImage map = post_process(load_map(options.map, options.scale),
                                             scenes::load_luma(options.image), options.how);
  write_map(map, options.scale, options.out);
  print_map(options.out, map);
  return kFine;
}

CLI::Option* add_file(CLI::App& command, const char* name, std::string& value, const char* what) {
  return command.add_option(name, value, what)->type_name("IMAGE")->required();
}

void add_scale(CLI::App& command, int& scale) {
  command.add_option("--scale", scale, "Greys of a map a pixel of disparity")
      ->type_name("N")
      ->capture_default_str();
}

void add_out(CLI::App& command, std::string& out) {
  command.add_option("--out", out, "The map to write")->type_name("MAP.png")->required();
}

}  // namespace

void add_stereo_match(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<MatchOptions>();
  CLI::App* command = stereo.add_subcommand("match", "Find the disparities of a rectified pair");
  add_file(*command, "--left", options->left, "The left picture");
  add_file(*command, "--right", options->right, "The right one, of the same size");
  command->add_option("--by", options->method, "census3, census5, rank3, rank5, sad, ssd or ncc")
      ->type_name("METHOD")
      ->capture_default_str();
  command->add_option("--window", options->parameters.window, "Side of the window, odd")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--min", options->parameters.disparity_min, "The least disparity")
      ->type_name("D")
      ->capture_default_str();
  command->add_option("--max", options->parameters.disparity_max, "The largest")
      ->type_name("D")
      ->capture_default_str();
  add_scale(*command, options->scale);
  add_out(*command, options->out);
  command
      ->add_option("--right-out", options->right_out,
                   "Also write the right picture's map, for check")
      ->type_name("MAP.png");
  command->footer(
      "Example: finback stereo match --left l.png --right r.png --max 64 --scale 3 --out map.png");
  command->callback([&action, options] { action = [options] { return match(*options); }; });
}

void add_stereo_check(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<LrcOptions>();
  CLI::App* command =
      stereo.add_subcommand("check", "Keep the disparities on which both pictures agree");
  add_file(*command, "--left", options->left, "The left picture's map");
  add_file(*command, "--right", options->right, "The right picture's map");
  command->add_option("--threshold", options->threshold, "By how many pixels they may differ")
      ->type_name("D")
      ->capture_default_str();
  add_scale(*command, options->scale);
  add_out(*command, options->out);
  command->footer(
      "Example: finback stereo check --left map.png --right right.png --out checked.png");
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

void add_stereo_postprocess(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<PostOptions>();
  CLI::App* command = stereo.add_subcommand(
      "postprocess", "Drop disparities that contradict each other where there is no texture");
  add_file(*command, "--map", options->map, "The map");
  add_file(*command, "--image", options->image, "The picture that it belongs to");
  command->add_option("--window", options->how.window, "Side of the window, odd")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--texture", options->how.texture_threshold,
                   "T_L: no texture up to this variance of greys")
      ->type_name("V")
      ->capture_default_str();
  command
      ->add_option("--disparity", options->how.disparity_threshold,
                   "T_H: contradiction from this variance of disparities")
      ->type_name("V")
      ->capture_default_str();
  command->add_flag("--either", options->how.either, "One of both suffices");
  add_scale(*command, options->scale);
  add_out(*command, options->out);
  command->footer(
      "Example: finback stereo postprocess --map checked.png --image l.png --out final.png");
  command->callback([&action, options] { action = [options] { return post(*options); }; });
}

}  // namespace finback::cli
