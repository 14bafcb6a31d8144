/* Graphs: shortest ways by a heap and by tables, strong components by an explicit stack. */
#include <string.h>

#include "report.h"

#define N 24
struct edge {
  unsigned char to, weight;
  short next;
};
static struct edge edges[120];
static short first[N];
static int edge_count;

static void connect(int from, int to, int weight) {
  edges[edge_count] = (struct edge){(unsigned char)to, (unsigned char)weight, first[from]};
  first[from] = (short)edge_count++;
}

struct item {
  unsigned distance;
  int node;
};
APART static unsigned shortest(int from, unsigned* distance) {
  static struct item heap[200];
  int size = 0;
  unsigned pops = 0;
  memset(distance, 0xff, N * sizeof *distance);
  distance[from] = 0;
  heap[size++] = (struct item){0, from};
  while (size > 0) {
    struct item top = heap[0], last = heap[--size];
    int at = 0;
    for (int child; (child = 2 * at + 1) < size; at = child) {
      child += child + 1 < size && heap[child + 1].distance < heap[child].distance;
      if (last.distance <= heap[child].distance)
        break;
      heap[at] = heap[child];
    }
    heap[at] = last;
    pops++;
    if (top.distance > distance[top.node])
      continue;
    for (int e = first[top.node]; e >= 0; e = edges[e].next) {
      unsigned d = top.distance + edges[e].weight;
      if (d >= distance[edges[e].to])
        continue;
      distance[edges[e].to] = d;
      int up = size++;
      for (; up > 0 && d < heap[(up - 1) / 2].distance; up = (up - 1) / 2)
        heap[up] = heap[(up - 1) / 2];
      heap[up] = (struct item){d, edges[e].to};
    }
  }
  return pops;
}
APART static void all_pairs(unsigned d[N][N]) {
  memset(d, 0x3f, N * sizeof *d);
  for (int i = 0; i < N; i++) {
    d[i][i] = 0;
    for (int e = first[i]; e >= 0; e = edges[e].next)
      if (edges[e].weight < d[i][edges[e].to])
        d[i][edges[e].to] = edges[e].weight;
  }
  for (int k = 0; k < N; k++)
    for (int i = 0; i < N; i++)
      for (int j = 0; j < N; j++)
        if (d[i][k] + d[k][j] < d[i][j])
          d[i][j] = d[i][k] + d[k][j];
}
APART static unsigned components(int* component) {
  int number[N], low[N], stack[N], path[N], edge[N], top = 0, depth, counter = 0, found = 0;
  for (int i = 0; i < N; i++)
    number[i] = component[i] = -1;
  for (int start = 0; start < N; start++) {
    if (number[start] >= 0)
      continue;
    depth = 0;
    path[0] = start;
    number[start] = -1;
    while (depth >= 0) {
      int v = path[depth];
      if (number[v] < 0) {
        number[v] = low[v] = counter++;
        stack[top++] = v;
        edge[v] = first[v];
      }
      int e = edge[v];
      if (e >= 0) {
        int w = edges[e].to;
        if (number[w] < 0) {
          path[++depth] = w;
          continue;
        }
        if (component[w] < 0 && low[w] < low[v])
          low[v] = low[w];
        edge[v] = edges[e].next;
        continue;
      }
      if (low[v] == number[v]) {
        int w;
        do
          component[w = stack[--top]] = found;
        while (w != v);
        found++;
      }
      depth--;
    }
  }
  return (unsigned)found;
}

int main(void) {
  static unsigned distance[N], table[N][N];
  int component[N];
  unsigned state = 31, s = 0;
  memset(first, -1, sizeof first);
  for (int i = 0; i < 60; i++) {
    unsigned x = next_number(&state);
    connect((int)(x % N), (int)(x / N % N), (int)(x / 1024 % 200) + 1);
  }
  all_pairs(table);
  for (int i = 0; i < N; i++) {
    s = mix(s, shortest(i, distance));
    for (int k = 0; k < N; k++) {
      s = mix(s, distance[k]);
      s += distance[k] != table[i][k] && table[i][k] < 0x3f3f3f3f;
    }
  }
  report("shortest", s);
  s = components(component);
  for (int i = 0; i < N; i++)
    s = mix(s, (unsigned)component[i]);
  report("components", s);
  return 0;
}
