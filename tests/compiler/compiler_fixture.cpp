#include "compiler_fixture.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace finback::compiler {

namespace fs = std::filesystem;

CompilerTest::CompilerTest() {
  std::string pattern = (fs::temp_directory_path() / "finback-cc-XXXXXX").string();
  folder_ = mkdtemp(pattern.data());
}

CompilerTest::~CompilerTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

static std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Finished CompilerTest::run(const std::vector<std::string>& command) const {
  std::string line = "cd '" + folder_.string() + "' && ";
  for (const std::string& word : command)
    line += "'" + word + "' ";
  line += "> stdout.txt 2> stderr.txt";
  int status = std::system(line.c_str());
  Finished finished;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  finished.out = contents(folder_ / "stdout.txt");
  finished.err = contents(folder_ / "stderr.txt");
  return finished;
}

Finished CompilerTest::cc(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), FINBACK_CC);
  return run(arguments);
}

void CompilerTest::write(const std::string& name, std::string_view text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string CompilerTest::read(const std::string& name) const { return contents(folder_ / name); }

std::string CompilerTest::compile(std::string_view text,
                                  const std::vector<std::string>& options) const {
  write("unit.c", text);
  std::vector<std::string> arguments = {"-O2", "--verify", "-o", "unit.bir", "unit.c"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  Finished finished = cc(arguments);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return read("unit.bir");
}

/// The units that a program is linked with: the build compiled them, once for all programs.
static std::vector<std::string> runtime_units(Copying copying) {
  const std::string left_out = copying == Copying::plain ? "memory_fast" : "memory";
  std::vector<std::string> units;
  for (const auto& entry : fs::directory_iterator(FINBACK_RUNTIME)) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with("start_") && name != left_out)
      units.push_back(entry.path().string());
  }
  std::sort(units.begin(), units.end());
  return units;
}

unsigned programs_to_try(unsigned on_every_run) {
  const char* wanted = std::getenv("FINBACK_RANDOM_C");
  return wanted == nullptr
             ? on_every_run
             : std::max(on_every_run, static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)));
}

std::vector<std::string> sources_of(const std::string& program) {
  std::vector<std::string> sources;
  if (!fs::is_directory(program))
    return {program};
  for (const auto& entry : fs::directory_iterator(program))
    if (entry.path().extension() == ".c")
      sources.push_back(entry.path().string());
  std::sort(sources.begin(), sources.end());
  std::stable_partition(sources.begin(), sources.end(),
                        [](const fs::path& source) { return source.stem() == "main"; });
  return sources;
}

Finished CompilerTest::execute(const std::string& program, const std::string& level,
                               Copying copying) const {
  std::vector<std::string> command = {FINBACK_BIR_RUN};
  for (const std::string& source : sources_of(program)) {
    const std::string bir = fs::path(source).stem().string() + ".bir";
    Finished finished = cc({"-O" + level, "--verify", "-W", "no-everything", "-o", bir, source});
    if (finished.exit_code != 0)
      return finished;
    command.push_back(bir);
  }
  for (std::string& unit : runtime_units(copying))
    command.push_back(std::move(unit));
  return run(command);
}

std::string function_of(const std::string& bir, const std::string& name) {
  size_t begin = bir.find("\n_" + name + ":");
  size_t end = bir.find(".size _" + name + ",", begin);
  return begin == std::string::npos ? "" : bir.substr(begin, end - begin);
}

int count(std::string_view text, std::string_view what) {
  int found = 0;
  for (size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1))
    ++found;
  return found;
}

}  // namespace finback::compiler
