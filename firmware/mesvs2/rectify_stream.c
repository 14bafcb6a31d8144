#include "rectify_stream.h"

#include <bf561.h>
#include <finback/blackfin.h>
#include <memory_dma.h>

#include "rectify.h"

/* 1: a band comes, and the one before leaves, while one is computed. 0: one after the other. */
#ifndef DOUBLE_BUFFERED
#define DOUBLE_BUFFERED 1
#endif

/* Of the flash in bank 0, in SCLK: setup 3, access 11, hold 2. */
#define FLASH_TIMES 0xFFC27BB0u

#define BAND_ROWS 4
#define BANDS_OF_PICTURE (MAP_HEIGHT / BAND_ROWS)
#define BAND_COUNT (2 * BANDS_OF_PICTURE)
_Static_assert(BANDS_OF_PICTURE* BAND_ROWS == MAP_HEIGHT, "bands fill the picture");

struct band {
  struct rectification_row rows[BAND_ROWS];
};

/* The left picture's bands, then the right one's. */
_Alignas(4) struct band rectification_tables[BAND_COUNT];
_Alignas(4) struct band table_bands[2];
_Alignas(4) uint8_t rectified_bands[2][BAND_ROWS * MAP_WIDTH];

static int flash_has_tables(const volatile struct rectification_header* header) {
  return header->magic == RECTIFICATION_MAGIC && header->width == MAP_WIDTH &&
         header->height == MAP_HEIGHT;
}

/* Band by band: a transfer has at most 65536 elements. */
static void copy_tables(const struct band* source) {
  for (int band = 0; band < BAND_COUNT; ++band) {
    memory_dma_copy(&rectification_tables[band], &source[band], sizeof source[band]);
  }
}

static void make_identity(void) {
  for (int band = 0; band < BAND_COUNT; ++band) {
    struct band* buffer = &table_bands[band % 2];
    for (int row = 0; row < BAND_ROWS; ++row) {
      identity_row(band % BANDS_OF_PICTURE * BAND_ROWS + row, &buffer->rows[row]);
    }
    memory_dma_copy(&rectification_tables[band], buffer, sizeof *buffer);
  }
}

void rectify_start(void) {
  const struct rectification_header* header = (const void*)FLASH_BASE;

  EBIU_AMBCTL0 = FLASH_TIMES;
  __builtin_bfin_ssync();
  if (flash_has_tables(header)) {
    copy_tables((const void*)(header + 1));
  } else {
    make_identity();
  }
  memory_dma_wait();
}

static void fetch_band(int band) {
  memory_dma_copy(&table_bands[band % 2], &rectification_tables[band], sizeof(struct band));
}

/* What is to be done with a band that is computed, and with its table's place. */
static void store_band(int band, uint8_t* rectified) {
  struct memory_dma_piece pieces[2] = {
      {rectified, rectified_bands[band % 2], sizeof rectified_bands[0]},
      {&table_bands[band % 2], &rectification_tables[band + 2], sizeof(struct band)}};
  if (DOUBLE_BUFFERED && band + 2 < BAND_COUNT) {
    memory_dma_copy_both(pieces);
  } else {
    memory_dma_copy(pieces[0].destination, pieces[0].source, pieces[0].bytes);
  }
}

void rectify_pictures(const uint8_t* left, const uint8_t* right, uint8_t* rectified_left,
                      uint8_t* rectified_right) {
  const uint8_t* image = left;
  uint8_t* rectified = rectified_left;

  if (DOUBLE_BUFFERED) {
    fetch_band(0);
    fetch_band(1);
  }
  for (int band = 0; band < BAND_COUNT; ++band) {
    if (band == BANDS_OF_PICTURE) {
      image = right;
      rectified = rectified_right;
    }
    if (!DOUBLE_BUFFERED) {
      fetch_band(band);
      memory_dma_wait();
    }
    rectify_rows(image, table_bands[band % 2].rows, BAND_ROWS, rectified_bands[band % 2]);
    store_band(band, rectified); /* when the band behind this one has come */
    if (!DOUBLE_BUFFERED) {
      memory_dma_wait();
    }
    rectified += sizeof rectified_bands[0];
  }
  memory_dma_wait();
}
