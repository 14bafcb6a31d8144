// Errors that people cause and can mend: a bad file, a bad option, a fault of the simulated
// program.
//
// Each is one line that names the place, says what is wrong and, where it can, how to mend it. The
// command line turns them into exit code 2. Errors of Finback itself are std::logic_error.
#pragma once

#include <stdexcept>
#include <string>

namespace finback {

// A place in a text file; line and column count from 1, 0 means "not known".
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;

  // "file:line:column", leaving out what is not known.
  [[nodiscard]] std::string to_string() const;
};

class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const SourcePlace& place, const std::string& message)
      : std::runtime_error(place.to_string() + ": " + message) {}
};

// The simulated program did what the machine cannot: a misaligned access, a jump into nowhere.
class GuestFault : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace finback
