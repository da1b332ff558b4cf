// The same writes to both signal registers, in each of their modes: what is unread is overwritten, or the bits gather.
#include <libspe2.h>
#include <pthread.h>

#include <cstdio>

extern "C" spe_program_handle_t collect;

static void* run(void* spe) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  if (spe_context_run(static_cast<spe_context_ptr_t>(spe), &entry, 0, NULL, NULL, &stop) != 0) return (void*)-1;
  return (void*)(long)stop.result.spe_exit_code;
}

static unsigned int heard(spe_context_ptr_t spe) {
  unsigned int word = 0;
  while (spe_out_mbox_read(spe, &word, 1) != 1) {
  }
  return word;
}

static void try_mode(unsigned int flags, const char* name) {
  spe_context_ptr_t spe = spe_context_create(flags, NULL);
  pthread_t thread;
  unsigned int go = 1;
  void* left;
  spe_program_load(spe, &collect);
  pthread_create(&thread, NULL, run, spe);
  const unsigned int before = heard(spe);
  for (unsigned int bit = 0; bit < 4; ++bit) {
    spe_signal_write(spe, SPE_SIG_NOTIFY_REG_1, 1u << (4 * bit));
    spe_signal_write(spe, SPE_SIG_NOTIFY_REG_2, 2u << (4 * bit));
  }
  spe_in_mbox_write(spe, &go, 1, SPE_MBOX_ALL_BLOCKING);
  const unsigned int first = heard(spe);
  spe_in_mbox_write(spe, &go, 1, SPE_MBOX_ALL_BLOCKING);
  const unsigned int second = heard(spe);
  pthread_join(thread, &left);
  std::printf("%-9s before %u, register 1 %04x, register 2 %04x, after %ld\n", name, before, first, second, (long)left);
  spe_context_destroy(spe);
}

int main() {
  try_mode(0, "overwrite");
  try_mode(SPE_CFG_SIGNOTIFY1_OR, "or 1");
  try_mode(SPE_CFG_SIGNOTIFY2_OR, "or 2");
  try_mode(SPE_CFG_SIGNOTIFY1_OR | SPE_CFG_SIGNOTIFY2_OR, "or both");
}
