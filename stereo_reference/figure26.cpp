#include <fmt/format.h>
#include <iterator>

#include <stereo_reference/figure26.hpp>
#include <stereo_reference/radiometry.hpp>

namespace finback::stereo_reference {

namespace {

constexpr const char* kScenes[] = {"2001/tsukuba", "2001/venus", "2003/teddy", "2003/cones"};
constexpr std::uint32_t kSeed = 1;

struct Piece {
  std::size_t change = 0;
  std::size_t level = 0;
  std::size_t scene = 0;
};

std::vector<Piece> pieces_of(const std::vector<LightChange>& changes) {
  std::vector<Piece> pieces;
  for (std::size_t change = 0; change < changes.size(); ++change) {
    for (std::size_t level = 0; level < changes[change].levels.size(); ++level) {
      for (std::size_t scene = 0; scene < std::size(kScenes); ++scene) {
        pieces.push_back({change, level, scene});
      }
    }
  }
  return pieces;
}

std::string csv_of(const Figure26& figure) {
  std::vector<std::vector<std::string>> rows = {
      {"change", "level", "scene", "method", "bad_percent", "bad_percent_of_valid"}};
  for (std::size_t c = 0; c < figure.changes.size(); ++c) {
    for (std::size_t l = 0; l < figure.changes[c].levels.size(); ++l) {
      const auto add = [&](const std::string& scene, const MethodErrors& errors) {
        for (std::size_t m = 0; m < kCompared.size(); ++m) {
          rows.push_back({figure.changes[c].name, fmt::format("{}", figure.changes[c].levels[l]),
                          scene, name_of(kCompared[m]), fmt::format("{:.4f}", errors[m].of_all),
                          fmt::format("{:.4f}", errors[m].of_valid)});
        }
      };
      for (std::size_t s = 0; s < figure.scenes.size(); ++s) {
        add(figure.scenes[s], figure.errors[c][l][s]);
      }
      add("average", figure.average(c, l));
    }
  }
  return csv_table(rows);
}

// "below rank3 in 10 of 10, below rank5 in 8 of 10 levels"
std::string verdict(const Figure26& figure, std::size_t change, double TrialError::*error) {
  const std::size_t levels = figure.changes[change].levels.size();
  std::array<std::size_t, 2> below{};
  for (std::size_t level = 0; level < levels; ++level) {
    const MethodErrors errors = figure.average(change, level);
    for (std::size_t rank = 0; rank < below.size(); ++rank) {
      below[rank] += errors[2].*error < errors[rank].*error ? 1 : 0;
    }
  }
  return fmt::format("below rank3 at {} of {} levels, below rank5 at {}", below[0], levels,
                     below[1]);
}

std::string page_of(const Figure26& figure) {
  std::string page =
      "Figure 26: percentage of bad pixels in non-occluded regions, average of Tsukuba, Venus, "
      "Teddy "
      "and Cones, 17x17, after the left-right check. First with pixels without a disparity as bad, "
      "then of those with a disparity.\n";
  for (std::size_t c = 0; c < figure.changes.size(); ++c) {
    const LightChange& change = figure.changes[c];
    std::vector<std::vector<std::string>> rows = {
        {change.axis, "rank3", "rank5", "census3", "rank3", "rank5", "census3"}};
    for (std::size_t l = 0; l < change.levels.size(); ++l) {
      const MethodErrors errors = figure.average(c, l);
      auto& row = rows.emplace_back();
      row.push_back(fmt::format("{}", change.levels[l]));
      for (double TrialError::*error : {&TrialError::of_all, &TrialError::of_valid}) {
        for (const TrialError& method : errors) {
          row.push_back(fmt::format("{:.2f}", method.*error));
        }
      }
    }
    page += fmt::format("\n{}\nCensus 3x3 is {}; of pixels with a disparity, {}.\n",
                        markdown_table(rows), verdict(figure, c, &TrialError::of_all),
                        verdict(figure, c, &TrialError::of_valid));
  }
  return page;
}

std::string script_of(const Figure26& figure, const std::filesystem::path& output) {
  std::string script = gnuplot_opening(output, 1200, 1000);
  auto out = std::back_inserter(script);
  for (std::size_t c = 0; c < figure.changes.size(); ++c) {
    fmt::format_to(out, "$change{} << EOD\n", c);
    for (std::size_t l = 0; l < figure.changes[c].levels.size(); ++l) {
      fmt::format_to(out, "{}", figure.changes[c].levels[l]);
      for (const TrialError& error : figure.average(c, l)) {
        fmt::format_to(out, " {:.4f}", error.of_all);
      }
      script += '\n';
    }
    script += "EOD\n";
  }
  script += plot_style();
  script += "set multiplot layout 2,2\nset yrange [0:*]\nset ylabel 'bad pixels, %'\n";
  for (std::size_t c = 0; c < figure.changes.size(); ++c) {
    fmt::format_to(out, "set xlabel '{}'\nplot ", figure.changes[c].axis);
    for (std::size_t m = 0; m < kCompared.size(); ++m) {
      fmt::format_to(out,
                     "{}$change{} using 1:{} with linespoints pt 7 ps 0.7 lw 1.5 lc rgb '{}' title "
                     "'{}'",
                     m == 0 ? "" : ", ", c, m + 2, kPlotColours[m], name_of(kCompared[m]));
    }
    script += '\n';
  }
  return script + "unset multiplot\n";
}

}  // namespace

std::vector<LightChange> figure26_changes() {
  const std::vector<double> tenths = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  return {{"scale", "scale of the greys", tenths, scale_greys},
          {"gamma", "gamma", {0.1, 0.2, 0.4, 0.6, 0.8, 1, 1.5, 2, 2.5, 3, 4, 5}, change_gamma},
          {"vignetting", "light in the corners", tenths, vignette},
          {"noise",
           "signal to noise, dB",
           {12.5, 15, 17.5, 20, 22.5, 25, 27.5, 30, 35, 40, 45, 50},
           [](const ByteImage& image, double level) {
             return add_noise(image, noise_variance(image, level), kSeed);
           }}};
}

MethodErrors Figure26::average(std::size_t change, std::size_t level) const {
  MethodErrors sum{};
  const auto& all = errors[change][level];
  for (const MethodErrors& scene : all) {
    for (std::size_t m = 0; m < sum.size(); ++m) {
      sum[m].of_all += scene[m].of_all / static_cast<double>(all.size());
      sum[m].of_valid += scene[m].of_valid / static_cast<double>(all.size());
    }
  }
  return sum;
}

Figure26 measure_figure26(const std::filesystem::path& folder, std::vector<LightChange> changes,
                          const Parallel& how) {
  std::vector<StereoSample> samples;
  std::vector<ByteImage> masks;
  for (const char* scene : kScenes) {
    samples.push_back(load_middlebury(folder, find_middlebury_scene(scene).value()));
    masks.push_back(non_occluded_mask(samples.back()));
  }
  Figure26 figure{std::move(changes), {}, {}};
  for (const LightChange& change : figure.changes) {
    figure.errors.emplace_back(change.levels.size(), std::vector<MethodErrors>(std::size(kScenes)));
  }
  const std::vector<Piece> pieces = pieces_of(figure.changes);
  const bool complete = run_all(pieces.size(), how, [&](std::size_t i) {
    const Piece& piece = pieces[i];
    const LightChange& change = figure.changes[piece.change];
    const StereoSample& sample = samples[piece.scene];
    const ByteImage right = change.apply(sample.right, change.levels[piece.level]);
    for (std::size_t m = 0; m < kCompared.size(); ++m) {
      figure.errors[piece.change][piece.level][piece.scene][m] =
          try_method(kCompared[m], sample.left, right, sample.left_truth, masks[piece.scene],
                     sample.largest_disparity());
    }
  });
  if (complete) {
    figure.scenes.assign(std::begin(kScenes), std::end(kScenes));
  }
  return figure;
}

Experiment figure26_experiment(const Figure26& figure) {
  return {page_of(figure),
          {{"figure26.csv", csv_of(figure)}},
          {{"figure26",
            [figure](const std::filesystem::path& output) { return script_of(figure, output); }}}};
}

}  // namespace finback::stereo_reference
