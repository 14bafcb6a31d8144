#include "camera.h"

#include <bf561.h>

#include "events.h"

static volatile unsigned captures_under_way; /* a bit a camera */
static void (*listener)(unsigned camera);

static volatile struct dma_registers* channel_of(unsigned camera) {
  return (volatile struct dma_registers*)(DMA1_0_BASE + camera * DMA_CHANNEL_STRIDE);
}

static volatile struct ppi_registers* port_of(unsigned camera) {
  return (volatile struct ppi_registers*)(PPI0_BASE + camera * PPI_STRIDE);
}

FINBACK_INTERRUPT static void frame_captured(void) {
  for (unsigned camera = 0; camera < 2; ++camera) {
    if (channel_of(camera)->irq_status & DMA_DONE) {
      port_of(camera)->control = 0;              /* before the next frame comes */
      channel_of(camera)->irq_status = DMA_DONE; /* written as 1 to withdraw the request */
      captures_under_way &= ~(1u << camera);
      if (listener != 0) {
        listener(camera);
      }
    }
  }
  __builtin_bfin_ssync();
}

void camera_start(enum core core) {
  events_attach(core, IRQ_DMA1_CHANNEL(0), EVT_IVG9, frame_captured);
  events_attach(core, IRQ_DMA1_CHANNEL(1), EVT_IVG9, frame_captured);
}

void camera_listen(void (*ended)(unsigned camera)) { listener = ended; }

void camera_capture(unsigned camera, uint8_t* luma, unsigned width, unsigned height) {
  volatile struct dma_registers* channel = channel_of(camera);
  volatile struct ppi_registers* port = port_of(camera);
  unsigned mask = __builtin_bfin_cli(); /* the handler changes the same word */

  captures_under_way |= 1u << camera;
  __builtin_bfin_sti(mask);
  /* Two pixels an element, row behind row. */
  channel->start_addr = (uint32_t)luma;
  channel->x_count = (uint16_t)(width / 2);
  channel->x_modify = 2;
  channel->y_count = (uint16_t)height;
  channel->y_modify = 2;
  channel->config = DI_EN | DMA2D | WDSIZE_16 | WNR | DMAEN;
  port->count = (uint16_t)(2 * width - 1); /* clocks of a line: Y U Y V */
  port->delay = 0;
  port->frame = (uint16_t)height;
  port->control = PPI_SKIP_EN | PPI_PACK_EN | PPI_TWO_SYNCS | PPI_SYNCS | PPI_EN;
  __builtin_bfin_ssync();
}

void camera_wait(void) { WAIT_UNTIL(captures_under_way == 0); }

unsigned camera_errors(unsigned camera) {
  unsigned status = port_of(camera)->status;

  port_of(camera)->status = (uint16_t)status;
  return status;
}
