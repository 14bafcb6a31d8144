/* The second file: it has its own static objects of the same names, and the definitions. */
#include "shared.h"

int counter = 40;
int in_a_block = 77;
static int twin = 3;
static int hidden(int x) { return x - twin++; }
const short table[5] = {1, -2, 3, -4, 5};
const char* const names[] = {"zero", "one", "two"};

int count(void) { return counter++ + next_private() * 10; }
int only_here(int x) { return hidden(x) * 7 + hidden(x); }
unsigned overridden(void) { return 9; }
extern inline int doubled(int x);
