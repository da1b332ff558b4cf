#include <libspe2.h>
#include <part.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t scan;
static unsigned int words[PARTS * WORDS] __attribute__((aligned(128)));
static struct part parts[PARTS];
static spe_context_ptr_t spes[PARTS];

static void *run(void *number) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  long i = (long)number;
  if (spe_context_run(spes[i], &entry, 0, &parts[i], (void *)(long)(i == 0), NULL)) perror("scan");
  return NULL;
}

int main(void) {
  pthread_t threads[PARTS];
  unsigned int sum = 0, wrong = 0;
  long i;
  for (i = 0; i < PARTS * WORDS; i++) words[i] = i * i % 1009;
  for (i = PARTS - 1; i >= 0; i--) {
    spes[i] = spe_context_create(SPE_MAP_PS, NULL);
    spe_program_load(spes[i], &scan);
    parts[i].words = (unsigned long long)(words + i * WORDS);
    parts[i].next_signal = 0;
    if (i < PARTS - 1) {
      spe_sig_notify_1_area_t *area = spe_ps_area_get(spes[i + 1], SPE_SIG_NOTIFY_1_AREA);
      parts[i].next_signal = (unsigned long long)&area->SPU_Sig_Notify_1;
    }
  }
  for (i = 0; i < PARTS; i++) pthread_create(&threads[i], NULL, run, (void *)i);
  for (i = 0; i < PARTS; i++) pthread_join(threads[i], NULL);
  for (i = 0; i < PARTS * WORDS; i++) wrong += words[i] != (sum += i * i % 1009);
  printf("%u wrong, the last is %u\n", wrong, words[PARTS * WORDS - 1]);
  return 0;
}
