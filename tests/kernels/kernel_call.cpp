#include "kernel_call.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <common/file.hpp>

namespace finback::kernels {

namespace {

std::string object_name(std::size_t number) { return fmt::format("_buffer{}", number); }

std::string read_kernel(const std::string& kernel) {
  const std::string text = read_text_file(std::string(FINBACK_KERNELS) + "/" + kernel + ".bir");
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

// What a C function keeps, each with a value of its own.
constexpr isa::Register kKept[] = {isa::R4, isa::R5, isa::P3, isa::P4, isa::P5};
std::uint32_t kept_value(isa::Register reg) { return 0x4b00u + static_cast<std::uint32_t>(reg); }

}  // namespace

KernelCall& KernelCall::number(std::int64_t value) {
  argument(std::to_string(value));
  return *this;
}

KernelCall& KernelCall::buffer(const Halves& values) {
  argument(object_name(objects_.size()));
  return hidden_buffer(values);
}

KernelCall& KernelCall::inside(const Halves& values, std::size_t bytes) {
  argument(fmt::format("{} + {}", object_name(objects_.size()), bytes));
  return hidden_buffer(values);
}

KernelCall& KernelCall::hidden_buffer(const Halves& values) {
  objects_.push_back(fmt::format(".byte2 {}\n", fmt::join(values, ", ")));
  return *this;
}

KernelCall& KernelCall::record(const std::vector<std::string>& words) {
  argument(object_name(objects_.size()));
  std::string lines;
  for (const std::string& word : words) {
    lines +=
        ".byte4 " + (word.starts_with('@') ? object_name(std::stoul(word.substr(1))) : word) + "\n";
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
    std::string text = core::program(caller()) + read_kernel(kernel_) + ".data\n";
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

Halves KernelCall::halves(std::size_t buffer) {
  const std::string name = ir::c_name(object_name(buffer));
  Halves values;
  for (const ir::PlacedObject& object : harness().image().objects) {
    if (object.name == name) {
      const auto bytes = harness().memory().view_bytes(object.address, object.size);
      for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        values.push_back(static_cast<std::int16_t>(bytes[i] | bytes[i + 1] << 8));
      }
    }
  }
  return values;
}

}  // namespace finback::kernels
