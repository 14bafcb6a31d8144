#include "frontend.hpp"

#include <fstream>
#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/InstrTypes.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/Process.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/raw_ostream.h>
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
                                      "-Wno-builtin-macro-redefined",
                                      "-D__STDC_HOSTED__=0",
                                      "-D__bfin__=1",
                                      "-D__BFIN__=1",
                                      "-D__ADSPBF561__=1",
                                      "-D__FINBACK__=1",
                                      "-Wall",
                                      std::string("-O") + options.level,
                                      "-isystem",
                                      include_dir};
  // Not -ffreestanding: it takes main for a function like any other, which at its closing brace
  // returns anything in C, and has another name in C++.
  if (is_cpp(input))
    command.insert(command.end(), {"-std=gnu++17", "-fno-exceptions", "-fno-rtti", "-nostdinc++",
                                   "-fno-threadsafe-statics", "-fno-use-cxa-atexit"});
  else
    command.insert(command.end(), {"-std=gnu11"});
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

/// Runs clang; false when it has reported errors. Its messages go to the user, or to a file.
bool run_clang(std::vector<std::string> arguments, const std::string& input,
               const TemporaryFile& output, const TemporaryFile* messages = nullptr) {
  auto clang = llvm::sys::findProgramByName("clang-19");
  if (!clang)
    throw std::runtime_error("clang-19 is not on PATH: install the package clang-19");
  arguments.insert(arguments.begin(), *clang);
  for (const std::string& last : {std::string("-o"), output.path(), input})
    arguments.push_back(last);
  std::vector<llvm::StringRef> command(arguments.begin(), arguments.end());
  const std::string kept = messages == nullptr ? "" : messages->path();
  std::vector<std::optional<llvm::StringRef>> redirects;
  if (messages != nullptr)
    redirects = {std::nullopt, std::nullopt, kept};
  std::string problem;
  const int code =
      llvm::sys::ExecuteAndWait(*clang, command, std::nullopt, redirects, 0, 0, &problem);
  if (code < 0)
    throw std::runtime_error("cannot run " + *clang + ": " + problem);
  return code == 0;
}

std::unique_ptr<llvm::Module> read_module(const TemporaryFile& bitcode,
                                          llvm::LLVMContext& context) {
  auto module = llvm::parseBitcodeFile(bitcode.read()->getMemBufferRef(), context);
  if (!module)
    throw std::runtime_error("cannot read what clang-19 wrote: " +
                             llvm::toString(module.takeError()));
  return std::move(*module);
}

bool mentions_assembly(const std::string& input) {
  auto text = llvm::MemoryBuffer::getFile(input);
  return text && (*text)->getBuffer().contains("asm");
}

bool has_assembly(const llvm::Module& module) {
  const auto is_assembly = [](const llvm::Instruction& inst) {
    const auto* call = llvm::dyn_cast<llvm::CallBase>(&inst);
    return call != nullptr && call->isInlineAsm();
  };
  return !module.getModuleInlineAsm().empty() ||
         llvm::any_of(module, [&](const llvm::Function& function) {
           return llvm::any_of(llvm::instructions(function), is_assembly);
         });
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

/// As it stands, with assembly as clang's own target has it; null: there are errors. What clang
/// said is in `messages`.
std::unique_ptr<llvm::Module> compile_plain(const std::string& input,
                                            std::vector<std::string> arguments,
                                            const TemporaryFile& messages,
                                            llvm::LLVMContext& context) {
  arguments.push_back("-fmessage-length=" +
                      std::to_string(llvm::sys::Process::StandardErrColumns()));
  if (llvm::sys::Process::StandardErrHasColors())
    arguments.emplace_back("-fcolor-diagnostics");
  const TemporaryFile bitcode("bc");
  if (!run_clang(arguments, input, bitcode, &messages))
    return nullptr;
  return read_module(bitcode, context);
}

/// Most files have no assembly, and clang runs once for them. Others, and those with errors, which
/// may be of the assembly in a header, are preprocessed first.
std::unique_ptr<llvm::Module> compile_any(const std::string& input, const Options& options,
                                          const std::string& include_dir,
                                          llvm::LLVMContext& context) {
  const std::vector<std::string> language = language_options(input, options, include_dir);
  std::vector<std::string> arguments = language;
  arguments.insert(arguments.end(), std::begin(kCompile), std::end(kCompile));
  const TemporaryFile messages("txt");
  bool failed = false;
  if (!mentions_assembly(input)) {
    auto module = compile_plain(input, arguments, messages, context);
    failed = module == nullptr;
    if (!failed && !has_assembly(*module)) {
      llvm::errs() << messages.read()->getBuffer();
      return module;
    }
  }
  const TemporaryFile rewritten(is_cpp(input) ? "ii" : "i");
  bool rewrote = false;
  if (!preprocess(input, language, rewritten, rewrote))
    return nullptr;
  if (failed && !rewrote) {
    llvm::errs() << messages.read()->getBuffer();
    return nullptr;
  }
  if (rewrote)
    arguments.emplace_back("-Wno-unused-command-line-argument");  // of the preprocessor
  const TemporaryFile bitcode("bc");
  if (!run_clang(arguments, rewrote ? rewritten.path() : input, bitcode))
    return nullptr;
  return read_module(bitcode, context);
}

}  // namespace

std::unique_ptr<llvm::Module> compile_c(const std::string& input, const Options& options,
                                        const std::string& include_dir,
                                        llvm::LLVMContext& context) {
  std::unique_ptr<llvm::Module> module = compile_any(input, options, include_dir, context);
  if (module != nullptr) {
    module->setTargetTriple("bfin-unknown-unknown");
    module->setDataLayout(llvm::BfinTargetMachine::kDataLayout);
  }
  return module;
}

}  // namespace finback::compiler
