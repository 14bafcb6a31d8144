// Runs a piece of BIR on one core with everything in its L1, for tests of meaning and of time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <isa_sim/core/core.hpp>
#include <isa_sim/core/evaluator.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>

namespace finback::core {

// 8 KB of data for a program under test, as `_buffer`.
constexpr const char* kBuffer =
    ".data\n.align 8\n.type _buffer, @object\n_buffer: .space 8192\n.size _buffer, 8192\n";

// A core whose machine has no devices and whose turn never ends.
class CoreHarness : public SystemPort {
 public:
  // `text`: BIR without its head line; a function `_start` that ends in IDLE.
  explicit CoreHarness(const std::string& text) {
    ir::Program program = ir::parse(".bir 1\n" + text, "test.bir");
    ir::verify(program);
    const ir::Firmware firmware = ir::bare_firmware(std::move(program));
    image_ = ir::link(firmware.units, firmware.placement, memory::bf561_map());
    std::vector<memory::ObjectPlace> places;
    for (const ir::PlacedObject& object : image_.objects) {
      places.push_back({object.name, "core_a", object.address, object.size});
    }
    memory_ = std::make_unique<memory::MemorySystem>(memory::bf561_map(), memory_parameters_,
                                                     clock_, places);
    for (const ir::PlacedObject& object : image_.objects) {
      memory_->store_bytes(object.address, object.initial);
    }
  }

  // Runs to IDLE or the program's end; returns the cycles it took.
  Cycles run(const Core::Start& how = {EventController::kSupervisor, kCyclesRun}) {
    return run_beside([] {}, how);
  }
  // `before`: what happens to the memory when the core is there and has not begun.
  template <class Before>
  Cycles run_beside(const Before& before,
                    const Core::Start& how = {EventController::kSupervisor, kCyclesRun}) {
    core_ = std::make_unique<Core>(CoreId::a, image_.cores[0], parameters_, 1, *memory_, *this);
    if (sink_) {
      core_->trace(sink_);
    }
    before();
    core_->start(0, how);
    while (!core_->sleeping()) {
      core_->run({});
    }
    core_->end_trace();
    return core_->profile().cycles;
  }
  // The next run is traced.
  void trace(TraceSink sink) { sink_ = std::move(sink); }
  Cycles evaluate(std::uint64_t max_packets = 1'000'000) {
    evaluator_ = std::make_unique<Evaluator>(0, image_.cores[0], parameters_, *memory_);
    if (!evaluator_->run(max_packets)) {
      throw std::runtime_error("the program did not reach IDLE");
    }
    return evaluator_->cycles();
  }

  [[nodiscard]] Core& core() { return *core_; }
  [[nodiscard]] const Evaluator& evaluator() const { return *evaluator_; }
  [[nodiscard]] std::uint32_t reg(isa::Register reg) { return core_->state().reg[reg]; }
  [[nodiscard]] CoreParameters& parameters() { return parameters_; }
  void set(std::string_view name, double value) {
    for (ParameterBase* parameter : parameters_.parameters()) {
      if (parameter->declaration().name == name) {
        parameter->set(value);
        return;
      }
    }
    throw std::runtime_error("no such parameter");
  }
  [[nodiscard]] memory::MemorySystem& memory() { return *memory_; }
  [[nodiscard]] const ir::Image& image() const { return image_; }

  Read device_read(int, Address, int, Cycles) override { return {}; }
  Cycles device_write(int, Address, int, std::uint32_t, Cycles) override { return 0; }
  [[nodiscard]] Cycles device_writes_drained_at(int) const override { return 0; }
  void print(int, std::string_view text) override { printed_ += text; }
  void halt(int, std::uint32_t status, const std::string& why, Cycles) override {
    exit_status_ = status;
    why_ = why;
  }
  HostCall host_call(int, isa::ExecutionState&, Cycles) override { return HostCall::none; }

  // What the program printed, and how it ended itself.
  [[nodiscard]] const std::string& printed() const { return printed_; }
  [[nodiscard]] std::optional<std::uint32_t> exit_status() const { return exit_status_; }
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  TraceSink sink_;
  std::string printed_;
  std::optional<std::uint32_t> exit_status_;
  std::string why_;
  CoreParameters parameters_;
  memory::MemoryParameters memory_parameters_;
  memory::ClockParameters clock_;
  ir::Image image_;
  std::unique_ptr<memory::MemorySystem> memory_;
  std::unique_ptr<Core> core_;
  std::unique_ptr<Evaluator> evaluator_;
};

// `body` as the whole of _start, and its cycles without the closing IDLE.
[[nodiscard]] inline std::string program(const std::string& body, const std::string& data = "") {
  return ".text\n.global _start\n.type _start, @function\n_start:\n" + body +
         "\nIDLE;\nRTS;\n.size _start, .-_start\n" + data;
}

}  // namespace finback::core
