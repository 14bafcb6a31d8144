#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <common/error.hpp>
#include <isa_sim/machine/program_host.hpp>

namespace finback::machine {

namespace {

namespace fs = std::filesystem;

// Numbers of libgloss's system calls.
enum Call : std::uint32_t {
  kExitCall = 1,
  kOpen = 2,
  kClose = 3,
  kRead = 4,
  kWrite = 5,
  kSeek = 6,
  kUnlink = 7,
  kGetPid = 8,
  kKill = 9,
  kStatusOfFile = 10,
  kStatusOfPath = 15,
  kTime = 18,
  kTimeOfDay = 19,
  kArgumentCount = 22,
  kArgumentLength = 23,
  kArgument = 24,
};

// newlib's errno and flags of open.
constexpr std::uint32_t kBadFile = 9, kFault = 14, kInvalid = 22, kTooMany = 24, kNoCall = 88;
constexpr std::uint32_t kAccessDenied = 13, kInputOutput = 5;
constexpr std::uint32_t kAccessMode = 3, kAppend = 0x8, kCreate = 0x200, kTruncate = 0x400,
                        kExclusive = 0x800;

constexpr std::uint32_t kFailed = ~0U;
constexpr std::uint32_t kFirstFile = 3;  // after input, output and errors
constexpr std::size_t kMostFiles = 64;
constexpr std::size_t kMostPathBytes = 4096;
constexpr std::uint32_t kStatusBytes = 60;
constexpr std::uint32_t kTerminalMode = S_IFCHR | 0666;

// newlib has the numbers of the old Unix errors in common with the host.
std::uint32_t newlib_error(int error) {
  constexpr int kLastCommon = 34;  // ERANGE
  return error <= kLastCommon ? static_cast<std::uint32_t>(error) : kInputOutput;
}

}  // namespace

ProgramHost::ProgramHost(ProgramHostOptions options, memory::MemorySystem& memory)
    : options_(std::move(options)), memory_(memory) {}

ProgramHost::~ProgramHost() {
  for (const int file : files_) {
    if (file >= 0) {
      ::close(file);
    }
  }
}

void ProgramHost::print(std::string_view text) {
  if (options_.output) {
    options_.output(1, text);
  }
}

std::optional<std::uint32_t> ProgramHost::call(isa::ExecutionState& state, Cycles now) {
  const std::uint32_t number = state.reg[isa::P0];
  constexpr std::uint32_t kSignalStatus = 128;
  Result result{kFailed, kFault};
  try {
    Arguments arguments{};
    std::memcpy(arguments.data(), memory_.view_bytes(state.reg[isa::R0], sizeof arguments).data(),
                sizeof arguments);
    if (number == kExitCall) {
      return arguments[0];
    }
    if (number == kKill && arguments[1] != 0) {
      return kSignalStatus + arguments[1];
    }
    result = serve(number, arguments, now);
  } catch (const InputError&) {
    // An address outside memory.
  }
  state.reg[isa::R0] = result.error != 0 ? kFailed : result.value;
  state.reg[isa::R1] = 0;
  state.reg[isa::R2] = result.error;
  return std::nullopt;
}

ProgramHost::Result ProgramHost::serve(std::uint32_t number, const Arguments& arguments,
                                       Cycles now) {
  switch (number) {
    case kOpen:
      return open(arguments[0], arguments[1], arguments[2]);
    case kClose:
      return close(arguments[0]);
    case kRead:
      return read(arguments[0], arguments[1], arguments[2]);
    case kWrite:
      return write(arguments[0], arguments[1], arguments[2]);
    case kSeek:
      return seek(arguments[0], arguments[1], arguments[2]);
    case kUnlink:
      return unlink(arguments[0]);
    case kGetPid:
      return {1, 0};
    case kKill:
      return {0, 0};
    case kStatusOfFile:
      return status(arguments[0], arguments[1]);
    case kStatusOfPath:
      return status_of_path(arguments[0], arguments[1]);
    case kTime:
      return {static_cast<std::uint32_t>(static_cast<double>(now) / options_.core_hertz), 0};
    case kTimeOfDay:
      return time_of_day(arguments[0], now);
    case kArgumentCount:
      return {static_cast<std::uint32_t>(options_.arguments.size()), 0};
    case kArgumentLength:
      return arguments[0] < options_.arguments.size()
                 ? Result{static_cast<std::uint32_t>(options_.arguments[arguments[0]].size()), 0}
                 : Result{kFailed, kInvalid};
    case kArgument:
      return argument(arguments[0], arguments[1]);
    default:
      return {kFailed, kNoCall};
  }
}

ProgramHost::Result ProgramHost::open(std::uint32_t path, std::uint32_t flags, std::uint32_t mode) {
  const auto file_path = host_path(path);
  if (!file_path) {
    return {kFailed, kAccessDenied};
  }
  const auto free = std::ranges::find(files_, -1);
  if (free == files_.end() && files_.size() == kMostFiles) {
    return {kFailed, kTooMany};
  }
  int host_flags = O_CLOEXEC | static_cast<int>(flags & kAccessMode);
  host_flags |= (flags & kAppend) != 0 ? O_APPEND : 0;
  host_flags |= (flags & kCreate) != 0 ? O_CREAT : 0;
  host_flags |= (flags & kTruncate) != 0 ? O_TRUNC : 0;
  host_flags |= (flags & kExclusive) != 0 ? O_EXCL : 0;
  const int file = ::open(file_path->c_str(), host_flags, mode & 0777);
  if (file < 0) {
    return {kFailed, newlib_error(errno)};
  }
  if (free != files_.end()) {
    *free = file;
    return {kFirstFile + static_cast<std::uint32_t>(free - files_.begin()), 0};
  }
  files_.push_back(file);
  return {kFirstFile + static_cast<std::uint32_t>(files_.size() - 1), 0};
}

ProgramHost::Result ProgramHost::close(std::uint32_t file) {
  if (file < kFirstFile) {
    return {0, 0};
  }
  const int host = host_file(file);
  if (host < 0) {
    return {kFailed, kBadFile};
  }
  files_[file - kFirstFile] = -1;
  return ::close(host) == 0 ? Result{0, 0} : Result{kFailed, newlib_error(errno)};
}

ProgramHost::Result ProgramHost::read(std::uint32_t file, std::uint32_t address,
                                      std::uint32_t size) {
  const int host = host_file(file);
  if (size == 0) {
    return {0, 0};
  }
  if (file != 0 && host < 0) {
    return {kFailed, kBadFile};
  }
  const std::span bytes(memory_.host_access(address, size, memory::Direction::write), size);
  if (file == 0) {
    return {options_.input ? static_cast<std::uint32_t>(options_.input(bytes)) : 0U, 0};
  }
  const ssize_t count = ::read(host, bytes.data(), size);
  return count < 0 ? Result{kFailed, newlib_error(errno)}
                   : Result{static_cast<std::uint32_t>(count), 0};
}

ProgramHost::Result ProgramHost::write(std::uint32_t file, std::uint32_t address,
                                       std::uint32_t size) {
  const int host = host_file(file);
  if (size == 0) {
    return {0, 0};
  }
  if (file != 1 && file != 2 && host < 0) {
    return {kFailed, kBadFile};
  }
  const std::uint8_t* bytes = memory_.host_access(address, size, memory::Direction::read);
  if (file < kFirstFile) {
    if (options_.output) {
      options_.output(static_cast<int>(file),
                      std::string_view(reinterpret_cast<const char*>(bytes), size));
    }
    return {size, 0};
  }
  const ssize_t count = ::write(host, bytes, size);
  return count < 0 ? Result{kFailed, newlib_error(errno)}
                   : Result{static_cast<std::uint32_t>(count), 0};
}

ProgramHost::Result ProgramHost::seek(std::uint32_t file, std::uint32_t offset,
                                      std::uint32_t whence) {
  constexpr std::array kWhence = {SEEK_SET, SEEK_CUR, SEEK_END};
  const int host = host_file(file);
  if (host < 0) {
    return {kFailed, kBadFile};
  }
  if (whence >= kWhence.size()) {
    return {kFailed, kInvalid};
  }
  const off_t at = ::lseek(host, static_cast<std::int32_t>(offset), kWhence[whence]);
  return at < 0 ? Result{kFailed, newlib_error(errno)} : Result{static_cast<std::uint32_t>(at), 0};
}

ProgramHost::Result ProgramHost::unlink(std::uint32_t path) {
  const auto file_path = host_path(path);
  if (!file_path) {
    return {kFailed, kAccessDenied};
  }
  return ::unlink(file_path->c_str()) == 0 ? Result{0, 0} : Result{kFailed, newlib_error(errno)};
}

ProgramHost::Result ProgramHost::status(std::uint32_t file, std::uint32_t address) {
  struct stat found {};
  if (file < kFirstFile) {
    found.st_mode = kTerminalMode;
  } else if (const int host = host_file(file); host < 0 || ::fstat(host, &found) != 0) {
    return {kFailed, kBadFile};
  }
  put_status(address, found);
  return {0, 0};
}

ProgramHost::Result ProgramHost::status_of_path(std::uint32_t path, std::uint32_t address) {
  const auto file_path = host_path(path);
  if (!file_path) {
    return {kFailed, kAccessDenied};
  }
  struct stat found {};
  if (::stat(file_path->c_str(), &found) != 0) {
    return {kFailed, newlib_error(errno)};
  }
  put_status(address, found);
  return {0, 0};
}

// Kind, permissions and size; no times, owners or devices, which differ from host to host.
void ProgramHost::put_status(std::uint32_t address, const struct ::stat& status) {
  constexpr std::size_t kModeWord = 1, kLinksWord = 2, kSizeWord = 4;
  std::array<std::uint32_t, kStatusBytes / 4> words{};
  words[kModeWord] = status.st_mode;
  words[kLinksWord] = 1;
  words[kSizeWord] = static_cast<std::uint32_t>(status.st_size);
  put_words(address, words);
}

ProgramHost::Result ProgramHost::time_of_day(std::uint32_t address, Cycles now) {
  constexpr double kMicroseconds = 1e6;
  const auto all =
      static_cast<std::uint64_t>(static_cast<double>(now) / options_.core_hertz * kMicroseconds);
  if (address != 0) {
    put_words(address, std::array{static_cast<std::uint32_t>(all / 1000000),
                                  static_cast<std::uint32_t>(all % 1000000)});
  }
  return {0, 0};
}

ProgramHost::Result ProgramHost::argument(std::uint32_t index, std::uint32_t address) {
  if (index >= options_.arguments.size()) {
    return {kFailed, kInvalid};
  }
  const std::string& text = options_.arguments[index];
  const auto size = static_cast<std::uint32_t>(text.size() + 1);
  std::memcpy(memory_.host_access(address, size, memory::Direction::write), text.c_str(), size);
  return {address, 0};
}

std::string ProgramHost::text_at(std::uint32_t address) const {
  std::string text;
  while (text.size() < kMostPathBytes) {
    const std::uint8_t byte = memory_.view_bytes(address++, 1)[0];
    if (byte == 0) {
      break;
    }
    text += static_cast<char>(byte);
  }
  return text;
}

// Below the folder, whatever `..` and links say; nothing when it is not.
std::optional<fs::path> ProgramHost::host_path(std::uint32_t address) const {
  if (options_.folder.empty()) {
    return std::nullopt;
  }
  std::error_code error;
  const fs::path root = fs::canonical(options_.folder, error);
  const fs::path path = fs::weakly_canonical(root / text_at(address), error);
  const auto [end, unused] = std::ranges::mismatch(root, path);
  return !error && end == root.end() ? std::optional(path) : std::nullopt;
}

int ProgramHost::host_file(std::uint32_t file) const {
  return file >= kFirstFile && file - kFirstFile < files_.size() ? files_[file - kFirstFile] : -1;
}

void ProgramHost::put_words(std::uint32_t address, std::span<const std::uint32_t> words) {
  const auto size = static_cast<std::uint32_t>(words.size_bytes());
  std::memcpy(memory_.host_access(address, size, memory::Direction::write), words.data(), size);
}

}  // namespace finback::machine
