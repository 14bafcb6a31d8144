/* The C library's stdio.h as far as the runtime has it: printing, to the host port's console or
 * into memory. Flags, widths and precisions as in C; d i u o x X c s p n % with hh h l ll j z t; f
 * F e E g G exact to the last digit. Not there: files, reading, %a, wide characters, long double
 * (it is double). */
#ifndef FINBACK_STDIO_H
#define FINBACK_STDIO_H

#include <stdarg.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EOF (-1)

/* print.c */
int printf(const char* __restrict format, ...) __attribute__((format(printf, 1, 2)));
int vprintf(const char* __restrict format, va_list values) __attribute__((format(printf, 1, 0)));
int sprintf(char* __restrict text, const char* __restrict format, ...)
    __attribute__((format(printf, 2, 3)));
int snprintf(char* __restrict text, size_t size, const char* __restrict format, ...)
    __attribute__((format(printf, 3, 4)));
int vsnprintf(char* __restrict text, size_t size, const char* __restrict format, va_list values)
    __attribute__((format(printf, 3, 0)));
int putchar(int character);
int puts(const char* text);

#ifdef __cplusplus
}
#endif

#endif
