/* Sorts signed words in place: quicksort, and insertion where 16 or fewer are left. The smaller
 * part is sorted first, so that few are ever put off. */
#include <stdint.h>

#define FEW 16
#define DEPTH 32

static void insert(int32_t* begin, int32_t* end) {
  for (int32_t* next = begin + 1; next < end; ++next) {
    int32_t value = *next;
    int32_t* to = next;
    while (to > begin && to[-1] > value) {
      *to = to[-1];
      --to;
    }
    *to = value;
  }
}

/* Where the second part begins: nothing before it is larger than anything in it. */
static int32_t* partition(int32_t* begin, int32_t* end) {
  int32_t pivot = begin[(end - begin - 1) / 2];
  int32_t* low = begin;
  int32_t* high = end - 1;
  for (;;) {
    while (*low < pivot) {
      ++low;
    }
    while (*high > pivot) {
      --high;
    }
    if (low >= high) {
      return high + 1;
    }
    int32_t swapped = *low;
    *low++ = *high;
    *high-- = swapped;
  }
}

void quicksort(int32_t* values, int count) {
  int32_t* put_off[2 * DEPTH];
  int32_t** top = put_off;
  int32_t* begin = values;
  int32_t* end = values + count;
  for (;;) {
    while (end - begin > FEW) {
      int32_t* middle = partition(begin, end);
      if (middle - begin < end - middle) {
        *top++ = middle;
        *top++ = end;
        end = middle;
      } else {
        *top++ = begin;
        *top++ = middle;
        begin = middle;
      }
    }
    insert(begin, end);
    if (top == put_off) {
      return;
    }
    end = *--top;
    begin = *--top;
  }
}
