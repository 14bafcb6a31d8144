/* qsort and bsearch over elements of several sizes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

struct record {
  short key;
  char name[9];
};

static int by_number(const void *a, const void *b) {
  int x = *(const int *)a, y = *(const int *)b;
  return (x > y) - (x < y);
}
static int by_text(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}
static int by_key(const void *a, const void *b) {
  return ((const struct record *)a)->key - ((const struct record *)b)->key;
}
static int by_value(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}
static int by_byte(const void *a, const void *b) {
  return *(const unsigned char *)b - *(const unsigned char *)a;
}

int main(void) {
  static int numbers[500];
  unsigned state = 9;
  for (int count = 0; count <= 500; count += count < 10 ? 1 : 245) {
    for (int i = 0; i < count; i++) numbers[i] = (int)next_number(&state) % 1000 - 500;
    qsort(numbers, (size_t)count, sizeof *numbers, by_number);
    unsigned sum = 0;
    for (int i = 0; i < count; i++) sum = mix(sum, (unsigned)numbers[i]);
    report("numbers", sum);
    int found = 0;
    for (int key = -510; key < 510; key += 3) {
      int *at = bsearch(&key, numbers, (size_t)count, sizeof *numbers, by_number);
      found += at != NULL && *at == key;
    }
    report("found", (unsigned)found);
  }
  const char *words[] = {"pear", "apple", "fig", "banana", "cherry", "date", "apricot"};
  qsort(words, 7, sizeof *words, by_text);
  for (int i = 0; i < 7; i++) puts(words[i]);
  static struct record records[40];
  for (int i = 0; i < 40; i++) {
    records[i].key = (short)(i * 17 % 40);
    snprintf(records[i].name, sizeof records[i].name, "r%d", records[i].key);
  }
  qsort(records, 40, sizeof *records, by_key);
  for (int i = 0; i < 40; i++) printf("%s ", records[i].name);
  double values[9] = {3.5, -1e300, 0.1, 7, -0.5, 1e-300, 2, 1e300, -7};
  qsort(values, 9, sizeof *values, by_value);
  for (int i = 0; i < 9; i++) printf("%g ", values[i]);
  unsigned char bytes[] = "sorted bytes";
  qsort(bytes, 12, 1, by_byte);
  puts((char *)bytes);
  return 0;
}
