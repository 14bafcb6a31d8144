/* memcpy, memmove, memset: by words where the alignment allows. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static int is_aligned(const void* one, const void* other) {
  return (((uintptr_t)one | (uintptr_t)other) & 3) == 0;
}

void* memcpy(void* restrict destination, const void* restrict source, size_t bytes) {
  uint8_t* to = destination;
  const uint8_t* from = source;
  if (is_aligned(to, from)) {
    uint32_t* to_word = (uint32_t*)to;
    const uint32_t* from_word = (const uint32_t*)from;
    for (size_t words = bytes / 4; words != 0; --words) {
      *to_word++ = *from_word++;
    }
    to = (uint8_t*)to_word;
    from = (const uint8_t*)from_word;
    bytes %= 4;
  }
  for (; bytes != 0; --bytes) {
    *to++ = *from++;
  }
  return destination;
}

void* memmove(void* destination, const void* source, size_t bytes) {
  uint8_t* to = destination;
  const uint8_t* from = source;
  if (to <= from) {
    for (; bytes != 0; --bytes) {
      *to++ = *from++;
    }
    return destination;
  }
  to += bytes;
  from += bytes;
  for (; bytes != 0; --bytes) {
    *--to = *--from;
  }
  return destination;
}

void* memset(void* destination, int value, size_t bytes) {
  uint8_t* to = destination;
  if (is_aligned(to, to)) {
    uint32_t* to_word = (uint32_t*)to;
    uint32_t pattern = (uint8_t)value * 0x01010101u;
    for (size_t words = bytes / 4; words != 0; --words) {
      *to_word++ = pattern;
    }
    to = (uint8_t*)to_word;
    bytes %= 4;
  }
  for (; bytes != 0; --bytes) {
    *to++ = (uint8_t)value;
  }
  return destination;
}
