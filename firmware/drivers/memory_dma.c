#include "memory_dma.h"

#include <bf561.h>

#include "events.h"

static volatile struct dma_registers* destination_channel;
static volatile struct dma_registers* source_channel;
static volatile int transfer_under_way;

/* What the transfers begun last write outside L1, where a data cache may hold older bytes. */
#define L1_BEGIN 0xFF800000u
#define CACHE_LINE 32u
static struct {
  uint32_t begin;
  uint32_t end;
} written[2];

/* Of memory_dma_copy_both. */
static volatile struct dma_large_descriptor destination_list[2];
static volatile struct dma_large_descriptor source_list[2];

FINBACK_INTERRUPT static void transfer_done(void) {
  destination_channel->irq_status = DMA_DONE; /* written as 1 to withdraw the request */
  __builtin_bfin_ssync();
  transfer_under_way = 0;
}

void memory_dma_start(enum core core) {
  unsigned stream = core == CORE_A ? 0 : 1;
  destination_channel =
      (volatile struct dma_registers*)(MDMA1_D0_BASE + stream * MDMA1_STREAM_STRIDE);
  source_channel = (volatile struct dma_registers*)(MDMA1_S0_BASE + stream * MDMA1_STREAM_STRIDE);
  events_attach(core, IRQ_MDMA1_STREAM(stream), EVT_IVG8, transfer_done);
}

/* The source's side is enabled first: the transfer runs from when the destination's is. */
static void enable(unsigned shape) {
  transfer_under_way = 1;
  /* What the core has written must have arrived before it is read by DMA. */
  __builtin_bfin_ssync();
  source_channel->config = (uint16_t)(shape | DMAEN);
  destination_channel->config = (uint16_t)(shape | DI_EN | WNR | DMAEN);
}

static unsigned element_log2(unsigned combined) {
  if (combined % 2 != 0) {
    return 0;
  }
  return combined % 4 != 0 ? 1 : 2;
}

static void will_write(unsigned piece, const void* destination, unsigned bytes) {
  if ((uint32_t)destination < L1_BEGIN) {
    written[piece].begin = (uint32_t)destination & ~(CACHE_LINE - 1);
    written[piece].end = (uint32_t)destination + bytes;
  }
}

/* The core's next reads of what was written come from memory. */
static void forget_cached(void) {
  for (unsigned piece = 0; piece < 2; ++piece) {
    for (uint32_t line = written[piece].begin; line < written[piece].end; line += CACHE_LINE) {
      __builtin_bfin_flushinv((const void*)line);
    }
    written[piece].begin = written[piece].end;
  }
}

void memory_dma_copy(void* destination, const void* source, unsigned bytes) {
  unsigned log2 = element_log2((uint32_t)destination | (uint32_t)source | bytes);

  memory_dma_wait();
  will_write(0, destination, bytes);
  source_channel->start_addr = (uint32_t)source;
  source_channel->x_count = (uint16_t)(bytes >> log2);
  source_channel->x_modify = (int16_t)(1 << log2);
  destination_channel->start_addr = (uint32_t)destination;
  destination_channel->x_count = (uint16_t)(bytes >> log2);
  destination_channel->x_modify = (int16_t)(1 << log2);
  enable(log2 * WDSIZE_16); /* WDSIZE is the logarithm */
}

static void describe(volatile struct dma_large_descriptor* descriptor, const void* start,
                     unsigned bytes, unsigned config) {
  descriptor->start_addr = (void*)start;
  descriptor->config = (uint16_t)(config | WDSIZE_32 | DMAEN);
  descriptor->x_count = (uint16_t)(bytes / 4);
  descriptor->x_modify = 4;
}

void memory_dma_copy_both(const struct memory_dma_piece pieces[2]) {
  const unsigned followed = DMAFLOW_LARGE | NDSIZE(7); /* down to x_modify */

  memory_dma_wait();
  will_write(0, pieces[0].destination, pieces[0].bytes);
  will_write(1, pieces[1].destination, pieces[1].bytes);
  describe(&source_list[0], pieces[0].source, pieces[0].bytes, followed);
  describe(&source_list[1], pieces[1].source, pieces[1].bytes, DMAFLOW_STOP);
  describe(&destination_list[0], pieces[0].destination, pieces[0].bytes, followed | WNR);
  describe(&destination_list[1], pieces[1].destination, pieces[1].bytes,
           DMAFLOW_STOP | DI_EN | WNR);
  source_list[0].next_desc_ptr = (void*)&source_list[1];
  destination_list[0].next_desc_ptr = (void*)&destination_list[1];
  source_channel->next_desc_ptr = (uint32_t)&source_list[0];
  destination_channel->next_desc_ptr = (uint32_t)&destination_list[0];
  transfer_under_way = 1;
  __builtin_bfin_ssync();
  source_channel->config = (uint16_t)(followed | WDSIZE_32 | DMAEN);
  destination_channel->config = (uint16_t)(followed | WDSIZE_32 | WNR | DMAEN);
}

void memory_dma_gather(void* destination, const void* source, unsigned columns, unsigned rows,
                       int step, int source_width) {
  memory_dma_wait();
  will_write(0, destination, columns * rows);
  source_channel->start_addr = (uint32_t)source;
  source_channel->x_count = (uint16_t)columns;
  source_channel->x_modify = (int16_t)step;
  source_channel->y_count = (uint16_t)rows;
  /* Y_MODIFY takes the place of X_MODIFY after a row's last element. */
  source_channel->y_modify = (int16_t)(step * source_width - ((int)columns - 1) * step);
  destination_channel->start_addr = (uint32_t)destination;
  destination_channel->x_count = (uint16_t)columns;
  destination_channel->x_modify = 1;
  destination_channel->y_count = (uint16_t)rows;
  destination_channel->y_modify = 1;
  enable(WDSIZE_8 | DMA2D);
}

void memory_dma_wait(void) {
  WAIT_UNTIL(!transfer_under_way);
  forget_cached();
}
