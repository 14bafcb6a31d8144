/* How full the pipeline of the two cores is. Core A fills slots, core B empties them and publishes
 * maps; both count, under a lock. Each tells the other by an interrupt that it may look again. */
#ifndef MESVS2_PIPELINE_H
#define MESVS2_PIPELINE_H

#include <lock.h>
#include <stdint.h>

struct pipeline {
  struct lock lock;
  uint32_t full_slots; /* handed over and not yet received */
  uint32_t pairs;      /* handed over, their maps not yet published */
};
extern struct pipeline pipeline;

/* Core A: one more slot is full. Core B: one is empty again; a map is published. */
void pipeline_slot_filled(void);
void pipeline_slot_emptied(void);
void pipeline_map_published(void);

uint32_t pipeline_full_slots(void);
uint32_t pipeline_pairs(void);

#endif
