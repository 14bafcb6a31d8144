/* SHA-256 and SHA-512's mixing: rotations, sums of many terms, big-endian words, tables. */
#include <string.h>

#include "report.h"

typedef unsigned long long u64;

static const unsigned k[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

struct hash {
  unsigned state[8];
  u64 length;
  unsigned char block[64];
};

static unsigned rotated(unsigned x, int n) { return x >> n | x << (32 - n); }

APART static void compress(struct hash* h) {
  unsigned w[64], v[8];
  for (int i = 0; i < 16; i++) {
    const unsigned char* p = h->block + 4 * i;
    w[i] = (unsigned)p[0] << 24 | (unsigned)p[1] << 16 | (unsigned)p[2] << 8 | p[3];
  }
  for (int i = 16; i < 64; i++) {
    unsigned a = rotated(w[i - 15], 7) ^ rotated(w[i - 15], 18) ^ w[i - 15] >> 3;
    unsigned b = rotated(w[i - 2], 17) ^ rotated(w[i - 2], 19) ^ w[i - 2] >> 10;
    w[i] = w[i - 16] + a + w[i - 7] + b;
  }
  memcpy(v, h->state, sizeof v);
  for (int i = 0; i < 64; i++) {
    unsigned s1 = rotated(v[4], 6) ^ rotated(v[4], 11) ^ rotated(v[4], 25);
    unsigned t1 = v[7] + s1 + ((v[4] & v[5]) ^ (~v[4] & v[6])) + k[i] + w[i];
    unsigned s0 = rotated(v[0], 2) ^ rotated(v[0], 13) ^ rotated(v[0], 22);
    unsigned t2 = s0 + ((v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]));
    memmove(v + 1, v, 7 * sizeof *v);
    v[4] += t1;
    v[0] = t1 + t2;
  }
  for (int i = 0; i < 8; i++)
    h->state[i] += v[i];
}
static void update(struct hash* h, const void* data, unsigned size) {
  const unsigned char* p = data;
  while (size-- > 0) {
    h->block[h->length++ % 64] = *p++;
    if (h->length % 64 == 0)
      compress(h);
  }
}
static void finish(struct hash* h) {
  u64 bits = h->length * 8;
  unsigned char tail[8];
  update(h, "\x80", 1);
  while (h->length % 64 != 56)
    update(h, "", 1);
  for (int i = 0; i < 8; i++)
    tail[i] = (unsigned char)(bits >> (56 - 8 * i));
  update(h, tail, 8);
}
static void test(const char* name, const char* text, int times) {
  struct hash h = {{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c,
                    0x1f83d9ab, 0x5be0cd19},
                   0,
                   {0}};
  for (int i = 0; i < times; i++)
    update(&h, text, (unsigned)strlen(text));
  finish(&h);
  for (int i = 0; i < 8; i++)
    report(name, h.state[i]);
}
static u64 rotated64(u64 x, int n) { return x >> n | x << (64 - n); }
APART static u64 mixed512(u64 a, u64 e, u64 f, u64 g) {
  u64 s1 = rotated64(e, 14) ^ rotated64(e, 18) ^ rotated64(e, 41),
      s0 = rotated64(a, 28) ^ rotated64(a, 34) ^ rotated64(a, 39);
  return s0 + s1 + ((e & f) ^ (~e & g)) + (rotated64(f, 19) ^ rotated64(f, 61) ^ f >> 6);
}

int main(void) {
  test("abc", "abc", 1);
  test("empty", "", 1);
  test("long", "a message longer than a block: ", 7);
  u64 x = 0x6a09e667f3bcc908ull;
  for (int i = 0; i < 20; i++)
    x = mixed512(x, ~x, x * 3, x + (u64)i);
  report("mixed", mix_long(0, x));
  return 0;
}
