// Manifests, and bare programs with a start-up of our own.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/ir/support.hpp>
#include <unistd.h>

#include <common/file.hpp>
#include <isa_sim/ir/linker.hpp>

namespace finback::ir {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, gone afterwards.
class FirmwareFolder : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              (std::string("finback_firmware_test_") + std::to_string(::getpid()) + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) {
    write_file_whole(folder_ / name, text);
    return folder_ / name;
  }
  std::string load_error(const std::string& manifest) {
    const fs::path path = write("firmware.toml", manifest);
    std::string error = error_of([&] { (void)load_firmware(path); });
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = error.find(prefix); at != std::string::npos; at = error.find(prefix)) {
      error.erase(at, prefix.size());
    }
    return error;
  }

  fs::path folder_;
};

const std::string kMain = std::string(".bir 1\n") + kStart + "RTS;\n";

TEST_F(FirmwareFolder, ReadsAManifest) {
  write("a.bir", kMain);
  write("s.bir", ".bir 1\n.comm _x, 4\n");
  write("p.toml", "[shared.objects]\nx = \"l3\"\n");
  const Firmware firmware = load_firmware(write("firmware.toml", R"(name = "demo"
placement = "p.toml"
[core_a]
units = ["a.bir"]
[core_b]
units = ["a.bir"]
entry = "_start"
[shared]
units = ["s.bir"]
[stages]
"z first" = { core = "b", function = "start" }
"a second" = { core = "a", function = "start" }
)"));
  EXPECT_EQ(firmware.units.name, "demo");
  EXPECT_TRUE(firmware.units.cores[1].present);
  EXPECT_EQ(firmware.units.cores[0].units[0], firmware.units.cores[1].units[0]) << "read once";
  ASSERT_EQ(firmware.units.stages.size(), 2u);
  EXPECT_EQ(firmware.units.stages[0].name, "z first");
  EXPECT_EQ(firmware.units.stages[0].core, Owner::core_b);
  const Image image = link(firmware.units, firmware.placement, memory::bf561_map());
  EXPECT_EQ(image.cores[1].entry, 0xFF600000u);
  EXPECT_EQ(image.objects.back().name, "x");
  EXPECT_EQ(image.objects.back().region, "l3");
}

TEST_F(FirmwareFolder, SaysWhatIsWrongWithAManifest) {
  write("a.bir", kMain);
  EXPECT_EQ(load_error("[core_a]\nunit = [\"a.bir\"]"),
            "firmware.toml:2:8: unknown key 'unit' in core_a; did you mean 'units'?");
  EXPECT_EQ(load_error("[core_a]"), "firmware.toml:1:1: core_a wants units = [\"a.bir\", ...]");
  EXPECT_EQ(load_error("[core_a]\nunits = [\"b.bir\"]"),
            "firmware.toml:2:9: unit b.bir is not there");
  EXPECT_EQ(load_error("[core_a]\nunits = [\"a.bir\", \"a.bir\"]"),
            "firmware.toml:2:9: core_a names a.bir twice");
  EXPECT_EQ(load_error("[core_b]\nunits = [\"a.bir\"]"),
            "firmware.toml: a firmware has a section [core_a]: that core starts first");
  EXPECT_EQ(load_error("[core_a]\nunits = [\"a.bir\"]\n[stages]\nx = { core = \"c\", function = "
                       "\"f\" }"),
            "firmware.toml:4:5: a stage names its core (\"a\" or \"b\") and its function");
  EXPECT_EQ(load_error("[core_a]\nunits = [\"a.bir\"]\n[stages]\nx = 1"),
            "firmware.toml:4:5: a stage is { core = \"a\", function = \"name\" }");
  EXPECT_EQ(load_error("placement = 3\n[core_a]\nunits = [\"a.bir\"]"),
            "firmware.toml:1:13: 'placement' is a string between quotes");
  EXPECT_EQ(load_error("placement = \"no.toml\"\n[core_a]\nunits = [\"a.bir\"]"),
            "no.toml: cannot be read: No such file or directory");
  write("s.bir", ".bir 1\n.data\n.type _x, @object\n_x: .long 0\n.size _x, 4\n");
  EXPECT_EQ(
      load_error("[core_a]\nunits = [\"a.bir\"]\n[shared]\nunits = [\"s.bir\"]\nflags = [\"y\"]"),
      "firmware.toml:5:9: flags: no shared unit has an object y");
  write("bad.bir", ".bir 1\n.type _f, @function\n_f: NOP;\n");
  EXPECT_EQ(load_error("[core_a]\nunits = [\"bad.bir\"]"),
            "bad.bir:3:5: _f runs on past its last instruction: end it with RTS or a jump");
}

TEST_F(FirmwareFolder, FilesGoIntoFlash) {
  write("a.bir", ".bir 1\n" + std::string(kStart) + "P0.L = _tables; P0.H = _tables; RTS;\n");
  write("t.bin", "abcdefg");
  write("u.bin", "xyz");
  Firmware firmware = load_firmware(write("firmware.toml", R"([core_a]
units = ["a.bir"]
[flash]
tables = { file = "t.bin" }
fixed = { file = "u.bin", at = 0x20000100 }
)"));
  const auto linked = [&](const std::string& name) {
    const Image image = link(firmware.units, firmware.placement, memory::bf561_map());
    return *std::ranges::find(image.objects, name, &PlacedObject::name);
  };
  EXPECT_EQ(linked("fixed").address, 0x20000100U);
  EXPECT_EQ(linked("tables").address, 0x20000104U) << "behind what has its place";
  EXPECT_EQ(linked("tables").region, "flash");
  EXPECT_EQ(linked("tables").size, 7U);
  EXPECT_EQ(linked("tables").initial,
            (std::vector<std::uint8_t>{'a', 'b', 'c', 'd', 'e', 'f', 'g'}));
  add_flash(firmware.units, "tables", folder_ / "u.bin", std::nullopt, {"(test)"});
  EXPECT_EQ(linked("tables").size, 3U) << "replaced";
  firmware.placement.override_object(Owner::shared, "tables", "l2");
  EXPECT_EQ(linked("tables").region, "l2");
  add_flash(firmware.units, "other", folder_ / "u.bin", 0x20000100, {"(test)"});
  EXPECT_EQ(error_of([&] { (void)linked("other"); }), "(test): other at 0x20000100 overlaps fixed");
  firmware.placement.override_object(Owner::shared, "fixed", "l3", {"(move)"});
  EXPECT_THAT(error_of([&] { (void)linked("fixed"); }),
              testing::MatchesRegex(".move.: fixed stands at 0x20000100, which .*firmware.toml:5:9 "
                                    "says: no placement moves it"));
}

TEST_F(FirmwareFolder, SaysWhatIsWrongWithFlash) {
  write("a.bir", kMain);
  write("empty.bin", "");
  const std::string core = "[core_a]\nunits = [\"a.bir\"]\n[flash]\n";
  EXPECT_EQ(load_error(core + "t = { file = \"no.bin\" }"),
            "firmware.toml:4:5: no.bin is not there");
  EXPECT_EQ(load_error(core + "t = { file = \"empty.bin\" }"),
            "firmware.toml:4:5: empty.bin is empty");
  EXPECT_EQ(load_error(core + "t = {}"), "firmware.toml:4:5: t wants file = \"tables.bin\"");
  EXPECT_EQ(load_error(core + "t = { file = \"a.bir\", at = 2 }"),
            "firmware.toml:4:28: 'at' is an address, a multiple of 4");
  EXPECT_EQ(load_error(core + "\"a b\" = { file = \"a.bir\" }"),
            "firmware.toml:4:9: [flash] holds NAME = { file = \"tables.bin\", at = 0x20000000 }, "
            "and NAME is one that C can say");
}

TEST_F(FirmwareFolder, BareProgramWithItsOwnStart) {
  const Firmware firmware = load_firmware(write("a.bir", kMain));
  EXPECT_EQ(firmware.units.name, "a");
  const Image image = link(firmware.units, firmware.placement, memory::bf561_map());
  EXPECT_EQ(image.cores[0].functions.size(), 1u);
}

TEST_F(FirmwareFolder, BareProgramWithMainGetsAStart) {
  const Firmware firmware =
      load_firmware(write("m.bir", ".bir 1\n.type _main, @function\n.global _main\n_main: RTS;\n"));
  const Image image = link(firmware.units, firmware.placement, memory::bf561_map());
  const CoreImage& core = image.cores[0];
  ASSERT_EQ(core.functions.size(), 2u);
  EXPECT_EQ(core.functions[0].name, "start");
  EXPECT_EQ(core.entry, core.functions[0].address);
  std::string text;
  for (std::size_t i = 0; i < core.functions[0].packet_count; ++i) {
    const PlacedInstruction& instruction = core.packets[i].slots[0];
    text += isa::disassemble(instruction.instruction, instruction.operand) + "\n";
  }
  EXPECT_THAT(text, testing::HasSubstr("CALL 0xffa0001a\nP0.L = 61472\nP0.H = 65472\n[P0] = R0\n"));
}

TEST_F(FirmwareFolder, BareProgramWithNeither) {
  const fs::path path = write("n.bir", ".bir 1\n.type _f, @function\n_f: RTS;\n");
  EXPECT_EQ(error_of([&] { (void)load_firmware(path); }),
            path.string() + ": has neither a function _start nor a function _main");
}

}  // namespace
}  // namespace finback::ir
