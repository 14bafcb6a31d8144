// Linking: where things go, what symbols are worth, and what is said when that cannot be.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/ir/support.hpp>

#include <isa_sim/ir/linker.hpp>

namespace finback::ir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const memory::MemoryMap& map() {
  static const memory::MemoryMap the_map = memory::bf561_map();
  return the_map;
}

Placement placement(const std::string& text) { return parse_placement(text, "p.toml"); }

std::string link_error(const FirmwareUnits& firmware, const Placement& p = default_placement()) {
  return error_of([&] { (void)link(firmware, p, map()); });
}

const PlacedObject& object(const Image& image, const std::string& name,
                           Owner owner = Owner::core_a) {
  return *std::ranges::find_if(image.objects, [&](const PlacedObject& one) {
    return one.name == name && one.owner == owner;
  });
}

const PlacedFunction& function_of(const CoreImage& core, const std::string& name) {
  return *std::ranges::find(core.functions, name, &PlacedFunction::name);
}

std::string text_of(const PlacedPacket& packet, std::size_t slot = 0) {
  return isa::disassemble(packet.slots[slot].instruction, packet.slots[slot].operand);
}

std::string start(const std::string& body = "RTS;\n") { return kStart + body; }

std::string bytes(const std::string& name, int size, const std::string& align = "4") {
  return ".bss\n.global " + name + "\n.align " + align + "\n.type " + name + ", @object\n" + name +
         ":\n.space " + std::to_string(size) + "\n";
}

TEST(Linker, LaysOutCodeInTheOrderOfTheText) {
  const Image image = link(core_a({unit(start("CALL _g;\nR0.L = ONES R1 || R1 = [P0++];\nRTS;\n") +
                                        ".align 8\n.type _g, @function\n_g: NOP; RTS;\n")}),
                           default_placement(), map());
  const CoreImage& core = image.cores[0];
  EXPECT_TRUE(core.present);
  EXPECT_FALSE(image.cores[1].present);
  ASSERT_EQ(core.packets.size(), 5u);
  EXPECT_EQ(core.entry, 0xFFA00000u);
  EXPECT_EQ(core.packets[1].address, 0xFFA00004u);
  EXPECT_EQ(core.packets[1].length, 8);
  EXPECT_EQ(core.packets[1].count, 2);
  EXPECT_EQ(core.packets[2].address, 0xFFA0000Cu);
  EXPECT_EQ(core.packets[2].length, 2);
  const PlacedFunction& g = function_of(core, "g");
  EXPECT_EQ(g.address, 0xFFA00010u);
  EXPECT_EQ(g.size, 4u);
  EXPECT_EQ(g.first_packet, 3u);
  EXPECT_EQ(g.packet_count, 2u);
  EXPECT_EQ(g.region, "l1.code");
  EXPECT_EQ(text_of(core.packets[0]), "CALL 0xffa00010");
  EXPECT_EQ(core.packets[3].function, 1u);
}

TEST(Linker, StackTopIsTheEndOfTheStack) {
  const Image image = link(core_a({unit(start())}), default_placement(), map());
  EXPECT_EQ(image.cores[0].stack_top, 0xFFB01000u);
  EXPECT_EQ(object(image, "stack").size, 4096u);
  EXPECT_EQ(object(image, "stack").region, "l1.scratch");
}

TEST(Linker, ResolvesHalvesAndRelocations) {
  const Image image = link(
      core_a({unit(start("P0.L = _x + 4;\nP0.H = _x + 4;\nR1.L = _start; R1.H = _start;\n"
                         "R2.L = 5;\n.La: RTS;\n") +
                   bytes("_x", 8) + ".data\n.align 4\n_y: .byte4 7, _x - 4, _start, .La + 2\n")}),
      default_placement(), map());
  const std::vector<PlacedPacket>& packets = image.cores[0].packets;
  const Address x = object(image, "x").address;
  EXPECT_EQ(x, 0xFF900000u);
  EXPECT_EQ(text_of(packets[0]), "P0.L = 4");
  EXPECT_EQ(text_of(packets[1]), "P0.H = 65424");  // 0xFF90
  EXPECT_EQ(text_of(packets[2]), "R1.L = 0");
  EXPECT_EQ(text_of(packets[3]), "R1.H = 65440");  // 0xFFA0
  EXPECT_EQ(text_of(packets[4]), "R2.L = 5");
  EXPECT_THAT(object(image, "y").initial,
              ElementsAre(7, 0, 0, 0, 0xFC, 0xFF, 0x8F, 0xFF, 0, 0, 0xA0, 0xFF,  //
                          22, 0, 0xA0, 0xFF));
}

TEST(Linker, PlacesNamedThingsFirstAndInTextOrder) {
  const Placement p = placement(
      "[core_a]\ndefault = \"l1.data.a\"\n[core_a.objects]\n"
      "late = \"l1.data.a\"\n\"vga_*\" = \"l3\"\n"
      "[core_a.functions]\n\"g*\" = \"l2\"\n");
  const Image image =
      link(core_a({unit(start() + ".type _g1, @function\n_g1: RTS;\n" + bytes("_early", 1, "1") +
                        bytes("_late", 2, "1") + bytes("_vga_b", 4) + bytes("_vga_a", 4) +
                        bytes("_wide", 8, "8"))}),
           p, map());
  EXPECT_EQ(object(image, "late").address, 0xFF800000u);
  EXPECT_EQ(object(image, "early").address, 0xFF800002u);
  EXPECT_EQ(object(image, "wide").address, 0xFF800008u);
  EXPECT_EQ(object(image, "vga_b").address, 0x1000u) << "address 0 is nobody's";
  EXPECT_EQ(object(image, "vga_a").address, 0x1004u);
  EXPECT_EQ(object(image, "vga_a").region, "l3");
  EXPECT_EQ(function_of(image.cores[0], "g1").address, 0xFEB00000u);
  EXPECT_EQ(image.cores[0].packets.front().address, 0xFEB00000u) << "packets go by address";
  EXPECT_EQ(image.cores[0].entry, 0xFFA00000u);
}

TEST(Linker, TakesTheFirstRegionWithRoom) {
  const Image image = link(core_a({unit(start() + bytes("_a", 30000) + bytes("_b", 30000) +
                                        bytes("_c", 30000) + bytes("_d", 2000))}),
                           default_placement(), map());
  EXPECT_EQ(object(image, "a").region, "l1.data.b");
  EXPECT_EQ(object(image, "b").region, "l1.data.a");
  EXPECT_EQ(object(image, "c").region, "l2");
  EXPECT_EQ(object(image, "d").region, "l1.data.b") << "what is left is used";
  EXPECT_EQ(object(image, "d").address, 0xFF900000u + 30000u);
}

TEST(Linker, TheFirstMatchingRuleWins) {
  const Placement p =
      placement("[core_a.objects]\nx1 = \"l2\"\n\"x*\" = [\"l1.scratch\", \"l3\"]\n");
  const Image image = link(core_a({unit(start() + bytes("_x1", 4) + bytes("_x2", 4))}), p, map());
  EXPECT_EQ(object(image, "x1").region, "l2");
  EXPECT_EQ(object(image, "x2").region, "l3") << "the scratchpad is full of the stack";
}

TEST(Linker, OverridesMoveOneObject) {
  const FirmwareUnits firmware = core_a({unit(start() + bytes("_x1", 4) + bytes("_x2", 4))});
  Placement p = placement("[core_a.objects]\n\"x*\" = \"l2\"\n");
  p.override_object(Owner::core_a, "x2", "l1.data.a");
  p.override_function(Owner::core_a, "start", "l3");
  const Image image = link(firmware, p, map());
  EXPECT_EQ(object(image, "x1").region, "l2");
  EXPECT_EQ(object(image, "x2").region, "l1.data.a");
  EXPECT_EQ(image.cores[0].entry, 0x1000u);
  p.override_object(Owner::core_a, "x3", "l2");
  EXPECT_EQ(link_error(firmware, p), "(override): core_a has no object x3, did you mean x1?");
}

TEST(Linker, OverflowTellsWhoIsIn) {
  const Placement p = placement("[core_a.objects]\n\"x*\" = \"l1.data.a\"\n");
  EXPECT_EQ(link_error(core_a({unit(start() + bytes("_x_small", 100) + bytes("_x_large", 30000) +
                                    bytes("_x_more", 4000))}),
                       p),
            "p.toml:2:8: l1.data.a overflows: object x_more of core_a has 4000 bytes (alignment "
            "4), but of 32768 bytes 30100 are taken\n"
            "  in l1.data.a (30100 of 32768 bytes taken):\n"
            "        30000  x_large (core_a)\n"
            "          100  x_small (core_a)");
}

TEST(Linker, ExhaustedDefaultsTellWhoIsIn) {
  const Placement p = placement("[core_a]\ndefault = [\"l1.data.a\", \"l1.data.b\"]\n");
  const std::string error = link_error(
      core_a({unit(start() + bytes("_a", 30000) + bytes("_b", 30000) + bytes("_c", 30000))}), p);
  EXPECT_THAT(error, StartsWith("p.toml:2:11: no room for object c of core_a, 30000 bytes "
                                "(alignment 4), in any of l1.data.a, l1.data.b, where it goes by "
                                "default\n  in l1.data.a (30000 of 32768 bytes taken):\n"));
  EXPECT_THAT(error, HasSubstr("  in l1.data.b (30000 of 32768 bytes taken):\n        30000  b"));
}

TEST(Linker, ChecksRegionsAndPatterns) {
  const FirmwareUnits firmware = core_a({unit(start() + bytes("_disparity", 4))});
  EXPECT_EQ(link_error(firmware, placement("[core_a.objects]\ndisparity = \"l1.data.c\"")),
            "p.toml:2:13: core_a has no region l1.data.c; did you mean l1.data.a?");
  EXPECT_EQ(link_error(firmware, placement("[core_a.objects]\ndisparty = \"l2\"")),
            "p.toml:2:12: core_a has no object disparty, did you mean disparity?");
  EXPECT_EQ(link_error(firmware, placement("[core_a.functions]\n\"q*\" = \"l2\"")),
            "p.toml:2:8: core_a has no function q*");
  EXPECT_EQ(link_error(firmware, placement("[shared.objects]\ndisparity = \"l2\"")),
            "p.toml:2:13: shared has no object disparity, but core_a has: move the line to "
            "[core_a.objects]");
  EXPECT_EQ(link_error(firmware, placement("[core_a.objects]\ndisparity = \"l1.code\"")),
            "p.toml:2:13: region l1.code holds instructions, not objects");
  EXPECT_EQ(link_error(firmware, placement("[core_a]\ncode = \"l1.data.a\"")),
            "p.toml:2:8: region l1.data.a holds data, not functions");
  EXPECT_EQ(link_error(firmware, placement("[shared]\ndefault = \"l1.data.a\"")),
            "p.toml:2:11: shared has no region l1.data.a; there are l3, flash, l2");
  EXPECT_EQ(link_error(firmware, placement("[core_b.objects]\nnothing = \"l2\"")), "")
      << "a core that the firmware does not have is not placed";
}

TEST(Linker, KeepsCoresAndFilesApart) {
  FirmwareUnits firmware;
  firmware.path = "firmware.toml";
  const Unit common = unit(
      ".text\n.global _f\n.type _f, @function\n_f: P0.L = _own; P1.L = _both; "
      "RTS;\n.data\n_own: .byte4 _own\n",
      "common.bir");
  const Unit start_unit =
      unit(start("CALL _f;\nP0.L = _own;\nRTS;\n") + bytes("_own", 64) + bytes("_both", 4, "2"),
           "start.bir");
  // _own is local to each file; start.bir's copy must not be global for that.
  const Unit local_start = [&] {
    Program copy = *start_unit;
    copy.objects[0].binding = Binding::local;
    return std::make_shared<const Program>(copy);
  }();
  for (CoreUnits& core : firmware.cores) {
    core.present = true;
    core.units = {local_start, common};
  }
  firmware.shared = {unit(bytes("_both", 12) + bytes("_only_shared", 4), "shared.bir")};
  const Image image = link(firmware, default_placement(), map());
  EXPECT_EQ(std::ranges::count(image.objects, "own", &PlacedObject::name), 4);
  EXPECT_EQ(std::ranges::count(image.objects, "both", &PlacedObject::name), 3);
  EXPECT_EQ(object(image, "both", Owner::shared).address, 0xFEB00000u);
  for (const int core : {0, 1}) {
    const Address bank_b = core == 0 ? 0xFF900000 : 0xFF500000;
    const CoreImage& own = image.cores[static_cast<std::size_t>(core)];
    const PlacedFunction& f = function_of(own, "f");
    EXPECT_EQ(text_of(own.packets[f.first_packet]), "P0.L = 68") << "its file's own";
    EXPECT_EQ(text_of(own.packets[f.first_packet + 1]), "P1.L = 64")
        << "the core's, not the shared";
    EXPECT_EQ(text_of(own.packets[1]), "P0.L = 0");
    EXPECT_EQ(own.entry, core == 0 ? 0xFFA00000u : 0xFF600000u);
    const auto pointer = std::ranges::find_if(image.objects, [&](const PlacedObject& one) {
      return one.name == "own" && one.size == 4 && one.address == bank_b + 68;
    });
    ASSERT_NE(pointer, image.objects.end());
    EXPECT_THAT(pointer->initial, ElementsAre(68, 0, bank_b >> 16 & 0xff, 0xff));
  }
}

TEST(Linker, AddressesOfLabelsAreSeenAllOverTheFile) {
  const std::string taker = ".type _g, @function\n_g: P0.L = .La; RTS;\n";
  const std::string other = ".type _h, @function\n_h: RTS; .La: RTS;\n";
  const Image image = link(core_a({unit(start() + taker + other)}), default_placement(), map());
  const CoreImage& core = image.cores[0];
  const Address label = function_of(core, "h").address + 2;
  EXPECT_EQ(text_of(core.packets[1]), "P0.L = " + std::to_string(label & 0xffff));
  EXPECT_EQ(link_error(core_a({unit(start(".La: RTS;\n") + taker + other)})),
            "a.bir:7:5: g takes the address of label .La, which two functions of this file have");
  EXPECT_EQ(error_of([&] { (void)unit(start() + taker); }), "a.bir:7:5: _g has no label .La");
  EXPECT_THAT(link_error(core_a({unit(start() + ".type _g, @function\n_g: P0.L = place; RTS;\n" +
                                      ".type _h, @function\n_h: RTS; place: JUMP elsewhere;\n" +
                                      ".type _i, @function\n_i: elsewhere: RTS;\n")})),
              HasSubstr("function h refers to elsewhere, which"));
}

TEST(Linker, SharedObjectsSeeOnlySharedSymbols) {
  FirmwareUnits firmware = core_a({unit(start())});
  firmware.shared = {unit(".data\n.align 4\n_p: .byte4 _start\n", "shared.bir")};
  EXPECT_EQ(link_error(firmware),
            "shared.bir:4:1: object p refers to _start, which no shared unit defines");
  firmware.shared = {unit(".type _f, @function\n_f: RTS;\n", "shared.bir")};
  EXPECT_EQ(link_error(firmware),
            "shared.bir:3:1: function f stands in a shared unit: shared units have objects only, "
            "list the unit under each core that calls it");
}

TEST(Linker, WeakDefinitionsGiveWay) {
  const std::string weak = ".weak _f\n.type _f, @function\n_f: R0 = 1 (X); RTS;\n";
  const std::string strong = ".global _f\n.type _f, @function\n_f: R0 = 2 (X); RTS;\n";
  const Unit main = unit(start("CALL _f; RTS;\n"));
  for (const bool strong_first : {false, true}) {
    const Image image =
        link(core_a({main, unit(strong_first ? strong : weak), unit(strong_first ? weak : strong)}),
             default_placement(), map());
    ASSERT_EQ(image.cores[0].functions.size(), 2u);
    EXPECT_EQ(text_of(image.cores[0].packets[2]), "R0 = 2 (X)");
  }
  EXPECT_EQ(link(core_a({main, unit(weak)}), default_placement(), map()).cores[0].functions.size(),
            2u);
}

TEST(LinkerErrors, Symbols) {
  EXPECT_EQ(link_error(core_a({unit(start("CALL _shd_update;\nRTS;\n") +
                                    ".type _shd_updated, @function\n_shd_updated: RTS;\n")})),
            "a.bir:5:1: function start refers to _shd_update, which no unit of core_a and no "
            "shared one defines; did you mean _shd_updated?");
  EXPECT_EQ(link_error(core_a({unit(start() + bytes("_x", 4)), unit(bytes("_x", 4), "b.bir")})),
            "b.bir:6:1: _x of core_a is defined already, at a.bir:10:1");
  EXPECT_EQ(link_error(core_a({unit(".type _f, @function\n_f: RTS;\n")})),
            "firmware.toml: core_a's entry _start is a function of none of its units");
  EXPECT_EQ(link_error(core_a({unit(start("CALL _x;\nRTS;\n") + bytes("_x", 4))})),
            "a.bir:5:1: function start branches to _x, which is no label and no function");
}

TEST(LinkerErrors, Distances) {
  std::string nops;
  for (int i = 0; i < 600; ++i) {
    nops += "NOP;\n";
  }
  EXPECT_EQ(link_error(core_a({unit(start("IF CC JUMP .La;\n" + nops + ".La: RTS;\n"))})),
            "a.bir:5:1: function start: .La is 1202 bytes away, out of the range -1024..1022");
  EXPECT_EQ(link_error(core_a({unit(start("JUMP.S .La;\n" + nops + ".La: RTS;\n"))})), "");
  EXPECT_EQ(link_error(
                core_a({unit(start("JUMP.S .La;\n" + nops + nops + nops + nops + ".La: RTS;\n"))})),
            "a.bir:5:1: function start: .La is 4802 bytes away, out of the range -4096..4094");
  const std::string loop = "LSETUP (.La, .Lb) LC0 = P0;\n";
  EXPECT_EQ(link_error(core_a({unit(start(loop + nops + ".La:\n.Lb: NOP;\nRTS;\n"))})),
            "a.bir:5:1: function start: the loop's top .La is 1204 bytes away, out of the range "
            "4..30");
  EXPECT_EQ(
      link_error(core_a({unit(start(loop + ".La: NOP;\n" + nops + nops + ".Lb: NOP;\nRTS;\n"))})),
      "a.bir:5:1: function start: the loop's bottom .Lb is 2406 bytes away, out of the range "
      "4..2046");
}

// Just within reach and one instruction further, for each kind of code address but pc24.
TEST(Linker, ReachesToTheEndOfTheRange) {
  const auto nops = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += "NOP;\n";
    }
    return text;
  };
  const auto forward = [&](int between) {
    return link_error(core_a({unit(start("IF CC JUMP .La;\n" + nops(between) + ".La: RTS;\n"))}));
  };
  EXPECT_EQ(forward(510), "");
  EXPECT_NE(forward(511), "");
  const auto backward = [&](int between) {
    return link_error(
        core_a({unit(start(".La: NOP;\n" + nops(between) + "IF CC JUMP .La;\nRTS;\n"))}));
  };
  EXPECT_EQ(backward(511), "");
  EXPECT_NE(backward(512), "");
  const auto loop = [&](int inside) {
    return link_error(core_a({unit(
        start("LSETUP (.La, .Lb) LC0 = P0;\n.La: NOP;\n" + nops(inside) + ".Lb: NOP;\nRTS;\n"))}));
  };
  EXPECT_EQ(loop(1020), "");
  EXPECT_NE(loop(1021), "");
}

TEST(Linker, CallsReachFromL1ToSdramAroundTheEndOfTheSpace) {
  const Placement p = placement("[core_a.functions]\ng = \"l3\"\n");
  const Image image = link(
      core_a({unit(start("CALL _g;\nRTS;\n") + ".type _g, @function\n_g: CALL _start;\nRTS;\n")}),
      p, map());
  EXPECT_EQ(text_of(image.cores[0].packets[2]), "CALL 0x1000");
  EXPECT_EQ(text_of(image.cores[0].packets[0]), "CALL 0xffa00000");
}

TEST(Linker, LinesComeFromLocOrElseFromTheText) {
  const Image image = link(core_a({unit(".file 1 \"x.c\"\n" + start("NOP;\n.loc 1 7\nRTS;\n"))}),
                           default_placement(), map());
  const CoreImage& core = image.cores[0];
  EXPECT_EQ(core.source_files[static_cast<std::size_t>(core.packets[0].file)], "a.bir");
  EXPECT_EQ(core.packets[0].line, 6);
  EXPECT_EQ(core.source_files[static_cast<std::size_t>(core.packets[1].file)], "x.c");
  EXPECT_EQ(core.packets[1].line, 7);
}

TEST(Linker, StagesMustExist) {
  FirmwareUnits firmware = core_a({unit(start())});
  firmware.stages = {{"match", Owner::core_a, "stort"}};
  EXPECT_EQ(link_error(firmware),
            "firmware.toml: stage \"match\": core_a has no function stort, did you mean start?");
}

TEST(LinkReport, AddsUpRegions) {
  FirmwareUnits firmware = core_a({unit(start() + bytes("_x", 5) + bytes("_y", 8, "8"))});
  firmware.shared = {unit(bytes("_z", 100), "shared.bir")};
  const Image image = link(firmware, default_placement(), map());
  const std::vector<RegionUse> report = link_report(image, map());
  ASSERT_EQ(report.size(), map().regions.size());
  const auto find = [&](const std::string& name, int core) {
    return *std::ranges::find_if(
        report, [&](const RegionUse& use) { return use.region == name && use.core == core; });
  };
  EXPECT_EQ(find("l1.data.b", 0).used, 13u);
  EXPECT_EQ(find("l1.data.b", 0).end, 16u);
  EXPECT_EQ(find("l1.data.b", 0).size, 32768u);
  EXPECT_EQ(find("l1.data.b", 1).used, 0u);
  EXPECT_EQ(find("l1.code", 0).used, 2u);
  EXPECT_EQ(find("l2", -1).used, 100u);
}

}  // namespace
}  // namespace finback::ir
