/* The C library's string.h as far as the runtime has it: memory in memory.c, text in string.c. */
#ifndef FINBACK_STRING_H
#define FINBACK_STRING_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void* memcpy(void* __restrict destination, const void* __restrict source, size_t bytes);
void* memmove(void* destination, const void* source, size_t bytes);
void* memset(void* destination, int value, size_t bytes);
int memcmp(const void* one, const void* other, size_t bytes);
void* memchr(const void* memory, int value, size_t bytes);

size_t strlen(const char* text);
size_t strnlen(const char* text, size_t limit);
char* strcpy(char* __restrict destination, const char* __restrict source);
char* strncpy(char* __restrict destination, const char* __restrict source, size_t bytes);
char* strcat(char* __restrict destination, const char* __restrict source);
char* strncat(char* __restrict destination, const char* __restrict source, size_t limit);
int strcmp(const char* one, const char* other);
int strncmp(const char* one, const char* other, size_t limit);
char* strchr(const char* text, int character);
char* strrchr(const char* text, int character);
char* strstr(const char* text, const char* part);
size_t strspn(const char* text, const char* accepted);
size_t strcspn(const char* text, const char* rejected);
char* strpbrk(const char* text, const char* accepted);
char* strtok(char* __restrict text, const char* __restrict separators);

#ifdef __cplusplus
}
#endif

#endif
