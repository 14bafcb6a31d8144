/* The C library's stdlib.h as far as the runtime has it. */
#ifndef FINBACK_STDLIB_H
#define FINBACK_STDLIB_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EXIT_SUCCESS 0
#define EXIT_FAILURE 1
#define RAND_MAX 0x7FFF

typedef struct {
  int quot;
  int rem;
} div_t;

/* numbers.c */
int abs(int value);
long labs(long value);
long long llabs(long long value);
#ifndef __cplusplus
#define abs(value) __builtin_abs(value)
#define labs(value) __builtin_labs(value)
#define llabs(value) __builtin_llabs(value)
#endif
div_t div(int dividend, int divisor);
int atoi(const char* text);
long atol(const char* text);
long strtol(const char* __restrict text, char** __restrict end, int base);
unsigned long strtoul(const char* __restrict text, char** __restrict end, int base);

/* random.c: the same numbers in every run. */
int rand(void);
void srand(unsigned seed);

/* sort.c: equal elements keep no order; no more than some hundred bytes of stack. */
void qsort(void* base, size_t count, size_t size, int (*compare)(const void*, const void*));
void* bsearch(const void* key, const void* base, size_t count, size_t size,
              int (*compare)(const void*, const void*));

/* heap.c: 8 KB, unless a unit in C writes HEAP(bytes); outside all functions. What is given out is
 * aligned to 8 bytes. Both cores of a firmware have a heap of their own. */
void* malloc(size_t bytes);
void* calloc(size_t count, size_t size);
void* realloc(void* memory, size_t bytes);
void free(void* memory);

#define HEAP(bytes)                                       \
  _Alignas(8) unsigned char heap_memory[(bytes) / 8 * 8]; \
  const size_t heap_size = (bytes) / 8 * 8

/* exit.c: the whole machine stops; abort() gives the status 134. */
_Noreturn void exit(int status);
_Noreturn void abort(void);

#ifdef __cplusplus
}
#endif

#endif
