/* A scheduler of a firmware in small: tasks with priorities and deadlines, a heap of timers,
 * messages in rings, a semaphore, a log of what ran when; all by tables of functions and states. */
#include <string.h>

#include "report.h"

enum { idle, ready, blocked };
struct task {
  int (*step)(struct task*);
  unsigned char priority, state, phase;
  unsigned runs, waited, data;
};
struct timer {
  unsigned due;
  short task;
  unsigned short period;
};
struct ring {
  unsigned short items[8];
  volatile unsigned char head, tail;
};
static struct task tasks[5];
static struct timer timers[12];
static int timer_count;
static struct ring ring;
static unsigned now, history;
static signed char tokens = 1;

static void add_timer(unsigned due, int task, unsigned period) {
  int at = timer_count++;
  for (; at > 0 && (int)(due - timers[(at - 1) / 2].due) < 0; at = (at - 1) / 2)
    timers[at] = timers[(at - 1) / 2];
  timers[at] = (struct timer){due, (short)task, (unsigned short)period};
}
static struct timer take_timer(void) {
  struct timer top = timers[0], last = timers[--timer_count];
  int at = 0;
  for (int child; (child = 2 * at + 1) < timer_count; at = child) {
    if (child + 1 < timer_count && (int)(timers[child + 1].due - timers[child].due) < 0)
      child++;
    if ((int)(timers[child].due - last.due) >= 0)
      break;
    timers[at] = timers[child];
  }
  timers[at] = last;
  return top;
}
static int put(unsigned value) {
  if ((unsigned char)(ring.head - ring.tail) == 8)
    return 0;
  ring.items[ring.head++ & 7] = (unsigned short)value;
  return 1;
}
static int get(void) { return ring.head == ring.tail ? -1 : ring.items[ring.tail++ & 7]; }

static int producer(struct task* t) {
  for (int i = 0; i < 3; i++)
    if (!put(t->data++ * 7 + now))
      return blocked;
  return idle;
}
static int consumer(struct task* t) {
  int value = get();
  if (value < 0)
    return blocked;
  t->data = mix(t->data, (unsigned)value);
  tasks[0].state = tasks[0].state == blocked ? ready : tasks[0].state;
  return ready;
}
static int worker(struct task* t) {
  switch (t->phase) {
    case 0:
      if (tokens == 0)
        return blocked;
      tokens--;
      t->phase = 1;
      return ready;
    case 1:
    case 2:
    case 3:
      t->data += t->phase++;
      return ready;
    default:
      tokens++;
      t->phase = 0;
      for (int i = 2; i < 4; i++)
        if (tasks[i].state == blocked)
          tasks[i].state = ready;
      return idle;
  }
}
static int monitor(struct task* t) {
  for (int i = 0; i < 4; i++)
    if (tasks[i].waited > t->data)
      t->data = tasks[i].waited;
  if (t->runs % 3 == 2)
    add_timer(now + 5, 1, 0);
  return idle;
}
APART static int choose(void) {
  int best = -1;
  for (int i = 0; i < 5; i++) {
    if (tasks[i].state != ready)
      continue;
    tasks[i].waited++;
    if (best < 0 ||
        tasks[i].priority + tasks[i].waited / 8 > tasks[best].priority + tasks[best].waited / 8)
      best = i;
  }
  return best;
}

int main(void) {
  static int (*const steps[])(struct task*) = {producer, consumer, worker, worker, monitor};
  static const unsigned char priorities[] = {5, 3, 4, 2, 1};
  for (int i = 0; i < 5; i++)
    tasks[i] = (struct task){steps[i], priorities[i], idle, 0, 0, 0, 0};
  now = 0xffffff00u; /* the clock wraps around soon */
  for (int i = 0; i < 5; i++)
    add_timer(now + 3u * (unsigned)i, i, 11 + 6 * (unsigned)i);
  for (int tick = 0; tick < 600; tick++, now++) {
    while (timer_count > 0 && (int)(timers[0].due - now) <= 0) {
      struct timer t = take_timer();
      if (tasks[t.task].state != ready)
        tasks[t.task].state = ready;
      if (t.period != 0)
        add_timer(t.due + t.period, t.task, t.period);
    }
    int run = choose();
    history = mix(history, (unsigned)run);
    if (run < 0)
      continue;
    struct task* t = &tasks[run];
    t->runs++;
    t->waited = 0;
    t->state = (unsigned char)t->step(t);
    if (run == 0 && tasks[1].state == blocked)
      tasks[1].state = ready;
  }
  for (int i = 0; i < 5; i++)
    report("task", mix(mix(tasks[i].runs, tasks[i].data), tasks[i].state));
  report("history", history);
  report("timers", (unsigned)(timer_count * 10 + tokens));
  return 0;
}
