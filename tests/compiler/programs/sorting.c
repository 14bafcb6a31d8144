/* Quick sort, heap sort and insertion on halves and words. */
#include "report.h"
static short values[200];
static unsigned keys[100];
__attribute__((noinline)) static void quick(short *v, int low, int high) {
  while (low < high) {
    short pivot = v[(low + high) / 2];
    int i = low, j = high;
    while (i <= j) {
      while (v[i] < pivot) i++;
      while (v[j] > pivot) j--;
      if (i <= j) {
        short t = v[i];
        v[i++] = v[j];
        v[j--] = t;
      }
    }
    quick(v, low, j);
    low = i;
  }
}
__attribute__((noinline)) static void heap(unsigned *v, int n) {
  for (int start = n / 2 - 1, end = n; end > 1;) {
    unsigned x;
    if (start >= 0) x = v[start];
    else {
      x = v[--end];
      v[end] = v[0];
    }
    int root = start >= 0 ? start-- : 0;
    for (int child; (child = 2 * root + 1) < end; root = child) {
      if (child + 1 < end && v[child + 1] > v[child]) child++;
      if (v[child] <= x) break;
      v[root] = v[child];
    }
    v[root] = x;
  }
}
__attribute__((noinline)) static int search(const short *v, int n, short what) {
  int low = 0, high = n;
  while (low < high) {
    int middle = (low + high) >> 1;
    if (v[middle] < what) low = middle + 1;
    else high = middle;
  }
  return low;
}
int main(void) {
  unsigned state = 21, s = 0;
  for (int i = 0; i < 200; i++) values[i] = (short)next_number(&state);
  for (int i = 0; i < 100; i++) keys[i] = next_number(&state) * 257;
  quick(values, 0, 199);
  heap(keys, 100);
  for (int i = 0; i < 200; i++) s = mix(s, (unsigned)values[i]);
  for (int i = 0; i < 100; i++) s = mix(s, keys[i]);
  report("sorted", s);
  for (int i = 0; i < 200; i += 17) s = mix(s, (unsigned)search(values, 200, values[i]));
  report("search", s);
  return 0;
}
