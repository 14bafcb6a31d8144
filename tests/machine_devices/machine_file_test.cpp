// Machine files: the BF561's, and what is wrong with others.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

#include <common/error.hpp>
#include <common/file.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/registers_page.hpp>

namespace finback::machine {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path kSource = FINBACK_SOURCE_DIR;

TEST(MachineFile, Bf561IsTheDefaultMachine) {
  const auto loaded = load_machine(kSource / "machines" / "bf561.toml");
  const MachineDescription defaults;
  EXPECT_EQ(loaded->name, defaults.name);
  const auto values = std::as_const(*loaded).parameters();
  const auto wanted = defaults.parameters();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(values[i]->value(), wanted[i]->value()) << wanted[i]->declaration().name;
  }
  ASSERT_EQ(loaded->map.regions.size(), defaults.map.regions.size());
  for (std::size_t i = 0; i < defaults.map.regions.size(); ++i) {
    const memory::Region& region = loaded->map.regions[i];
    const memory::Region& other = defaults.map.regions[i];
    EXPECT_EQ(region.name, other.name);
    EXPECT_EQ(region.base, other.base) << region.name;
    EXPECT_EQ(region.size, other.size) << region.name;
    EXPECT_EQ(region.level, other.level) << region.name;
    EXPECT_EQ(region.core, other.core) << region.name;
    EXPECT_EQ(region.code, other.code) << region.name;
    EXPECT_EQ(region.data, other.data) << region.name;
    EXPECT_EQ(region.dma_reachable, other.dma_reachable) << region.name;
  }
}

TEST(MachineFile, TheManualsPageOfParametersIsTheGeneratedOne) {
  std::istringstream page(read_text_file(kSource / "docs" / "machine-parameters.md"));
  std::istringstream generated(parameters_as_markdown());
  std::string line;
  std::string wanted;
  while (std::getline(generated, wanted)) {
    ASSERT_TRUE(std::getline(page, line)) << "the page ends before: " << wanted;
    ASSERT_EQ(line, wanted) << "write it anew: finback machine > docs/machine-parameters.md";
  }
  EXPECT_FALSE(std::getline(page, line)) << line;
}

TEST(MachineFile, TheManualsPageOfRegistersIsTheGeneratedOne) {
  EXPECT_EQ(read_text_file(kSource / "docs" / "registers.md"), registers_as_markdown())
      << "write it anew: finback machine --registers > docs/registers.md";
}

TEST(MachineFile, EveryParameterCanBeSetByFileAndByName) {
  const MachineDescription defaults;
  for (const ParameterBase* parameter : defaults.parameters()) {
    const ParameterDeclaration& d = parameter->declaration();
    if (d.name.starts_with("clock.")) {
      continue;  // go together: the ratio is whole
    }
    const std::string name(d.name);
    const auto dot = name.rfind('.');
    const auto machine = parse_machine("[" + name.substr(0, dot) + "]\n" + name.substr(dot + 1) +
                                           " = " + std::to_string(d.maximum) + "\n",
                                       "m.toml");
    EXPECT_EQ(machine->get(name), d.maximum) << name;
    MachineDescription other;
    other.set(name, d.minimum);
    EXPECT_EQ(other.clone()->get(name), d.minimum) << name;
  }
}

TEST(MachineFile, NamesOfParametersAreUnique) {
  std::vector<std::string_view> names;
  const MachineDescription defaults;
  for (const ParameterBase* parameter : defaults.parameters()) {
    names.push_back(parameter->declaration().name);
    EXPECT_FALSE(parameter->declaration().source.empty()) << names.back();
    EXPECT_FALSE(parameter->declaration().meaning.empty()) << names.back();
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(MachineFile, UnknownParameterNamesTheNearest) {
  MachineDescription machine;
  EXPECT_THAT([&] { machine.set("memory.l2.read_cicles", 1); },
              ThrowsMessage<InputError>("unknown machine parameter memory.l2.read_cicles, did you "
                                        "mean memory.l2.read_cycles"));
}

struct WrongFile {
  const char* name;
  const char* text;
  const char* message;
};

class MachineFileError : public testing::TestWithParam<WrongFile> {};

TEST_P(MachineFileError, NamesPlaceAndMend) {
  EXPECT_THAT([] { static_cast<void>(parse_machine(GetParam().text, "m.toml")); },
              ThrowsMessage<InputError>(HasSubstr(GetParam().message)));
}

constexpr const char* kRegion =
    "[[region]]\nname = \"l2\"\nbase = 0xFEB00000\nsize = 0x20000\nlevel = \"l2\"\n";

INSTANTIATE_TEST_SUITE_P(
    All, MachineFileError,
    testing::Values(
        WrongFile{"syntax", "[memory\n", "m.toml:1:"},
        WrongFile{"unknown_key", "[memory.l2]\n\nread_cicles = 9\n",
                  "m.toml:3:1: unknown key memory.l2.read_cicles, did you mean "
                  "memory.l2.read_cycles"},
        WrongFile{"unknown_at_top", "colour = 1\n", "m.toml:1:1: unknown key colour"},
        WrongFile{"text", "[memory.l2]\nread_cycles = \"nine\"\n",
                  "m.toml:2:15: memory.l2.read_cycles wants a number of CCLK"},
        WrongFile{"range", "[memory.l2]\nread_cycles = 900\n",
                  "m.toml:2:15: memory.l2.read_cycles = 900 is out of range: it takes 1 to 64"},
        WrongFile{"fraction", "[memory.l2]\nread_cycles = 9.5\n",
                  "m.toml:2:15: memory.l2.read_cycles = 9.5 has a fraction"},
        WrongFile{"ratio", "[clock]\nsclk_mhz = 133\n", "m.toml: clock.cclk_mhz = 600 over"},
        WrongFile{"name", "name = 7\n", "m.toml:1:8: name wants a text in quotes"},
        WrongFile{"region_table", "[region]\nname = \"l2\"\n",
                  "m.toml:1:1: region wants [[region]]"},
        WrongFile{"region_key", "[[region]]\nnome = \"l2\"\n",
                  "m.toml:2:1: unknown key of a region: nome, did you mean name"},
        WrongFile{"region_lacks", "[[region]]\nname = \"l2\"\n", "m.toml:1:1: a region needs base"},
        WrongFile{"region_size", "[[region]]\nname = \"l2\"\nbase = 0\nsize = 6\n",
                  "m.toml:4:8: region.size wants a multiple of 4 from 4"},
        WrongFile{"region_level", "[[region]]\nname = \"l2\"\nbase = 0\nsize = 8\nlevel = \"l4\"\n",
                  "m.toml:5:9: region.level = \"l4\": it is \"l1\", \"l2\" or \"l3\""},
        WrongFile{"region_core", "[[region]]\nname = \"x\"\nbase = 0\nsize = 8\nlevel = \"l1\"\n",
                  "region x: an l1 region needs core"},
        WrongFile{"region_core_name",
                  "[[region]]\nname = \"x\"\nbase = 0\nsize = 8\nlevel = \"l1\"\ncore = \"c\"\n",
                  "m.toml:6:8: region.core = \"c\": it is \"core_a\" or \"core_b\""},
        WrongFile{"region_device",
                  "[[region]]\nname = \"x\"\nbase = 0xFFBFFFFC\nsize = 8\nlevel = \"l3\"\n",
                  "region x reaches into the device registers"},
        WrongFile{"region_flag",
                  "[[region]]\nname = \"x\"\nbase = 0\nsize = 8\nlevel = \"l3\"\ncode = 1\n",
                  "m.toml:6:8: region.code wants true or false"}),
    [](const testing::TestParamInfo<WrongFile>& wrong) { return wrong.param.name; });

TEST(MachineFile, RegionsThatOverlapOrRepeatAreErrors) {
  const std::string region = kRegion;
  EXPECT_THAT([&] { static_cast<void>(parse_machine(region + region, "m.toml")); },
              ThrowsMessage<InputError>(
                  HasSubstr("m.toml:6:1: region l2 at 0xfeb00000 overlaps l2 at 0xfeb00000")));
  std::string second = region;
  second.replace(second.find("FEB"), 3, "FEC");
  EXPECT_THAT([&] { static_cast<void>(parse_machine(region + second, "m.toml")); },
              ThrowsMessage<InputError>(HasSubstr("two regions l2")));
  second.replace(second.find("\"l2\""), 4, "\"l9\"");
  EXPECT_THAT([&] { static_cast<void>(parse_machine(region + second, "m.toml")); },
              ThrowsMessage<InputError>(HasSubstr("regions l2 and l9 are both l2")));
}

TEST(MachineFile, OneRegionReplacesTheWholeMap) {
  EXPECT_EQ(parse_machine(kRegion, "m.toml")->map.regions.size(), 1U);
  EXPECT_GT(parse_machine("", "m.toml")->map.regions.size(), 1U);
}

TEST(MachineFile, AMissingFileIsNamed) {
  EXPECT_THAT([] { static_cast<void>(load_machine("/nowhere/m.toml")); },
              ThrowsMessage<InputError>(HasSubstr("/nowhere/m.toml")));
}

std::uint32_t size_of(const MachineDescription& machine, int core, const char* name) {
  const memory::Region* region = machine.map.find(core, name);
  return region == nullptr ? 0 : region->size;
}

TEST(MachineMap, ChangesRegionsOfBothCoresOrOne) {
  const auto machine = parse_machine(
      "[map]\n\"l1.data.a\" = { size = 0x4000 }\n\"core_b.l1.code\" = { size = 0x2000, data = true "
      "}\n"
      "l2 = { base = 0xFEA00000, size = 0x40000 }\n",
      "m.toml");
  EXPECT_EQ(size_of(*machine, 0, "l1.data.a"), 0x4000U);
  EXPECT_EQ(size_of(*machine, 1, "l1.data.a"), 0x4000U);
  EXPECT_EQ(size_of(*machine, 0, "l1.code"), 0x4000U);
  EXPECT_EQ(size_of(*machine, 1, "l1.code"), 0x2000U);
  EXPECT_TRUE(machine->map.find(1, "l1.code")->data);
  EXPECT_EQ(machine->map.find(0xFEA00000)->size, 0x40000U);
  EXPECT_EQ(machine->map.find(0xFEB00000), nullptr);
}

TEST(MachineMap, TakesRegionsAwayAndACoreWithAllOfIts) {
  const auto machine = parse_machine("[map]\ncore_b = false\nl2 = false\n", "m.toml");
  EXPECT_EQ(machine->map.regions.size(), 7U);
  EXPECT_EQ(machine->map.find(1, "l1.code"), nullptr);
  EXPECT_EQ(machine->map.find(0, "l2"), nullptr);
}

TEST(MachineMap, SaysWhatIsWrong) {
  const auto error = [](const std::string& text) {
    try {
      static_cast<void>(parse_machine(text, "m.toml"));
      return std::string();
    } catch (const InputError& problem) {
      return std::string(problem.what());
    }
  };
  EXPECT_EQ(error("[map]\nl4 = false"), "m.toml:2:1: unknown region l4, did you mean l3");
  EXPECT_EQ(error("[map]\nl2 = true"),
            "m.toml:2:6: map.l2 wants { size = ... }, or false for a machine without it");
  EXPECT_EQ(error("[map]\nl2 = { sise = 4 }"),
            "m.toml:2:8: unknown key of a region: sise, did you mean size");
  EXPECT_EQ(error("[map]\nl2 = { size = 0x20000000 }"),
            "m.toml:2:6: region l2 reaches into the device registers at 0xffc00000");
  EXPECT_EQ(error("[map]\nl2 = { size = 0xA00000 }"),
            "m.toml:1:1: region l1.data.a at 0xff400000 overlaps l2 at 0xfeb00000");
  EXPECT_EQ(
      error("[map]\nl2 = false\n[[region]]\nname = \"l3\"\nbase = 0\nsize = 64\nlevel = \"l3\""),
      "m.toml:1:1: [map] changes the BF561's map, [[region]] replaces it: one of the two");
  EXPECT_EQ(error("[map]\nflash = { size = 0x8000000 }"),
            "m.toml:2:9: region flash is not all of one kind: from 0x20000000 to 0x2fffffff lie "
            "four banks of asynchronous memory, 64 MB each");
  EXPECT_EQ(error("[map]\nflash = { base = 0x28000000, read_only = false }"), "");
  EXPECT_EQ(error("map = 3"),
            "m.toml:1:7: map wants a table [map] of regions and what changes in them");
}

TEST(MachineFiles, OfTheRepositoryAreAllReadable) {
  int machines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "machines")) {
    if (entry.path().extension() == ".toml") {
      EXPECT_EQ(load_machine(entry.path())->name, entry.path().stem().string());
      ++machines;
    }
  }
  EXPECT_GE(machines, 4);
}

}  // namespace
}  // namespace finback::machine
