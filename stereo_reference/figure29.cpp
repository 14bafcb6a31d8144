#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include <scenes/luma.hpp>
#include <stereo_reference/figure29.hpp>

namespace finback::stereo_reference {

namespace fs = std::filesystem;

namespace {

// A pair to try, and where its truth comes from.
struct Pair {
  std::string name;
  fs::path left;  // of `folder`
  fs::path right;
  std::string truth;  // a scene's path
  bool other_light;
};

std::vector<Pair> pairs_of(const std::vector<MiddleburyScene>& plain) {
  const fs::path aloe = "radiometric/Aloe_thirdsize";
  const fs::path official = "2006/Aloe";
  std::vector<Pair> pairs;
  pairs.reserve(plain.size() + 9);
  for (const MiddleburyScene& scene : plain) {
    pairs.push_back({scene.name, scene.path() + "/view1.png", scene.path() + "/view5.png",
                     scene.path(), false});
  }
  // left_1 and right_1 share their light, so do view1 and view5.
  const std::pair<const char*, fs::path> rights[] = {{"right_1", aloe / "right_1.png"},
                                                     {"right_2", aloe / "right_2.png"},
                                                     {"right_3", aloe / "right_3.png"},
                                                     {"view5", official / "view5.png"}};
  for (const auto& [name, path] : rights) {
    const bool first = path.stem() == "right_1";
    pairs.push_back(
        {fmt::format("Aloe left_1 {}", name), aloe / "left_1.png", path, "2006/Aloe", !first});
  }
  for (const auto& [name, path] : rights) {
    const bool same = path.stem() == "view5";
    pairs.push_back(
        {fmt::format("Aloe view1 {}", name), official / "view1.png", path, "2006/Aloe", !same});
  }
  pairs.push_back({"ArtL", "radiometric/ArtL_quarter/left.png",
                   "radiometric/ArtL_quarter/right.png", "2005/Art", true});
  return pairs;
}

// The truth of a larger picture of the same view: nearest pixels, disparities shrunk with the
// width.
FloatImage shrunk(const FloatImage& truth, int width, int height) {
  FloatImage result(width, height);
  const float factor = static_cast<float>(width) / static_cast<float>(truth.width());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int from_x = (2 * x + 1) * truth.width() / (2 * width);
      const int from_y = (2 * y + 1) * truth.height() / (2 * height);
      result.at(x, y) = truth.at(from_x, from_y) * factor;
    }
  }
  return result;
}

MethodErrors try_pair(const fs::path& folder, const Pair& pair) {
  StereoSample sample = load_middlebury(folder, find_middlebury_scene(pair.truth).value());
  sample.left = scenes::load_luma(folder / pair.left);
  sample.right = scenes::load_luma(folder / pair.right);
  const int width = sample.left.width();
  const int height = sample.left.height();
  if (sample.left_truth.width() != width) {
    sample.left_truth = shrunk(sample.left_truth, width, height);
    sample.right_truth = shrunk(sample.right_truth, width, height);
  }
  const ByteImage mask = non_occluded_mask(sample);
  MethodErrors errors;
  for (std::size_t m = 0; m < kCompared.size(); ++m) {
    errors[m] = try_method(kCompared[m], sample.left, sample.right, sample.left_truth, mask,
                           sample.largest_disparity());
  }
  return errors;
}

std::string page_of(const std::vector<LightTrial>& trials) {
  std::vector<std::vector<std::string>> rows = {
      {"pair", "light", "rank3", "rank5", "census3", "rank3", "rank5", "census3"}};
  std::array<std::size_t, 2> below{};
  for (const LightTrial& trial : trials) {
    auto& row = rows.emplace_back();
    row = {trial.name, trial.other_light ? "differs" : "same"};
    for (double TrialError::*error : {&TrialError::of_all, &TrialError::of_valid}) {
      for (const TrialError& method : trial.errors) {
        row.push_back(fmt::format("{:.2f}", method.*error));
      }
    }
    for (std::size_t rank = 0; rank < below.size(); ++rank) {
      below[rank] += trial.errors[2].of_all < trial.errors[rank].of_all ? 1 : 0;
    }
  }
  return fmt::format(
      "Figure 29: percentage of bad pixels in non-occluded regions, 17x17, after the left-right "
      "check. First with pixels without a disparity as bad, then of those with a disparity.\n\n{}\n"
      "Census 3x3 is below rank3 in {} of {} pairs, below rank5 in {}.\n",
      markdown_table(rows), below[0], trials.size(), below[1]);
}

std::string csv_of(const std::vector<LightTrial>& trials) {
  std::vector<std::vector<std::string>> rows = {
      {"pair", "other_light", "method", "bad_percent", "bad_percent_of_valid"}};
  for (const LightTrial& trial : trials) {
    for (std::size_t m = 0; m < kCompared.size(); ++m) {
      rows.push_back({trial.name, fmt::format("{:d}", trial.other_light), name_of(kCompared[m]),
                      fmt::format("{:.4f}", trial.errors[m].of_all),
                      fmt::format("{:.4f}", trial.errors[m].of_valid)});
    }
  }
  return csv_table(rows);
}

std::string script_of(const std::vector<LightTrial>& trials, const fs::path& output) {
  std::string script = gnuplot_opening(output);
  auto out = std::back_inserter(script);
  script += "$trials << EOD\n";
  for (const LightTrial& trial : trials) {
    fmt::format_to(out, "\"{}\"", trial.name);
    for (const TrialError& error : trial.errors) {
      fmt::format_to(out, " {:.4f}", error.of_all);
    }
    script += '\n';
  }
  script += "EOD\n" + plot_style() +
            "set style data histograms\nset style histogram clustered gap 1\nset style fill solid\n"
            "set boxwidth 0.9\nset xtics rotate by -40 noenhanced\nset yrange [0:*]\n"
            "set ylabel 'bad pixels, %'\nplot ";
  for (std::size_t m = 0; m < kCompared.size(); ++m) {
    fmt::format_to(out, "{}$trials using {}:xtic(1) lc rgb '{}' title '{}'", m == 0 ? "" : ", ",
                   m + 2, kPlotColours[m], name_of(kCompared[m]));
  }
  return script + "\n";
}

}  // namespace

std::vector<LightTrial> measure_figure29(const fs::path& folder, const Parallel& how) {
  const std::vector<Pair> pairs = pairs_of(middlebury_scenes(2005));
  std::vector<LightTrial> trials(pairs.size());
  const bool complete = run_all(pairs.size(), how, [&](std::size_t i) {
    trials[i] = {pairs[i].name, pairs[i].other_light, try_pair(folder, pairs[i])};
  });
  return complete ? trials : std::vector<LightTrial>();
}

Experiment figure29_experiment(const std::vector<LightTrial>& trials) {
  return {page_of(trials),
          {{"figure29.csv", csv_of(trials)}},
          {{"figure29", [trials](const fs::path& output) { return script_of(trials, output); }}}};
}

}  // namespace finback::stereo_reference
