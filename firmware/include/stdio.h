/* The C library's stdio.h as far as the runtime has it: printing, to the host port's console or
 * into memory. Flags, widths and precisions as in C; d i u o x X c s p n % with hh h l ll j z t; f
 * F e E g G exact to the last digit. Not there: files, reading, %a, wide characters, long double
 * (it is double). */
#ifndef FINBACK_STDIO_H
#define FINBACK_STDIO_H

#include <stdarg.h>
#include <stddef.h>

#define EOF (-1)

/* print.c */
int printf(const char* restrict format, ...) __attribute__((format(printf, 1, 2)));
int vprintf(const char* restrict format, va_list values) __attribute__((format(printf, 1, 0)));
int sprintf(char* restrict text, const char* restrict format, ...)
    __attribute__((format(printf, 2, 3)));
int snprintf(char* restrict text, size_t size, const char* restrict format, ...)
    __attribute__((format(printf, 3, 4)));
int vsnprintf(char* restrict text, size_t size, const char* restrict format, va_list values)
    __attribute__((format(printf, 3, 0)));
int putchar(int character);
int puts(const char* text);

#endif
