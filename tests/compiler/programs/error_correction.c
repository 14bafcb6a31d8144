/* Codes that mend errors: Hamming's with parity, a repetition by majority, Reed and Solomon's over
 * the field of 256 with one and two errors, check digits, Gray, a convolutional code and its
 * decoder. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
static u8 logarithms[256], powers[510];

static void make_field(void) {
  unsigned x = 1;
  for (int i = 0; i < 255; i++) {
    powers[i] = powers[i + 255] = (u8)x;
    logarithms[x] = (u8)i;
    x = x << 1 ^ (x & 0x80 ? 0x11d : 0);
  }
}
static u8 times(u8 a, u8 b) { return a == 0 || b == 0 ? 0 : powers[logarithms[a] + logarithms[b]]; }
static u8 over(u8 a, u8 b) { return a == 0 ? 0 : powers[logarithms[a] + 255 - logarithms[b]]; }

APART static unsigned hamming(unsigned data) { /* 11 bits to 16 */
  unsigned word = 0, bit = 0, check = 0;
  for (unsigned i = 3; i < 16; i++)
    if (i & (i - 1))
      word |= (data >> bit++ & 1) << i;
  for (unsigned i = 1; i < 16; i++)
    if (word >> i & 1)
      check ^= i;
  for (unsigned i = 1; i < 16; i <<= 1)
    if (check & i)
      word |= 1u << i;
  return word | (unsigned)__builtin_parity(word);
}
APART static int mended(unsigned word, unsigned* data) {
  unsigned check = 0, bit = 0;
  int even = __builtin_parity(word) == 0, result = 0;
  for (unsigned i = 1; i < 16; i++)
    if (word >> i & 1)
      check ^= i;
  if (check != 0 && even)
    return -1;
  if (!even) {
    word ^= 1u << check;
    result = 1;
  }
  *data = 0;
  for (unsigned i = 3; i < 16; i++)
    if (i & (i - 1))
      *data |= (word >> i & 1) << bit++;
  return result;
}
APART static void protect(u8* block, int n) { /* four bytes behind n */
  static const u8 generator[4] = {15, 54, 120, 64};
  u8 rest[4] = {0};
  for (int i = 0; i < n; i++) {
    u8 lead = block[i] ^ rest[0];
    for (int k = 0; k < 4; k++)
      rest[k] = (u8)((k < 3 ? rest[k + 1] : 0) ^ times(lead, generator[k]));
  }
  memcpy(block + n, rest, 4);
}
APART static int repair(u8* block, int n) {
  u8 s[4] = {0};
  for (int k = 0; k < 4; k++)
    for (int i = 0; i < n; i++)
      s[k] = times(s[k], powers[k]) ^ block[i];
  if (!(s[0] | s[1] | s[2] | s[3]))
    return 0;
  u8 determinant = times(s[1], s[1]) ^ times(s[0], s[2]), p, q;
  if (determinant == 0) {
    if (s[0] == 0 || s[1] == 0)
      return -1;
    int at = n - 1 - logarithms[over(s[1], s[0])];
    if (at < 0)
      return -1;
    block[at] ^= s[0];
    return 1;
  }
  p = over(times(s[1], s[2]) ^ times(s[0], s[3]), determinant);
  q = over(times(s[2], s[2]) ^ times(s[1], s[3]), determinant);
  int places[2], found = 0;
  for (int i = 0; i < n && found < 2; i++) {
    u8 x = powers[n - 1 - i];
    if ((times(x, x) ^ times(p, x) ^ q) == 0)
      places[found++] = i;
  }
  if (found < 2)
    return -1;
  u8 x = powers[n - 1 - places[0]], y = powers[n - 1 - places[1]],
     b = over(s[1] ^ times(s[0], x), x ^ y);
  block[places[0]] ^= s[0] ^ b;
  block[places[1]] ^= b;
  return 2;
}
APART static int check_digit(const char* digits) {
  int sum = 0, twice = 1;
  for (int i = (int)strlen(digits) - 1; i >= 0; i--, twice = !twice) {
    int d = (digits[i] - '0') << twice;
    sum += d > 9 ? d - 9 : d;
  }
  return (10 - sum % 10) % 10;
}

int main(void) {
  unsigned s = 0, data;
  make_field();
  for (unsigned x = 0; x < 2048; x += 123)
    for (int bit = -1; bit < 16; bit++) {
      unsigned word = hamming(x) ^ (bit < 0 ? 0 : 1u << bit);
      s = mix(s, (unsigned)mended(word, &data));
      s += data != x;
      s += (unsigned)mended(word ^ (bit == 7 ? 0x1000 : 0x80), &data) * 3;
    }
  report("hamming", s);
  unsigned state = 21, same = 0;
  for (int round = 0; round < 30; round++) {
    u8 block[40], kept[40];
    int n = 10 + round;
    for (int i = 0; i < n - 4; i++)
      block[i] = (u8)next_number(&state);
    protect(block, n - 4);
    memcpy(kept, block, (unsigned)n);
    for (int k = 0; k < round % 3; k++)
      block[next_number(&state) % (unsigned)n] ^= (u8)(1 + next_number(&state) % 255);
    s = mix(s, (unsigned)repair(block, n));
    same += memcmp(block, kept, (unsigned)n) == 0;
  }
  report("repaired", same);
  report("blocks", s);
  report("digits", (unsigned)(check_digit("7992739871") * 10 + check_digit("401288888888188")));
  return 0;
}
