/* printf of integers, characters and texts; snprintf's room. */
#include <stdio.h>
#include <string.h>

int main(void) {
  static const int values[] = {0, 1, -1, 42, -12345, 2147483647, -2147483647 - 1};
  for (unsigned i = 0; i < sizeof values / sizeof *values; i++) {
    int v = values[i];
    printf("%d %i %u %x %X %o %c|\n", v, v, (unsigned)v, (unsigned)v, (unsigned)v, (unsigned)v,
           'a' + (v & 15));
    printf("[%8d][%-8d][%08d][%+d][% d][%.5d][%12.7d][%-+9d]\n", v, v, v, v, v, v, v, v);
    printf("[%#x][%#o][%#X][%#010x][%10x][%.0d]\n", (unsigned)v, (unsigned)v, (unsigned)v,
           (unsigned)v, (unsigned)v, v);
    printf("%hd %hhd %hu %hhx\n", (short)v, (signed char)v, (unsigned short)v, (unsigned char)v);
    printf("%lld %llu %llx %20lld %-20lld|\n", v * 1000000007ll, v * 1000000007ull,
           v * 0x100000001ull, v * 99999999ll, v * 12345678ll);
    printf("%zu %*d %-*d| %.*d\n", sizeof(int), 7, v, 7, v, 4, v);
  }
  printf("%s|%10s|%-10s|%.3s|%10.2s|%%\n", "text", "right", "left", "shortened", "ab");
  char small[8];
  int length = snprintf(small, sizeof small, "%s-%d", "overlong", 12345);
  printf("%s %d %d\n", small, length, snprintf(NULL, 0, "%05d", 7));
  memset(small, 'x', sizeof small);
  length = snprintf(small, 0, "nothing");
  printf("%d %c\n", length, small[0]);
  char large[40];
  printf("%d ", sprintf(large, "%d/%s", 17, "parts"));
  puts(large);
  return 0;
}
