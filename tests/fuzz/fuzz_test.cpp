// Do the readers survive anything? Texts made from good ones by a few random changes go through the
// parser, the verifier, the assembler and the linker: each is read, or refused in one line. Run in
// the sanitizer builds, too. FINBACK_FUZZ_INPUTS asks for more inputs (CONTRIBUTING.md).
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include <common/error.hpp>
#include <common/file.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback {
namespace {

constexpr long kInputs = 20'000;
constexpr int kBatches = 8;

const std::vector<std::string>& seeds(bool assembler) {
  static const std::vector<std::string> bir = {
      read_text_file(FINBACK_SOURCE_DIR "/tests/fuzz/seeds/functions.bir"),
      read_text_file(FINBACK_SOURCE_DIR "/tests/fuzz/seeds/data.bir")};
  static const std::vector<std::string> gas = {
      read_text_file(FINBACK_SOURCE_DIR "/tests/fuzz/seeds/macros.s"),
      read_text_file(FINBACK_SOURCE_DIR "/tests/fuzz/seeds/sections.s")};
  return assembler ? gas : bir;
}

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  std::string input(bool assembler) {
    const auto& all = seeds(assembler);
    std::string text = all[below(all.size())];
    const std::size_t changes = 1 + below(8);
    for (std::size_t i = 0; i < changes; ++i) {
      change(text, all);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }

  void change(std::string& text, const std::vector<std::string>& all) {
    const std::size_t at = text.empty() ? 0 : below(text.size());
    switch (below(8)) {
      case 0:  // a byte
        if (!text.empty()) {
          text[at] = static_cast<char>(below(256));
        }
        break;
      case 1:  // a printable byte
        text.insert(at, 1, static_cast<char>(' ' + below(95)));
        break;
      case 2:
        text.erase(at, 1 + below(12));
        break;
      case 3:  // a piece of itself somewhere else
        text.insert(at, text.substr(below(text.size() + 1), 1 + below(40)));
        break;
      case 4: {  // a piece of another seed
        const std::string& other = all[below(all.size())];
        text.insert(at, other.substr(below(other.size()), 1 + below(60)));
        break;
      }
      case 5:
        text.insert(at, kWords[below(std::size(kWords))]);
        break;
      case 6:  // an instruction of the table
        text.insert(at, instruction());
        break;
      default:
        text.resize(at);
    }
  }

  std::string instruction() {
    const auto entry = static_cast<int>(below(isa::instruction_table().size()));
    isa::ParsedInstruction parsed;
    parsed.instruction = entry;
    std::size_t i = 0;
    for (const isa::OperandRole& role : isa::roles_of(entry)) {
      const auto values = isa::sample_values(role.kind);
      parsed.operand[i++] = values[below(values.size())];
    }
    return " " + isa::instruction_syntax().print(parsed) + ";\n";
  }

  static constexpr const char* kWords[] = {"0x7fffffffffffffff",
                                           "-9223372036854775808",
                                           "99999999999999999999",
                                           "1e",
                                           "1f",
                                           "1:",
                                           "\\\\",
                                           "\\@",
                                           "\"",
                                           "'",
                                           "/*",
                                           "*/",
                                           "//",
                                           "(((((((((((((((((",
                                           "))))",
                                           ".rept 100000\n",
                                           ".endr\n",
                                           ".macro m\n m\n.endm\nm\n",
                                           ".if 1\n",
                                           ".else\n",
                                           ".endif\n",
                                           ".space 0x7fffffff\n",
                                           ".align 3\n",
                                           ".include \"x\"\n",
                                           "||",
                                           ";",
                                           ",",
                                           "~~~~",
                                           "<<",
                                           "% 0",
                                           "/ 0",
                                           ".set a, a + 1\n",
                                           ".org -1\n",
                                           ".fill 1000000, 8, 1\n",
                                           ".section \n",
                                           ".size ., .-x\n",
                                           "\n",
                                           "\r",
                                           "\t",
                                           ".irp x, 1, 2\n",
                                           ".ascii \"\\777\"\n",
                                           ".bir 2\n",
                                           ".type x, @function\n",
                                           ".global",
                                           "x = x\n"};

  std::mt19937 random_;
};

// Reads as a user's file is read, up to an image. False when it is refused, which is a line of
// text.
bool accepted(const std::string& text, bool assembler) {
  try {
    ir::Program program =
        assembler ? assembler::assemble(text, "fuzz.s") : ir::parse(text, "fuzz.bir");
    ir::verify(program);
    const ir::Firmware firmware = ir::bare_firmware(std::move(program));
    static_cast<void>(ir::link(firmware.units, firmware.placement, memory::bf561_map()));
    return true;
  } catch (const InputError& refused) {
    EXPECT_NE(std::string(refused.what()), "");
    return false;
  }
}

class Fuzz : public testing::TestWithParam<int> {};

TEST_P(Fuzz, EveryTextIsReadOrRefused) {
  const char* wanted = std::getenv("FINBACK_FUZZ_INPUTS");
  const long inputs = (wanted == nullptr ? kInputs : std::strtol(wanted, nullptr, 10)) / kBatches;
  long read = 0;
  for (long i = 0; i < inputs; ++i) {
    const auto seed = static_cast<std::uint32_t>(GetParam() * inputs + i);
    const bool assembler = i % 2 == 0;
    const std::string text = Mutator(seed).input(assembler);
    try {
      read += accepted(text, assembler) ? 1 : 0;
    } catch (const std::exception& problem) {
      FAIL() << "seed " << seed << ": " << problem.what() << "\n" << text;
    }
  }
  EXPECT_GT(read, 0);       // some changes hurt nobody
  EXPECT_LT(read, inputs);  // and some are refused
}

INSTANTIATE_TEST_SUITE_P(Batches, Fuzz, testing::Range(0, kBatches));

TEST(FuzzSeeds, AreGood) {
  for (const bool assembler : {false, true}) {
    for (const std::string& text : seeds(assembler)) {
      EXPECT_TRUE(accepted(text, assembler)) << text;
    }
  }
}

}  // namespace
}  // namespace finback
