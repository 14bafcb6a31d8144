// What a program asks of its host by EXCPT 0, on a whole machine; debug output; how programs begin
// and end; the core timer as an event that wakes.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/program_host.hpp>

namespace finback::machine {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Calls number R7 with the words at _block; the program ends with the low byte of R0, plus 100 when
// there was an error.
constexpr const char* kCall =
    ".type _call, @function\n_call: R0.L = _block; R0.H = _block; P0 = R7; EXCPT 0; RTS;\n"
    ".size _call, .-_call\n"
    ".type _exit, @function\n_exit: P1.L = _block; P1.H = _block; [P1] = R0; R0 = P1; P0 = 1; "
    "EXCPT "
    "0; RTS;\n.size _exit, .-_exit\n";

std::string program(const std::string& body, const std::string& block) {
  return ".text\n.global _start\n.type _start, @function\n_start:\n" + body +
         "\nIDLE;\nRTS;\n.size _start, .-_start\n" + kCall +
         ".data\n.align 4\n.type _block, @object\n_block: .byte4 " + block +
         "\n.size _block, 16\n.type _text, @object\n_text: .ascii \"hello\\0\\0\\0\"\n"
         ".size _text, 8\n.type _name, @object\n_name: .ascii \"notes\\0\\0\\0\"\n.size _name, 8\n"
         ".type _out, @object\n_out: .ascii \"../away\\0\"\n.size _out, 8\n"
         ".type _room, @object\n_room: .space 64\n.size _room, 64\n";
}

class ProgramHostTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "files");
  }
  void TearDown() override { fs::remove_all(folder_); }

  StopInfo run(const std::string& text, Begin begin = Begin::program) {
    ir::Program units = ir::parse(".bir 1\n" + text, "test.bir");
    ir::verify(units);
    const ir::Firmware firmware = ir::bare_firmware(std::move(units));
    image_ = ir::link(firmware.units, firmware.placement, description_.map);
    machine_ = std::make_unique<Machine>(description_, image_, begin);
    ProgramHostOptions options;
    options.arguments = {"prog", "first"};
    options.folder = files_allowed_ ? (folder_ / "files").string() : "";
    options.output = [this](int stream, std::string_view bytes) {
      (stream == 2 ? errors_ : output_) += bytes;
    };
    options.input = [](std::span<std::uint8_t> bytes) {
      const std::size_t count = std::min<std::size_t>(bytes.size(), 3);
      std::memcpy(bytes.data(), "in\n", count);
      return count;
    };
    machine_->serve_programs(std::move(options));
    return machine_->run({.cycles = 100'000'000, .cancelled = {}});
  }
  std::uint32_t reg(isa::Register number) const { return machine_->state(CoreId::a).reg[number]; }

  fs::path folder_;
  bool files_allowed_ = true;
  MachineDescription description_;
  ir::Image image_;
  std::unique_ptr<Machine> machine_;
  std::string output_;
  std::string errors_;
};

TEST_F(ProgramHostTest, WritesAndExitsWithAStatus) {
  const StopInfo stop = run(program("R7 = 5; CALL _call; R0 += 2; CALL _exit;", "2, _text, 5, 0"));
  EXPECT_EQ(stop.reason, Stop::exited);
  EXPECT_EQ(stop.exit_status, 7U);
  EXPECT_EQ(errors_, "hello");
}

TEST_F(ProgramHostTest, ReadsItsInput) {
  run(program("R7 = 4; CALL _call; R6 = R0; R0 = 0; CALL _exit;", "0, _room, 64, 0"));
  EXPECT_EQ(reg(isa::R6), 3U);
}

TEST_F(ProgramHostTest, OpensFilesBelowItsFolder) {
  // O_WRONLY | O_CREAT
  run(
      program("R7 = 2; CALL _call; R6 = R0; P1.L = _block; P1.H = _block; [P1] = R0; R1.L = _text;"
              "R1.H = _text; [P1 + 4] = R1; R1 = 5; [P1 + 8] = R1; R7 = 5; CALL _call; R5 = R0;"
              "R7 = 3; CALL _call; R0 = 0; CALL _exit;",
              "_name, 0x201, 0x1B4, 0"));
  EXPECT_EQ(reg(isa::R6), 3U);
  EXPECT_EQ(reg(isa::R5), 5U);
  std::ifstream file(folder_ / "files" / "notes");
  std::string text;
  file >> text;
  EXPECT_EQ(text, "hello");
}

struct Refusal {
  const char* name;
  int number;
  const char* block;
  bool files;
  std::uint32_t error;  // newlib's errno
};
class Refusals : public ProgramHostTest, public testing::WithParamInterface<Refusal> {};

TEST_P(Refusals, AnswerWithAnError) {
  files_allowed_ = GetParam().files;
  run(program("R7 = " + std::to_string(GetParam().number) +
                  "; CALL _call; R6 = R0; R5 = R2; R0 = 0; CALL _exit;",
              GetParam().block));
  EXPECT_EQ(reg(isa::R6), 0xFFFFFFFFU);
  EXPECT_EQ(reg(isa::R5), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Calls, Refusals,
    testing::Values(Refusal{"no_folder", 2, "_name, 0, 0, 0", false, 13},
                    Refusal{"outside_the_folder", 2, "_out, 0x201, 0, 0", true, 13},
                    Refusal{"no_such_file", 2, "_name, 0, 0, 0", true, 2},
                    Refusal{"file_not_open", 4, "7, _room, 4, 0", true, 9},
                    Refusal{"address_outside_memory", 5, "1, 0x30000000, 4, 0", true, 14},
                    Refusal{"no_such_argument", 24, "2, _room, 0, 0", true, 22},
                    Refusal{"unknown_call", 99, "0, 0, 0, 0", true, 88}),
    [](const auto& item) { return std::string(item.param.name); });

TEST_F(ProgramHostTest, TellsArgumentsAndTime) {
  run(
      program("R7 = 22; CALL _call; R6 = R0; P1.L = _block; P1.H = _block; R1 = 1; [P1] = R1;"
              "R7 = 23; CALL _call; R5 = R0; R1.L = _room; R1.H = _room; [P1 + 4] = R1; R7 = 24;"
              "CALL _call; P2.L = _room; P2.H = _room; R4 = [P2]; R7 = 18; CALL _call; R3 = R0;"
              "R0 = 0; CALL _exit;",
              "0, 0, 0, 0"));
  EXPECT_EQ(reg(isa::R6), 2U);
  EXPECT_EQ(reg(isa::R5), 5U);           // "first"
  EXPECT_EQ(reg(isa::R4), 0x73726966U);  // "firs"
  EXPECT_EQ(reg(isa::R3), 0U);           // no second has passed
}

TEST_F(ProgramHostTest, DebugOutputGoesToTheProgramsOutput) {
  const StopInfo stop = run(program("OUTC 72; R1 = 3; DBG R1; DBGA (R1.L, 4);", "0, 0, 0, 0"));
  EXPECT_EQ(output_, "HDBG : R1 = 0x00000003\n");
  EXPECT_EQ(stop.reason, Stop::exited);
  EXPECT_EQ(stop.exit_status, 1U);
  EXPECT_THAT(stop.message, HasSubstr("R1.L is 0x0003, expected 0x0004"));
}

TEST_F(ProgramHostTest, ExceptionWithoutHandlerIsAFault) {
  EXPECT_THAT([&] { run(program("EXCPT 3;", "0, 0, 0, 0")); },
              ThrowsMessage<GuestFault>(HasSubstr("EXCPT 3, but EVT3 is 0")));
}

// After reset interrupts are held back until RTI, and exceptions are double faults.
TEST_F(ProgramHostTest, ResetBeginsAtLevelOne) {
  run(program("P1.L = 0x2108; P1.H = 0xFFE0; R6 = [P1]; R5 = SYSCFG; R0 = 0; CALL _exit;",
              "0, 0, 0, 0"),
      Begin::reset);
  EXPECT_EQ(reg(isa::R6), 0x12U);
  EXPECT_EQ(reg(isa::R5), 0x30U);
  EXPECT_THAT(
      [&] {
        run(program("P1.L = 0x200C; P1.H = 0xFFE0; R1 = 2; [P1] = R1; P2 = 1; R1 = [P2];",
                    "0, 0, 0, 0"),
            Begin::reset);
      },
      ThrowsMessage<GuestFault>(HasSubstr("double fault")));
}

// The timer wakes a core that sleeps, at its time; masked it does not.
TEST_F(ProgramHostTest, TimerEndsSleep) {
  const std::string start =
      "P1.L = 0x3000; P1.H = 0xFFE0; R1 = 1; [P1] = R1; R1 = 1000 (X); [P1 + 4] = R1; R1 = 4;"
      "[P1 + 8] = R1; R1 = 3; [P1] = R1; R6 = CYCLES; ";
  const std::string handler =
      "P2.L = 0x2018; P2.H = 0xFFE0; R1.L = _tick; R1.H = _tick; [P2] = R1; ";
  const std::string tick =
      ".type _tick, @function\n_tick: R5 = CYCLES; RTI;\n.size _tick, .-_tick\n";
  const StopInfo stop =
      run(program(handler + "R1 = 64 (X); STI R1; " + start + "IDLE; R0 = 9; CALL _exit;",
                  "0, 0, 0, 0") +
          ".text\n" + tick);
  EXPECT_EQ(stop.exit_status, 9U);
  // 5 x 1000 cycles from the timer's start, waking and entry
  EXPECT_GE(reg(isa::R5) - reg(isa::R6), 5000U);
  EXPECT_LT(reg(isa::R5) - reg(isa::R6), 5040U);
  EXPECT_EQ(run(program(start + "IDLE;", "0, 0, 0, 0")).reason, Stop::deadlock);
}

}  // namespace
}  // namespace finback::machine
