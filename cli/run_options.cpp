#include <algorithm>

#include <cli/camera_options.hpp>
#include <cli/run_options.hpp>

namespace finback::cli {

namespace {

constexpr const char* kGroup = "What is run";

}  // namespace

void add_run_options(CLI::App& command, runner::RunRequest& request) {
  CLI::Option* left = command.add_option("--left", request.left, "Left image, any size or colour");
  CLI::Option* right = command.add_option("--right", request.right, "Right image, of equal size");
  left->needs(right)->group(kGroup);
  right->needs(left)->group(kGroup);
  command.add_option("--scene", request.scene, "A scene with known truth: aloe or synthetic")
      ->capture_default_str()
      ->excludes(left)
      ->excludes(right)
      ->group(kGroup);
  command
      .add_option(
          "--frames-from", request.frames_from,
          "Pairs that change: moving, a folder of left_* and right_* pictures, a video (side "
          "by side), or two: LEFT,RIGHT")
      ->type_name("moving|DIR|VIDEO")
      ->excludes(left)
      ->excludes(right)
      ->excludes(command.get_option("--scene"))
      ->group(kGroup);
  command.add_option("--frames", request.frames, "Frames to process; pairs are repeated")
      ->capture_default_str()
      ->check(CLI::Range(1U, runner::kMostFrames))
      ->group(kGroup);
  add_link_options(command, request);
  command.add_option("--power", request.power, "Power file (TOML): other numbers for the watts")
      ->group(kGroup);
  add_camera_options(command, request, kGroup);
  add_port_options(command, request.ports, kGroup);
  command
      .add_option("--max-seconds", request.max_seconds,
                  "Give up after so much simulated time (default: 2 s a frame)")
      ->check(CLI::PositiveNumber)
      ->group(kGroup);
}

void add_link_options(CLI::App& command, runner::RunRequest& request) {
  command
      .add_option("--firmware", request.firmware,
                  "Installed firmware, or path of a folder, a firmware.toml or a .bir file")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--machine", request.machine,
                  "Installed machine, or machine file (TOML), instead of the BF561")
      ->group(kGroup);
  command
      .add_option("--set", request.settings,
                  "One machine parameter, e.g. memory.l2.read_cycles=9; repeatable")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false)
      ->group(kGroup);
  command
      .add_option("--placement", request.placement,
                  "Placement file (TOML) instead of the firmware's own")
      ->group(kGroup);
  command
      .add_option("--place", request.moves,
                  "Put one object, function or stack elsewhere, e.g. core_b.shd_scores=l3; "
                  "repeatable")
      ->type_name("OWNER.NAME=REGION")
      ->allow_extra_args(false)
      ->group(kGroup);
  command
      .add_option("--flash", request.flash,
                  "Put a file's bytes into flash; NAME: instead of the firmware's own; repeatable")
      ->type_name("[NAME=]FILE[@ADDRESS]")
      ->allow_extra_args(false)
      ->group(kGroup);
}

runner::RunRequest with_given_options(const CLI::App& command, const runner::RunRequest& given,
                                      runner::RunRequest base) {
  const auto take = [&](const char* option, auto member) {
    if (command.get_option(option)->count() > 0) {
      base.*member = given.*member;
    }
  };
  take("--left", &runner::RunRequest::left);
  take("--right", &runner::RunRequest::right);
  take("--scene", &runner::RunRequest::scene);
  take("--frames-from", &runner::RunRequest::frames_from);
  if (command.get_option("--scene")->count() > 0) {
    base.left.clear();
    base.right.clear();
  }
  take("--camera-rate", &runner::RunRequest::camera_rate);
  take("--distort", &runner::RunRequest::distortion);
  take("--misalign", &runner::RunRequest::misalignment);
  take("--drop-frame", &runner::RunRequest::dropped);
  take("--late-frame", &runner::RunRequest::late);
  take("--uart", &runner::RunRequest::ports);
  take("--uart-input", &runner::RunRequest::ports);
  take("--flags", &runner::RunRequest::ports);
  take("--flags-input", &runner::RunRequest::ports);
  take("--frames", &runner::RunRequest::frames);
  take("--firmware", &runner::RunRequest::firmware);
  take("--machine", &runner::RunRequest::machine);
  take("--placement", &runner::RunRequest::placement);
  take("--power", &runner::RunRequest::power);
  take("--max-seconds", &runner::RunRequest::max_seconds);
  base.flash.insert(base.flash.end(), given.flash.begin(), given.flash.end());
  base.moves.insert(base.moves.end(), given.moves.begin(), given.moves.end());
  base.settings.insert(base.settings.end(), given.settings.begin(), given.settings.end());
  return base;
}

void exclude_run_options(CLI::App& command, CLI::Option& option,
                         const std::vector<std::string>& still) {
  for (CLI::Option* other : command.get_options()) {
    if (other->get_group() == kGroup &&
        std::ranges::find(still, other->get_name()) == still.end()) {
      option.excludes(other);
    }
  }
}

}  // namespace finback::cli
