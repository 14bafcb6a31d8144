/* What the files of this program share: declarations, inline functions, constants, a variable that
 * each file has for itself. */
#ifndef SHARED_H
#define SHARED_H

#include "../report.h"

struct message {
  int kind;
  short values[3];
};

extern int counter, tentative;
extern const short table[5];
extern int (*handler)(struct message);
extern struct message last_message;
extern const char* const names[];

int count(void);
int only_here(int x);
struct message make_message(int kind, int value);
long long combine(char a, long long b, short c, struct message d, int e);
unsigned overridden(void);
static const int limit = 10;
static int private_count;
static inline int next_private(void) { return ++private_count; }
inline int doubled(int x) { return 2 * x + 10; }

#endif
