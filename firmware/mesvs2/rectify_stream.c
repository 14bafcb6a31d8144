#include "rectify_stream.h"

#include <bf561.h>
#include <finback/blackfin.h>
#include <memory_dma.h>

#include "prepare.h"
#include "rectify.h"

/* 1: a band comes, and the one before leaves, while one is computed. 0: one after the other. */
#ifndef DOUBLE_BUFFERED
#define DOUBLE_BUFFERED 1
#endif

/* Of the flash in bank 0, in SCLK: setup 3, access 11, hold 2. */
#define FLASH_TIMES 0xFFC27BB0u

#define BAND_COUNT (2 * BANDS_OF_PICTURE)

struct band {
  struct rectification_row rows[BAND_ROWS];
};

/* The left picture's bands, then the right one's. */
_Alignas(4) struct band rectification_tables[BAND_COUNT];
_Alignas(4) struct band table_bands[2];
_Alignas(4) uint8_t code_bands[2][BAND_ROWS + 1][MAP_WIDTH];

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

/* Waits for its table, where it does not come beside the computing. */
__attribute__((noinline)) void rectify_band(int band, int y, const uint8_t* image) {
  if (!DOUBLE_BUFFERED) {
    fetch_band(band);
    memory_dma_wait();
  }
  rectify_rows(image, table_bands[band % 2].rows, BAND_ROWS, rectified_line(y));
}

/* Sends a band's codes to their rows, and fetches the table that takes the place of the band's.
 * Waits until the transfer before is over: the next band's table has come then. */
__attribute__((noinline)) void send_codes(int band, int y, uint8_t* codes) {
  int first = first_code_row(y);
  struct memory_dma_piece pieces[2] = {
      {codes + (y - 1 + first) * MAP_WIDTH, code_bands[band % 2][first],
       (unsigned)((end_of_code_rows(y) - first) * MAP_WIDTH)},
      {&table_bands[band % 2], &rectification_tables[band + 2], sizeof(struct band)}};
  if (DOUBLE_BUFFERED && band + 2 < BAND_COUNT) {
    memory_dma_copy_both(pieces);
    return;
  }
  memory_dma_copy(pieces[0].destination, pieces[0].source, pieces[0].bytes);
  if (!DOUBLE_BUFFERED) {
    memory_dma_wait();
  }
}

static void prepare_picture(int first_band, const uint8_t* image, uint8_t* codes,
                            uint32_t (*plain)[FLAG_WORDS]) {
  for (int i = 0; i < BANDS_OF_PICTURE; ++i) {
    int band = first_band + i;
    int y = i * BAND_ROWS;
    rectify_band(band, y, image);
    prepare_codes(y, code_bands[band % 2]);
    if (plain != 0) {
      prepare_texture(y, plain + y);
    }
    send_codes(band, y, codes);
  }
}

void prepare_pictures(const uint8_t* left, const uint8_t* right, uint8_t* left_codes,
                      uint8_t* right_codes, uint32_t (*plain)[FLAG_WORDS]) {
  if (DOUBLE_BUFFERED) {
    fetch_band(0);
    fetch_band(1);
  }
  prepare_picture(0, left, left_codes, plain);
  prepare_picture(BANDS_OF_PICTURE, right, right_codes, 0);
  memory_dma_wait();
}
