#include "frontend.hpp"

#include <fstream>
#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/Program.h>
#include <stdexcept>

#include "../target/BfinTargetMachine.hpp"
#include "assembly.hpp"

namespace finback::compiler {
namespace {

/// A file that is removed when it is no longer needed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const char* suffix) {
    if (std::error_code error = llvm::sys::fs::createTemporaryFile("finback-cc", suffix, path_))
      throw std::runtime_error("cannot make a temporary file: " + error.message());
  }
  ~TemporaryFile() { llvm::sys::fs::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.str().str(); }
  std::unique_ptr<llvm::MemoryBuffer> read() const {
    auto buffer = llvm::MemoryBuffer::getFile(path_);
    if (!buffer)
      throw std::runtime_error("cannot read what clang-19 wrote: " + buffer.getError().message());
    return std::move(*buffer);
  }

 private:
  llvm::SmallString<128> path_;
};

bool is_cpp(const std::string& path) {
  const llvm::StringRef ending = llvm::sys::path::extension(path);
  return ending == ".cpp" || ending == ".cc" || ending == ".cxx";
}

/// What decides how clang reads C or C++.
std::vector<std::string> language_options(const std::string& input, const Options& options,
                                          const std::string& include_dir) {
  std::vector<std::string> command = {"-target",
                                      "csky",
                                      "-fno-builtin",
                                      "-nostdlibinc",
                                      "-Ucsky",
                                      "-U__csky__",
                                      "-U__CSKY__",
                                      "-U__ckcore__",
                                      "-U__CKCORE__",
                                      "-U__CSKYABI__",
                                      "-U__cskyabi__",
                                      "-U__CSKYLE__",
                                      "-U__cskyle__",
                                      "-D__bfin__=1",
                                      "-D__BFIN__=1",
                                      "-D__ADSPBF561__=1",
                                      "-D__FINBACK__=1",
                                      "-Wall",
                                      std::string("-O") + options.level,
                                      "-isystem",
                                      include_dir};
  if (is_cpp(input))
    // Freestanding C++ would take main for a function like any other, and change its name.
    command.insert(command.end(), {"-std=gnu++17", "-fno-exceptions", "-fno-rtti", "-nostdinc++",
                                   "-fno-threadsafe-statics", "-fno-use-cxa-atexit"});
  else
    command.insert(command.end(), {"-std=gnu11", "-ffreestanding"});
  command.insert(command.end(), options.clang_arguments.begin(), options.clang_arguments.end());
  return command;
}

/// To bitcode, before any optimisation. Every operation on floats rounds by itself.
constexpr const char* kCompile[] = {"-g",
                                    "-ffp-contract=off",
                                    "-gline-tables-only",
                                    "-emit-llvm",
                                    "-fno-discard-value-names",
                                    "-Xclang",
                                    "-disable-llvm-passes",
                                    "-Xclang",
                                    "-disable-O0-optnone",
                                    "-fdebug-default-version=5",
                                    "-c"};

/// Runs clang; false when it has reported errors.
bool run_clang(std::vector<std::string> arguments, const std::string& input,
               const TemporaryFile& output) {
  auto clang = llvm::sys::findProgramByName("clang-19");
  if (!clang)
    throw std::runtime_error("clang-19 is not on PATH: install the package clang-19");
  arguments.insert(arguments.begin(), *clang);
  for (const std::string& last : {std::string("-o"), output.path(), input})
    arguments.push_back(last);
  std::vector<llvm::StringRef> command(arguments.begin(), arguments.end());
  std::string problem;
  const int code = llvm::sys::ExecuteAndWait(*clang, command, std::nullopt, {}, 0, 0, &problem);
  if (code < 0)
    throw std::runtime_error("cannot run " + *clang + ": " + problem);
  return code == 0;
}

/// Where there is assembly: to `output`, with the assembly in the form that clang takes; the lines
/// are told by line markers. False: clang has reported errors.
bool preprocess(const std::string& input, std::vector<std::string> arguments,
                const TemporaryFile& output, bool& has_assembly) {
  const TemporaryFile plain("i");
  arguments.insert(arguments.end(), {"-E", "-w"});
  if (!run_clang(arguments, input, plain))
    return false;
  std::string text = plain.read()->getBuffer().str();
  has_assembly = rewrite_assembly(text);
  if (has_assembly)
    std::ofstream(output.path(), std::ios::binary) << text;
  return true;
}

}  // namespace

std::unique_ptr<llvm::Module> compile_c(const std::string& input, const Options& options,
                                        const std::string& include_dir,
                                        llvm::LLVMContext& context) {
  std::vector<std::string> arguments = language_options(input, options, include_dir);
  const TemporaryFile rewritten(is_cpp(input) ? "ii" : "i");
  bool has_assembly = false;
  if (!preprocess(input, arguments, rewritten, has_assembly))
    return nullptr;
  arguments.insert(arguments.end(), std::begin(kCompile), std::end(kCompile));
  if (has_assembly)
    arguments.emplace_back("-Wno-unused-command-line-argument");  // of the preprocessor
  const TemporaryFile bitcode("bc");
  if (!run_clang(arguments, has_assembly ? rewritten.path() : input, bitcode))
    return nullptr;
  auto module = llvm::parseBitcodeFile(bitcode.read()->getMemBufferRef(), context);
  if (!module)
    throw std::runtime_error("cannot read what clang-19 wrote: " +
                             llvm::toString(module.takeError()));
  (*module)->setTargetTriple("bfin-unknown-unknown");
  (*module)->setDataLayout(llvm::BfinTargetMachine::kDataLayout);
  return std::move(*module);
}

}  // namespace finback::compiler
