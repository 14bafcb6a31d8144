/* Memory to memory DMA on MDMA1: core A uses stream 0, core B stream 1. One transfer at a time. */
#ifndef FINBACK_MEMORY_DMA_H
#define FINBACK_MEMORY_DMA_H

#include <core.h>

/* Takes the calling core's stream and attaches its interrupt. */
void memory_dma_start(enum core core);

/* Begins to copy `bytes` bytes in the largest elements that both addresses and the size allow
 * (at most 65536 of them). */
void memory_dma_copy(void* destination, const void* source, unsigned bytes);

/* Some bytes to copy: aligned to 4 bytes, and so many. */
struct memory_dma_piece {
  void* destination;
  const void* source;
  unsigned bytes;
};

/* Begins to copy two pieces, one behind the other: one transfer, which needs no core between. */
void memory_dma_copy_both(const struct memory_dma_piece pieces[2]);

/* Begins to gather `columns` x `rows` bytes: every `step`-th byte of every `step`-th row of an
 * image whose rows are `source_width` bytes long. */
void memory_dma_gather(void* destination, const void* source, unsigned columns, unsigned rows,
                       int step, int source_width);

/* Sleeps until the transfer begun last is complete; returns at once when none was begun. Beginning
 * another one waits as well. The calling core's data cache has nothing of the destination then,
 * which must not be cached for writing back. */
void memory_dma_wait(void);

#endif
