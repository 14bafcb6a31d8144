#include "kernel_call.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <common/file.hpp>

namespace finback::kernels {

namespace {

std::string object_name(const std::string& number) { return "_buffer" + number; }
std::string object_name(std::size_t number) { return object_name(std::to_string(number)); }

std::string read_unit(const std::string& path) {
  const std::string text = read_text_file(path);
  return text.substr(text.find('\n') + 1);  // the harness writes the head line
}

// `value`, a number or a symbol, into a data register.
std::string load(const std::string& reg, const std::string& value) {
  const bool symbol = value.starts_with('_');
  const std::int64_t number = symbol ? 0 : std::stoll(value);
  if (!symbol && number >= -0x8000 && number <= 0x7fff) {
    return fmt::format("{} = {} (X);\n", reg, number);
  }
  const auto half = [&](int shift) {
    return symbol ? value : std::to_string(number >> shift & 0xffff);
  };
  return fmt::format("{0}.L = {1};\n{0}.H = {2};\n", reg, half(0), half(16));
}

// Little-endian values of type T.
template <typename T>
std::vector<T> values(const Bytes& bytes) {
  std::vector<T> all;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      value |= static_cast<std::uint32_t>(bytes[i + k]) << (8 * k);
    }
    all.push_back(static_cast<T>(value));
  }
  return all;
}

// What a C function keeps, each with a value of its own.
constexpr isa::Register kKept[] = {isa::R4, isa::R5, isa::P3, isa::P4, isa::P5};
std::uint32_t kept_value(isa::Register reg) { return 0x4b00u + static_cast<std::uint32_t>(reg); }

}  // namespace

KernelCall& KernelCall::with(const std::string& path) {
  linked_ += read_unit(path);
  return *this;
}

KernelCall& KernelCall::number(std::int64_t value) {
  argument(std::to_string(value));
  return *this;
}

void KernelCall::next_argument(std::size_t bytes) {
  const std::string name = object_name(objects_.size());
  argument(bytes == 0 ? name : fmt::format("{} + {}", name, bytes));
}

KernelCall& KernelCall::buffer(const Halves& values) { return inside(values, 0); }

KernelCall& KernelCall::buffer(const Bytes& values) { return inside(values, 0); }

KernelCall& KernelCall::buffer(const Words& values) {
  next_argument(0);
  objects_.push_back(fmt::format(".byte4 {}\n", fmt::join(values, ", ")));
  return *this;
}

KernelCall& KernelCall::inside(const Halves& values, std::size_t bytes) {
  next_argument(bytes);
  return hidden_buffer(values);
}

KernelCall& KernelCall::inside(const Bytes& values, std::size_t bytes) {
  next_argument(bytes);
  return hidden_buffer(values);
}

KernelCall& KernelCall::hidden_buffer(const Halves& values) {
  objects_.push_back(fmt::format(".byte2 {}\n", fmt::join(values, ", ")));
  return *this;
}

KernelCall& KernelCall::hidden_buffer(const Bytes& values) {
  objects_.push_back(fmt::format(".byte {}\n", fmt::join(values, ", ")));
  return *this;
}

KernelCall& KernelCall::record(const std::vector<std::string>& words) {
  argument(object_name(objects_.size()));
  std::string lines;
  for (const std::string& word : words) {
    lines += ".byte4 " + (word.starts_with('@') ? object_name(word.substr(1)) : word) + "\n";
  }
  objects_.push_back(lines);
  return *this;
}

KernelCall& KernelCall::crowded() {
  alignment_ = 8;
  return *this;
}

void KernelCall::argument(const std::string& value) { arguments_.push_back(value); }

// The caller's frame has room for the arguments, R0 to R2 included, as the calling convention
// wants.
std::string KernelCall::caller() const {
  std::string text = "SP += -32;\n";
  for (const isa::Register reg : kKept) {
    text += fmt::format("{} = {} (X);\n", isa::register_name(reg), kept_value(reg));
  }
  text += "R7 = CYCLES;\n";
  for (std::size_t i = 3; i < arguments_.size(); ++i) {
    text += load("R3", arguments_[i]) + fmt::format("[SP + {}] = R3;\n", 4 * i);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(3, arguments_.size()); ++i) {
    text += load(fmt::format("R{}", i), arguments_[i]);
  }
  return text + "CALL _" + kernel_ + ";\nR6 = CYCLES;\nSP += 32;";
}

core::CoreHarness& KernelCall::harness() {
  if (!harness_) {
    const std::string kernel = read_unit(folder_ + "/" + kernel_ + ".bir");
    std::string text = core::program(caller()) + kernel + linked_ + ".data\n";
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      text += fmt::format(".align {0}\n.type {1}, @object\n{1}:\n{2}", alignment_, object_name(i),
                          objects_[i]);
    }
    harness_ = std::make_shared<core::CoreHarness>(text);
  }
  return *harness_;
}

core::CoreParameters& KernelCall::parameters() { return harness().parameters(); }

Cycles KernelCall::run() {
  core::CoreHarness& core = harness();
  core.run();
  for (const isa::Register reg : kKept) {
    EXPECT_EQ(core.reg(reg), kept_value(reg)) << kernel_ << ": " << isa::register_name(reg);
  }
  for (const isa::Register length : {isa::L0, isa::L1, isa::L2, isa::L3}) {
    EXPECT_EQ(core.reg(length), 0u) << kernel_ << ": " << isa::register_name(length);
  }
  EXPECT_EQ(core.reg(isa::SP), core.reg(isa::FP)) << kernel_ << ": SP";
  return core.reg(isa::R6) - core.reg(isa::R7) - 1;  // less the first reading itself
}

std::uint32_t KernelCall::result() { return harness().reg(isa::R0); }

Bytes KernelCall::bytes(std::size_t buffer) {
  const std::string name = ir::c_name(object_name(buffer));
  for (const ir::PlacedObject& object : harness().image().objects) {
    if (object.name == name) {
      const auto view = harness().memory().view_bytes(object.address, object.size);
      return {view.begin(), view.end()};
    }
  }
  return {};
}

Halves KernelCall::halves(std::size_t buffer) { return values<std::int16_t>(bytes(buffer)); }

Words KernelCall::words(std::size_t buffer) { return values<std::int32_t>(bytes(buffer)); }

}  // namespace finback::kernels
