#include "sum.h"

#include <libspe2.h>
#include <malloc.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t sum_spu_handle;

static struct control controls[SPES];
static spe_context_ptr_t spes[SPES];

static void *ppu_pthread_function(void *arg) {
  long n = (long)arg;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  if (spe_context_run(spes[n], &entry, 0, &controls[n], NULL, NULL) < 0) perror("Failed running context");
  return NULL;
}

int main() {
  pthread_t threads[SPES];
  const unsigned int words = SPES * CHUNKS * (CHUNK / 4);
  unsigned int *data = memalign(128, words * 4), expected = 0, got = 0, i;
  long n;

  for (i = 0; i < words; i++) expected += data[i] = i * 2654435761u;
  for (n = 0; n < SPES; n++) {
    controls[n].ea = (unsigned long long)(data + n * CHUNKS * (CHUNK / 4));
    controls[n].chunks = CHUNKS;
    spes[n] = spe_context_create(0, NULL);
    spe_program_load(spes[n], &sum_spu_handle);
    pthread_create(&threads[n], NULL, &ppu_pthread_function, (void *)n);
  }
  for (n = 0; n < SPES; n++) {
    pthread_join(threads[n], NULL);
    spe_context_destroy(spes[n]);
    got += controls[n].result;
  }
  printf("%u words: %s\n", words, got == expected ? "the sum is right" : "WRONG");
  free(data);
  return got != expected;
}
