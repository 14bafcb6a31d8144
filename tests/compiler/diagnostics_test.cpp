// What cannot be compiled is said at its line, in clang's form, with exit code 2 and nothing
// written.
#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

struct Case {
  const char* name;
  const char* source;
  const char* message;  // how stderr must contain it
};

constexpr Case kCases[] = {
    {"Syntax", "int f(void) {\n  return 1 +;\n}\n", "bad.c:2:13: error: expected expression"},
    {"UnknownName", "int f(void) { return x; }\n",
     "bad.c:1:22: error: use of undeclared identifier"},
    {"HalfFloat", "_Float16 f(_Float16 a) { return a; }\n",
     "bad.c:1:1: error: _Float16 is not supported"},
    {"AssemblyGoto",
     "int f(int a) {\n  __asm__ goto(\"JUMP %l0;\" : : : : out);\n  return a;\nout:\n  return "
     "1;\n}\n",
     "bad.c:2:3: error: asm goto is not supported"},
    {"WideAssemblyOperand",
     "long long f(long long a) {\n  __asm__(\"%0 += 1;\" : \"+d\"(a));\n  return a;\n}\n",
     "bad.c:2:3: error: an operand of inline assembly has at most 32 bits"},
    {"AssemblyConstraint", "void f(int a) {\n  __asm__(\"\" : : \"Q\"(a));\n}\n",
     "bad.c:2:18: error: invalid input constraint 'Q' in asm"},
    {"AssemblyClobber", "void f(void) {\n  __asm__(\"\" : : : \"X9\");\n}\n",
     "bad.c:2:20: error: unknown register name 'X9' in asm"},
    {"FileAssembly", "__asm__(\"nop\");\n", "error: assembly outside functions is not supported"},
    {"Atomic", "int f(int *p) {\n  return __atomic_fetch_add(p, 1, __ATOMIC_SEQ_CST);\n}\n",
     "bad.c:2:10: error: atomic read-modify-write is not supported"},
    {"ReturnAddress", "void *f(void) {\n  return __builtin_return_address(0);\n}\n",
     "bad.c:2:10: error: addresses of frames and to return to are not supported"},
    {"Vector",
     "typedef int v4 __attribute__((vector_size(16)));\nv4 f(v4 a) {\n  return a + a;\n}\n",
     "error: vector types are not supported"},
    {"ThreadLocal", "_Thread_local int x;\n", "is not supported"},
    {"WideProduct", "__int128 f(__int128 a) {\n  return a;\n}\n", "__int128 is not supported"},
    {"RaiseByVariable",
     "#include <finback/blackfin.h>\nvoid f(unsigned n) {\n  __builtin_bfin_raise(n);\n}\n",
     "bad.c:3:3: error: the argument of __builtin_bfin_raise must be a constant"},
    {"UnknownInstruction",
     "void __builtin_bfin_fly(void);\nvoid f(void) {\n  __builtin_bfin_fly();\n}\n",
     "bad.c:3:3: error: there is no instruction behind __builtin_bfin_fly"},
    {"HandlerWithArgument",
     "#include <finback/blackfin.h>\nFINBACK_INTERRUPT void f(int n) { (void)n; }\n",
     "error: an interrupt handler takes no arguments"},
    {"AlignedVariableArgument",
     "struct S { int a[4]; } __attribute__((aligned(16)));\nint f(int n, ...) {\n  "
     "__builtin_va_list v;\n  __builtin_va_start(v, n);\n  n += __builtin_va_arg(v, int);\n  "
     "return "
     "__builtin_va_arg(v, struct S).a[n];\n}\n",
     "bad.c:6:10: error: va_arg of a type that is aligned to more than 4 bytes"},
    {"EnormousArgument",
     "struct S { int a[5000]; };\nvoid g(struct S);\nvoid f(struct S *s) {\n  g(*s);\n}\n",
     "bad.c:4:3: error: a struct of 20000 bytes is passed by value; pass its address"},
    {"DifferenceOfLabels",
     "int f(int i) {\n  static const int to[] = {0, &&b - &&a};\n  goto *(&&a + to[i]);\na:\n  "
     "return 1;\nb:\n  return 2;\n}\n",
     "error: a difference of addresses in what 'f.to' begins with is not supported"},
    {"EnormousFrame", "void g(char *);\nvoid f(void) {\n  char a[300000];\n  g(a);\n}\n",
     "bad.c:2:1: error: the stack frame of"},
};

TEST_F(CompilerTest, CodeBeforeMainIsAnError) {
  write("bad.cpp", "struct A {\n  int x;\n  A() : x(f()) {}\n  static int f();\n};\nA a;\n");
  const Finished finished = cc({"-o", "bad.bir", "bad.cpp"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("want code before main"), std::string::npos) << finished.err;
}

TEST_F(CompilerTest, CppHasNoExceptionsAndNoTypeInformation) {
  write("bad.cpp", "int f() {\n  throw 1;\n}\n");
  EXPECT_NE(cc({"-o", "bad.bir", "bad.cpp"}).err.find("bad.cpp:2:3: error: cannot use 'throw'"),
            std::string::npos);
}

class Diagnostics : public CompilerTest, public ::testing::WithParamInterface<Case> {};

TEST_P(Diagnostics, NamesTheLine) {
  write("bad.c", GetParam().source);
  for (const char* level : {"-O0", "-O2"}) {
    const Finished finished = cc({level, "-o", "bad.bir", "bad.c"});
    EXPECT_EQ(finished.exit_code, 2) << level;
    EXPECT_NE(finished.err.find(GetParam().message), std::string::npos) << finished.err;
    EXPECT_FALSE(std::filesystem::exists(folder() / "bad.bir"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Diagnostics, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace finback::compiler
