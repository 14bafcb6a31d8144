/* Random numbers: congruences of 32 and 64 bits, shifts and exclusive ors, Mersenne's twister, a
 * lagged sum, a cipher of eight bits, shuffles and draws without bias, tests of what comes out. */
#include "report.h"

typedef unsigned long long u64;

static unsigned twister[624];
static int twister_at;
static void seed_twister(unsigned seed) {
  twister[0] = seed;
  for (unsigned i = 1; i < 624; i++)
    twister[i] = 1812433253u * (twister[i - 1] ^ twister[i - 1] >> 30) + i;
  twister_at = 624;
}
APART static unsigned next_twister(void) {
  if (twister_at == 624) {
    for (int i = 0; i < 624; i++) {
      unsigned y = (twister[i] & 0x80000000u) | (twister[(i + 1) % 624] & 0x7fffffff);
      twister[i] = twister[(i + 397) % 624] ^ y >> 1 ^ (y & 1 ? 0x9908b0dfu : 0);
    }
    twister_at = 0;
  }
  unsigned y = twister[twister_at++];
  y ^= y >> 11;
  y ^= y << 7 & 0x9d2c5680u;
  y ^= y << 15 & 0xefc60000u;
  return y ^ y >> 18;
}
APART static unsigned xorshift(unsigned* s) {
  unsigned t = s[3], first = s[0];
  s[3] = s[2];
  s[2] = s[1];
  s[1] = first;
  t ^= t << 11;
  t ^= t >> 8;
  return s[0] = t ^ first ^ first >> 19;
}
APART static unsigned permuted(u64* state) {
  u64 old = *state;
  *state = old * 6364136223846793005ull + 1442695040888963407ull;
  unsigned x = (unsigned)((old >> 18 ^ old) >> 27), turn = (unsigned)(old >> 59);
  return x >> turn | x << (-turn & 31);
}
APART static u64 split(u64* state) {
  u64 z = *state += 0x9e3779b97f4a7c15ull;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ z >> 27) * 0x94d049bb133111ebull;
  return z ^ z >> 31;
}
APART static unsigned minimal(unsigned x) {
  int next = (int)(16807 * (x % 127773)) - (int)(2836 * (x / 127773));
  return (unsigned)(next <= 0 ? next + 2147483647 : next);
}
struct cipher {
  unsigned char s[256], i, j;
};
static void key(struct cipher* c, const char* text, unsigned length) {
  for (int i = 0; i < 256; i++)
    c->s[i] = (unsigned char)i;
  for (unsigned i = 0, j = 0; i < 256; i++) {
    j = (j + c->s[i] + (unsigned char)text[i % length]) & 255;
    unsigned char t = c->s[i];
    c->s[i] = c->s[j];
    c->s[j] = t;
  }
  c->i = c->j = 0;
}
APART static unsigned char next_byte(struct cipher* c) {
  unsigned char t = c->s[++c->i];
  c->j = (unsigned char)(c->j + t);
  c->s[c->i] = c->s[c->j];
  c->s[c->j] = t;
  return c->s[(unsigned char)(c->s[c->i] + t)];
}
APART static unsigned below(u64* state, unsigned limit) {
  unsigned least = -limit % limit, x;
  do
    x = permuted(state);
  while (x < least);
  return x % limit;
}
APART static unsigned by_product(u64* state, unsigned limit) {
  return (unsigned)((u64)permuted(state) * limit >> 32);
}
static void shuffle(unsigned char* p, unsigned n, u64* state) {
  for (unsigned i = n; i > 1; i--) {
    unsigned k = below(state, i);
    unsigned char t = p[i - 1];
    p[i - 1] = p[k];
    p[k] = t;
  }
}

int main(void) {
  unsigned s = 0, words[4] = {1, 2, 3, 4};
  seed_twister(5489);
  report("first", next_twister());
  for (int i = 1; i < 1000; i++)
    s = next_twister();
  report("thousandth", s);
  for (int i = 0; i < 100; i++)
    s = mix(s, xorshift(words));
  report("xorshift", s);
  u64 state = 42, other = 7;
  for (int i = 0; i < 100; i++)
    s = mix_long(mix(s, permuted(&state)), split(&other));
  report("permuted", s);
  unsigned x = 1;
  for (int i = 0; i < 10000; i++)
    x = minimal(x);
  report("minimal", x);
  struct cipher cipher;
  key(&cipher, "Key", 3);
  for (int i = 0; i < 50; i++)
    s = mix(s, next_byte(&cipher));
  report("cipher", s);
  unsigned char deck[52];
  for (int i = 0; i < 52; i++)
    deck[i] = (unsigned char)i;
  shuffle(deck, 52, &state);
  for (int i = 0; i < 52; i++)
    s = mix(s, deck[i]);
  report("deck", s);
  int counts[6] = {0}, chi = 0;
  for (int i = 0; i < 600; i++)
    counts[i & 1 ? below(&state, 6) : by_product(&state, 6)]++;
  for (int i = 0; i < 6; i++)
    chi += (counts[i] - 100) * (counts[i] - 100);
  report("dice", (unsigned)chi);
  return 0;
}
