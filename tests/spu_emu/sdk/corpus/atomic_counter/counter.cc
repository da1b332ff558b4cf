#include <libspe2.h>
#include <pthread.h>
#include <cstdio>

extern "C" spe_program_handle_t counter_spu;

static const int kSpes = 6;
static const unsigned long kTimes = 500;
static volatile unsigned int counter[32] __attribute__((aligned(128)));

static void* spe_thread(void*) {
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  if (spe_program_load(spe, &counter_spu) != 0 ||
      spe_context_run(spe, &entry, 0, (void*)counter, (void*)kTimes, NULL) != 0) {
    std::perror("spe");
  }
  spe_context_destroy(spe);
  return NULL;
}

int main() {
  pthread_t threads[kSpes];
  for (int i = 0; i < kSpes; ++i) pthread_create(&threads[i], NULL, spe_thread, NULL);
  for (unsigned long i = 0; i < kTimes; ++i) __sync_fetch_and_add(&counter[0], 1);
  for (int i = 0; i < kSpes; ++i) pthread_join(threads[i], NULL);
  std::printf("%u of %lu\n", counter[0], (kSpes + 1) * kTimes);
  return counter[0] != (kSpes + 1) * kTimes;
}
