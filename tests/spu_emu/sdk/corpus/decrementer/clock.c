// The decrementer counts down, its event comes when it passes zero, and the clock of the library goes on.
#include <profile.h>
#include <spu_mfcio.h>
#include <spu_timer.h>
#include <stdio.h>

int main(void) {
  unsigned int before, after, events;
  unsigned long long begin, end;

  prof_start();
  spu_write_decrementer(0x7fffffff);
  before = spu_read_decrementer();
  do {
    after = spu_read_decrementer();
  } while (before - after < 100);
  prof_stop();
  printf("down: %d\n", after < before);

  spu_write_event_mask(MFC_DECREMENTER_EVENT);
  spu_write_decrementer(2000);
  events = spu_read_event_status();
  printf("event: %x, past zero: %d\n", events & MFC_DECREMENTER_EVENT, (int)spu_read_decrementer() < 0);
  spu_write_event_ack(MFC_DECREMENTER_EVENT);
  spu_write_event_mask(0);
  printf("waiting: %d\n", spu_stat_event_status());

  spu_clock_start();
  begin = spu_clock_read();
  do {
    end = spu_clock_read();
  } while (end - begin < 500);
  printf("clock: %d, stopped: %d, once more: %d\n", end > begin, spu_clock_stop(), spu_clock_stop());
  return 0;
}
