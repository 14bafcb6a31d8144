#include <charconv>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <common/error.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/checkerboard.hpp>
#include <stereo_reference/parallel.hpp>

namespace finback::stereo_reference {

namespace {

// Half the side of the window that a corner is sought in: less than half a square of the smallest
// boards that are found.
constexpr int kRefineWindow = 5;
constexpr int kRefineRounds = 100;
constexpr double kRefineStep = 1e-4;  // pixels

constexpr int kLeastCorners = 3;

// The number at the beginning of `text`, which is then shortened by it; 0: none.
int take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() ? number : 0;
}

}  // namespace

Points3 Board::points() const {
  Points3 points(3, corners());
  for (int n = 0; n < corners(); ++n) {
    const int row = n / columns;
    points.col(n) << square * (n % columns), square * row, 0;
  }
  return points;
}

Board parse_board(const std::string& text) {
  std::string_view rest = text;
  Board board;
  board.columns = take_number(rest);
  const bool cross = rest.starts_with('x');
  rest.remove_prefix(cross ? 1 : 0);
  board.rows = take_number(rest);
  if (!cross || !rest.empty() || board.columns < kLeastCorners || board.rows < kLeastCorners) {
    throw InputError(
        fmt::format("board '{}': it is COLUMNSxROWS of inner corners, such as 9x6, "
                    "each from {}",
                    text, kLeastCorners));
  }
  return board;
}

std::optional<Points2> find_corners(const scenes::ByteImage& image, const Board& board) {
  // OpenCV wants the pixels without const, and leaves them alone.
  scenes::ByteImage copy = image;
  const cv::Mat pixels(copy.height(), copy.width(), CV_8UC1, copy.data());
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(pixels, {board.columns, board.rows}, corners)) {
    return std::nullopt;
  }
  cv::cornerSubPix(pixels, corners, {kRefineWindow, kRefineWindow}, {-1, -1},
                   {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kRefineRounds, kRefineStep});
  Points2 points(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t n = 0; n < corners.size(); ++n) {
    points.col(static_cast<Eigen::Index>(n)) << corners[n].x, corners[n].y;
  }
  return points;
}

BoardPairs find_board_pairs(const std::vector<std::string>& left,
                            const std::vector<std::string>& right, const Board& board,
                            unsigned jobs) {
  if (left.size() != right.size()) {
    throw InputError(
        fmt::format("{} photographs of the left camera, {} of the right one; they must "
                    "be pairs",
                    left.size(), right.size()));
  }
  struct View {
    std::string path;
    int width = 0;
    int height = 0;
    std::optional<Points2> corners;
  };
  std::vector<View> views(2 * left.size());
  run_all(views.size(), {jobs, {}}, [&](std::size_t i) {
    View& view = views[i];
    view.path = i % 2 == 0 ? left[i / 2] : right[i / 2];
    const scenes::ByteImage image = scenes::load_luma(view.path);
    view.width = image.width();
    view.height = image.height();
    view.corners = find_corners(image, board);
  });
  BoardPairs found;
  for (std::size_t i = 0; i < views.size(); i += 2) {
    found.width = views.front().width;
    found.height = views.front().height;
    for (const View* view : {&views[i], &views[i + 1]}) {
      if (view->width != found.width || view->height != found.height) {
        throw InputError(fmt::format(
            "{}: {}x{} pixels, but {} has {}x{}; all photographs must have "
            "the same size",
            view->path, view->width, view->height, views.front().path, found.width, found.height));
      }
    }
    if (views[i].corners && views[i + 1].corners) {
      found.pairs.push_back({std::move(*views[i].corners), std::move(*views[i + 1].corners)});
    } else {
      found.left_out.push_back(views[i].corners ? views[i + 1].path : views[i].path);
    }
  }
  return found;
}

}  // namespace finback::stereo_reference
