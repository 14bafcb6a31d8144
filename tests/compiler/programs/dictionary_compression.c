/* Compression by references to what was before (LZ77 with hash chains) and by a growing dictionary
 * (LZW): packed, unpacked, compared. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
#define WINDOW 255

static short heads[64], previous[600];

static unsigned hash(const u8* p) { return (p[0] * 33u + p[1] * 7u + p[2]) & 63; }

APART static int pack(const u8* in, int size, u8* out) {
  int written = 0, flags_at = 0, flag = 0;
  memset(heads, -1, sizeof heads);
  for (int at = 0; at < size;) {
    int best = 0, from = 0;
    if (flag == 0) {
      flags_at = written++;
      out[flags_at] = 0;
    }
    if (at + 2 < size) {
      int tries = 8;
      for (int candidate = heads[hash(in + at)];
           candidate >= 0 && at - candidate <= WINDOW && tries-- > 0;
           candidate = previous[candidate]) {
        int length = 0;
        while (at + length < size && length < 258 && in[candidate + length] == in[at + length])
          length++;
        if (length > best) {
          best = length;
          from = candidate;
        }
      }
    }
    int step = 1;
    if (best >= 3) {
      out[flags_at] |= (u8)(1 << flag);
      out[written++] = (u8)(at - from);
      out[written++] = (u8)(best - 3);
      step = best;
    } else {
      out[written++] = in[at];
    }
    flag = (flag + 1) & 7;
    for (; step > 0; step--, at++)
      if (at + 2 < size) {
        previous[at] = heads[hash(in + at)];
        heads[hash(in + at)] = (short)at;
      }
  }
  return written;
}
APART static int unpack(const u8* in, int size, u8* out) {
  int written = 0, flags = 0;
  for (int at = 0, flag = 0; at < size; flag = (flag + 1) & 7) {
    if (flag == 0)
      flags = in[at++];
    if (flags >> flag & 1) {
      int distance = in[at], length = in[at + 1] + 3;
      for (at += 2; length > 0; length--, written++)
        out[written] = out[written - distance];
    } else {
      out[written++] = in[at++];
    }
  }
  return written;
}

struct entry {
  short prefix;
  u8 last, length;
};
static struct entry entries[512];
APART static int pack_words(const u8* in, int size, unsigned short* out) {
  int count = 256, written = 0, word = in[0];
  for (int at = 1; at < size; at++) {
    int next = -1;
    for (int i = 256; i < count && next < 0; i++)
      if (entries[i].prefix == word && entries[i].last == in[at])
        next = i;
    if (next >= 0) {
      word = next;
      continue;
    }
    out[written++] = (unsigned short)word;
    if (count < 512)
      entries[count++] = (struct entry){(short)word, in[at], 0};
    word = in[at];
  }
  out[written++] = (unsigned short)word;
  return written;
}
static int write_word(int word, u8* out) {
  u8 letters[64];
  int n = 0;
  for (; word >= 256; word = entries[word].prefix)
    letters[n++] = entries[word].last;
  letters[n++] = (u8)word;
  for (int i = 0; i < n; i++)
    out[i] = letters[n - 1 - i];
  return n;
}

int main(void) {
  static u8 text[600], packed[700], unpacked[600];
  static unsigned short words[600];
  unsigned state = 12, s = 0;
  for (int kind = 0; kind < 4; kind++) {
    int size = kind == 3 ? 5 : 600 - kind;
    for (int i = 0; i < size; i++) {
      unsigned x = next_number(&state);
      text[i] = (u8)(kind == 0         ? "abcabd"[i % 6]
                     : kind == 1       ? x & 3
                     : i > 40 && x % 5 ? text[i - 1 - (int)(x % 40)]
                                       : x);
    }
    int length = pack(text, size, packed), back = unpack(packed, length, unpacked);
    report("length", (unsigned)length);
    report("same", back == size && memcmp(text, unpacked, (size_t)size) == 0);
    for (int i = 0; i < length; i++)
      s = mix(s, packed[i]);
    int count = pack_words(text, size, words), written = 0;
    for (int i = 0; i < count; i++)
      written += write_word(words[i], unpacked + written);
    report("words",
           (unsigned)count * 2 + (written == size && memcmp(text, unpacked, (size_t)size) == 0));
  }
  report("packed", s);
  return 0;
}
