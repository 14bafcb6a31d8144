/* Huffman coding: counts, a tree from a heap of nodes, canonical codes, a bit stream written and
 * read back. */
#include <string.h>

#include "report.h"

struct node {
  int count;
  short left, right; /* -1: a leaf */
};
static struct node nodes[511];
static short heap[256];
static int heap_size, node_count;
static unsigned char lengths[256];
static unsigned codes[256];

static int before(int a, int b) {
  return nodes[a].count < nodes[b].count || (nodes[a].count == nodes[b].count && a < b);
}
APART static void push(int n) {
  int at = heap_size++;
  while (at > 0 && before(n, heap[(at - 1) / 2])) {
    heap[at] = heap[(at - 1) / 2];
    at = (at - 1) / 2;
  }
  heap[at] = (short)n;
}
APART static int pop(void) {
  int top = heap[0], n = heap[--heap_size], at = 0;
  for (;;) {
    int child = 2 * at + 1;
    if (child >= heap_size)
      break;
    if (child + 1 < heap_size && before(heap[child + 1], heap[child]))
      child++;
    if (!before(heap[child], n))
      break;
    heap[at] = heap[child];
    at = child;
  }
  heap[at] = (short)n;
  return top;
}
static void measure(int n, int depth) {
  if (nodes[n].left < 0) {
    lengths[n] = (unsigned char)(depth == 0 ? 1 : depth);
    return;
  }
  measure(nodes[n].left, depth + 1);
  measure(nodes[n].right, depth + 1);
}
static void build(const unsigned char* text, int size) {
  memset(nodes, 0, sizeof nodes);
  memset(lengths, 0, sizeof lengths);
  for (int i = 0; i < size; i++)
    nodes[text[i]].count++;
  heap_size = 0;
  node_count = 256;
  for (int i = 0; i < 256; i++) {
    nodes[i].left = nodes[i].right = -1;
    if (nodes[i].count > 0)
      push(i);
  }
  while (heap_size > 1) {
    int a = pop(), b = pop();
    nodes[node_count] = (struct node){nodes[a].count + nodes[b].count, (short)a, (short)b};
    push(node_count++);
  }
  measure(pop(), 0);
  unsigned code = 0;
  for (int length = 1; length < 32; length++, code <<= 1)
    for (int i = 0; i < 256; i++)
      if (lengths[i] == length)
        codes[i] = code++;
}
static int encode(const unsigned char* text, int size, unsigned char* out) {
  unsigned long long bits = 0;
  int held = 0, written = 0;
  for (int i = 0; i < size; i++) {
    bits = bits << lengths[text[i]] | codes[text[i]];
    held += lengths[text[i]];
    while (held >= 8)
      out[written++] = (unsigned char)(bits >> (held -= 8));
  }
  if (held > 0)
    out[written++] = (unsigned char)(bits << (8 - held));
  return written;
}
static void decode(const unsigned char* in, unsigned char* out, int size) {
  int bit = 0;
  while (size-- > 0) {
    unsigned code = 0;
    int found = -1;
    for (int length = 1; found < 0; length++) {
      code = code << 1 | (in[bit / 8] >> (7 - bit % 8) & 1);
      bit++;
      for (int i = 0; i < 256 && found < 0; i++)
        if (lengths[i] == length && codes[i] == code)
          found = i;
    }
    *out++ = (unsigned char)found;
  }
}
static void test(const char* name, const unsigned char* text, int size) {
  static unsigned char packed[400], unpacked[400];
  build(text, size);
  int length = encode(text, size, packed);
  decode(packed, unpacked, size);
  unsigned s = memcmp(text, unpacked, (size_t)size) == 0 ? (unsigned)length : 0xbad;
  report(name, s);
  for (int i = 0; i < length; i++)
    s = mix(s, packed[i]);
  report(name, s);
}

int main(void) {
  static const char text[] =
      "she sells sea shells by the sea shore; the shells she sells are sea shells, surely";
  test("text", (const unsigned char*)text, sizeof text);
  test("same", (const unsigned char*)"aaaaaaaaaaaaaaaa", 16);
  unsigned char numbers[150];
  unsigned state = 3;
  for (int i = 0; i < 150; i++) {
    unsigned x = next_number(&state) & 0xffff;
    numbers[i] = (unsigned char)(x * x >> 26);
  }
  test("numbers", numbers, 150);
  return 0;
}
