// Sequences from videos, by the module that reads them (video_file.hpp) where Finback has it.
#include <algorithm>
#include <array>
#include <dlfcn.h>
#include <fmt/format.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <scenes/sequence.hpp>
#include <scenes/video_file.hpp>

namespace finback::scenes {

namespace fs = std::filesystem;

namespace {

fs::path module_path() { return library_folder() / "video.so"; }

// Loaded once, and never unloaded: what OpenCV's libraries leave to the end of the program stays
// valid.
OpenVideo& open_video() {
  static OpenVideo* const open = [] {
    void* module = dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      throw InputError(fmt::format("videos cannot be read: {}", dlerror()));
    }
    return reinterpret_cast<OpenVideo*>(dlsym(module, kOpenVideoName));
  }();
  return *open;
}

ByteImage to_vga(const ByteImage& image) {
  return resize(crop_to_4_by_3(image), kVgaWidth, kVgaHeight);
}

class Video {
 public:
  explicit Video(const fs::path& path) : path_(path), file_(open_video()(path.c_str())) {
    if (!file_) {
      throw InputError(fmt::format("{}: is no video that OpenCV can read", path.string()));
    }
  }

  [[nodiscard]] std::uint32_t frames() const { return file_->frames(); }
  ByteImage frame(std::uint32_t number) {
    ByteImage luma;
    if (!file_->read(number, luma)) {
      throw InputError(fmt::format("{}: frame {} cannot be read", path_.string(), number));
    }
    return luma;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  std::unique_ptr<VideoFile> file_;
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

bool reads_videos() { return fs::exists(module_path()); }

std::unique_ptr<FrameSequence> video_sequence(const std::vector<fs::path>& paths) {
  if (!reads_videos()) {
    throw InputError(fmt::format(
        "{}: this Finback was built without OpenCV's videoio and reads no videos; give a folder of "
        "left_* and right_* pictures, or install libopencv-videoio-dev and build it again",
        paths.front().string()));
  }
  return std::make_unique<VideoSequence>(paths);
}

}  // namespace finback::scenes
