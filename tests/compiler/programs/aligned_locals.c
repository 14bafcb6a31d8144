/* Locals aligned to more than the stack is, beside others, in recursion and with arrays of variable
 * size. */
#include "report.h"

static unsigned misaligned;

static void check(const void *address, unsigned align) {
  misaligned += (unsigned)(unsigned long)address % align != 0;
}

static unsigned nest(unsigned depth) {
  _Alignas(32) unsigned words[5];
  _Alignas(8) char bytes[3];
  unsigned plain = depth;
  check(words, 32);
  check(bytes, 8);
  for (unsigned i = 0; i < 5; i++) words[i] = depth * i + 1;
  bytes[1] = (char)depth;
  if (depth > 0) plain += nest(depth - 1);
  for (unsigned i = 0; i < 5; i++) plain = mix(plain, words[i]);
  return mix(plain, (unsigned)bytes[1]);
}

static unsigned beside_variable(unsigned count) {
  _Alignas(16) long long pair[2] = {count, -(long long)count};
  unsigned char room[count];
  check(pair, 16);
  for (unsigned i = 0; i < count; i++) room[i] = (unsigned char)(i * i);
  unsigned sum = (unsigned)pair[1];
  for (unsigned i = 0; i < count; i++) sum = mix(sum, room[i]);
  return sum;
}

int main(void) {
  report("nest", nest(4));
  report("variable", beside_variable(9) ^ beside_variable(30));
  report("misaligned", misaligned);
  return 0;
}
