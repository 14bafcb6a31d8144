// lib/finback/video.so: videos by OpenCV's videoio.
//
// Knows of Finback what headers say (video_file.hpp), so that it links nothing of it.
#include <algorithm>
#include <memory>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include <scenes/video_file.hpp>

namespace finback::scenes {

namespace {

// Read forwards; going back begins the file anew.
class OpenCvVideo final : public VideoFile {
 public:
  explicit OpenCvVideo(std::string path) : path_(std::move(path)) { open(); }

  [[nodiscard]] bool is_open() const { return capture_.isOpened(); }
  [[nodiscard]] std::uint32_t frames() const override {
    const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
    return count >= 1 ? static_cast<std::uint32_t>(count) : 0;
  }
  bool read(std::uint32_t number, ByteImage& luma) override {
    if (number < next_) {
      open();
    }
    while (next_ < number && capture_.grab()) {
      ++next_;
    }
    cv::Mat picture;
    if (next_ != number || !capture_.read(picture) || picture.empty() || picture.depth() != CV_8U) {
      return false;
    }
    ++next_;
    luma = luma_of(picture);
    return true;
  }

 private:
  void open() {
    capture_.open(path_);
    next_ = 0;
  }

  static ByteImage luma_of(const cv::Mat& picture) {
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

  std::string path_;
  cv::VideoCapture capture_;
  std::uint32_t next_ = 0;
};

}  // namespace

extern "C" VideoFile* finback_open_video(const char* path) {
  // What is wrong is said once, by who called.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  auto video = std::make_unique<OpenCvVideo>(path);
  return video->is_open() ? video.release() : nullptr;
}

}  // namespace finback::scenes
