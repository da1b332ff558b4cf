#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "tree.h"

extern spe_program_handle_t node;

static spe_context_ptr_t spes[NODES];
static setup_t setups[NODES];
static int codes[NODES];

static void *run(void *arg) {
  int n = *(int *)arg;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t info;
  memset(&info, 0, sizeof info);
  if (spe_context_run(spes[n], &entry, 0, &setups[n], 0, &info) < 0) perror("spe_context_run");
  codes[n] = info.result.spe_exit_code;
  return 0;
}

int main() {
  pthread_t threads[NODES];
  int numbers[NODES], i, k, sum = 0;
  unsigned int message;

  for (i = 0; i < NODES; i++) {
    spes[i] = spe_context_create(SPE_MAP_PS | SPE_CFG_SIGNOTIFY1_OR, NULL);
    if (!spes[i] || spe_program_load(spes[i], &node)) return 1;
  }
  for (i = 0; i < NODES; i++) {
    setups[i].node = i;
    for (k = 0; k < NODES; k++) {
      spe_sig_notify_1_area_t *area = spe_ps_area_get(spes[k], SPE_SIG_NOTIFY_1_AREA);
      setups[i].signal1[k] = (unsigned long long)&area->SPU_Sig_Notify_1;
    }
    numbers[i] = i;
    pthread_create(&threads[i], NULL, run, &numbers[i]);
  }
  spe_out_intr_mbox_read(spes[0], &message, 1, SPE_MBOX_ALL_BLOCKING);
  for (i = 0; i < NODES; i++) {
    pthread_join(threads[i], NULL);
    sum += codes[i];
  }
  printf("the root says %x, exit codes add up to %d\n", message, sum);
  return 0;
}
