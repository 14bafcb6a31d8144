/* stdio.h: printing to the host port's console and into memory. */
#include <host_port.h>
#include <stdint.h>
#include <stdio.h>

#include "print/format.h"

void put_character(struct output* output, char character) {
  ++output->written;
  if (output->at == NULL) {
    putchar(character);
  } else if (output->at < output->end) {
    *output->at++ = character;
  }
}

int putchar(int character) {
  HOST_PORT->console = (unsigned char)character;
  return (unsigned char)character;
}

int puts(const char* text) {
  host_print(text);
  return putchar('\n');
}

int vprintf(const char* restrict format, va_list values) {
  struct output console = {NULL, NULL, 0};
  va_list rest;
  va_copy(rest, values);
  put_formatted(&console, format, &rest);
  va_end(rest);
  return (int)console.written;
}

int vsnprintf(char* restrict text, size_t size, const char* restrict format, va_list values) {
  /* The last character is kept for the end; a text without any room is not written to. */
  char nowhere;
  struct output memory = {size != 0 ? text : &nowhere, &nowhere, 0};
  if (size != 0) {
    /* sprintf has all there is. */
    uintptr_t room = UINTPTR_MAX - (uintptr_t)text;
    memory.end = (char*)((uintptr_t)text + (size - 1 < room ? size - 1 : room));
  }
  va_list rest;
  va_copy(rest, values);
  put_formatted(&memory, format, &rest);
  va_end(rest);
  *memory.at = 0;
  return (int)memory.written;
}

int printf(const char* restrict format, ...) {
  va_list values;
  va_start(values, format);
  int written = vprintf(format, values);
  va_end(values);
  return written;
}

int snprintf(char* restrict text, size_t size, const char* restrict format, ...) {
  va_list values;
  va_start(values, format);
  int written = vsnprintf(text, size, format, values);
  va_end(values);
  return written;
}

int sprintf(char* restrict text, const char* restrict format, ...) {
  va_list values;
  va_start(values, format);
  int written = vsnprintf(text, SIZE_MAX, format, values);
  va_end(values);
  return written;
}
