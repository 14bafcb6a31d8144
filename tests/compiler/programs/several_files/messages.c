/* The third file: structs by value between files, and an object that two files declare. */
#include "shared.h"

struct message last_message = {1, {2, 3, 4}};

struct message make_message(int kind, int value) {
  struct message m = {kind + last_message.values[1],
                      {(short)value, (short)-value, (short)(value / 7)}};
  counter += next_private();
  return m;
}
long long combine(char a, long long b, short c, struct message d, int e) {
  return (a * b - c) * (d.kind + d.values[1]) + e + handler(make_message(a, c));
}
