/* Several files: external, static and inline functions of one name, tentative definitions,
 * constants, initialised pointers across files, weak functions that another file replaces, commons.
 */
#include "shared.h"

int tentative;
int tentative = 5;
static int hidden(int x) { return x + 1; }
static int twin = 100;
int (*handler)(struct message);
static int handle(struct message m) { return m.kind + m.values[2]; }
__attribute__((weak)) unsigned overridden(void) { return 1; }
__attribute__((weak)) unsigned kept(void) { return 2; }
extern int missing_data __attribute__((weak));
static int* const counter_address = &counter;
static const short* const behind = &table[4];

int main(void) {
  handler = handle;
  for (int i = 0; i < 5; i++)
    report("count", (unsigned)(count() + next_private()));
  *counter_address += tentative;
  report("counter", (unsigned)counter);
  report("hidden", (unsigned)(hidden(1) * 100 + only_here(1) + twin));
  last_message = make_message(7, 300);
  report("message", (unsigned)(handler(last_message) + last_message.values[0]));
  unsigned s = (unsigned)*behind;
  for (int i = 0; i < 3; i++)
    s = mix(s, (unsigned char)names[i][i]);
  report("tables", s);
  report("combine", mix_long(0, (unsigned long long)combine('a', 1ll << 35, -2, last_message, 9)));
  report("inline", (unsigned)(doubled(4) + limit));
  report("weak", overridden() * 10 + kept());
  extern int in_a_block;
  report("block", (unsigned)in_a_block);
  return 0;
}
