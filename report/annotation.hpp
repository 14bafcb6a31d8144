// One function's code with what each instruction and each line of source cost.
//
// Filled by runner/annotate.hpp. The cycles over the packets, over the lines and over the causes
// each sum to the function's exclusive cycles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <report/run_result.hpp>

namespace finback::report {

// Instructions that issue together.
struct AnnotatedPacket {
  Address address = 0;
  std::vector<std::string> labels;  // that stand before it: ".LBB0_1"
  std::string text;                 // "R0 = [P0++] || R1 = W[I0++];"
  std::uint64_t executions = 0;     // 0: never ran
  Cycles cycles = 0;
  CyclesByCause causes;  // those that are not 0
  BytesByLevel bytes;    // those that are not 0
};

// A line of source with the code that was made from it, in the order of addresses.
struct AnnotatedLine {
  std::string file;                   // as the program names it; "": code without a line
  int line = 0;                       // from 1; 0 without a line
  std::optional<std::string> source;  // nothing when the file was not found
  std::uint64_t executions = 0;       // of its most executed packet
  std::uint64_t packets = 0;          // issued
  Cycles cycles = 0;
  CyclesByCause causes;
  BytesByLevel bytes;
  std::vector<AnnotatedPacket> code;  // empty: a line between those that have code
};

struct Annotation {
  std::string core;
  std::string function;
  std::string region;  // where its code lies
  Address address = 0;
  Cycles core_cycles = 0;
  Function cost;
  // The function's own file first, by line; then files that were inlined; code without a line last.
  std::vector<AnnotatedLine> lines;
  std::vector<std::string> missing_sources;  // files whose text was not found
};

}  // namespace finback::report
