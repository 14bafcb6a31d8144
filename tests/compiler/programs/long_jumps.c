/* setjmp and longjmp: out of nested calls, more than once, with what a callee keeps intact. */
#include <setjmp.h>
#include <stdio.h>

static jmp_buf outer;

__attribute__((noinline)) static int descend(int depth, jmp_buf place) {
  volatile int local[8];
  for (int i = 0; i < 8; i++) local[i] = depth * i;
  if (depth == 0) longjmp(place, local[7] + 5);
  return descend(depth - 1, place) + local[3];
}

__attribute__((noinline)) static int guarded(int divisor) {
  jmp_buf place;
  int kept = divisor * 7;
  int code = setjmp(place);
  if (code != 0) return kept + 1000 * code;
  if (divisor == 3) longjmp(outer, 33);
  return descend(divisor, place);
}

int main(void) {
  int a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7, h = 8;
  volatile int round = 0;
  int code = setjmp(outer);
  printf("code %d round %d: %d\n", code, round, a + b * c + d * e + f * g * h);
  round++;
  if (round == 1) longjmp(outer, 0);
  if (round == 2) longjmp(outer, -9);
  if (round == 3) printf("%d\n", guarded(2));
  if (round == 3) printf("%d\n", guarded(3));
  double kept = 0.1;
  jmp_buf again;
  for (volatile int i = 0; i < 3; i++) {
    int now = setjmp(again);
    printf("%d %d %g\n", i, now, kept);
    if (now < i) longjmp(again, now + 1);
  }
  return 0;
}
