/* The part of the C library's string.h that the runtime has. */
#ifndef FINBACK_STRING_H
#define FINBACK_STRING_H

#include <stddef.h>

void* memcpy(void* restrict destination, const void* restrict source, size_t bytes);
void* memmove(void* destination, const void* source, size_t bytes);
void* memset(void* destination, int value, size_t bytes);

#endif
