/* A receiver of frames as firmware has it: a state machine byte by byte, escapes, lengths, CRC of
 * 16 and 32 bits, a ring of received frames, time-outs; good and bad streams. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
enum state { waiting, length, payload, check_low, check_high };
struct frame {
  u8 length, data[15];
};
struct receiver {
  enum state state;
  u8 escaped, at, age;
  unsigned short sum, received;
  struct frame current, ring[4];
  volatile u8 head, tail;
  unsigned good, bad_sum, too_long, overruns, timeouts;
};

APART static unsigned short crc16(unsigned short crc, u8 byte) {
  crc ^= (unsigned short)(byte << 8);
  for (int i = 0; i < 8; i++)
    crc = (unsigned short)(crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1);
  return crc;
}
APART static unsigned crc32(const u8* p, int n) {
  static unsigned table[256];
  if (table[1] == 0)
    for (unsigned i = 0; i < 256; i++) {
      unsigned x = i;
      for (int k = 0; k < 8; k++)
        x = x >> 1 ^ (0xedb88320 & -(x & 1));
      table[i] = x;
    }
  unsigned crc = ~0u;
  while (n-- > 0)
    crc = crc >> 8 ^ table[(crc ^ *p++) & 255];
  return ~crc;
}
static void finish(struct receiver* r) {
  r->state = waiting;
  if (r->received != r->sum) {
    r->bad_sum++;
  } else if ((u8)(r->head - r->tail) == 4) {
    r->overruns++;
  } else {
    r->ring[r->head & 3] = r->current;
    r->head++;
    r->good++;
  }
}
APART static void receive(struct receiver* r, u8 byte) {
  r->age = 0;
  if (byte == 0x7e) {
    r->state = length;
    r->escaped = 0;
    r->sum = 0xffff;
    return;
  }
  if (byte == 0x7d) {
    r->escaped = 1;
    return;
  }
  if (r->escaped)
    byte ^= 0x20;
  r->escaped = 0;
  switch (r->state) {
    case waiting:
      return;
    case length:
      if (byte > sizeof r->current.data) {
        r->too_long++;
        r->state = waiting;
        return;
      }
      r->current.length = byte;
      r->at = 0;
      r->state = byte == 0 ? check_low : payload;
      break;
    case payload:
      r->current.data[r->at++] = byte;
      if (r->at == r->current.length)
        r->state = check_low;
      break;
    case check_low:
      r->received = byte;
      r->state = check_high;
      return;
    case check_high:
      r->received |= (unsigned short)(byte << 8);
      finish(r);
      return;
  }
  r->sum = crc16(r->sum, byte);
}
static void tick(struct receiver* r) {
  if (r->state != waiting && ++r->age == 3) {
    r->timeouts++;
    r->state = waiting;
  }
}
static int put(u8* out, u8 byte) {
  if (byte != 0x7e && byte != 0x7d)
    return out[0] = byte, 1;
  out[0] = 0x7d;
  out[1] = byte ^ 0x20;
  return 2;
}
APART static int send(u8* out, const u8* data, int n) {
  u8* start = out;
  unsigned short sum = crc16(0xffff, (u8)n);
  *out++ = 0x7e;
  out += put(out, (u8)n);
  for (int i = 0; i < n; i++) {
    sum = crc16(sum, data[i]);
    out += put(out, data[i]);
  }
  out += put(out, (u8)sum);
  out += put(out, (u8)(sum >> 8));
  return (int)(out - start);
}

int main(void) {
  static struct receiver r;
  static u8 line[60], data[20];
  unsigned state = 44, s = 0;
  for (int i = 0; i < 90; i++) {
    int n = i % 16;
    for (int k = 0; k < n; k++)
      data[k] = (u8)(i % 7 == 0 ? 0x7c + k % 4 : (int)next_number(&state));
    int size = send(line, data, n);
    if (i % 10 == 3)
      line[next_number(&state) % (unsigned)size] ^= 4;
    if (i % 13 == 5)
      size /= 2;
    for (int k = 0; k < size; k++)
      receive(&r, line[k]);
    for (int k = 0; k < i % 5; k++)
      tick(&r);
    while (i % 6 == 5 && r.tail != r.head) {
      const struct frame* f = &r.ring[r.tail++ & 3];
      s = mix(s, crc32(f->data, f->length));
    }
  }
  report("frames", s);
  report("counts",
         r.good * 10000 + r.bad_sum * 1000 + r.overruns * 100 + r.timeouts * 10 + r.too_long);
  report("crc32", crc32((const u8*)"123456789", 9));
  return 0;
}
