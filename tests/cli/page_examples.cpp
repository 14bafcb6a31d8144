#include "page_examples.hpp"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {

namespace {

// Both streams, as a terminal shows them.
std::string output_of(const std::string& command, const std::string& folder) {
  const std::string programs = std::filesystem::path(FINBACK_PROGRAM).parent_path().string();
  const Finished finished = run_program(
      {"sh", "-c", "PATH='" + programs + "':\"$PATH\"; { " + command + "; } 2>&1"}, folder);
  return finished.out;
}

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
    if (fence || (in_block_ && line.starts_with("$ "))) {
      finish_command();
    }
    if (fence) {
      in_block_ = !in_block_ && line == "```console";
    } else if (in_block_ && line.starts_with("$ ")) {
      command_ = line.substr(2);
    } else if (!command_.empty()) {
      said_ += line + "\n";
      return;  // written by finish_command
    }
    renewed_ += line + "\n";
  }

  void finish_command() {
    if (command_.empty()) {
      return;
    }
    const std::string printed = output_of(command_, folder_);
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
  bool in_block_ = false;
  std::string command_;
  std::string said_;
  std::string renewed_;
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
