/* How a program of the differential tests says what it found: a line a value, the same on the host
 * and on the simulated machine. */
#ifndef REPORT_H
#define REPORT_H

#ifdef __FINBACK__
#define CONSOLE (*(volatile unsigned *)0xFFC0F01Cu)
static inline void report_char(char c) { CONSOLE = (unsigned char)c; }
#else
#ifdef __cplusplus
extern "C"
#endif
    int
    putchar(int);
static inline void report_char(char c) { putchar(c); }
#endif

static void report(const char *name, unsigned value) {
  while (*name != 0)
    report_char(*name++);
  report_char(' ');
  for (int shift = 28; shift >= 0; shift -= 4)
    report_char("0123456789abcdef"[value >> shift & 15]);
  report_char('\n');
}

/* Mixes a value into a checksum. */
static inline unsigned mix(unsigned sum, unsigned value) {
  sum ^= value + 0x9e3779b9u + (sum << 6) + (sum >> 2);
  return sum;
}

static inline unsigned mix_long(unsigned sum, unsigned long long value) {
  return mix(mix(sum, (unsigned)value), (unsigned)(value >> 32));
}

/* A function that is called, with arguments that its body cannot know. */
#define APART __attribute__((noinline))

/* A generator of numbers; the seed is the caller's. */
static inline unsigned next_number(unsigned *state) {
  *state = *state * 1664525u + 1013904223u;
  return *state >> 8;
}

#endif
