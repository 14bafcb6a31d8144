/* qsort, a heap sort: in place, without recursion, and never worse than n log n. bsearch. */
#include <stdint.h>
#include <stdlib.h>

typedef int (*compare_t)(const void*, const void*);

struct array {
  char* base;
  size_t size;
  compare_t compare;
};

static char* element(const struct array* array, size_t index) {
  return array->base + index * array->size;
}

static void swap(char* one, char* other, size_t size) {
  if ((((uintptr_t)one | size) & 3) == 0) {
    for (; size != 0; size -= 4, one += 4, other += 4) {
      typedef uint32_t __attribute__((may_alias)) word_t;
      word_t kept = *(word_t*)one;
      *(word_t*)one = *(word_t*)other;
      *(word_t*)other = kept;
    }
    return;
  }
  for (; size != 0; --size) {
    char kept = *one;
    *one++ = *other;
    *other++ = kept;
  }
}

/* Sinks an element of the heap's first `count` until no child is greater. */
static void sink(const struct array* array, size_t parent, size_t count) {
  for (size_t child = 2 * parent + 1; child < count; child = 2 * parent + 1) {
    if (child + 1 < count && array->compare(element(array, child), element(array, child + 1)) < 0) {
      ++child;
    }
    if (array->compare(element(array, parent), element(array, child)) >= 0) {
      return;
    }
    swap(element(array, parent), element(array, child), array->size);
    parent = child;
  }
}

void qsort(void* base, size_t count, size_t size, compare_t compare) {
  struct array array = {base, size, compare};
  for (size_t parent = count / 2; parent != 0; --parent) {
    sink(&array, parent - 1, count);
  }
  for (; count > 1; --count) {
    swap(element(&array, 0), element(&array, count - 1), size);
    sink(&array, 0, count - 1);
  }
}

void* bsearch(const void* key, const void* base, size_t count, size_t size, compare_t compare) {
  const char* first = base;
  while (count != 0) {
    const char* middle = first + count / 2 * size;
    int order = compare(key, middle);
    if (order == 0) {
      return (void*)middle;
    }
    if (order > 0) {
      first = middle + size;
      --count;
    }
    count /= 2;
  }
  return NULL;
}
