/* The checksum CRC-32 of Ethernet and zip, a byte at a time by a table of 256 remainders. */
#include <stdint.h>

uint32_t crc32(const uint8_t* restrict data, unsigned bytes, const uint32_t* restrict table) {
  uint32_t crc = 0xffffffff;
  for (; bytes != 0; --bytes) {
    crc = table[(crc ^ *data++) & 0xff] ^ crc >> 8;
  }
  return ~crc;
}
