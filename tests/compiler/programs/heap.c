/* malloc, calloc, realloc and free: contents survive, blocks do not overlap, memory comes back. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

struct node {
  struct node *next;
  int value;
};

static struct node *pushed(struct node *list, int value) {
  struct node *node = malloc(sizeof *node);
  if (node == NULL) return list;
  *node = (struct node){list, value};
  return node;
}

/* Blocks come, grow and go; each is filled with its own number. */
static unsigned churn(void) {
  enum { kBlocks = 24 };
  static unsigned char *blocks[kBlocks];
  static unsigned sizes[kBlocks];
  unsigned state = 21, wrong = 0;
  for (int step = 0; step < 1500; step++) {
    unsigned i = next_number(&state) % kBlocks;
    unsigned size = 1 + next_number(&state) % 150;
    for (unsigned k = 0; k < sizes[i]; k++) wrong += blocks[i][k] != (unsigned char)(i * 37);
    if (next_number(&state) % 3 == 0) {
      free(blocks[i]);
      blocks[i] = NULL;
      sizes[i] = 0;
      continue;
    }
    unsigned kept = sizes[i] < size ? sizes[i] : size;
    blocks[i] = realloc(blocks[i], size);
    if (blocks[i] == NULL) {
      sizes[i] = 0;
      wrong++;
      continue;
    }
    wrong += ((uintptr_t)blocks[i] & 7) != 0;
    for (unsigned k = 0; k < kept; k++) wrong += blocks[i][k] != (unsigned char)(i * 37);
    memset(blocks[i], (int)(i * 37), size);
    sizes[i] = size;
  }
  for (int i = 0; i < kBlocks; i++) free(blocks[i]);
  return wrong;
}

int main(void) {
  struct node *list = NULL;
  for (int i = 0; i < 100; i++) list = pushed(list, i * i);
  unsigned sum = 0;
  while (list != NULL) {
    struct node *next = list->next;
    sum = mix(sum, (unsigned)list->value);
    free(list);
    list = next;
  }
  report("list", sum);
  report("wrong", churn());
  for (int i = 0; i < 50; i++) {
    char *large = malloc(7000); /* whatever was given back must be whole again */
    if (large == NULL) report("lost", (unsigned)i);
    free(large);
  }
  int *zeros = calloc(100, sizeof *zeros);
  for (int i = 0; i < 100; i++) sum += (unsigned)zeros[i];
  report("zeros", sum);
  zeros = realloc(zeros, 10 * sizeof *zeros);
  free(zeros);
  free(NULL);
  volatile size_t much = SIZE_MAX / 2;
  report("too much", malloc(much) == NULL);
  report("too many", calloc(much, 4) == NULL);
  return 0;
}
