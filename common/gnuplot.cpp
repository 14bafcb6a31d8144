#include <cstdlib>
#include <fmt/format.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <common/gnuplot.hpp>

namespace finback {

namespace fs = std::filesystem;

namespace {

bool gnuplot_installed() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    if (::access((fs::path(folder) / "gnuplot").c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

// Runs gnuplot on a script; its own messages are its own.
bool run_gnuplot(const fs::path& script) {
  std::string program = "gnuplot";
  std::string argument = script.string();
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "gnuplot", nullptr, nullptr, arguments, ::environ) != 0) {
    return false;
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

void check_plot_path(const std::string& option, const fs::path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".svg" && extension != ".png") {
    throw InputError(fmt::format("{} {}: a plot is an .svg or a .png file", option, path.string()));
  }
  if (!gnuplot_installed()) {
    throw InputError(
        fmt::format("{}: gnuplot is not installed; install it (Debian: apt-get install "
                    "gnuplot-nox), or leave {} out",
                    option, option));
  }
}

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? "''" : std::string(1, c);
  }
  return result + "'";
}

std::string gnuplot_opening(const fs::path& output, int width, int height) {
  const bool png = output.extension() == ".png";
  return fmt::format(
      "set terminal {} size {},{} font 'DejaVu Sans,{}' background 'white'\nset output {}\n",
      png ? "pngcairo" : "svg", width, height, png ? 12 : 14, gnuplot_quoted(output.string()));
}

void draw_plot(const PlotScript& script, const fs::path& path) {
  write_file_whole(path, [&](const fs::path& temporary) {
    fs::path file = temporary;
    file += ".gnuplot";
    write_file_whole(file, script(temporary));
    const bool drawn = run_gnuplot(file);
    std::error_code ignored;
    fs::remove(file, ignored);
    if (!drawn || !fs::exists(temporary, ignored)) {
      throw InputError(fmt::format("{}: gnuplot could not draw it", path.string()));
    }
  });
}

}  // namespace finback
