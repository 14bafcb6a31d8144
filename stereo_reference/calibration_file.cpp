#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <common/file.hpp>
#include <common/toml_reader.hpp>
#include <stereo_reference/calibration_file.hpp>

namespace finback::stereo_reference {

namespace {

constexpr int kMostPixels = 65536;

// The shortest text that reads back as the same number, also where it is whole.
std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

template <class Vector>
std::string list_text(const Vector& vector) {
  std::vector<std::string> numbers;
  for (const double value : vector) {
    numbers.push_back(number_text(value));
  }
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string camera_text(const char* name, const Intrinsics& camera) {
  return fmt::format(
      "\n[{}]\nfocal = {}  # pixels, horizontal and vertical\nprincipal = {}  # pixels from the "
      "centre of the first one\nskew = {}\ndistortion = {}  # k1, k2, p1, p2, k3\n",
      name, list_text(camera.focal), list_text(camera.principal), number_text(camera.skew),
      list_text(camera.distortion));
}

class File {
 public:
  File(const std::string& text, const std::string& name) : reader_(text, name) {}

  StereoCalibration read() {
    const toml::table& root = reader_.root();
    reader_.check_keys(root, "calibration", {"width", "height", "left", "right", "left_to_right"});
    StereoCalibration calibration;
    calibration.width = pixels(root, "width");
    calibration.height = pixels(root, "height");
    calibration.left = camera(table(root, "left"));
    calibration.right = camera(table(root, "right"));
    const toml::table& position = table(root, "left_to_right");
    reader_.check_keys(position, "left_to_right", {"rotation", "translation"});
    calibration.left_to_right.rotation = list<3>(position, "rotation");
    calibration.left_to_right.translation = list<3>(position, "translation");
    return calibration;
  }

 private:
  const toml::node& wanted(const toml::table& parent, const char* key) const {
    const toml::node* node = parent.get(key);
    if (node == nullptr) {
      reader_.fail(parent, fmt::format("there is no '{}'", key));
    }
    return *node;
  }

  const toml::table& table(const toml::table& parent, const char* key) const {
    (void)wanted(parent, key);
    return *reader_.table(parent, key);
  }

  int pixels(const toml::table& parent, const char* key) const {
    const toml::node& node = wanted(parent, key);
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 1 || *value > kMostPixels) {
      reader_.fail(node,
                   fmt::format("'{}' is a whole number of pixels, 1 to {}", key, kMostPixels));
    }
    return static_cast<int>(*value);
  }

  double number(const toml::node& node, const char* key) const {
    const auto value = node.value<double>();
    if (!node.is_number() || !value || !std::isfinite(*value)) {
      reader_.fail(node, fmt::format("'{}' wants finite numbers", key));
    }
    return *value;
  }

  template <int Count>
  Eigen::Matrix<double, Count, 1> list(const toml::table& parent, const char* key) const {
    const toml::node& node = wanted(parent, key);
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != Count) {
      reader_.fail(node, fmt::format("'{}' is a list of {} numbers", key, Count));
    }
    Eigen::Matrix<double, Count, 1> values;
    for (int i = 0; i < Count; ++i) {
      values[i] = number((*array)[static_cast<std::size_t>(i)], key);
    }
    return values;
  }

  Intrinsics camera(const toml::table& table) const {
    reader_.check_keys(table, "a camera", {"focal", "principal", "skew", "distortion"});
    Intrinsics camera;
    camera.focal = list<2>(table, "focal");
    camera.principal = list<2>(table, "principal");
    camera.skew = number(wanted(table, "skew"), "skew");
    camera.distortion = list<5>(table, "distortion");
    return camera;
  }

  TomlReader reader_;
};

}  // namespace

std::string calibration_text(const StereoCalibration& calibration) {
  return fmt::format(
      "# Two cameras, as finback stereo calibrate found them.\nwidth = {}  # pixels\nheight = "
      "{}\n{}{}\n# A point X of the left camera's space is, to the right one, R X + translation.\n"
      "[left_to_right]\nrotation = {}  # of R: axis times angle, radians\ntranslation = {}  # in "
      "the unit of the board's squares\n",
      calibration.width, calibration.height, camera_text("left", calibration.left),
      camera_text("right", calibration.right), list_text(calibration.left_to_right.rotation),
      list_text(calibration.left_to_right.translation));
}

StereoCalibration parse_calibration(const std::string& text, const std::string& file) {
  StereoCalibration calibration = File(text, file).read();
  try {
    (void)rectify(calibration);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  return calibration;
}

StereoCalibration load_calibration(const std::filesystem::path& path) {
  return parse_calibration(read_text_file(path), path.string());
}

}  // namespace finback::stereo_reference
