/* The SPU's clock: a time that goes on since spu_clock_start, in ticks of the decrementer (spu_timebase of them a
 * second). Between two reads may lie one turn of the decrementer, 53 seconds. Its timers, which interrupt the program,
 * are for real SPU code only: the compiler of spu_emu/toolchain has them. */
#ifndef SPU_EMU_SPU_TIMER_H
#define SPU_EMU_SPU_TIMER_H

#include <spu_mfcio.h>
#include <stdint.h>

#define SPU_CLOCK_ERR_NOT_RUNNING (-2)

typedef struct spu_emu_clock {
  int users;
  unsigned int last;
  uint64_t time;
} spu_emu_clock;

static inline spu_emu_clock* spu_emu_clock_of_program(void) {
  static spu_emu_clock clock;
  return &clock;
}

static inline uint64_t spu_clock_read(void) {
  spu_emu_clock* clock = spu_emu_clock_of_program();
  if (clock->users > 0) {
    const unsigned int now = spu_read_decrementer();
    clock->time += clock->last - now;
    clock->last = now;
  }
  return clock->time;
}

/* Starts that are nested need as many stops; the first one begins at zero. */
static inline void spu_clock_start(void) {
  spu_emu_clock* clock = spu_emu_clock_of_program();
  if (clock->users++ > 0) return;
  spu_write_decrementer(0xffffffffu);
  clock->last = 0xffffffffu;
  clock->time = 0;
}
static inline int spu_clock_stop(void) {
  spu_emu_clock* clock = spu_emu_clock_of_program();
  if (clock->users == 0) return SPU_CLOCK_ERR_NOT_RUNNING;
  (void)spu_clock_read();
  --clock->users;
  return 0;
}

/* As this emulation has it unless its settings say otherwise, and as on the PlayStation 3. */
static inline unsigned int spu_timebase(void) { return 79800000u; }

#endif
