/* Each camera fills two buffers in turn, for itself, without a pause: its interrupt begins the next
 * capture. The newest whole frame of each is kept for the pipeline; a frame that comes while the
 * one before has not been taken takes its place, and one that comes while the other buffer is being
 * read is given up. Frames that a camera drops or sends late make no pair with the other one's:
 * two frames are one when they have ended within a quarter of a frame of each other. */
#include <bf561.h>
#include <camera.h>
#include <events.h>
#include <host_port.h>
#include <sysreg.h>

#include "frames.h"
#include "stereo_config.h"

#define NONE (-1)
#define CYCLES_COUNT 2u /* SYSCFG: CCEN */

_Alignas(4) uint8_t vga_left[2][CAMERA_WIDTH * CAMERA_HEIGHT];
_Alignas(4) uint8_t vga_right[2][CAMERA_WIDTH * CAMERA_HEIGHT];

struct view {
  int filling;     /* buffers, or NONE */
  int ready;       /* whole, and the newest */
  int lent;        /* to the pipeline */
  unsigned number; /* of the frame in `ready` */
  unsigned ended;  /* and when it ended, cycles */
  unsigned period; /* the least time between two frames so far, cycles; 0: not known yet */
  unsigned frames; /* captured so far */
  unsigned last_ended;
};

static volatile struct view views[2];
static unsigned frames_wanted;

/* What did not become a map: overtaken by a newer one or without a partner; spoilt on the way. */
volatile unsigned frames_skipped[2];
volatile unsigned frames_damaged[2];

static void capture(unsigned camera) {
  int buffer = views[camera].filling;
  camera_capture(camera, camera == 0 ? vga_left[buffer] : vga_right[buffer], CAMERA_WIDTH,
                 CAMERA_HEIGHT);
}

static void measure_period(volatile struct view* view, unsigned now) {
  unsigned period = now - view->last_ended;
  if (view->frames > 0 && (view->period == 0 || period < view->period)) {
    view->period = period;
  }
  view->last_ended = now;
}

/* In the interrupt of a frame's end. */
static void frame_ended(unsigned camera) {
  volatile struct view* view = &views[camera];
  unsigned now = sysreg_read(reg_CYCLES);

  measure_period(view, now);
  if (camera_errors(camera) != 0) {
    ++frames_damaged[camera];
  } else if (view->lent == 1 - view->filling) {
    ++frames_skipped[camera];
  } else {
    if (view->ready != NONE) {
      ++frames_skipped[camera];
    }
    view->ready = view->filling;
    view->number = view->frames;
    view->ended = now;
    view->filling = 1 - view->filling;
  }
  ++view->frames;
  capture(camera);
}

/* To be called with interrupts held back. */
static int pair_is_ready(void) {
  unsigned tolerance = views[0].period < views[1].period ? views[0].period : views[1].period;
  int apart = (int)(views[0].ended - views[1].ended);

  return views[0].ready != NONE && views[1].ready != NONE &&
         (unsigned)(apart < 0 ? -apart : apart) < tolerance / 4;
}

void frames_start(void) {
  frames_wanted = host_frames_left();
  sysreg_write(reg_SYSCFG, sysreg_read(reg_SYSCFG) | CYCLES_COUNT);
  camera_start(CORE_A);
  camera_listen(frame_ended);
  for (unsigned camera = 0; camera < 2; ++camera) {
    views[camera].ready = NONE;
    views[camera].lent = NONE;
    capture(camera);
  }
}

__attribute__((noinline)) static void lend(volatile struct view* view) {
  view->lent = view->ready;
  view->ready = NONE;
}

__attribute__((noinline)) void wait_for_cameras(void) { WAIT_UNTIL(pair_is_ready()); }

__attribute__((noinline)) int acquire_frame(struct frame_pair* pair) {
  if (frames_wanted == 0) {
    return 0;
  }
  for (;;) {
    unsigned mask;
    int taken;
    wait_for_cameras();
    mask = __builtin_bfin_cli();
    taken = pair_is_ready(); /* still: a newer frame of one may have come */
    if (taken) {
      lend(&views[0]);
      lend(&views[1]);
    }
    __builtin_bfin_sti(mask);
    if (taken) {
      break;
    }
  }
  --frames_wanted;
  pair->left = vga_left[views[0].lent];
  pair->right = vga_right[views[1].lent];
  pair->number = views[0].number;
  return 1;
}

void release_frame(void) {
  views[0].lent = NONE;
  views[1].lent = NONE;
}

static void print_number(unsigned number) {
  static const unsigned powers[] = {1000000000, 100000000, 10000000, 1000000, 100000,
                                    10000,      1000,      100,      10,      1};
  char digits[11];
  char* end = digits;
  for (unsigned i = 0; i < sizeof powers / sizeof powers[0]; ++i) {
    char digit = '0';
    for (; number >= powers[i]; number -= powers[i]) {
      ++digit;
    }
    if (digit != '0' || end != digits || powers[i] == 1) {
      *end++ = digit;
    }
  }
  *end = 0;
  host_print(digits);
}

void frames_end(void) {
  for (unsigned camera = 0; camera < 2; ++camera) {
    host_print(camera == 0 ? "frames skipped, damaged: left " : "; right ");
    print_number(frames_skipped[camera]);
    host_print(", ");
    print_number(frames_damaged[camera]);
  }
  host_print("\n");
}
