/* Checks of the runtime and the drivers on the chip. The exit status is 0 or the first check that
 * failed. */
#include <bf561.h>
#include <core_interrupt.h>
#include <events.h>
#include <host_port.h>
#include <memory_dma.h>
#include <string.h>

#include "shared_checks.h"

enum check {
  ALL_WELL,
  UNSIGNED_DIVISION,
  SIGNED_DIVISION,
  MEMORY_FUNCTIONS,
  DMA_COPY,
  DMA_COPY_SPILLS,
  DMA_GATHER,
  DMA_DESCRIPTORS,
  DMA_RING,
  LOCK,
};

_Alignas(4) uint8_t bytes_in_l1[CHECKED_BYTES];
_Alignas(4) uint8_t other_bytes_in_l1[CHECKED_BYTES];

static uint32_t random_state = 1;

static uint32_t random_number(void) {
  random_state = random_state * 1664525u + 1013904223u;
  return random_state >> (random_state >> 27);
}

static enum check check_division(void) {
  for (int i = 0; i < 200; ++i) {
    uint32_t dividend = random_number();
    uint32_t divisor = random_number() | 1;
    uint32_t quotient = dividend / divisor;
    uint32_t remainder = dividend % divisor;
    if (quotient * divisor + remainder != dividend || remainder >= divisor) {
      return UNSIGNED_DIVISION;
    }
  }
  for (int i = 0; i < 4; ++i) {
    volatile int32_t dividend = i < 2 ? 47 : -47;
    volatile int32_t divisor = i % 2 == 0 ? 9 : -9;
    int32_t quotient = i == 0 || i == 3 ? 5 : -5;
    if (dividend / divisor != quotient || dividend % divisor != (i < 2 ? 2 : -2)) {
      return SIGNED_DIVISION;
    }
  }
  return ALL_WELL;
}

static void count_up(uint8_t* bytes) {
  for (int i = 0; i < CHECKED_BYTES; ++i) {
    bytes[i] = (uint8_t)(i * 5 + 1);
  }
}

/* Whether `size` bytes at `to` are those that count_up puts at `from`, and all others 0. */
static enum check check_copy(const uint8_t* copy, int to, int from, int size) {
  for (int i = 0; i < CHECKED_BYTES; ++i) {
    int inside = i >= to && i < to + size;
    if (copy[i] != (inside ? (uint8_t)((i - to + from) * 5 + 1) : 0)) {
      return inside ? DMA_COPY : DMA_COPY_SPILLS;
    }
  }
  return ALL_WELL;
}

static enum check check_memory_functions(void) {
  count_up(bytes_in_l1);
  for (int from = 0; from < 4; ++from) {
    for (int to = 0; to < 4; ++to) {
      memset(other_bytes_in_l1, 0, CHECKED_BYTES);
      memcpy(other_bytes_in_l1 + to, bytes_in_l1 + from, 37);
      if (check_copy(other_bytes_in_l1, to, from, 37) != ALL_WELL) {
        return MEMORY_FUNCTIONS;
      }
      memmove(other_bytes_in_l1 + 9, other_bytes_in_l1 + to, 37);
      memset(other_bytes_in_l1, 0, 9);
      if (check_copy(other_bytes_in_l1, 9, from, 37) != ALL_WELL) {
        return MEMORY_FUNCTIONS;
      }
    }
  }
  return ALL_WELL;
}

/* Every alignment of both ends, sizes of every element width. */
static enum check check_dma_copies(uint8_t* destination, uint8_t* source) {
  static const uint8_t sizes[] = {1, 2, 3, 4, 31, 64, 200};
  count_up(source);
  for (int from = 0; from < 4; ++from) {
    for (int to = 0; to < 4; ++to) {
      for (unsigned i = 0; i < sizeof sizes; ++i) {
        enum check result;
        memset(destination, 0, CHECKED_BYTES);
        memory_dma_copy(destination + to, source + from, sizes[i]);
        memory_dma_wait();
        result = check_copy(destination, to, from, sizes[i]);
        if (result != ALL_WELL) {
          return result;
        }
      }
    }
  }
  return ALL_WELL;
}

static void pause_for(unsigned loops) {
  for (; loops != 0; --loops) {
    __builtin_bfin_nop();
  }
}

/* A transfer that ends ever earlier with respect to the moment of going to sleep; no end may be
 * overlooked, or the machine stands still. */
static void meet_the_end_of_dma(void) {
  for (unsigned delay = 0; delay < 400; ++delay) {
    memory_dma_copy(bytes_in_l1, other_bytes_in_l1, 4);
    pause_for(delay);
    memory_dma_wait();
  }
}

/* 5 x 3 bytes out of an image of 20 x 12. */
static enum check check_dma_gather(void) {
  count_up(bytes_in_l3);
  memset(bytes_in_l1, 0, CHECKED_BYTES);
  memory_dma_gather(bytes_in_l1, bytes_in_l3, 5, 3, 4, 20);
  memory_dma_wait();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      if (bytes_in_l1[5 * y + x] != bytes_in_l3[20 * 4 * y + 4 * x]) {
        return DMA_GATHER;
      }
    }
  }
  return bytes_in_l1[15] == 0 ? ALL_WELL : DMA_GATHER;
}

#define UNIT (WDSIZE_16 | DMAEN)

static volatile struct dma_registers* const destination =
    (volatile struct dma_registers*)MDMA2_D0_BASE;
static volatile struct dma_registers* const source = (volatile struct dma_registers*)MDMA2_S0_BASE;

static void wait_for_done(void) {
  while ((destination->irq_status & DMA_DONE) == 0) {
  }
  destination->irq_status = DMA_DONE;
}

/* 60 bytes in one piece to three places, by a list; then backwards, by an array. */
static enum check check_dma_descriptors(void) {
  static struct dma_large_descriptor list[3];
  static uint16_t array[6];
  count_up(bytes_in_l3);
  memset(bytes_in_l1, 0, CHECKED_BYTES);
  source->start_addr = (uint32_t)bytes_in_l3;
  source->x_count = 30;
  source->x_modify = 2;
  for (int i = 0; i < 3; ++i) {
    list[i].next_desc_ptr = &list[i + 1];
    list[i].start_addr = bytes_in_l1 + 100 * i;
    list[i].config = (uint16_t)(UNIT | WNR | (i < 2 ? DMAFLOW_LARGE | NDSIZE(7) : DMAFLOW_STOP));
    list[i].x_count = 10;
    list[i].x_modify = 2;
  }
  destination->next_desc_ptr = (uint32_t)list;
  __builtin_bfin_ssync();
  source->config = UNIT;
  destination->config = UNIT | WNR | DMAFLOW_LARGE | NDSIZE(7);
  while ((destination->irq_status & DMA_RUN) != 0) {
  }
  wait_for_done();
  for (int i = 0; i < 60; ++i) {
    if (bytes_in_l1[100 * (i / 20) + i % 20] != bytes_in_l3[i]) {
      return DMA_DESCRIPTORS;
    }
  }
  for (int i = 0; i < 2; ++i) {
    uint32_t at = (uint32_t)(bytes_in_l3 + 58 - 30 * i);
    array[3 * i] = (uint16_t)at;
    array[3 * i + 1] = (uint16_t)(at >> 16);
    array[3 * i + 2] = (uint16_t)(UNIT | (i == 0 ? DMAFLOW_ARRAY | NDSIZE(3) : DMAFLOW_STOP));
  }
  source->curr_desc_ptr = (uint32_t)array;
  source->x_count = 15;
  source->x_modify = -2;
  destination->start_addr = (uint32_t)bytes_in_l1;
  destination->x_count = 30;
  __builtin_bfin_ssync();
  source->config = UNIT | DMAFLOW_ARRAY | NDSIZE(3);
  destination->config = UNIT | WNR;
  wait_for_done();
  for (int i = 0; i < 60; ++i) {
    if (bytes_in_l1[i] != bytes_in_l3[58 - i + 2 * (i % 2)]) {
      return DMA_DESCRIPTORS;
    }
  }
  return ALL_WELL;
}

/* Two buffers in turn, by a ring; the source goes round by itself. */
static enum check check_dma_ring(void) {
  static struct dma_large_descriptor ring[2];
  for (int i = 0; i < 2; ++i) {
    ring[i].next_desc_ptr = &ring[1 - i];
    ring[i].start_addr = bytes_in_l1 + 64 * i;
    ring[i].config = UNIT | WNR | DMAFLOW_LARGE | NDSIZE(5);
  }
  source->start_addr = (uint32_t)bytes_in_l2;
  source->x_count = 32;
  source->x_modify = 2;
  destination->next_desc_ptr = (uint32_t)ring;
  destination->x_count = 32;
  destination->x_modify = 2;
  __builtin_bfin_ssync();
  source->config = UNIT | DMAFLOW_AUTO;
  destination->config = UNIT | WNR | DMAFLOW_LARGE | NDSIZE(5);
  for (int round = 0; round < 6; ++round) {
    wait_for_done();
    if (destination->curr_desc_ptr - (uint32_t)&ring[(round + 1) % 2] > sizeof ring[0]) {
      return DMA_RING;
    }
  }
  destination->config = 0;
  source->config = 0;
  for (int i = 0; i < 128; ++i) {
    if (bytes_in_l1[i] != bytes_in_l2[i % 64]) {
      return DMA_RING;
    }
  }
  return ALL_WELL;
}

/* Beside core B, which does the same. */
static void start_core_b_and_count(void) {
  SICA_SYSCR &= ~COREB_SRAM_INIT;
  for (int i = 0; i < COUNTED_BY_EACH; ++i) {
    count_under_lock();
  }
}

/* Loses a wake-up and the machine stands still. */
static void play_with_core_b(void) {
  for (unsigned round = 1; round <= 300; ++round) {
    thrown = round;
    core_interrupt_raise(CORE_B);
    pause_for(round * 11 % 64);
    WAIT_UNTIL(returned == round);
  }
}

int main(void) {
  enum check result = check_division();
  memory_dma_start(CORE_A);
  core_interrupt_start(CORE_A);
  events_enable();
  if (result == ALL_WELL) {
    result = check_memory_functions();
  }
  if (result == ALL_WELL) {
    result = check_dma_copies(bytes_in_l1, bytes_in_l3);
  }
  if (result == ALL_WELL) {
    result = check_dma_copies(bytes_in_l3, other_bytes_in_l1);
  }
  if (result == ALL_WELL) {
    result = check_dma_copies(bytes_in_l1, bytes_in_l2);
  }
  if (result == ALL_WELL) {
    result = check_dma_copies(bytes_in_l2, bytes_in_l3);
  }
  if (result == ALL_WELL) {
    result = check_dma_gather();
  }
  if (result == ALL_WELL) {
    result = check_dma_descriptors();
  }
  if (result == ALL_WELL) {
    result = check_dma_ring();
  }
  meet_the_end_of_dma();
  start_core_b_and_count();
  play_with_core_b();
  if (result == ALL_WELL && counted != 2 * COUNTED_BY_EACH) {
    result = LOCK;
  }
  host_print(result == ALL_WELL ? "all checks passed\n" : "a check failed\n");
  return (int)result;
}
