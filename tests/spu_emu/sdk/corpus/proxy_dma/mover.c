#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t mover_program;
static spe_context_ptr_t spe;
static unsigned int data[256] __attribute__((aligned(128)));

static void *run(void *unused) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_run(spe, &entry, 0, NULL, NULL, NULL);
  return unused;
}

static unsigned int word(void) {
  unsigned int value;
  while (spe_out_mbox_read(spe, &value, 1) != 1) {
  }
  return value;
}

static unsigned int done(unsigned int tag) {
  unsigned int status = 0;
  spe_mfcio_tag_status_read(spe, 1 << tag, SPE_TAG_ALL, &status);
  return status;
}

int main(void) {
  pthread_t thread;
  unsigned int where, go = 1, stop = 0, sum = 0, i, status, bad;
  spe = spe_context_create(0, NULL);
  spe_program_load(spe, &mover_program);
  pthread_create(&thread, NULL, run, NULL);
  where = word();
  for (i = 0; i < 256; i++) data[i] = i * 3;
  spe_mfcio_get(spe, where, data, 512, 3, 0, 0);
  spe_mfcio_getb(spe, where + 512, data + 128, 512, 3, 0, 0);
  printf("in: %x\n", done(3));
  spe_in_mbox_write(spe, &go, 1, SPE_MBOX_ALL_BLOCKING);
  printf("last word %u\n", word());
  spe_mfcio_put(spe, where, data, 1024, 4, 0, 0);
  status = done(4);
  for (i = 0; i < 256; i++) sum += data[i];
  printf("out: %x, sum %u\n", status, sum);
  bad = spe_mfcio_get(spe, where, data, 100, 3, 0, 0);
  printf("100 bytes: %d\n", (int)bad);
  spe_in_mbox_write(spe, &stop, 1, SPE_MBOX_ALL_BLOCKING);
  pthread_join(thread, NULL);
  return spe_context_destroy(spe);
}
