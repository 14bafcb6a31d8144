#include "shared_checks.h"

_Alignas(4) uint8_t bytes_in_l2[CHECKED_BYTES];
_Alignas(4) uint8_t bytes_in_l3[CHECKED_BYTES];
volatile uint32_t thrown;
volatile uint32_t returned;
struct lock counted_lock;
uint32_t counted;
