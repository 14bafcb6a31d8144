#include <common/error.hpp>

namespace finback {

std::string SourcePlace::to_string() const {
  std::string text = file;
  if (line > 0) {
    text += ":" + std::to_string(line);
    if (column > 0) {
      text += ":" + std::to_string(column);
    }
  }
  return text;
}

}  // namespace finback
