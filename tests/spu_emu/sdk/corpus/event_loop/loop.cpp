// One thread serves the messages and the ends of several SPEs as they come.
#include <libspe2.h>
#include <pthread.h>

#include <cstdio>
#include <map>
#include <vector>

extern "C" spe_program_handle_t tick;

namespace {

const unsigned long kSpes = 3, kTicks = 20;

struct Spe {
  spe_context_ptr_t context;
  pthread_t thread;
  unsigned long number;
};

void* run(void* argument) {
  Spe* spe = static_cast<Spe*>(argument);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_run(spe->context, &entry, 0, (void*)spe->number, (void*)kTicks, NULL);
  return NULL;
}

}  // namespace

int main() {
  std::vector<Spe> spes(kSpes);
  std::map<unsigned long, unsigned int> heard;
  spe_event_handler_ptr_t handler = spe_event_handler_create();
  for (unsigned long i = 0; i < kSpes; ++i) {
    Spe& spe = spes[i];
    spe.number = i;
    spe.context = spe_context_create(SPE_EVENTS_ENABLE, NULL);
    spe_program_load(spe.context, &tick);
    spe_event_unit_t unit;
    unit.spe = spe.context;
    unit.events = SPE_EVENT_OUT_INTR_MBOX | SPE_EVENT_SPE_STOPPED;
    unit.data.u64 = i;
    spe_event_handler_register(handler, &unit);
    pthread_create(&spe.thread, NULL, run, &spe);
  }
  unsigned int stopped = 0, codes = 0;
  unsigned long messages = 0;
  while (stopped < kSpes || messages < kSpes * kTicks) {
    spe_event_unit_t units[8];
    const int found = spe_event_wait(handler, units, 8, 10000);
    if (found <= 0) return 1;
    for (int i = 0; i < found; ++i) {
      if (units[i].events & SPE_EVENT_OUT_INTR_MBOX) {
        unsigned int message;
        if (spe_out_intr_mbox_read(units[i].spe, &message, 1, SPE_MBOX_ANY_NONBLOCKING) != 1) continue;
        if (message >> 16 != units[i].data.u64 || (message & 0xffff) != heard[message >> 16]++) return 2;
        ++messages;
      } else {
        spe_stop_info_t info;
        if (spe_stop_info_read(units[i].spe, &info) != 0) continue;
        codes += info.result.spe_exit_code;
        ++stopped;
      }
    }
  }
  for (unsigned long i = 0; i < kSpes; ++i) {
    pthread_join(spes[i].thread, NULL);
    spe_context_destroy(spes[i].context);
  }
  std::printf("%lu messages in order, %u stopped, codes %u\n", messages, stopped, codes);
  return spe_event_handler_destroy(handler);
}
