#include "program.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <common/file.hpp>

namespace finback::cli {

namespace fs = std::filesystem;

namespace {

// A folder that no other test has, since tests run at the same time.
fs::path new_folder() {
  std::string pattern = (fs::temp_directory_path() / "finback-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("no temporary folder");
  }
  return pattern;
}

// In the child: becomes the program, or ends with 127 as a shell does.
[[noreturn]] void become(const std::vector<std::string>& command, const fs::path& where,
                         const fs::path& out, const fs::path& err) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
  const int out_file = ::open(out.c_str(), kFlags, 0600);
  const int err_file = ::open(err.c_str(), kFlags, 0600);
  if (::chdir(where.c_str()) == 0 && ::dup2(out_file, STDOUT_FILENO) >= 0 &&
      ::dup2(err_file, STDERR_FILENO) >= 0) {
    ::execvp(arguments[0], arguments.data());
  }
  ::_exit(127);
}

}  // namespace

Finished run_program(const std::vector<std::string>& command, const fs::path& where,
                     int interrupt_after_ms) {
  const fs::path captured = new_folder();
  const pid_t child = ::fork();
  if (child == 0) {
    become(command, where, captured / "out", captured / "err");
  }
  if (interrupt_after_ms >= 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(interrupt_after_ms));
    ::kill(child, SIGINT);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  Finished finished;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  finished.out = read_text_file(captured / "out");
  finished.err = read_text_file(captured / "err");
  fs::remove_all(captured);
  return finished;
}

ProgramTest::ProgramTest() : folder_(new_folder()) {}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Finished ProgramTest::finback(std::vector<std::string> arguments, int interrupt_after_ms) const {
  arguments.insert(arguments.begin(), FINBACK_PROGRAM);
  return run_program(arguments, folder_, interrupt_after_ms);
}

std::string ProgramTest::write(const std::string& name, std::string_view text) const {
  write_file_whole(folder_ / name, text);
  return name;
}

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    names.push_back(fs::relative(entry.path(), folder_).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string program_text(std::string_view body, std::string_view objects) {
  std::string text =
      ".bir 1\n"
      ".text\n"
      ".global _main\n"
      ".type _main, @function\n"
      "_main:\n";
  text += body;
  text += ".size _main, .-_main\n";
  text += objects;
  return text;
}

}  // namespace finback::cli
