/* The ADSP-BF561's memory-mapped registers that the firmware uses, under the names of ADI's
 * defBF561.h; of repeated blocks, the base and the layout. */
#ifndef FINBACK_BF561_H
#define FINBACK_BF561_H

#include <stdint.h>

#define BF561_REGISTER_16(address) (*(volatile uint16_t*)(address))
#define BF561_REGISTER_32(address) (*(volatile uint32_t*)(address))

/* --- system interrupt controllers, one a core --- */

#define SICA_BASE 0xFFC00100u
#define SICB_BASE 0xFFC01100u
#define SICA_SYSCR BF561_REGISTER_32(SICA_BASE + 0x04u)
#define SICB_SYSCR BF561_REGISTER_32(SICB_BASE + 0x04u)

/* SICA_SYSCR: core B is held in reset while set. */
#define COREB_SRAM_INIT 0x20u

/* SICB_SYSCR: bits that raise and acknowledge supplemental interrupt 0 of a core (0 A, 1 B). */
#define SUPPLEMENTAL_0_RAISE(core) (1u << (6 + (core)))
#define SUPPLEMENTAL_0_ACKNOWLEDGE(core) (1u << (10 + (core)))

struct sic_registers {
  uint32_t swrst;
  uint32_t syscr;
  uint32_t rvect;
  uint32_t imask[2]; /* 1: the source may interrupt */
  uint32_t isr[2];
  uint32_t iwr[2]; /* 1: the source ends IDLE */
  uint32_t iar[8]; /* 8 sources each, 4 bits a source: its IVG less 7 */
};

/* Interrupt sources. */
#define IRQ_DMA1_ERROR 1
#define IRQ_DMA2_ERROR 2
#define IRQ_IMDMA_ERROR 3
#define IRQ_DMA1_CHANNEL(channel) (11 + (channel)) /* 0: PPI0, 1: PPI1 */
#define IRQ_DMA2_CHANNEL(channel) (23 + (channel))
#define IRQ_MDMA1_STREAM(stream) (53 + (stream))
#define IRQ_SUPPLEMENTAL_0 62

/* --- external memory --- */

#define FLASH_BASE 0x20000000u /* asynchronous bank 0 */
#define EBIU_AMBCTL0 BF561_REGISTER_32(0xFFC00A04u)

/* --- DMA (docs/dma.md): channels of peripherals, and of memory DMA two streams, each a destination
 * and a source channel --- */

#define DMA1_0_BASE 0xFFC01C00u
#define DMA2_0_BASE 0xFFC00C00u
#define DMA_CHANNEL_STRIDE 0x40u
#define DMA1_TC_PER BF561_REGISTER_16(0xFFC01B0Cu)
#define DMA2_TC_PER BF561_REGISTER_16(0xFFC00B0Cu)
#define MDMA1_D0_BASE 0xFFC01F00u
#define MDMA1_S0_BASE 0xFFC01F40u
#define MDMA1_STREAM_STRIDE 0x80u
#define MDMA2_D0_BASE 0xFFC00F00u
#define MDMA2_S0_BASE 0xFFC00F40u

struct dma_registers {
  uint32_t next_desc_ptr;
  uint32_t start_addr;
  uint16_t config, reserved_0a;
  uint32_t reserved_0c;
  uint16_t x_count, reserved_12;
  int16_t x_modify, reserved_16;
  uint16_t y_count, reserved_1a;
  int16_t y_modify, reserved_1e;
  uint32_t curr_desc_ptr;
  uint32_t curr_addr;
  uint16_t irq_status, reserved_2a;
  uint16_t peripheral_map, reserved_2e;
  uint16_t curr_x_count, reserved_32;
  uint32_t reserved_34;
  uint16_t curr_y_count, reserved_3a;
};

/* A descriptor of a large list; of a small one next_desc_ptr is 16 bits wide, an array has none. */
struct dma_large_descriptor {
  void* next_desc_ptr;
  void* start_addr;
  uint16_t config;
  uint16_t x_count;
  int16_t x_modify;
  uint16_t y_count;
  int16_t y_modify;
};

/* CONFIG */
#define DMAEN 0x0001u
#define WNR 0x0002u
#define WDSIZE_8 0x0000u
#define WDSIZE_16 0x0004u
#define WDSIZE_32 0x0008u
#define DMA2D 0x0010u
#define RESTART 0x0020u
#define DI_SEL 0x0040u
#define DI_EN 0x0080u
#define NDSIZE(words) ((words) << 8)
#define DMAFLOW_STOP 0x0000u
#define DMAFLOW_AUTO 0x1000u
#define DMAFLOW_ARRAY 0x4000u
#define DMAFLOW_SMALL 0x6000u
#define DMAFLOW_LARGE 0x7000u

/* IRQ_STATUS */
#define DMA_DONE 0x0001u
#define DMA_ERR 0x0002u
#define DFETCH 0x0004u
#define DMA_RUN 0x0008u

/* --- parallel ports: PPI0 and PPI1 --- */

#define PPI0_BASE 0xFFC01000u
#define PPI_STRIDE 0x300u

struct ppi_registers {
  uint16_t control, reserved_02;
  uint16_t status, reserved_06; /* written as 1 to clear */
  uint16_t count, reserved_0a;  /* clocks that are taken of a line, less 1 */
  uint16_t delay, reserved_0e;  /* clocks before them */
  uint16_t frame, reserved_12;  /* lines */
};

/* CONTROL */
#define PPI_EN 0x0001u
#define PPI_SYNCS 0x000Cu     /* XFR_TYPE: frame syncs, not ITU-656 */
#define PPI_TWO_SYNCS 0x0020u /* PORT_CFG: HREF and VSYNC */
#define PPI_PACK_EN 0x0080u
#define PPI_SKIP_EN 0x0200u

/* STATUS */
#define PPI_FT_ERR 0x0800u
#define PPI_OVR 0x1000u

/* --- the core's own event controller --- */

#define EVT(ivg) BF561_REGISTER_32(0xFFE02000u + 4u * (ivg))
#define EVT_IVG7 7
#define EVT_IVG8 8
#define EVT_IVG9 9

#endif
