/* string.h but for what moves memory (memory.c). strlen, strcpy, strcmp, memcmp and memchr look at
 * four characters at a time where the alignment allows: a word read whole lies within memory that
 * is there. */
#include <stdint.h>
#include <string.h>

typedef uint32_t __attribute__((may_alias)) word_t;

/* The host's tests run under sanitizers, which know of the characters only. */
#define READS_WHOLE_WORDS __attribute__((no_sanitize("address")))

/* Not 0 where one of a word's four bytes is. */
static inline word_t zero_byte(word_t word) { return (word - 0x01010101u) & ~word & 0x80808080u; }

static inline int is_aligned(const void* memory) { return ((uintptr_t)memory & 3) == 0; }

READS_WHOLE_WORDS size_t strlen(const char* text) {
  const char* at = text;
  for (; !is_aligned(at); ++at) {
    if (*at == 0) {
      return (size_t)(at - text);
    }
  }
  const word_t* words = (const word_t*)at;
  while (zero_byte(*words) == 0) {
    ++words;
  }
  at = (const char*)words;
  while (*at != 0) {
    ++at;
  }
  return (size_t)(at - text);
}

size_t strnlen(const char* text, size_t limit) {
  const char* end = memchr(text, 0, limit);
  return end != NULL ? (size_t)(end - text) : limit;
}

READS_WHOLE_WORDS char* strcpy(char* restrict destination, const char* restrict source) {
  char* to = destination;
  if (is_aligned(to) && is_aligned(source)) {
    const word_t* from_word = (const word_t*)source;
    word_t* to_word = (word_t*)to;
    for (word_t word = *from_word; zero_byte(word) == 0; word = *from_word) {
      *to_word++ = word;
      ++from_word;
    }
    source = (const char*)from_word;
    to = (char*)to_word;
  }
  while ((*to++ = *source++) != 0) {
  }
  return destination;
}

char* strncpy(char* restrict destination, const char* restrict source, size_t bytes) {
  size_t length = strnlen(source, bytes);
  memcpy(destination, source, length);
  memset(destination + length, 0, bytes - length);
  return destination;
}

char* strcat(char* restrict destination, const char* restrict source) {
  strcpy(destination + strlen(destination), source);
  return destination;
}

char* strncat(char* restrict destination, const char* restrict source, size_t limit) {
  char* end = destination + strlen(destination);
  size_t length = strnlen(source, limit);
  memcpy(end, source, length);
  end[length] = 0;
  return destination;
}

READS_WHOLE_WORDS int strcmp(const char* one, const char* other) {
  if (is_aligned(one) && is_aligned(other)) {
    const word_t* one_word = (const word_t*)one;
    const word_t* other_word = (const word_t*)other;
    word_t word = *one_word;
    for (; word == *other_word; word = *++one_word, ++other_word) {
      if (zero_byte(word) != 0) {
        return 0;
      }
    }
    one = (const char*)one_word;
    other = (const char*)other_word;
  }
  while (*one != 0 && *one == *other) {
    ++one;
    ++other;
  }
  return (unsigned char)*one - (unsigned char)*other;
}

int strncmp(const char* one, const char* other, size_t limit) {
  for (; limit != 0; --limit, ++one, ++other) {
    if (*one != *other) {
      return (unsigned char)*one - (unsigned char)*other;
    }
    if (*one == 0) {
      break;
    }
  }
  return 0;
}

int memcmp(const void* one, const void* other, size_t bytes) {
  const unsigned char* a = one;
  const unsigned char* b = other;
  if (is_aligned(a) && is_aligned(b)) {
    const word_t* a_word = one;
    const word_t* b_word = other;
    for (; bytes >= 4 && *a_word == *b_word; bytes -= 4) {
      ++a_word;
      ++b_word;
    }
    a = (const unsigned char*)a_word;
    b = (const unsigned char*)b_word;
  }
  for (; bytes != 0; --bytes, ++a, ++b) {
    if (*a != *b) {
      return *a - *b;
    }
  }
  return 0;
}

READS_WHOLE_WORDS void* memchr(const void* memory, int value, size_t bytes) {
  const unsigned char* at = memory;
  const unsigned char wanted = (unsigned char)value;
  for (; bytes != 0 && !is_aligned(at); --bytes, ++at) {
    if (*at == wanted) {
      return (void*)at;
    }
  }
  const word_t* words = (const word_t*)at;
  for (; bytes >= 4 && zero_byte(*words ^ wanted * 0x01010101u) == 0; bytes -= 4) {
    ++words;
  }
  for (at = (const unsigned char*)words; bytes != 0; --bytes, ++at) {
    if (*at == wanted) {
      return (void*)at;
    }
  }
  return NULL;
}

char* strchr(const char* text, int character) {
  for (; *text != (char)character; ++text) {
    if (*text == 0) {
      return NULL;
    }
  }
  return (char*)text;
}

char* strrchr(const char* text, int character) {
  const char* found = NULL;
  for (;; ++text) {
    if (*text == (char)character) {
      found = text;
    }
    if (*text == 0) {
      return (char*)found;
    }
  }
}

char* strstr(const char* text, const char* part) {
  size_t length = strlen(part);
  if (length == 0) {
    return (char*)text;
  }
  for (text = strchr(text, *part); text != NULL; text = strchr(text + 1, *part)) {
    if (strncmp(text, part, length) == 0) {
      return (char*)text;
    }
  }
  return NULL;
}

size_t strspn(const char* text, const char* accepted) {
  size_t length = 0;
  while (text[length] != 0 && strchr(accepted, text[length]) != NULL) {
    ++length;
  }
  return length;
}

size_t strcspn(const char* text, const char* rejected) {
  size_t length = 0;
  while (text[length] != 0 && strchr(rejected, text[length]) == NULL) {
    ++length;
  }
  return length;
}

char* strpbrk(const char* text, const char* accepted) {
  text += strcspn(text, accepted);
  return *text != 0 ? (char*)text : NULL;
}

char* strtok(char* restrict text, const char* restrict separators) {
  static char* rest;
  if (text == NULL) {
    text = rest;
  }
  text += strspn(text, separators);
  rest = text + strcspn(text, separators);
  if (*rest != 0) {
    *rest++ = 0;
  }
  return *text != 0 ? text : NULL;
}
