#include <algorithm>
#include <fmt/format.h>
#include <system_error>
#include <utility>
#include <vector>

#include <common/error.hpp>
#include <scenes/sequence.hpp>

namespace finback::scenes {

namespace fs = std::filesystem;

namespace {

class StillSequence final : public FrameSequence {
 public:
  explicit StillSequence(Scene scene) : scene_(std::move(scene)) {}
  [[nodiscard]] std::uint32_t size() const override { return 1; }
  [[nodiscard]] FloatImage truth(std::uint32_t /*number*/) const override { return scene_.truth; }

 protected:
  LumaPair load(std::uint32_t /*number*/) override { return {scene_.left, scene_.right}; }

 private:
  Scene scene_;
};

class FolderSequence final : public FrameSequence {
 public:
  explicit FolderSequence(const fs::path& folder) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(kLeft)) {
        fs::path right = folder / (kRight + name.substr(kLeft.size()));
        if (!fs::exists(right)) {
          throw InputError(fmt::format("{}: there is no {} beside it", entry.path().string(),
                                       right.filename().string()));
        }
        files_.emplace_back(entry.path(), std::move(right));
      }
    }
    if (error) {
      throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
    }
    if (files_.empty()) {
      throw InputError(
          fmt::format("{}: there are no pictures left_* with right_* beside them, such as "
                      "left_0001.png and right_0001.png",
                      folder.string()));
    }
    std::ranges::sort(files_);
  }
  [[nodiscard]] std::uint32_t size() const override {
    return static_cast<std::uint32_t>(files_.size());
  }

 protected:
  LumaPair load(std::uint32_t number) override {
    return load_luma_vga_pair(files_[number].first, files_[number].second);
  }

 private:
  static inline const std::string kLeft = "left_";
  static inline const std::string kRight = "right_";
  std::vector<std::pair<fs::path, fs::path>> files_;
};

class MovingSequence final : public FrameSequence {
 public:
  explicit MovingSequence(std::uint32_t seed) : seed_(seed) {}
  // All speeds divide this way there and back.
  [[nodiscard]] std::uint32_t size() const override { return 192; }
  [[nodiscard]] FloatImage truth(std::uint32_t number) const override {
    return make_synthetic_scene(seed_, number % size()).truth;
  }

 protected:
  LumaPair load(std::uint32_t number) override {
    Scene scene = make_synthetic_scene(seed_, number);
    return {std::move(scene.left), std::move(scene.right)};
  }

 private:
  std::uint32_t seed_;
};

class LensSequence final : public FrameSequence {
 public:
  LensSequence(std::unique_ptr<FrameSequence> sequence, const Lens& left, const Lens& right)
      : sequence_(std::move(sequence)), left_(left), right_(right) {}
  [[nodiscard]] std::uint32_t size() const override { return sequence_->size(); }
  [[nodiscard]] FloatImage truth(std::uint32_t number) const override {
    return sequence_->truth(number);
  }

 protected:
  LumaPair load(std::uint32_t number) override {
    const LumaPair& scene = sequence_->pair(number);
    return {through_lens(scene.left, left_), through_lens(scene.right, right_)};
  }

 private:
  std::unique_ptr<FrameSequence> sequence_;
  Lens left_;
  Lens right_;
};

}  // namespace

const LumaPair& FrameSequence::pair(std::uint32_t number) {
  const std::uint32_t wanted = number % size();
  if (wanted != loaded_) {
    pair_ = load(wanted);
    loaded_ = wanted;
  }
  return pair_;
}

std::unique_ptr<FrameSequence> still_sequence(Scene scene) {
  return std::make_unique<StillSequence>(std::move(scene));
}

std::unique_ptr<FrameSequence> folder_sequence(const fs::path& folder) {
  return std::make_unique<FolderSequence>(folder);
}

std::unique_ptr<FrameSequence> moving_sequence(std::uint32_t seed) {
  return std::make_unique<MovingSequence>(seed);
}

std::unique_ptr<FrameSequence> sequence_through_lenses(std::unique_ptr<FrameSequence> sequence,
                                                       const Lens& left, const Lens& right) {
  check_lens(left, "the left lens");
  check_lens(right, "the right lens");
  return std::make_unique<LensSequence>(std::move(sequence), left, right);
}

}  // namespace finback::scenes
