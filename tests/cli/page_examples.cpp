#include "page_examples.hpp"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <string_view>

#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {

namespace {

class Page {
 public:
  Page(const std::string& text, std::string folder) : folder_(std::move(folder)) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      read(line);
    }
    finish_command();
  }

  [[nodiscard]] int commands() const { return commands_; }
  [[nodiscard]] const std::string& renewed() const { return renewed_; }

 private:
  void read(const std::string& line) {
    const bool fence = line.starts_with("```");
    if (fence || line.starts_with("$ ")) {
      finish_command();
    }
    if (fence) {
      if (is_file()) {
        write_file_whole(std::filesystem::path(folder_) / file_, file_text_);
      }
      block_ = block_.empty() ? line.substr(3) : "";
      file_text_.clear();
    } else if (block_ == "console" && line.starts_with("$ ")) {
      command_ = line.substr(2);
    } else if (!command_.empty()) {
      said_ += line + "\n";
      return;  // written by finish_command
    } else if (is_file()) {
      file_text_ += line + "\n";
    } else {
      note_file(line);
    }
    renewed_ += line + "\n";
  }

  [[nodiscard]] bool is_file() const { return block_ == "toml" || block_ == "asm"; }

  // The last `NAME.toml`, `NAME.s` or `NAME.inc` of a line of the text.
  void note_file(const std::string& line) {
    std::size_t last = 0;
    for (const std::string_view ending : {".toml`", ".s`", ".inc`"}) {
      const std::size_t end = line.rfind(ending);
      if (end != std::string::npos && end >= last) {
        const std::size_t begin = line.rfind('`', end) + 1;
        file_ = line.substr(begin, end + ending.size() - 1 - begin);
        last = end;
      }
    }
  }

  std::string output_of(const std::string& command) {
    if (command == "echo $?") {
      return std::to_string(exit_code_) + "\n";
    }
    const std::string programs = std::filesystem::path(FINBACK_PROGRAM).parent_path().string();
    const Finished finished = run_program(
        {"sh", "-c", "PATH='" + programs + "':\"$PATH\"; { " + command + "; } 2>&1"}, folder_);
    exit_code_ = finished.exit_code;
    return finished.out;
  }

  void finish_command() {
    if (command_.empty()) {
      return;
    }
    const std::string printed = output_of(command_);
    if (std::getenv("FINBACK_REFRESH") == nullptr) {
      EXPECT_EQ(printed, said_) << "of: " << command_
                                << "\nif the change is meant, run scripts/refresh-traces.sh";
    }
    renewed_ += printed;
    ++commands_;
    command_.clear();
    said_.clear();
  }

  std::string folder_;
  std::string block_;  // language of the block that is read; "" outside
  std::string command_;
  std::string said_;
  std::string file_;
  std::string file_text_;
  std::string renewed_;
  int exit_code_ = 0;
  int commands_ = 0;
};

}  // namespace

void check_page_examples(const std::string& page, const std::string& folder) {
  const std::string path = FINBACK_SOURCE_DIR "/docs/" + page;
  const Page read(read_text_file(path), folder);
  EXPECT_GT(read.commands(), 0) << page << " has no example";
  if (std::getenv("FINBACK_REFRESH") != nullptr) {
    write_file_whole(path, read.renewed());
  }
}

}  // namespace finback::cli
