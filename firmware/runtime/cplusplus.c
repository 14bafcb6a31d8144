/* What compiled C++ calls: operator new and delete over malloc, and the place of functions that no
 * class defines. Exceptions are not there: where memory ends, so does the program. */
#include <stdlib.h>

/* Names as C++ mangles them. */
void* _Znwj(unsigned size) {
  void* memory = malloc(size == 0 ? 1 : size);
  if (memory == 0) {
    abort();
  }
  return memory;
}

void* _Znaj(unsigned size) { return _Znwj(size); }
void _ZdlPv(void* memory) { free(memory); }
void _ZdaPv(void* memory) { free(memory); }
void _ZdlPvj(void* memory, unsigned size) {
  (void)size;
  free(memory);
}
void _ZdaPvj(void* memory, unsigned size) {
  (void)size;
  free(memory);
}

_Noreturn void __cxa_pure_virtual(void) { abort(); }
