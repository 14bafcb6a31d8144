/* What a program of csmith includes, in the form that both the host and the simulated machine take:
 * its safe arithmetic from csmith's own headers, its checksum as lines of report.h. */
#ifndef CSMITH_H
#define CSMITH_H

#include <float.h>
#include <limits.h>
#include <stdint.h>

#include "../programs/report.h"

/* What the safe arithmetic of floating point asks for; nothing here uses it. */
static inline float fabsf(float value) { return value < 0 ? -value : value; }
static inline double fabs(double value) { return value < 0 ? -value : value; }
#define STATIC static
#define UNDEFINED(value) (value)
#define LOG_INDEX
#define LOG_EXEC
#define FUNC_NAME(name) (safe_##name)
#include <safe_math.h>
#undef FUNC_NAME

#define _CSMITH_BITFIELD(bits) ((bits) > 32 ? (bits) % 32 : (bits))

#define printf(...) ((void)0) /* of indices, when somebody asks */

static uint32_t crc32_context;

static void transparent_crc(uint64_t value, const char *name, int show) {
  crc32_context = mix(mix(crc32_context, (uint32_t)value), (uint32_t)(value >> 32));
}

static void transparent_crc_bytes(const char *bytes, int count, const char *name, int show) {
  for (int i = 0; i < count; i++)
    transparent_crc((uint8_t)bytes[i], name, show);
}

static void crc32_gentab(void) {}
static void platform_main_begin(void) {}
static void platform_main_end(uint32_t sum, int show) { report("checksum", sum); }

#endif
