// finback-cc: C to BIR.
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <iostream>
#include <llvm/ADT/SmallString.h>
#include <llvm/CodeGen/Passes.h>
#include <llvm/InitializePasses.h>
#include <llvm/PassRegistry.h>
#include <llvm/Support/CommandLine.h>
#include <llvm/Support/ErrorHandling.h>
#include <llvm/Support/FileSystem.h>

#include "../target/Bfin.hpp"
#include "backend.hpp"
#include "diagnose.hpp"
#include "frontend.hpp"
#include <CLI/CLI.hpp>

namespace finback::compiler {
namespace {

namespace fs = std::filesystem;

constexpr int kUsage = 1;
constexpr int kBadInput = 2;

/// What LLVM cannot go on from, as an exception: it must not end in a crash.
void throw_fatal(void*, const char* reason, bool) { throw std::runtime_error(reason); }

/// Headers beside the executable: <bin>/../share/finback/include.
std::string include_dir(const char* argv0) {
  std::string self = llvm::sys::fs::getMainExecutable(argv0, reinterpret_cast<void*>(&throw_fatal));
  return (fs::path(self).parent_path().parent_path() / "share" / "finback" / "include").string();
}

void initialize_llvm(const Options& options) {
  llvm::PassRegistry& registry = *llvm::PassRegistry::getPassRegistry();
  llvm::initializeCore(registry);
  llvm::initializeCodeGen(registry);
  llvm::initializeLoopStrengthReducePass(registry);
  llvm::initializeHardwareLoopsLegacyPass(registry);
  llvm::initializeBfinTarget();
  // A nest with its sums of products two at a time is larger than the default allows.
  std::vector<const char*> arguments = {"finback-cc", "-unswitch-threshold=200"};
  if (options.verify)
    arguments.push_back("-verify-machineinstrs");
  llvm::cl::ParseCommandLineOptions(static_cast<int>(arguments.size()), arguments.data());
}

void write_file(const std::string& path, const std::string& text) {
  std::string temporary = path + ".tmp";
  {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    if (!file.flush())
      throw std::runtime_error("cannot write " + path + ": is its folder there and writable?");
  }
  fs::rename(temporary, path);
}

/// One C file to one BIR file; the exit code.
int compile_file(const std::string& input, const std::string& output, const Options& options,
                 const std::string& headers) {
  if (!fs::exists(input)) {
    fmt::print(stderr, "finback-cc: error: no such file: {}\n", input);
    return kBadInput;
  }
  llvm::LLVMContext context;
  std::unique_ptr<llvm::Module> module = compile_c(input, options, headers, context);
  if (module == nullptr)
    return kBadInput;
  prepare(*module);
  std::vector<std::string> problems = unsupported_constructs(*module, input);
  for (const std::string& problem : problems)
    fmt::print(stderr, "{}\n", problem);
  if (!problems.empty())
    return kBadInput;
  const std::string text = generate(*module, options);
  if (output == "-")
    fmt::print("{}", text);
  else
    write_file(output, text);
  return 0;
}

int run(const Options& options, const char* argv0) {
  initialize_llvm(options);
  llvm::install_fatal_error_handler(throw_fatal);
  std::string headers = include_dir(argv0);
  int code = 0;
  for (const std::string& input : options.inputs) {
    std::string output = options.output;
    if (output.empty())
      output = fs::path(input).stem().string() + (options.emit_llvm ? ".ll" : ".bir");
    try {
      code = std::max(code, compile_file(input, output, options, headers));
    } catch (const std::exception& error) {
      const std::string what = error.what();
      const bool placed = what.find(": error: ") != std::string::npos;
      fmt::print(stderr, "{}{}\n", placed ? "" : input + ":1:1: error: ", what);
      code = kBadInput;
    }
  }
  return code;
}

}  // namespace
}  // namespace finback::compiler

int main(int argc, char** argv) {
  using finback::compiler::Options;
  Options options;
  CLI::App app{"finback-cc: compiles C to BIR, the assembly text that finback loads"};
  app.footer(
      "Example:\n  finback-cc -O2 -I firmware/include -o shd.bir firmware/shd.c\n\n"
      "Exit codes: 0 fine, 1 usage, 2 bad input.");
  std::string level = "2";
  std::vector<std::string> includes, defines, undefines, warnings, features;
  bool unused = false;
  app.add_option("files", options.inputs, "C source files")->required();
  app.add_option(
      "-o", options.output,
      "The BIR file to write, - for standard output (one input only; else NAME.bir each)");
  app.add_option("-O", level, "Optimisation: 0, 1, 2, 3 or s")
      ->check(CLI::IsMember({"0", "1", "2", "3", "s"}))
      ->capture_default_str();
  app.add_option("-I", includes, "A folder to look for headers in")->allow_extra_args(false);
  app.add_option("-D", defines, "A macro: NAME or NAME=VALUE")->allow_extra_args(false);
  app.add_option("-U", undefines, "A macro to forget")->allow_extra_args(false);
  app.add_option("-W", warnings, "A warning option of clang, e.g. -Werror")
      ->allow_extra_args(false);
  app.add_option("-f", features, "A language option of clang, e.g. -fwrapv")
      ->allow_extra_args(false);
  app.add_flag("-g", unused, "Source lines in the output (always on; accepted for scripts)");
  app.add_flag("-c", unused, "Compile only (always so; accepted for scripts)");
  app.add_flag("-S", unused, "Write assembly (BIR is that; accepted for scripts)");
  app.add_flag("--emit-llvm", options.emit_llvm, "Write LLVM IR after the middle end instead");
  app.add_flag("--verify", options.verify, "Check the machine code between all passes (slow)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : finback::compiler::kUsage;
  }
  options.level = level[0];
  for (auto [flag, values] :
       {std::pair{"-I", &includes}, std::pair{"-D", &defines}, std::pair{"-U", &undefines},
        std::pair{"-W", &warnings}, std::pair{"-f", &features}})
    for (const std::string& value : *values)
      options.clang_arguments.push_back(flag + value);
  if (!options.output.empty() && options.inputs.size() > 1) {
    fmt::print(stderr, "finback-cc: error: -o names one file, but there are {} inputs\n",
               options.inputs.size());
    return finback::compiler::kUsage;
  }
  try {
    return finback::compiler::run(options, argv[0]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "finback-cc: error: {}\n", error.what());
    return finback::compiler::kBadInput;
  }
}
