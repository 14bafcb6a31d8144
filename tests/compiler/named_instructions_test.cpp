// The functions that are instructions: each compiles to what docs/fract.md says and to nothing
// else, the headers declare what the compiler knows, and what it does not know is an error.
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

std::string source_text(const std::string& path) {
  std::ifstream file(std::string(FINBACK_SOURCE_DIR) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::smatch> all_matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

// A line of a table of the page: a prototype and its instructions.
struct Promise {
  std::string prototype;
  std::vector<std::string> instructions;
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

// By header.
std::map<std::string, std::vector<Promise>> promises() {
  static const std::regex heading("^## `<(.*)>`$");
  static const std::regex row(R"(^\| `(.*)` \| `(.*)` \|$)");
  std::map<std::string, std::vector<Promise>> found;
  std::string header;
  for (const std::string& line : split(source_text("docs/fract.md"), "\n")) {
    std::smatch match;
    if (line.starts_with("## "))
      header = std::regex_match(line, match, heading) ? match[1].str() : "";
    else if (!header.empty() && std::regex_match(line, match, row))
      found[header].push_back(
          {match[1].str(),
           split(std::regex_replace(match[2].str(), std::regex(R"(\\\|)"), "|"), "; ")});
  }
  return found;
}

// A function f<number> that calls the prototype's with its own parameters.
std::string caller(const std::string& prototype, size_t number) {
  static const std::regex parts(R"(^(.*[ *])(\w+)\((.*)\)$)");
  static const std::regex last_word(R"((\w+)$)");
  std::smatch match;
  EXPECT_TRUE(std::regex_match(prototype, match, parts)) << prototype;
  std::string arguments;
  for (const std::string& parameter : split(match[3].str(), ", ")) {
    std::smatch name;
    if (std::regex_search(parameter, name, last_word))
      arguments += (arguments.empty() ? "" : ", ") + name[1].str();
  }
  return match[1].str() + "f" + std::to_string(number) + "(" + match[3].str() + ") { return " +
         match[2].str() + "(" + arguments + "); }\n";
}

// What a function does beside moving its arguments and its result to their places.
std::vector<std::string> work_of(const std::string& body) {
  static const std::regex moves(
      R"(^([RPI]\d = [RPI]\d|[RP]\d = \[SP.*|\[--SP\].*|\(.*\) = \[SP\+\+\]|R\d = R\d\.L \(X\)|RTS|NOP)$)");
  static const std::regex short_shift(R"(^(R\d) (>>>|>>|<<)= (\d+)$)");
  std::vector<std::string> work;
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line.find(".loc") != std::string::npos)
      continue;
    // Of a packet the computation.
    const std::string statement = line.substr(2, std::min(line.find(" ||"), line.find(';')) - 2);
    if (!std::regex_match(statement, moves))
      work.push_back(std::regex_replace(statement, short_shift, "$1 = $1 $2 $3"));
  }
  return work;
}

std::regex as_pattern(const std::string& instruction) {
  std::string pattern =
      std::regex_replace(instruction, std::regex(R"([\^$\\.*+?()\[\]{}|])"), "\\$&");
  pattern = std::regex_replace(pattern, std::regex("R[a-z]"), "R[0-7]");
  return std::regex(pattern);
}

class NamedInstructions : public CompilerTest {};

TEST_F(NamedInstructions, AreWhatThePageSays) {
  size_t rows = 0;
  for (const auto& [header, list] : promises()) {
    std::string program = "#include <" + header + ">\n";
    for (size_t i = 0; i < list.size(); ++i)
      program += caller(list[i].prototype, i);
    const std::string text = compile(program);
    for (size_t i = 0; i < list.size(); ++i) {
      const std::string body = function_of(text, "f" + std::to_string(i));
      const std::vector<std::string> work = work_of(body);
      SCOPED_TRACE(list[i].prototype + body);
      ASSERT_EQ(work.size(), list[i].instructions.size());
      for (size_t k = 0; k < work.size(); ++k)
        EXPECT_TRUE(std::regex_match(work[k], as_pattern(list[i].instructions[k])))
            << work[k] << " for " << list[i].instructions[k];
    }
    rows += list.size();
  }
  EXPECT_GE(rows, 90U);
}

// The compiler's table: name and types.
std::map<std::string, std::string> table() {
  const std::string text = source_text("compiler/target/BfinNamedInstructions.cpp");
  std::map<std::string, std::string> found;
  for (const std::smatch& row :
       all_matches(text, std::regex(R"re(\{"(\w+)", "(\w:\w*)", k(?!Internal|Ring)\w+, )re")))
    found[row[1].str()] = row[2].str();
  return found;
}

std::string type_of(char letter) {
  switch (letter) {
    case 'v':
      return "void";
    case 'l':
      return "long long";
    case 'p':
      return "void *";
    case 's':
    case 'h':
      return "short";
    default:
      return "int";
  }
}

TEST_F(NamedInstructions, AreDeclaredWithTheirTypesAndNeedNoCall) {
  std::set<std::string> declared;
  for (const char* header : {"builtins.h", "finback/blackfin.h"}) {
    const std::string text = source_text(std::string("compiler/include/") + header);
    for (const std::smatch& name : all_matches(text, std::regex(R"(__builtin_bfin_(\w+)\()")))
      declared.insert(name[1].str());
  }
  std::string program = "#include <builtins.h>\n";
  std::set<std::string> known;
  for (const auto& [name, types] : table()) {
    known.insert(name);
    std::string parameters;
    std::string arguments;
    for (size_t i = 2; i < types.size(); ++i) {
      const std::string separator = i == 2 ? "" : ", ";
      const std::string parameter = "p" + std::to_string(i);
      parameters += separator + type_of(types[i]) + " " + parameter;
      arguments += separator + (types[i] == 'n' || types[i] == 'r' ? "3" : parameter);
    }
    program += type_of(types[0]) + " f_" + name + "(" + (parameters.empty() ? "void" : parameters) +
               ") { " + (types[0] == 'v' ? "" : "return ") + "__builtin_bfin_" + name + "(" +
               arguments + "); }\n";
  }
  EXPECT_EQ(declared, known);
  EXPECT_GE(known.size(), 100U);
  const std::string text = compile(program);
  EXPECT_EQ(count(text, "CALL"), 0) << text;
  for (const std::string& name : known)
    EXPECT_FALSE(work_of(function_of(text, "f_" + name)).empty() && name != "nop") << name;
}

TEST_F(NamedInstructions, ComputeOnceAndOutsideOfLoops) {
  const std::string text = compile(
      "#include <fract_math.h>\n"
      "int twice(int a, int b) { return mult_fr1x32x32(a, b) ^ mult_fr1x32x32(a, b) << 1; }\n"
      "void unused(int a) { add_fr1x32(a, a); }\n"
      "void out(int *p, short a, short b, int n) {\n"
      "  for (int i = 0; i < n; i++) p[i] += multr_fr1x16(a, b);\n}\n");
  EXPECT_EQ(count(function_of(text, "twice"), "A1 >> 16"), 1) << text;
  EXPECT_TRUE(work_of(function_of(text, "unused")).empty()) << text;
  const std::string loop = function_of(text, "out");
  EXPECT_LT(loop.find("R1.L * R2.L"), loop.find("LSETUP")) << text;
}

// Extensions between halves are not written, halves are read where they are, two results are one
// instruction.
TEST_F(NamedInstructions, FitTogether) {
  const std::string text = compile(
      "#include <fract.h>\n"
      "short chain(short a, short b, int c) {\n"
      "  return add_fr1x16(add_fr1x16(a, b), high_of_fr2x16(c)); }\n"
      "void both(int a, int b, int *to) { to[0] = sub_fr2x16(a, b); to[1] = add_fr2x16(b, a); }\n"
      "int known(int a) { return shr_fr2x16(shl_fr2x16(a, 3), 5); }\n");
  EXPECT_EQ(count(function_of(text, "chain"), "(X)"), 1) << text;
  EXPECT_EQ(count(function_of(text, "chain"), ".H (S)"), 1) << text;
  EXPECT_EQ(count(function_of(text, "both"), "+|+"), 1) << text;
  EXPECT_EQ(work_of(function_of(text, "both")).size(), 3U) << text;
  EXPECT_EQ(count(function_of(text, "known"), "<< 3 (V, S)"), 1) << text;
  EXPECT_EQ(count(function_of(text, "known"), ">>> 5 (V)"), 1) << text;
}

// C has words for some of them.
TEST_F(NamedInstructions, AreFoundInPlainC) {
  const std::string text = compile(
      "static short limited(int s) { return s > 32767 ? 32767 : s < -32768 ? -32768 : s; }\n"
      "short sum(short a, short b) { return limited(a + b); }\n"
      "void differences(short *restrict d, const short *a, int n) {\n"
      "  for (int i = 0; i < n; i++) d[i] = limited(a[i] - d[i]);\n}\n"
      "int words(int a, int b) { return __builtin_elementwise_add_sat(a, b); }\n"
      "int pair(int a, int b) { return a & ~0xffff | (unsigned short)b; }\n");
  EXPECT_EQ(count(function_of(text, "sum"), "+|+"), 1) << text;
  EXPECT_EQ(work_of(function_of(text, "sum")).size(), 1U) << text;
  EXPECT_GE(count(function_of(text, "differences"), "-|-"), 3) << text;
  EXPECT_EQ(count(function_of(text, "differences"), "<<"), 0) << text;
  EXPECT_EQ(count(function_of(text, "words"), "(S)"), 1) << text;
  EXPECT_EQ(count(function_of(text, "pair"), "PACK"), 1) << text;
}

TEST_F(NamedInstructions, HandlersSaveTheAccumulatorsAndIndexRegistersTheyUse) {
  const std::string text = compile(
      "#include <finback/blackfin.h>\n#include <complex_bf.h>\n#include <video.h>\n"
      "volatile int x, y;\n"
      "FINBACK_INTERRUPT void product(void) { x = __builtin_bfin_cmplx_mul(x, y); }\n"
      "FINBACK_INTERRUPT void average(void) { x = avg_i4x8(x, (void *)y, y, (void *)x); }\n");
  for (const char* reg : {"A0.X", "A0.W", "A1.X", "A1.W"})
    EXPECT_EQ(count(function_of(text, "product"), std::string("[--SP] = ") + reg + ";"), 1) << text;
  for (const char* reg : {"I0", "I1"})
    EXPECT_EQ(count(function_of(text, "average"), std::string("[--SP] = ") + reg + ";"), 1) << text;
}

struct Wrong {
  const char* text;
  const char* message;
};

TEST_F(NamedInstructions, ThatAreNotThereAreErrors) {
  for (const Wrong& wrong : {
           Wrong{"int __builtin_bfin_divs(int, int);\nint f(int a) {\n"
                 "  return __builtin_bfin_divs(a, 3);\n}\n",
                 "unit.c:3:10: error: there is no instruction behind __builtin_bfin_divs"},
           Wrong{"short __builtin_bfin_add_fr1x32(short, short);\nint f(short a) {\n"
                 "  return __builtin_bfin_add_fr1x32(a, 3);\n}\n",
                 "unit.c:3:10: error: __builtin_bfin_add_fr1x32 is declared with other types"},
           Wrong{"#include <sysreg.h>\nint f(int a) {\n  return (int)sysreg_read(a);\n}\n",
                 "unit.c:3:15: error: the register of __builtin_bfin_sysreg_read must be one of"},
           Wrong{"#include <fract.h>\nint f(int a) {\n  return divs(a, a);\n}\n",
                 "unit.c:3:10: error: call to undeclared function 'divs'"},
       }) {
    write("unit.c", wrong.text);
    const Finished finished = cc({"-o", "unit.bir", "unit.c"});
    EXPECT_EQ(finished.exit_code, 2) << wrong.text;
    EXPECT_NE(finished.err.find(wrong.message), std::string::npos) << finished.err;
  }
}

}  // namespace
}  // namespace finback::compiler
