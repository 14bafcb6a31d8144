/* One array, many ways to sort it: by Shell's, heaps, merging from below, partition with
 * three parts, radix, counting, and lists merged by their links; stable ones keep the order of
 * equals. */
#include <string.h>

#include "report.h"

struct item {
  short key, order;
  struct item* next;
};
#define N 120
static struct item items[N], room[N];
typedef void sorter(struct item*, int);

static void shell(struct item* p, int n) {
  static const unsigned char gaps[] = {57, 23, 10, 4, 1};
  for (int g = 0; g < 5; g++)
    for (int gap = gaps[g], i = gap; i < n; i++) {
      struct item t = p[i];
      int k = i;
      for (; k >= gap && p[k - gap].key > t.key; k -= gap)
        p[k] = p[k - gap];
      p[k] = t;
    }
}
static void sift(struct item* p, int at, int n) {
  struct item t = p[at];
  for (int child; (child = 2 * at + 1) < n; at = child) {
    if (child + 1 < n && p[child + 1].key > p[child].key)
      child++;
    if (p[child].key <= t.key)
      break;
    p[at] = p[child];
  }
  p[at] = t;
}
static void heap(struct item* p, int n) {
  for (int i = n / 2 - 1; i >= 0; i--)
    sift(p, i, n);
  while (--n > 0) {
    struct item t = p[0];
    p[0] = p[n];
    p[n] = t;
    sift(p, 0, n);
  }
}
static void merging(struct item* p, int n) {
  for (int width = 1; width < n; width *= 2) {
    for (int start = 0; start < n; start += 2 * width) {
      int a = start, middle = start + width < n ? start + width : n, b = middle,
          end = middle + width < n ? middle + width : n;
      for (int i = start; i < end; i++)
        room[i] = a < middle && (b >= end || p[a].key <= p[b].key) ? p[a++] : p[b++];
    }
    memcpy(p, room, (size_t)n * sizeof *p);
  }
}
static void quick(struct item* p, int n) {
  while (n > 1) {
    short pivot = p[n / 2].key;
    int low = 0, at = 0, high = n;
    while (at < high) {
      struct item t = p[at];
      if (t.key < pivot) {
        p[at++] = p[low];
        p[low++] = t;
      } else if (t.key > pivot) {
        p[at] = p[--high];
        p[high] = t;
      } else {
        at++;
      }
    }
    if (low < n - high) {
      quick(p, low);
      p += high;
      n -= high;
    } else {
      quick(p + high, n - high);
      n = low;
    }
  }
}
static void radix(struct item* p, int n) {
  for (int shift = 0; shift < 16; shift += 4) {
    int starts[17] = {0};
    for (int i = 0; i < n; i++)
      starts[(((unsigned short)p[i].key ^ 0x8000) >> shift & 15) + 1]++;
    for (int i = 0; i < 16; i++)
      starts[i + 1] += starts[i];
    for (int i = 0; i < n; i++)
      room[starts[((unsigned short)p[i].key ^ 0x8000) >> shift & 15]++] = p[i];
    memcpy(p, room, (size_t)n * sizeof *p);
  }
}
static struct item* merged(struct item* a, struct item* b) {
  struct item *first = NULL, **last = &first;
  for (; a != NULL && b != NULL; last = &(*last)->next) {
    struct item** least = b->key < a->key ? &b : &a;
    *last = *least;
    *least = (*least)->next;
  }
  *last = a != NULL ? a : b;
  return first;
}
static void links(struct item* p, int n) {
  struct item *piles[8] = {NULL}, *all = NULL;
  for (int i = 0, k; i < n; i++) {
    struct item* one = &p[i];
    one->next = NULL;
    for (k = 0; k < 7 && piles[k] != NULL; k++) {
      one = merged(piles[k], one);
      piles[k] = NULL;
    }
    piles[k] = piles[k] == NULL ? one : merged(piles[k], one);
  }
  for (int k = 0; k < 8; k++)
    all = merged(piles[k], all);
  for (int i = 0; i < n; i++, all = all->next)
    room[i] = *all;
  memcpy(p, room, (size_t)n * sizeof *p);
}

int main(void) {
  static sorter* const sorters[] = {shell, heap, quick, merging, radix, links};
  for (unsigned k = 0; k < sizeof sorters / sizeof *sorters; k++) {
    unsigned s = 0, state = 5;
    for (int n = 1; n <= N; n += 17) {
      for (int i = 0; i < n; i++)
        items[i] =
            (struct item){(short)((int)(next_number(&state) % 60) * 500 - 15000), (short)i, NULL};
      sorters[k](items, n);
      for (int i = 0; i < n; i++) {
        s = mix(s, (unsigned)items[i].key);
        if (k >= 3)
          s = mix(s, (unsigned)items[i].order);
      }
    }
    report("sorted", s);
  }
  return 0;
}
