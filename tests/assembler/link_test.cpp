// Assembler files linked with others: symbols, functions, objects, placement.
#include <gmock/gmock.h>

#include "support.hpp"
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>

namespace finback::assembler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ir::Unit unit(const std::string& text, const std::string& file) {
  return std::make_shared<const ir::Program>(is_assembler_file(file) ? assemble(text, file)
                                                                     : ir::parse(text, file));
}

ir::Image linked(std::vector<ir::Unit> units, ir::Placement placement = ir::default_placement()) {
  ir::FirmwareUnits firmware;
  firmware.path = "firmware.toml";
  firmware.cores[0].present = true;
  firmware.cores[0].units = std::move(units);
  return ir::link(firmware, placement, memory::bf561_map());
}

std::string link_error(std::vector<ir::Unit> units) {
  try {
    (void)linked(std::move(units));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const ir::PlacedObject& object(const ir::Image& image, const std::string& name) {
  return *std::ranges::find(image.objects, name, &ir::PlacedObject::name);
}

TEST(Linked, FunctionsAndObjectsAreNamedByTheirLabels) {
  const ir::Image image =
      linked({unit(".global _start\n_start: NOP; .Lx: RTS;\n.long 7\nf: RTS;\n.byte 1, 2\nRTS;\n"
                   ".data\n.byte 9\n_one: .long 1\ntwo: .space 6\nnone:\n",
                   "boot.s")});
  std::vector<std::string> functions;
  for (const ir::PlacedFunction& function : image.cores[0].functions) {
    functions.push_back(function.name);
  }
  EXPECT_THAT(functions, ElementsAre("start", "f", "f+0x4"));
  std::vector<std::string> objects;
  for (const ir::PlacedObject& found : image.objects) {
    objects.push_back(found.name);
  }
  EXPECT_THAT(objects, testing::UnorderedElementsAre("stack", "boot.data", "one", "two",
                                                     "start+0x4", "f+0x2"));
  EXPECT_EQ(object(image, "two").address, object(image, "one").address + 4);
  EXPECT_EQ(object(image, "start+0x4").initial, std::vector<std::uint8_t>({7, 0, 0, 0}));
}

TEST(Linked, SymbolsAreSharedWithBir) {
  const ir::Image image = linked(
      {unit(".bir 1\n.global _start\n.type _start, @function\n_start:\n  CALL _f;\n  P0.L = SIZE;\n"
            "  P0.H = SIZE;\n  RTS;\n",
            "a.bir"),
       unit(".global _f, SIZE\nNOP; _f: RTS;\nSIZE = 0x12345678\n", "f.s")});
  const ir::PlacedPacket& call = image.cores[0].packets[0];
  const ir::PlacedFunction& f = image.cores[0].functions.back();
  EXPECT_EQ(f.name, "f");
  EXPECT_EQ(static_cast<Address>(call.slots[0].operand[0]), f.address);
  EXPECT_EQ(image.cores[0].packets[1].slots[0].operand[1], 0x5678);
  EXPECT_EQ(image.cores[0].packets[2].slots[0].operand[1], 0x1234);
}

TEST(Linked, TablesOfLabelsHoldTheirAddresses) {
  const ir::Image image =
      linked({unit("_start: NOP; a: RTS;\n.data\ntable: .long a, table + 4, a + 2\n", "a.s")});
  const Address start = image.cores[0].entry;
  const ir::PlacedObject& table = object(image, "table");
  const auto word = [&](std::size_t at) {
    Address value = 0;
    for (std::size_t i = 4; i-- > 0;) {
      value = value << 8 | table.initial[at + i];
    }
    return value;
  };
  EXPECT_EQ(word(0), start + 2);
  EXPECT_EQ(word(4), table.address + 4);
  EXPECT_EQ(word(8), start + 4);
}

TEST(Linked, WeakGivesWayAndGlobalsAreUnique) {
  const char* start = "_start: CALL f; RTS;\n";
  const ir::Image image = linked({unit(std::string(start) + ".weak f\nf: NOP; RTS;\n", "a.s"),
                                  unit(".global f\nf: RTS;\n", "b.s")});
  EXPECT_EQ(image.cores[0].functions.back().address, image.cores[0].functions[2].address);
  EXPECT_THAT(link_error({unit(std::string(start) + ".global f\nf: RTS;\n", "a.s"),
                          unit(".global f\nf: RTS;\n", "b.s")}),
              HasSubstr("b.s:2:1: f of core_a is defined already, at a.s:3:1"));
}

TEST(Linked, UndefinedSymbolsNameTheNearest) {
  EXPECT_THAT(
      link_error({unit("_start: NOP;\n CALL functoin; RTS;\nfunction: RTS;\n", "a.s")}),
      HasSubstr("a.s:2:2: section a.text refers to functoin, which no unit of core_a and no "
                "shared one defines; did you mean function?"));
}

TEST(Linked, BranchesReachOnlySoFar) {
  EXPECT_THAT(link_error({unit("_start: JUMP.S far;\n.space 8000\nfar: RTS;\n", "a.s")}),
              HasSubstr("a.s:1:9: section a.text: far is 8002 bytes away"));
}

TEST(Linked, SectionsArePlacedAsOne) {
  ir::Placement placement = ir::default_placement();
  placement.override_object(ir::Owner::core_a, "a.data", "l2");
  const ir::Image image =
      linked({unit("_start: RTS;\n.data\nx: .byte 1\ny: .byte 2\n", "a.s")}, placement);
  EXPECT_EQ(object(image, "x").region, "l2");
  EXPECT_EQ(object(image, "y").address, object(image, "x").address + 1);
}

}  // namespace
}  // namespace finback::assembler
