#include "signals.h"

volatile uint32_t frames_ready;
volatile uint32_t frames_matched;
