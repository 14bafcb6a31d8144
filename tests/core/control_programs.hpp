// The programs of control_test.cpp, for who asks which instructions are tested.
#pragma once

#include <string>
#include <vector>

namespace finback::core {

[[nodiscard]] std::vector<std::string> control_programs();

}  // namespace finback::core
