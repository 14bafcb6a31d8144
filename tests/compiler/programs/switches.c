/* Switches dense and sparse, with falling through, as a state machine. */
#include "report.h"
__attribute__((noinline)) static int dense(int x) {
  switch (x) {
    case 0: return 11;
    case 1: return -5;
    case 2: return x * 7;
    case 3:
    case 4: return 99;
    case 5: x += 3; /* fall through */
    case 6: return x + 1000;
    case 7: return 1 << x;
    default: return -1;
  }
}
__attribute__((noinline)) static int sparse(int x) {
  switch (x) {
    case -1000: return 1;
    case 3: return 2;
    case 77: return 3;
    case 1024: return 4;
    case 65536: return 5;
    case 0x7fffffff: return 6;
    default: return 7;
  }
}
__attribute__((noinline)) static unsigned machine(const char *p) {
  enum { START, NUMBER, WORD, END } state = START;
  unsigned n = 0, words = 0, sum = 0;
  for (; state != END; p++) {
    switch (state) {
      case START:
        if (*p >= '0' && *p <= '9') state = NUMBER, n = (unsigned)(*p - '0');
        else if (*p == 0) state = END;
        else if (*p != ' ') state = WORD;
        break;
      case NUMBER:
        if (*p >= '0' && *p <= '9') n = n * 10 + (unsigned)(*p - '0');
        else sum = mix(sum, n), state = *p ? START : END;
        break;
      case WORD:
        if (*p == ' ' || *p == 0) words++, state = *p ? START : END;
        break;
      default: break;
    }
  }
  return mix(sum, words);
}
int main(void) {
  unsigned s = 0;
  for (int i = -3; i < 12; i++) s = mix(s, (unsigned)dense(i));
  report("dense", s);
  static const int keys[] = {-1000, 3, 77, 1024, 65536, 0x7fffffff, 0, -1, 78, 1023};
  for (unsigned i = 0; i < sizeof keys / sizeof *keys; i++) s = mix(s, (unsigned)sparse(keys[i]));
  report("sparse", s);
  report("machine", machine("12 abc 345 de 6 f 70000 gh"));
  return 0;
}
