/* malloc and free: blocks in a row in the order of their addresses, each behind a header of 8
 * bytes. The first block with room is taken and split; free neighbours are joined when somebody
 * looks. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define ALIGNMENT 8u

struct header {
  uint32_t bytes; /* with this header */
  uint32_t used;
};

/* A unit that writes HEAP(bytes) has these in the place of ours. */
__attribute__((weak)) _Alignas(ALIGNMENT) unsigned char heap_memory[8192];
__attribute__((weak)) const size_t heap_size = sizeof heap_memory;

static struct header* after(struct header* block) {
  return (struct header*)((char*)block + block->bytes);
}

static struct header* heap_end(void) { return (struct header*)(heap_memory + heap_size); }

static struct header* first_block(void) {
  struct header* first = (struct header*)heap_memory;
  if (first->bytes == 0) {
    first->bytes = heap_size; /* nobody has asked yet */
  }
  return first;
}

/* Joins a free block with the free ones behind it. */
static void join(struct header* block) {
  for (struct header* next = after(block); next < heap_end() && !next->used; next = after(block)) {
    block->bytes += next->bytes;
  }
}

/* Takes a block for its first `bytes`; what remains becomes a free block where it has room for one.
 */
static void* take(struct header* block, uint32_t bytes) {
  if (block->bytes - bytes >= sizeof(struct header) + ALIGNMENT) {
    uint32_t whole = block->bytes;
    block->bytes = bytes;
    after(block)->bytes = whole - bytes;
    after(block)->used = 0;
  }
  block->used = 1;
  return block + 1;
}

/* The bytes of a block that holds so many; 0 where no heap has them. */
static uint32_t block_bytes(size_t bytes) {
  if (bytes == 0 || bytes > heap_size) {
    return 0;
  }
  return ((uint32_t)bytes + sizeof(struct header) + ALIGNMENT - 1) & ~(ALIGNMENT - 1);
}

void* malloc(size_t bytes) {
  uint32_t wanted = block_bytes(bytes);
  if (wanted == 0) {
    return NULL;
  }
  for (struct header* block = first_block(); block < heap_end(); block = after(block)) {
    if (block->used) {
      continue;
    }
    join(block);
    if (block->bytes >= wanted) {
      return take(block, wanted);
    }
  }
  return NULL;
}

void free(void* memory) {
  if (memory != NULL) {
    ((struct header*)memory - 1)->used = 0;
  }
}

void* calloc(size_t count, size_t size) {
  if (size != 0 && count > heap_size / size) {
    return NULL;
  }
  void* memory = malloc(count * size);
  if (memory != NULL) {
    memset(memory, 0, count * size);
  }
  return memory;
}

void* realloc(void* memory, size_t bytes) {
  if (memory == NULL) {
    return malloc(bytes);
  }
  struct header* block = (struct header*)memory - 1;
  uint32_t wanted = block_bytes(bytes);
  if (wanted == 0) {
    if (bytes == 0) {
      free(memory);
    }
    return NULL;
  }
  uint32_t kept = block->bytes;
  join(block); /* grows where it stands, if what follows is free */
  if (block->bytes >= wanted) {
    return take(block, wanted);
  }
  void* moved = malloc(bytes);
  if (moved != NULL) {
    memcpy(moved, memory, kept - sizeof(struct header));
    free(memory);
  }
  return moved;
}
