// The services that a program asks of its host by EXCPT 0: the system calls of newlib's Blackfin
// port (libgloss), as the GNU simulator serves them.
//
// The number is in P0, R0 points to the arguments, one word each; the result goes to R0, a second
// one to R1, the error (newlib's errno) to R2. Serves: exit, open, close, read, write, lseek,
// unlink, getpid, kill, fstat, stat, time, gettimeofday, argc, argnlen, argn; any other answers -1
// and ENOSYS. Files lie below one folder, if there is one; without it none can be opened. Time is
// the machine's, from 0, so that runs repeat. Does not serve: directories, links, processes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <isa_sim/isa/operation.hpp>
#include <memory_model/memory_system.hpp>

struct stat;

namespace finback::machine {

struct ProgramHostOptions {
  std::vector<std::string> arguments;  // argv, the program's name first
  std::filesystem::path folder;        // files that the program may open lie below; "": none
  double core_hertz = 600e6;           // set by the machine
  // What the program writes; `stream` is 1 or 2.
  std::function<void(int stream, std::string_view text)> output;
  // What it reads from its input: fills `bytes`, returns how many there were, 0 at the end.
  std::function<std::size_t(std::span<std::uint8_t> bytes)> input;
};

class ProgramHost {
 public:
  ProgramHost(ProgramHostOptions options, memory::MemorySystem& memory);
  ProgramHost(const ProgramHost&) = delete;
  ProgramHost& operator=(const ProgramHost&) = delete;
  ~ProgramHost();

  // Does what `state` asks for at time `now`. The exit status, when that is the program's end.
  std::optional<std::uint32_t> call(isa::ExecutionState& state, Cycles now);
  // The program prints by a debug instruction.
  void print(std::string_view text);

 private:
  struct Result {
    std::uint32_t value = 0;
    std::uint32_t error = 0;
  };
  static constexpr std::size_t kArguments = 4;
  using Arguments = std::array<std::uint32_t, kArguments>;

  [[nodiscard]] Result serve(std::uint32_t number, const Arguments& arguments, Cycles now);
  [[nodiscard]] Result open(std::uint32_t path, std::uint32_t flags, std::uint32_t mode);
  [[nodiscard]] Result close(std::uint32_t file);
  [[nodiscard]] Result read(std::uint32_t file, std::uint32_t address, std::uint32_t size);
  [[nodiscard]] Result write(std::uint32_t file, std::uint32_t address, std::uint32_t size);
  [[nodiscard]] Result seek(std::uint32_t file, std::uint32_t offset, std::uint32_t whence);
  [[nodiscard]] Result unlink(std::uint32_t path);
  [[nodiscard]] Result status(std::uint32_t file, std::uint32_t address);
  [[nodiscard]] Result status_of_path(std::uint32_t path, std::uint32_t address);
  [[nodiscard]] Result time_of_day(std::uint32_t address, Cycles now);
  [[nodiscard]] Result argument(std::uint32_t index, std::uint32_t address);
  [[nodiscard]] std::string text_at(std::uint32_t address) const;
  [[nodiscard]] std::optional<std::filesystem::path> host_path(std::uint32_t address) const;
  [[nodiscard]] int host_file(std::uint32_t file) const;
  void put_status(std::uint32_t address, const struct ::stat& status);
  void put_words(std::uint32_t address, std::span<const std::uint32_t> words);

  ProgramHostOptions options_;
  memory::MemorySystem& memory_;
  std::vector<int> files_;  // the host's descriptors from the program's number 3; -1: closed
};

}  // namespace finback::machine
