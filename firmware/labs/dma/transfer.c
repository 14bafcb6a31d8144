/* Memory DMA reads the cameras' pixels and writes the map, beside the computing: while two rows are
 * worked on, the next two come, first the left view's, then the right one's. */
#include <memory_dma.h>

#include "../common/lab.h"

#define BLOCK_ROWS 2 /* fetched together */

void transfer_start(enum core core) { memory_dma_start(core); }

static void fetch_block(const uint8_t* frame, uint8_t* lines, const struct columns* columns,
                        int row) {
  memory_dma_gather(line_of(lines, columns, row),
                    frame + (row * CAMERA_WIDTH + columns->first) * SUBSAMPLING,
                    (unsigned)columns->count, BLOCK_ROWS, SUBSAMPLING, CAMERA_WIDTH);
}

__attribute__((noinline)) void fetch_row(int row) {
  int next = (row | (BLOCK_ROWS - 1)) + 1;
  if (row == 0) {
    fetch_block(vga_left, left_lines, &left_columns, 0);
    fetch_block(vga_right, right_lines, &right_columns, 0);
  }
  memory_dma_wait();
  if (next >= MAP_HEIGHT) {
    return;
  }
  if (row % BLOCK_ROWS == 0) {
    fetch_block(vga_left, left_lines, &left_columns, next);
  } else {
    fetch_block(vga_right, right_lines, &right_columns, next);
  }
}

__attribute__((noinline)) void store_row(int y, const uint8_t* disparities) {
  memory_dma_copy(disparity_map + y * MAP_WIDTH + stored_columns.first,
                  disparities + stored_columns.first, (unsigned)stored_columns.count);
}

void transfer_finish(void) { memory_dma_wait(); }
