#include <libspe2.h>
#include <pthread.h>

#include <iostream>

extern "C" spe_program_handle_t table;
static int keys[512] __attribute__((aligned(128)));
static spe_context_ptr_t spe;

extern "C" void* run(void*) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_run(spe, &entry, 0, keys, NULL, NULL);
  return NULL;
}

static unsigned int call(unsigned int function) {
  unsigned int answer;
  spe_in_mbox_write(spe, &function, 1, SPE_MBOX_ALL_BLOCKING);
  spe_out_intr_mbox_read(spe, &answer, 1, SPE_MBOX_ALL_BLOCKING);
  return answer;
}

int main() {
  static const char* const names[] = {"up", "down", "by size"};
  for (int i = 0; i < 512; ++i) keys[i] = (i * 7919 % 1021) - 510;
  spe = spe_context_create(SPE_EVENTS_ENABLE, NULL);
  spe_program_load(spe, &table);
  pthread_t thread;
  pthread_create(&thread, NULL, run, NULL);
  for (unsigned int f = 0; f < 3; ++f) {
    call(f);
    std::cout << names[f] << ": " << keys[0] << " ... " << keys[511] << ", " << call(3) << " descents" << std::endl;
  }
  unsigned int quit = ~0u;
  spe_in_mbox_write(spe, &quit, 1, SPE_MBOX_ALL_BLOCKING);
  pthread_join(thread, NULL);
  return spe_context_destroy(spe);
}
