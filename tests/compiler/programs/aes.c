/* AES-128: tables made from the field's arithmetic, key expansion, both ways of a block, and
 * counters as a stream. The known answer is the standard's. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
static u8 box[256], inverse[256];

static u8 times(u8 a, u8 b) {
  u8 product = 0;
  for (; b != 0; b >>= 1) {
    if (b & 1)
      product ^= a;
    a = (u8)(a << 1 ^ (a & 0x80 ? 0x1b : 0));
  }
  return product;
}
static void make_tables(void) {
  u8 p = 1, q = 1;
  do {
    p = (u8)(p ^ p << 1 ^ (p & 0x80 ? 0x1b : 0));
    q ^= (u8)(q << 1);
    q ^= (u8)(q << 2);
    q ^= (u8)(q << 4);
    if (q & 0x80)
      q ^= 0x09;
    unsigned x = q;
    x = x ^ (x << 1 | x >> 7) ^ (x << 2 | x >> 6) ^ (x << 3 | x >> 5) ^ (x << 4 | x >> 4);
    box[p] = (u8)(x ^ 0x63);
  } while (p != 1);
  box[0] = 0x63;
  for (int i = 0; i < 256; i++)
    inverse[box[i]] = (u8)i;
}
APART static void expand(const u8* key, u8 keys[11][16]) {
  u8 *w = keys[0], constant = 1;
  memcpy(w, key, 16);
  for (int i = 16; i < 176; i += 4) {
    u8 t[4];
    memcpy(t, w + i - 4, 4);
    if (i % 16 == 0) {
      u8 first = t[0];
      t[0] = box[t[1]] ^ constant;
      t[1] = box[t[2]];
      t[2] = box[t[3]];
      t[3] = box[first];
      constant = times(constant, 2);
    }
    for (int k = 0; k < 4; k++)
      w[i + k] = w[i + k - 16] ^ t[k];
  }
}
static void add_key(u8* s, const u8* key) {
  for (int i = 0; i < 16; i++)
    s[i] ^= key[i];
}
static void shift_rows(u8* s, int by) {
  u8 t[16];
  for (int i = 0; i < 16; i++)
    t[i] = s[(i + by * 4 * (i & 3)) & 15];
  memcpy(s, t, 16);
}
static void mix_columns(u8* s, u8 a, u8 b, u8 c, u8 d) {
  for (int i = 0; i < 16; i += 4) {
    u8 t[4];
    for (int k = 0; k < 4; k++)
      t[k] = times(s[i + k], a) ^ times(s[i + ((k + 1) & 3)], b) ^ times(s[i + ((k + 2) & 3)], c) ^
             times(s[i + ((k + 3) & 3)], d);
    memcpy(s + i, t, 4);
  }
}
APART static void encrypt(u8* s, u8 keys[11][16]) {
  add_key(s, keys[0]);
  for (int round = 1; round <= 10; round++) {
    for (int i = 0; i < 16; i++)
      s[i] = box[s[i]];
    shift_rows(s, 1);
    if (round < 10)
      mix_columns(s, 2, 3, 1, 1);
    add_key(s, keys[round]);
  }
}
APART static void decrypt(u8* s, u8 keys[11][16]) {
  for (int round = 10; round > 0; round--) {
    add_key(s, keys[round]);
    if (round < 10)
      mix_columns(s, 14, 11, 13, 9);
    shift_rows(s, 3);
    for (int i = 0; i < 16; i++)
      s[i] = inverse[s[i]];
  }
  add_key(s, keys[0]);
}
static unsigned sum_of(const u8* p, int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++)
    s = mix(s, p[i]);
  return s;
}

int main(void) {
  static u8 keys[11][16];
  u8 key[16], block[16];
  make_tables();
  for (int i = 0; i < 16; i++) {
    key[i] = (u8)i;
    block[i] = (u8)(i * 17);
  }
  expand(key, keys);
  encrypt(block, keys);
  for (int i = 0; i < 16; i += 4)
    report("block", (unsigned)block[i] << 24 | (unsigned)block[i + 1] << 16 |
                        (unsigned)block[i + 2] << 8 | block[i + 3]);
  decrypt(block, keys);
  report("back", sum_of(block, 16));
  char text[] = "a text that is longer than one block of the cipher";
  u8 counter[16] = {0};
  for (unsigned i = 0; i < sizeof text; i++) {
    if (i % 16 == 0) {
      counter[0]++;
      memcpy(block, counter, 16);
      encrypt(block, keys);
    }
    text[i] = (char)((u8)text[i] ^ block[i % 16]);
  }
  report("stream", sum_of((u8*)text, sizeof text));
  report("tables", mix(sum_of(box, 256), sum_of(inverse, 256)));
  return 0;
}
