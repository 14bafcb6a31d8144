/* Inline assembly: data and pointer registers, halves, memory, numbers, clobbers, a call. The host has
 * the same in C. */
#include "report.h"

#ifdef __FINBACK__
#define ON_MACHINE(assembly, otherwise) assembly
#else
#define ON_MACHINE(assembly, otherwise) otherwise
#endif

static int count_ones(unsigned word) {
  int count;
  ON_MACHINE(__asm__("%h0 = ONES %1; %0 = %h0 (Z);" : "=d"(count) : "d"(word)),
             count = __builtin_popcount(word));
  return count;
}

static int element(const int *table, int index) {
  int value;
  ON_MACHINE(__asm__ volatile("%0 = %1 << 2;\n\t%0 = %0 + %2;\n\t%0 = [%0]"
                              : "=&a"(value)
                              : "a"(index), "a"(table)
                              : "memory"),
             value = table[index]);
  return value;
}

static int through_memory(int *pair) {
  int value;
  ON_MACHINE(__asm__("%0 = %1;" : "=d"(value) : "m"(pair[0])), value = pair[0]);
  ON_MACHINE(__asm__("%0 = %1;" : "=m"(pair[1]) : "d"(value + 1)), pair[1] = value + 1);
  return value;
}

static int clobbers(int value, int kept) {
  ON_MACHINE(__asm__("%0 += %1;" : "+d"(value) : "i"(5)), value += 5);
  ON_MACHINE(__asm__("R4 = %1; %0 = R4 + R4;" : "=r"(value) : "r"(value) : "R4", "CC", "A0"),
             value += value);
  return value * 100 + kept;
}

/* Both halves of a packet, and a data and a pointer register in one statement. */
static int sum_of(const short *values, int count) {
  int sum = 0;
  for (int i = 0; i < count; i++) {
    int value = 0;
    ON_MACHINE(__asm__ volatile("%0 = W[%1++] (X);" : "=d"(value), "+a"(values) : : "memory"),
               value = *values++);
    sum += value;
  }
  return sum;
}

#ifdef __FINBACK__
__attribute__((used, noinline)) int twice(int value) { return 2 * value; }
#endif

static int calls(int value) {
  int result;
  ON_MACHINE(__asm__ volatile("R0 = %1; CALL _twice; %0 = R0;"
                              : "=d"(result)
                              : "d"(value)
                              : "R0", "R1", "R2", "R3", "P0", "P1", "P2", "CC", "ASTAT", "RETS",
                                "LC0", "LC1", "memory"),
             result = 2 * value);
  return result + value;
}

/* A thousand bytes and more of it: branches across are far, and loops around are long. */
#define TEN(text) text text text text text text text text text text
static int across(int value) {
  int sum = 0;
  for (int i = 0; i < 3; i++) {
    if (value & 1 << i) {
      ON_MACHINE(__asm__ volatile(TEN(TEN("NOP; NOP; NOP; NOP; NOP; NOP; NOP;\n")) : : : "memory"),
                 (void)0);
      sum += value + i;
    }
  }
  return sum;
}

int main(void) {
  static const int table[] = {1, 20, 3, 44};
  static const short shorts[] = {-3, 700, -30000, 5};
  int pair[2] = {7, 0};
  report("ones", count_ones(0xff0f));
  report("element", element(table, 3));
  report("memory", through_memory(pair));
  report("stored", pair[1]);
  report("clobbers", clobbers(9, 4));
  report("sum", sum_of(shorts, 4));
  report("call", calls(21));
  report("across", across(5));
  __asm__ volatile("" ::: "memory");
  __asm__("nop");
  return 0;
}
