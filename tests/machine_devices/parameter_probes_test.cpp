// Parameters of devices and clocks by programs that show them, and the list: each parameter of the
// machine is named by a test.
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <map>
#include <regex>
#include <sstream>

#include "guest_program.hpp"
#include <common/error.hpp>
#include <isa_sim/machine/peripherals.hpp>

namespace finback::machine {
namespace {

namespace fs = std::filesystem;

class ParameterProbes : public GuestProgramTest {
 protected:
  // When the program ends, with two characters for the UART and a grey camera at PPI0.
  Cycles time_of(const std::string& body) {
    load(body + "HLT;");
    machine_->peripherals().uart().set_input({'A', 'B'});
    machine_->peripherals().connect_camera(
        peripheral::Camera::Side::left,
        [](std::uint32_t) {
          static const auto kPicture = std::make_shared<const peripheral::Picture>(
              peripheral::Picture{160, 120, std::vector<std::uint8_t>(160 * 120, 128)});
          return kPicture;
        },
        {});
    const StopInfo stop = machine_->run({.cycles = 20'000'000, .cancelled = {}});
    EXPECT_EQ(stop.reason, Stop::exited) << stop.message;
    return stop.time;
  }
};

const std::string kTimer = store(0xFFC00600, 0x11, 2) + store(0xFFC0060C, 500) +
                           store(0xFFC0011C, 0) + store(0xFFC00120, 1U << 3) +
                           store(0xFFC00680, 1, 2) + "IDLE;\n";
// 8N1, divisor 1; a character, then the other one.
const std::string kTwoCharacters =
    store(0xFFC0040C, 0x83, 2) + store(0xFFC00400, 1, 2) + store(0xFFC0040C, 3, 2) +
    store(0xFFC0011C, 1U << 28) + store(0xFFC00120, 0) + store(0xFFC00404, 1, 2) +
    store(0xFFC00424, 1, 2) + "P0.L = 0x0400; P0.H = 0xFFC0;\nIDLE; R0 = W[P0] (Z); IDLE;\n";
// A QQVGA frame's luma.
const std::string kCapture = store(0xFFC01C04, 0x100000) + store(0xFFC01C10, 80, 2) +
                             store(0xFFC01C14, 2, 2) + store(0xFFC01C18, 120, 2) +
                             store(0xFFC01C1C, 2, 2) + store(0xFFC01C08, 0x97, 2) +
                             store(0xFFC01008, 319, 2) + store(0xFFC0100C, 0, 2) +
                             store(0xFFC01010, 120, 2) + store(0xFFC01000, 0x2AD, 2) + "IDLE;\n";

TEST_F(ParameterProbes, EachShowsInItsProgram) {
  const std::string mask = "P0.L = 0x010C; P0.H = 0xFFC0;\n";
  struct Probe {
    const char* parameter;
    double value;
    std::int64_t change;
    std::string program;
  };
  const std::vector<Probe> probes = {
      {"devices.read_sclk", 5, 5, mask + "R0 = [P0];\n"},
      {"devices.write_sclk", 3, 5, mask + "[P0] = R0; [P0] = R0;\n"},
      {"devices.core_register_cycles", 2, 1, "P0.L = 0x2104; P0.H = 0xFFE0; R0 = [P0];\n"},
      {"timer.start_sclk", 4, 5, kTimer},
      {"uart.input_gap_sclk", 10, 2 * 50, kTwoCharacters},
      {"ppi.burst_bytes", 16, -40, kCapture},  // the last burst has 8 elements less
      {"camera.line_pixels", 800, -192, kCapture},
  };
  description_.camera.halvings.set(2);
  description_.camera.frame_rate.set(100);
  for (const Probe& probe : probes) {
    const double usual = description_.get(probe.parameter);
    const Cycles before = time_of(probe.program);
    description_.set(probe.parameter, probe.value);
    EXPECT_EQ(static_cast<std::int64_t>(time_of(probe.program) - before), probe.change)
        << probe.parameter;
    description_.set(probe.parameter, usual);
  }
}

TEST_F(ParameterProbes, LimitsRefuseWhatIsBeyondThem) {
  struct Probe {
    const char* parameter;
    double value;  // that bears what the default does not
    std::string program;
  };
  const std::vector<Probe> probes = {
      {"clock.vco_minimum_mhz", 20, store(kPllCtl, 1U << 9, 2)},
      {"clock.vco_maximum_mhz", 650, store(kPllDiv, 0x16, 2) + store(kPllCtl, 25U << 9, 2)},
      {"clock.sclk_limit_mhz", 160, store(kPllDiv, 0x14, 2)},
      {"clock.sclk_limit_low_mhz", 130, store(kPllDiv, 0x15, 2) + store(kVrCtl, 0x00BB, 2)},
      {"ppi.clock_share", 0.5, kCapture},
  };
  for (const Probe& probe : probes) {
    const double usual = description_.get(probe.parameter);
    const bool camera = probe.program == kCapture;
    description_.set(probe.parameter, camera ? 0.01 : usual);
    description_.camera.halvings.set(2);
    description_.camera.frame_rate.set(100);
    EXPECT_THROW(time_of(probe.program), GuestFault) << probe.parameter;
    description_.set(probe.parameter, probe.value);
    EXPECT_NO_THROW(time_of(probe.program)) << probe.parameter;
    description_.set(probe.parameter, usual);
  }
}

TEST_F(ParameterProbes, TheSeedChoosesTheChances) {
  description_.camera.halvings.set(2);
  description_.camera.frame_rate.set(100);
  description_.set("camera.jitter_us", 500);
  const Cycles before = time_of(kCapture);
  EXPECT_EQ(time_of(kCapture), before);
  description_.set("camera.seed", description_.get("camera.seed") + 1);
  EXPECT_NE(time_of(kCapture), before);
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// A test names a parameter as machine files do, or by its member.
TEST(ParameterList, EveryParameterIsInATest) {
  const fs::path source = FINBACK_SOURCE_DIR;
  std::map<std::string, std::string> members;
  const std::regex declaration(R"(Parameter\s+(\w+)\s*\{\s*this,\s*\{\s*\"([\w.]+)\")");
  for (const char* room : {"clock_model", "memory_model", "dma_model", "peripheral_model",
                           "isa_sim/machine", "isa_sim/core"}) {
    for (const auto& entry : fs::directory_iterator(source / room)) {
      if (entry.path().filename().string().ends_with("parameters.hpp")) {
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at) {
          members[(*at)[2]] = (*at)[1];
        }
      }
    }
  }
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(source / "tests")) {
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") {
      tests += text_of(entry.path());
    }
  }
  const MachineDescription description;
  for (const ParameterBase* parameter : description.parameters()) {
    const std::string name(parameter->declaration().name);
    ASSERT_TRUE(members.contains(name)) << name;
    EXPECT_TRUE(tests.find(name) != std::string::npos ||
                tests.find("." + members[name]) != std::string::npos)
        << "no test names " << name << " or " << members[name];
  }
}

}  // namespace
}  // namespace finback::machine
