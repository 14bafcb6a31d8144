#include "pipeline.h"

static void change(uint32_t full_slots, uint32_t pairs) {
  unsigned mask = lock_take(&pipeline.lock);
  pipeline.full_slots += full_slots;
  pipeline.pairs += pairs;
  lock_give(&pipeline.lock, mask);
}

/* One word, but only the lock says that it is not older than what it counts. */
static uint32_t look_at(const uint32_t* number) {
  unsigned mask = lock_take(&pipeline.lock);
  uint32_t seen = *number;
  lock_give(&pipeline.lock, mask);
  return seen;
}

void pipeline_slot_filled(void) { change(1, 1); }
void pipeline_slot_emptied(void) { change(-1u, 0); }
void pipeline_map_published(void) { change(0, -1u); }
uint32_t pipeline_full_slots(void) { return look_at(&pipeline.full_slots); }
uint32_t pipeline_pairs(void) { return look_at(&pipeline.pairs); }
