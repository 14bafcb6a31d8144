/* Addresses: indices scaled by every size, constant and variable offsets, of both signs and large,
 * members of elements, pointers that step up and down by one and by more, before and after, in one
 * loop. */
#include "report.h"

struct s6 {
  short a, b, c;
};
struct s20 {
  int a[3];
  char b;
  short c;
  signed char d[4];
};
static char c1[200];
static short c2[200];
static int c4[200];
static long long c8[40];
static struct s6 s6[40];
static struct s20 s20[40];
static int far_array[40000];

APART static int indexed(int i, unsigned j, short k, unsigned char l) {
  return c1[i] + c2[i + 1] + c4[i - 1] + (int)c8[j / 8] + s6[j % 40].b + s20[k].c +
         s20[l].d[i & 3] + c4[k * 3] + c2[j - 5u] + c1[2 * i + k];
}
APART static int offsets(const int* p, const short* q, const signed char* r) {
  return p[0] + p[1] + p[-1] + p[40] + p[-40] + q[5] + q[-7] + q[60] + q[-60] + r[3] + r[-3] +
         r[90] + r[-90];
}
APART static int far(const int* p, int i) {
  return p[30000] + p[i + 20000] + p[i * 1000] + *(p + 39999) + p[16384] + p[8191];
}
APART static int steps(const int* p, const short* q, const signed char* r, int n) {
  int s = 0;
  const short* end = q + 3 * n;
  while (q < end) {
    s = s * 3 + *p++ - *q;
    s ^= *--r;
    q += 3;
    s += *q++ & 15;
    p += s & 1;
    end += 1;
    s &= 0xffffff;
  }
  return s;
}
APART static int before_and_after(int* p, int n) {
  int s = 0, *q = p + n;
  for (int i = 0; i < n / 4; i++) {
    s += *++p;
    s -= *p--;
    s ^= *p++ * 3;
    *--q += s;
    s += q[-1];
    *q-- ^= 5;
  }
  return s;
}
APART static int members(struct s20* p, int n) {
  int s = 0;
  for (; n > 0; n--, p++) {
    p->c = (short)(p->a[n % 3] + p->b);
    p->d[n & 3]++;
    s += p->c - p->d[3] + p[-1].a[2] + (&p->a[0])[1] + p[1].b;
  }
  return s;
}
APART static int gathered(const unsigned char* at, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s = (s + c4[at[i]] * c2[at[i] ^ 1] - s6[at[i] % 40].c) & 0xffffff;
  return s;
}
APART static void scattered(const unsigned char* at, int n) {
  for (int i = 0; i < n; i++) {
    c4[at[i]] += i;
    s20[at[i] % 40].d[i & 3] = (signed char)i;
    c8[at[i] % 40] ^= (long long)i << 33;
  }
}
APART static int strided(const short* p, int stride, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s += p[i * stride] - p[(n - i) * stride / 2];
  return s;
}
APART static int** rows(int** p, int n) {
  while (n-- > 0)
    **p++ += n;
  return p;
}

int main(void) {
  unsigned char at[50];
  for (int i = 0; i < 200; i++) {
    c1[i] = (char)(i * 3);
    c2[i] = (short)(i * 31 - 700);
    c4[i] = i * i - 9999;
    at[i / 4] = (unsigned char)(i * 7 % 199);
  }
  for (int i = 0; i < 40; i++) {
    c8[i] = i * 0x123456789ll;
    s6[i] = (struct s6){(short)i, (short)(i * 2), (short)(-i)};
    s20[i] = (struct s20){{i, i * 5, -i}, (char)i, (short)(i * 9), {1, 2, 3, (signed char)i}};
  }
  for (int i = 0; i < 40000; i += 77)
    far_array[i] = i;
  far_array[30000] = far_array[39999] = far_array[16384] = far_array[8191] = 5;
  unsigned s = 0;
  for (int i = 1; i < 39; i++)
    s = mix(s, (unsigned)indexed(i, (unsigned)i * 5, (short)(39 - i), (unsigned char)i));
  report("indexed", s);
  report("offsets", (unsigned)offsets(c4 + 100, c2 + 100, (signed char*)c1 + 100));
  report("far", (unsigned)(far(far_array, 7) + far(far_array, 38)));
  report("steps", (unsigned)steps(c4, c2, (signed char*)c1 + 150, 30));
  report("turns", (unsigned)before_and_after(c4 + 20, 80));
  report("members", (unsigned)members(s20 + 1, 38));
  report("gathered", (unsigned)gathered(at, 50));
  scattered(at, 50);
  for (int i = 0; i < 40; i++)
    s = mix_long(mix(s, (unsigned)(c4[i * 5] + s20[i].d[i & 3])), (unsigned long long)c8[i]);
  report("scattered", s);
  report("strided", (unsigned)(strided(c2, 3, 60) + strided(c2 + 199, -2, 90)));
  int* pointers[3] = {&c4[3], &c4[9], &c4[3]};
  report("rows", (unsigned)(rows(pointers, 3) - pointers) + (unsigned)c4[3]);
  return 0;
}
