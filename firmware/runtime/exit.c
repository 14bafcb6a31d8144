/* The ends of a program: exit, abort, and assertions that do not hold. */
#include <assert.h>
#include <host_port.h>
#include <stdlib.h>

#define STATUS_OF_ABORT 134u

_Noreturn void exit(int status) { host_exit((unsigned)status); }

_Noreturn void abort(void) { host_exit(STATUS_OF_ABORT); }

static void print_number(unsigned number) {
  char digits[11];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  do {
    *--at = (char)('0' + number % 10);
    number /= 10;
  } while (number != 0);
  host_print(at);
}

_Noreturn void assertion_failed(const char* condition, const char* file, unsigned line,
                                const char* function) {
  host_print(file);
  host_print(":");
  print_number(line);
  host_print(": ");
  host_print(function);
  host_print(": assertion failed: ");
  host_print(condition);
  host_print("\n");
  abort();
}
