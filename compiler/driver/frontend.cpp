#include "frontend.hpp"

#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/FileUtilities.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Program.h>
#include <stdexcept>

#include "../target/BfinTargetMachine.hpp"

namespace finback::compiler {
namespace {

std::vector<std::string> clang_command(const std::string& clang, const std::string& input,
                                       const Options& options, const std::string& include_dir,
                                       const std::string& output) {
  std::vector<std::string> command = {clang,
                                      "-target",
                                      "csky",
                                      "-std=gnu11",
                                      "-ffreestanding",
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
                                      "-g",
                                      "-gline-tables-only",
                                      "-emit-llvm",
                                      "-fno-discard-value-names",
                                      "-Xclang",
                                      "-disable-llvm-passes",
                                      "-Xclang",
                                      "-disable-O0-optnone",
                                      "-fdebug-default-version=5",
                                      std::string("-O") + options.level,
                                      "-isystem",
                                      include_dir};
  command.insert(command.end(), options.clang_arguments.begin(), options.clang_arguments.end());
  for (const char* last : {"-c", "-o"})
    command.emplace_back(last);
  command.push_back(output);
  command.push_back(input);
  return command;
}

}  // namespace

std::unique_ptr<llvm::Module> compile_c(const std::string& input, const Options& options,
                                        const std::string& include_dir,
                                        llvm::LLVMContext& context) {
  auto clang = llvm::sys::findProgramByName("clang-19");
  if (!clang)
    throw std::runtime_error("clang-19 is not on PATH: install the package clang-19");
  llvm::SmallString<128> bitcode;
  if (std::error_code error = llvm::sys::fs::createTemporaryFile("finback-cc", "bc", bitcode))
    throw std::runtime_error("cannot make a temporary file: " + error.message());
  llvm::FileRemover remover(bitcode);
  std::vector<std::string> command =
      clang_command(*clang, input, options, include_dir, bitcode.str().str());
  std::vector<llvm::StringRef> arguments(command.begin(), command.end());
  std::string problem;
  int code = llvm::sys::ExecuteAndWait(*clang, arguments, std::nullopt, {}, 0, 0, &problem);
  if (code < 0)
    throw std::runtime_error("cannot run " + *clang + ": " + problem);
  if (code > 0)
    return nullptr;
  auto buffer = llvm::MemoryBuffer::getFile(bitcode);
  if (!buffer)
    throw std::runtime_error("cannot read what clang-19 wrote: " + buffer.getError().message());
  auto module = llvm::parseBitcodeFile((*buffer)->getMemBufferRef(), context);
  if (!module)
    throw std::runtime_error("cannot read what clang-19 wrote: " +
                             llvm::toString(module.takeError()));
  (*module)->setTargetTriple("bfin-unknown-unknown");
  (*module)->setDataLayout(llvm::BfinTargetMachine::kDataLayout);
  return std::move(*module);
}

}  // namespace finback::compiler
