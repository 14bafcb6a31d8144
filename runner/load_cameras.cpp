#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include <common/file.hpp>
#include <runner/identity.hpp>
#include <runner/load_cameras.hpp>
#include <scenes/sequence.hpp>

namespace finback::runner {

namespace fs = std::filesystem;
using peripheral::FrameTrouble;

namespace {

constexpr std::uint32_t kMovingSeed = 1;

// A sequence, its name and what tells it from others.
struct Named {
  std::unique_ptr<scenes::FrameSequence> sequence;
  std::string name;
  std::string identity;
};

// Names and bytes of all files, in the order of their names.
std::string folder_identity(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::string identity;
  for (const fs::path& file : files) {
    identity += file.filename().string() + ' ' + report::content_hash(read_text_file(file)) + '\n';
  }
  return identity;
}

Named load_frames(const std::string& from) {
  if (from == "moving") {
    return {scenes::moving_sequence(kMovingSeed), from, fmt::format("moving {}", kMovingSeed)};
  }
  if (const std::size_t comma = from.find(','); comma != std::string::npos) {
    const fs::path left = from.substr(0, comma);
    const fs::path right = from.substr(comma + 1);
    return {
        scenes::video_sequence({left, right}), from,
        report::content_hash(read_text_file(left)) + report::content_hash(read_text_file(right))};
  }
  const fs::path path(from);
  if (fs::is_directory(path)) {
    return {scenes::folder_sequence(path), path.lexically_normal().string(), folder_identity(path)};
  }
  if (!fs::exists(path)) {
    throw InputError(
        fmt::format("--frames-from {}: there is no such folder or video, and the only scene that "
                    "moves is 'moving'",
                    from));
  }
  return {scenes::video_sequence({path}), path.filename().string(),
          report::content_hash(read_text_file(path))};
}

// The numbers of a frame that is late or dropped: "[left:|right:]NUMBER[:MS]".
struct Trouble {
  bool left = true;
  bool right = true;
  FrameTrouble frame;
};

Trouble parse_trouble(const std::string& option, const std::string& text, bool late) {
  std::string_view rest = text;
  Trouble trouble;
  trouble.frame.dropped = !late;
  if (rest.starts_with("left:")) {
    trouble.right = false;
    rest.remove_prefix(5);
  } else if (rest.starts_with("right:")) {
    trouble.left = false;
    rest.remove_prefix(6);
  }
  const char* end = rest.data() + rest.size();
  auto [after, error] = std::from_chars(rest.data(), end, trouble.frame.frame);
  if (late && error == std::errc() && after != end && *after == ':') {
    double milliseconds = -1;
    const auto number = std::from_chars(after + 1, end, milliseconds);
    after = number.ptr;
    const bool sensible = milliseconds >= 0 && milliseconds <= 1e6;
    error = sensible ? number.ec : std::errc::invalid_argument;
    trouble.frame.late_us = milliseconds * 1e3;
  } else if (late) {
    error = std::errc::invalid_argument;
  }
  if (error != std::errc() || after != end) {
    throw InputError(fmt::format("{} {}: wants {}", option, text,
                                 late ? "FRAME:MILLISECONDS, such as 12:5 or left:12:5"
                                      : "the number of a frame, such as 12 or left:12"));
  }
  return trouble;
}

}  // namespace

void load_scene(const RunRequest& request, RunInputs& inputs) {
  Named named;
  if (request.frames_from.empty()) {
    inputs.scene = request.left.empty()
                       ? scenes::load_scene(request.scene, share_folder() / "scenes")
                       : scenes::load_scene_pair(request.left, request.right);
    named = {nullptr, inputs.scene.name, scene_hash(inputs.scene)};
  } else {
    named = load_frames(request.frames_from);
  }
  const bool bent = !request.distortion.empty() || !request.misalignment.empty();
  if (bent) {
    scenes::Lens left;
    if (!request.distortion.empty()) {
      left.k1 = request.distortion[0];
      left.k2 = request.distortion[1];
    }
    scenes::Lens right = left;
    if (!request.misalignment.empty()) {
      right.rotation_degrees = request.misalignment[0];
      right.shift_x = request.misalignment[1];
      right.shift_y = request.misalignment[2];
    }
    if (!named.sequence) {
      named.sequence = scenes::still_sequence(std::move(inputs.scene));
    }
    named.sequence = scenes::sequence_through_lenses(std::move(named.sequence), left, right);
    named.identity += fmt::format("lenses {} {}\n", fmt::join(request.distortion, " "),
                                  fmt::join(request.misalignment, " "));
  }
  if (!named.sequence) {
    return;
  }
  const scenes::LumaPair& first = named.sequence->pair(0);
  inputs.scene = {named.name, first.left, first.right, named.sequence->truth(0)};
  inputs.sequence = std::move(named.sequence);
  inputs.sequence_hash = report::content_hash(named.identity);
}

std::array<std::vector<FrameTrouble>, 2> camera_troubles(const RunRequest& request) {
  std::array<std::vector<FrameTrouble>, 2> troubles;
  const auto add = [&](const Trouble& trouble) {
    if (trouble.left) {
      troubles[0].push_back(trouble.frame);
    }
    if (trouble.right) {
      troubles[1].push_back(trouble.frame);
    }
  };
  for (const std::string& text : request.late) {
    add(parse_trouble("--late-frame", text, true));
  }
  for (const std::string& text : request.dropped) {
    add(parse_trouble("--drop-frame", text, false));
  }
  return troubles;
}

}  // namespace finback::runner
