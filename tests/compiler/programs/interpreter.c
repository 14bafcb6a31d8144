/* A byte-code interpreter: a switch in a loop, a stack in memory. */
#include "report.h"
enum { PUSH, ADD, MUL, SUB, DUP, SWAP, JNZ, DEC, OUT, HALT };
static const signed char code[] = {PUSH, 1, PUSH, 10, DUP, JNZ, 9, OUT, HALT, DUP, SWAP, DEC, SWAP, PUSH, 3, MUL, ADD, PUSH, 7, SUB, DUP, OUT, HALT};
static int stack[32];
static unsigned output;
__attribute__((noinline)) static int run(const signed char *p, int limit) {
  int sp = 0, pc = 0, steps = 0;
  while (steps++ < limit) {
    switch (p[pc++]) {
      case PUSH: stack[sp++] = p[pc++]; break;
      case ADD: sp--; stack[sp - 1] += stack[sp]; break;
      case SUB: sp--; stack[sp - 1] -= stack[sp]; break;
      case MUL: sp--; stack[sp - 1] *= stack[sp]; break;
      case DUP: stack[sp] = stack[sp - 1]; sp++; break;
      case SWAP: { int t = stack[sp - 1]; stack[sp - 1] = stack[sp - 2]; stack[sp - 2] = t; break; }
      case DEC: stack[sp - 1]--; break;
      case JNZ: if (stack[--sp]) pc = p[pc]; else pc++; break;
      case OUT: output = mix(output, (unsigned)stack[sp - 1]); break;
      case HALT: return steps;
    }
  }
  return -1;
}
int main(void) {
  report("steps", (unsigned)run(code, 1000));
  report("output", output);
  return 0;
}
