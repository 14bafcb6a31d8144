// finback stereo, as a user runs it: a map step by step, cameras, experiments, and what goes wrong.
#include <gmock/gmock.h>

#include "../stereo_reference/data_folder.hpp"
#include "page_examples.hpp"
#include "program.hpp"
#include <common/file.hpp>
#include <scenes/luma.hpp>
#include <scenes/scene.hpp>

namespace finback::cli {
namespace {

namespace fs = std::filesystem;
using scenes::ByteImage;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr const char* kRig =
    "width = 160\nheight = 120\n[left]\nfocal = [140.0, 140.0]\nprincipal = [79.5, 59.5]\n"
    "skew = 0.0\ndistortion = [-0.2, 0.0, 0.001, 0.0, 0.0]\n[right]\nfocal = [141.0, 141.0]\n"
    "principal = [80.5, 58.5]\nskew = 0.0\ndistortion = [-0.2, 0.0, 0.0, 0.001, 0.0]\n"
    "[left_to_right]\nrotation = [0.0, 0.01, 0.0]\ntranslation = [-28.0, 0.0, 0.0]\n";

class Stereo : public ProgramTest {
 protected:
  // The synthetic scene at 160x120, with its truth of 4 greys a pixel.
  void write_pair() const {
    const scenes::Scene scene = scenes::make_synthetic_scene();
    ByteImage left(160, 120);
    ByteImage right(160, 120);
    ByteImage truth(160, 120);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        left.at(x, y) = scene.left.at(4 * x, 4 * y);
        right.at(x, y) = scene.right.at(4 * x, 4 * y);
        truth.at(x, y) = static_cast<std::uint8_t>(4 * scene.truth.at(x, y));
      }
    }
    scenes::write_png(left, folder() / "left.png");
    scenes::write_png(right, folder() / "right.png");
    scenes::write_png(truth, folder() / "truth.png");
  }

  std::string fine(const std::string& command) const {
    const Finished finished = run_words(command);
    EXPECT_EQ(finished.exit_code, 0) << command << ": " << finished.err;
    return finished.out;
  }

  [[nodiscard]] Finished run_words(const std::string& command) const {
    std::vector<std::string> words = {"stereo"};
    std::istringstream text(command);
    for (std::string word; text >> word;) {
      words.push_back(word);
    }
    return finback(words);
  }

  // One line, exit code 2, nothing written.
  void wrong(const std::string& command, const std::string& message) const {
    const auto before = files();
    const Finished finished = run_words(command);
    EXPECT_EQ(finished.exit_code, 2) << command << ": " << finished.err;
    EXPECT_THAT(finished.err, HasSubstr(message)) << command;
    EXPECT_EQ(std::ranges::count(finished.err, '\n'), 1) << finished.err;
    EXPECT_EQ(files(), before) << command;
  }
};

// What stands behind "bad" in what evaluate prints.
double bad_percent(const std::string& text) {
  return std::stod(text.substr(text.find("bad ") + 4));
}

TEST_F(Stereo, MapStepByStep) {
  write_pair();
  EXPECT_THAT(fine("match --left left.png --right right.png --window 9 --scale 4 --out map.png "
                   "--right-out r.png"),
              StartsWith("map.png: 160x120 pixels, "));
  fine("check --left map.png --right r.png --scale 4 --out checked.png");
  fine("postprocess --map checked.png --image left.png --scale 4 --out final.png");
  // Where the window and the least disparity leave a map.
  scenes::write_png(ByteImage(160, 120, 255), folder() / "all.png");
  const std::string truth = " --truth truth.png --scale 4 --truth-scale 4 --border 20";
  const std::string matched = fine("evaluate --map map.png" + truth);
  EXPECT_EQ(fine("evaluate --mask all.png --map map.png" + truth), matched);
  EXPECT_THAT(matched, HasSubstr("no disparity  0."));
  EXPECT_LT(bad_percent(matched), 12);
  const std::string last = fine("evaluate --map final.png" + truth);
  const auto wrong_of_valid = [](const std::string& text) {
    return std::stod(text.substr(text.find("of all, ") + 8));
  };
  EXPECT_LT(wrong_of_valid(last), wrong_of_valid(matched) / 2);
  // The truth itself has no error.
  EXPECT_THAT(fine("evaluate --map truth.png" + truth), HasSubstr("bad           0.00 % of all"));
}

TEST_F(Stereo, ScaledErrorsAreInGreysOfTheTruth) {
  scenes::write_png(ByteImage(8, 6, 10), folder() / "map.png");
  scenes::write_png(ByteImage(8, 6, 42), folder() / "truth.png");
  const std::string half_off = "evaluate --map map.png --truth truth.png --truth-scale 4";
  EXPECT_THAT(fine(half_off), testing::AllOf(HasSubstr("bad           0.00 % of all"),
                                             HasSubstr("RMS error     0.500 pixels")));
  EXPECT_THAT(fine(half_off + " --scaled"),
              testing::AllOf(HasSubstr("bad           100.00 % of all"),
                             HasSubstr("RMS error     2.000 greys")));
  EXPECT_THAT(fine(half_off + " --scaled --delta 2"), HasSubstr("bad           0.00 % of all"));
  for (int disparity = 1; disparity < 80; disparity += 13) {  // one grey off, in thirds of a pixel
    scenes::write_png(ByteImage(8, 6, static_cast<std::uint8_t>(disparity)), folder() / "map.png");
    scenes::write_png(ByteImage(8, 6, static_cast<std::uint8_t>(3 * disparity + 1)),
                      folder() / "truth.png");
    EXPECT_THAT(fine("evaluate --map map.png --truth truth.png --truth-scale 3 --scaled"),
                HasSubstr("bad           0.00 % of all"))
        << disparity;
  }
}

TEST_F(Stereo, OtherMethodsFindTheDisparities) {
  write_pair();
  for (const std::string method : {"rank3", "ncc"}) {
    fine("match --left left.png --right right.png --window 9 --by " + method + " --out m.png");
    EXPECT_LT(
        bad_percent(fine("evaluate --map m.png --truth truth.png --truth-scale 4 --border 20")), 25)
        << method;
  }
}

TEST_F(Stereo, PerturbedPicturesAreTheSameEveryTime) {
  write_pair();
  fine("perturb left.png --scale 0.5 --gamma 2 --vignette 0.3 --noise 20 --seed 7 --out a.png");
  fine("perturb left.png --scale 0.5 --gamma 2 --vignette 0.3 --noise 20 --seed 7 --out b.png");
  EXPECT_EQ(read_text_file(folder() / "a.png"), read_text_file(folder() / "b.png"));
  fine("perturb left.png --out same.png");
  EXPECT_EQ(scenes::load_luma(folder() / "same.png"), scenes::load_luma(folder() / "left.png"));
}

TEST_F(Stereo, CamerasRectifyAndGiveTables) {
  write_pair();
  write("rig.toml", kRig);
  EXPECT_THAT(fine("rectify rig.toml --left left.png --right right.png --out rectified"),
              HasSubstr("baseline 28\n"));
  EXPECT_EQ(scenes::load_luma(folder() / "rectified/left.png").width(), 160);
  EXPECT_THAT(fine("tables rig.toml --subsample 1 --out tables.c"),
              HasSubstr("160x120 pixels, 384000 bytes"));
  EXPECT_THAT(read_text_file(folder() / "tables.c"),
              HasSubstr("const short rectification_right_weights[19200][4] = {"));
}

TEST_F(Stereo, MistakesAreOneLine) {
  write_pair();
  scenes::write_png(ByteImage(80, 120, 9), folder() / "narrow.png");
  scenes::write_png(ByteImage(6, 6, 9), folder() / "tiny.png");
  write("rig.toml", kRig);
  write("nan.toml", std::string(kRig).replace(std::string(kRig).find("140.0"), 5, "nan"));
  write("text.png", "no picture");
  const std::string pair = "match --left left.png --right right.png --out map.png ";
  wrong("match --left left.png --right narrow.png --out map.png",
        "is 160x120, the right one 80x120");
  wrong("match --left tiny.png --right tiny.png --out map.png", "too small for a window of 15");
  wrong("match --left text.png --right right.png --out map.png", "text.png: not an image");
  wrong("match --left none.png --right right.png --out map.png", "none.png: no such image file");
  wrong(pair + "--window 8", "matching window 8: it must be an odd number");
  wrong(pair + "--min 20 --max 10", "disparities 20..10");
  wrong(pair + "--by magic", "matching by 'magic': it is one of census3");
  wrong(pair + "--max 40 --scale 8", "over 255; take a scale of at most");
  wrong("check --left left.png --right right.png --scale 2 --out c.png",
        "no multiple of the scale 2");
  wrong("check --left narrow.png --right left.png --out c.png", "160x120");
  wrong("postprocess --map narrow.png --image left.png --out p.png", "80x120");
  wrong("postprocess --map left.png --image left.png --window 4 --out p.png", "window 4");
  wrong("evaluate --map left.png --truth truth.png --mask narrow.png", "the mask 80x120");
  wrong("evaluate --map left.png --truth truth.png --border 60", "no region of a map of 160x120");
  wrong("perturb left.png --gamma 0 --out g.png", "gamma: it must be positive");
  wrong("rectify nan.toml --left left.png --right right.png --out r",
        "nan.toml:4:10: 'focal' wants");
  wrong("rectify rig.toml --left narrow.png --right right.png --out r",
        "narrow.png: 80x120 pixels, but rig.toml is of cameras with 160x120");
  wrong("tables rig.toml --subsample 7 --out t.c", "cannot be sub-sampled by 7");
  wrong("calibrate --left left.png right.png --right right.png --out c.toml", "they must be pairs");
  wrong("calibrate --left left.png --right right.png --square 0 --out c.toml", "--square 0");
  fs::create_directories(folder() / "data/middlebury");
  wrong("experiment figure26 --data data --out t",
        "middlebury/2001/tsukuba/im2.png: no such image");
  wrong("experiment table8 --data data --out t", "middlebury/2006/Aloe/view1.png: no such image");
  wrong("experiment table8 --data nowhere --out t",
        "--data nowhere: there is no folder middlebury");
}

TEST_F(Stereo, CommandsWithASlipGetTheNearest) {
  const auto said = [&](const std::string& command) {
    const Finished finished = run_words(command);
    EXPECT_EQ(finished.exit_code, 1) << command;
    return finished.err;
  };
  EXPECT_THAT(said("mach"),
              HasSubstr("there is no command 'stereo mach', did you mean 'stereo match'?"));
  EXPECT_THAT(said("experiment figure9"), HasSubstr("did you mean 'stereo experiment figure"));
  EXPECT_THAT(said("experiment"), HasSubstr("stereo experiment wants one of figure8, figure26"));
  EXPECT_THAT(said("match"), HasSubstr("--left is required"));
}

TEST_F(Stereo, PhotographsWithoutABoardAreNamed) {
  write_pair();
  const Finished finished = run_words("calibrate --left left.png --right right.png --out c.toml");
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err,
              StartsWith("left.png: no board of 9x6 corners; the pair is left out\n"));
  EXPECT_THAT(finished.err, HasSubstr("0 pairs with the whole board in both views"));
}

TEST_F(Stereo, AnExperimentLeavesPageTableAndPlot) {
  const std::string page = fine("experiment figure8 --out new/folder");
  EXPECT_EQ(read_text_file(folder() / "new/folder/figure8.md"), page);
  EXPECT_THAT(read_text_file(folder() / "new/folder/figure8.csv"),
              StartsWith("disparity,range_cm"));
  EXPECT_THAT(read_text_file(folder() / "new/folder/figure8.svg"), HasSubstr("</svg>"));
  fine("experiment figure8 --out new --format png");
  EXPECT_GT(scenes::load_luma(folder() / "new/figure8.png").width(), 1000);
  wrong("experiment figure8 --out new/figure8.png", "cannot be written as output folder");
}

TEST_F(Stereo, ManualPageTellsTheTruth) {
  check_page_examples("finback-stereo.md", folder().string());
}

TEST_F(Stereo, Table8OfTheRealScenes) {
  const fs::path data = stereo_reference::data_folder();
  FINBACK_NEEDS_DATA(data / "middlebury");
  const std::string page = fine("experiment table8 --jobs 2 --out t --data " + data.string());
  EXPECT_THAT(page, HasSubstr("| non-occluded, mean | 29.75 | 30.29 |"));
  EXPECT_EQ(read_text_file(folder() / "t/table8.md"), page);
  for (const char* name : {"table8.csv", "figure34.csv", "figure34.svg"}) {
    EXPECT_TRUE(fs::exists(folder() / "t" / name)) << name;
  }
}

}  // namespace
}  // namespace finback::cli
