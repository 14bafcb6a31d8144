// A small camera for tests: grabs a pair, reads two tables in a loop, publishes a map. Its speed
// depends on where the tables lie, and its simulation takes milliseconds.
#pragma once

#include <fmt/format.h>
#include <string>

namespace finback::explorer {

// `rounds`: how often each table is read, a multiple of 65536. `end` stands before the return.
inline std::string camera_text(unsigned rounds = 65536, const std::string& end = "") {
  const auto object = [](const char* name, unsigned size) {
    return fmt::format(".type _{0}, @object\n_{0}:\n  .space {1}\n.size _{0}, {1}\n", name, size);
  };
  return fmt::format(
             ".bir 1\n.text\n.global _main\n.type _main, @function\n_main:\n"
             "  P0.L = 0xF000; P0.H = 0xFFC0;\n"
             "  R0.L = _left_frame; R0.H = _left_frame; [P0 + 4] = R0;\n"
             "  R0.L = _right_frame; R0.H = _right_frame; [P0 + 8] = R0;\n"
             "  R0 = 1 (X); [P0 + 12] = R0;\n"
             "  P1.L = 0; P1.H = {};\n"
             "  P2.L = _table_a; P2.H = _table_a; P3.L = _table_b; P3.H = _table_b;\n"
             "  LSETUP (.Lfirst, .Llast) LC0 = P1;\n"
             ".Lfirst:\n  R1 = [P2];\n.Llast:\n  R2 = [P3];\n"
             "  R0.L = _map; R0.H = _map; [P0 + 16] = R0;\n"
             "  R0.L = 4; R0.H = 4; [P0 + 20] = R0;\n"
             "  R0 = 0 (X); [P0 + 24] = R0;\n{}  RTS;\n.size _main, .-_main\n.bss\n.align 4\n",
             rounds / 65536, end) +
         object("left_frame", 307200) + object("right_frame", 307200) + object("table_a", 64) +
         object("table_b", 64) + object("huge_table", 40000) + object("map", 16);
}

// A space's run of it, stored as camera.bir.
constexpr std::string_view kCameraRun =
    "[run]\nfirmware = \"camera.bir\"\nscene = \"synthetic\"\nframes = 1\n";

}  // namespace finback::explorer
