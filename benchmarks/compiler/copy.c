/* Copies bytes between places that do not overlap: by words where both are aligned. */
#include <stdint.h>

void copy(void* restrict destination, const void* restrict source, unsigned bytes) {
  uint8_t* restrict to = destination;
  const uint8_t* restrict from = source;
  if ((((uintptr_t)to | (uintptr_t)from) & 3) == 0) {
    uint32_t* restrict to_word = (uint32_t*)to;
    const uint32_t* restrict from_word = (const uint32_t*)from;
    for (unsigned words = bytes / 4; words != 0; --words) {
      *to_word++ = *from_word++;
    }
    to = (uint8_t*)to_word;
    from = (const uint8_t*)from_word;
    bytes %= 4;
  }
  for (; bytes != 0; --bytes) {
    *to++ = *from++;
  }
}
