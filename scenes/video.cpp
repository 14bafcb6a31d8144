// Sequences from videos, by OpenCV's videoio where Finback was built with it.
#include <fmt/format.h>

#include <common/error.hpp>
#include <scenes/sequence.hpp>

#ifdef FINBACK_VIDEO
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <vector>
#endif

namespace finback::scenes {

namespace fs = std::filesystem;

#ifdef FINBACK_VIDEO

namespace {

ByteImage luma_of(const cv::Mat& picture) {
  cv::Mat grey = picture;
  if (picture.channels() == 3) {
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  }
  ByteImage image(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y) {
    std::copy_n(grey.ptr<std::uint8_t>(y), grey.cols, &image.at(0, y));
  }
  return image;
}

ByteImage to_vga(const ByteImage& image) {
  return resize(crop_to_4_by_3(image), kVgaWidth, kVgaHeight);
}

// One file, read forwards; going back begins it anew.
class Video {
 public:
  explicit Video(const fs::path& path) : path_(path) { open(); }

  [[nodiscard]] std::uint32_t frames() const {
    const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
    return count >= 1 ? static_cast<std::uint32_t>(count) : 0;
  }
  ByteImage frame(std::uint32_t number) {
    if (number < next_) {
      open();
    }
    while (next_ < number && capture_.grab()) {
      ++next_;
    }
    cv::Mat picture;
    if (next_ != number || !capture_.read(picture) || picture.empty() || picture.depth() != CV_8U) {
      throw InputError(fmt::format("{}: frame {} cannot be read", path_.string(), number));
    }
    ++next_;
    return luma_of(picture);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  void open() {
    if (!capture_.open(path_.string())) {
      throw InputError(fmt::format("{}: is no video that OpenCV can read", path_.string()));
    }
    next_ = 0;
  }

  fs::path path_;
  cv::VideoCapture capture_;
  std::uint32_t next_ = 0;
};

class VideoSequence final : public FrameSequence {
 public:
  explicit VideoSequence(const std::vector<fs::path>& paths) {
    for (const fs::path& path : paths) {
      videos_.emplace_back(path);
    }
    size_ = videos_.front().frames();
    for (const Video& video : videos_) {
      size_ = std::min(size_, video.frames());
    }
    if (size_ == 0) {
      throw InputError(fmt::format("{}: has no frames", videos_.front().path().string()));
    }
  }
  [[nodiscard]] std::uint32_t size() const override { return size_; }

 protected:
  LumaPair load(std::uint32_t number) override {
    const ByteImage first = videos_.front().frame(number);
    if (videos_.size() == 2) {
      return {to_vga(first), to_vga(videos_.back().frame(number))};
    }
    const int half = first.width() / 2;
    std::array<ByteImage, 2> sides = {ByteImage(half, first.height()),
                                      ByteImage(half, first.height())};
    for (int y = 0; half > 0 && y < first.height(); ++y) {
      std::copy_n(&first.at(0, y), half, &sides[0].at(0, y));
      std::copy_n(&first.at(half, y), half, &sides[1].at(0, y));
    }
    return {to_vga(sides[0]), to_vga(sides[1])};
  }

 private:
  std::vector<Video> videos_;
  std::uint32_t size_ = 0;
};

}  // namespace

bool reads_videos() { return true; }

std::unique_ptr<FrameSequence> video_sequence(const std::vector<fs::path>& paths) {
  return std::make_unique<VideoSequence>(paths);
}

#else

bool reads_videos() { return false; }

std::unique_ptr<FrameSequence> video_sequence(const std::vector<fs::path>& paths) {
  throw InputError(
      fmt::format("{}: this Finback was built without OpenCV's videoio and reads no videos; give a "
                  "folder of left_* and right_* pictures, or build it with -DFINBACK_VIDEO=ON",
                  paths.front().string()));
}

#endif

}  // namespace finback::scenes
