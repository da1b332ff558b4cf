#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t spe_crc32, spe_adler32;

static unsigned char text[8192] __attribute__((aligned(128)));

static unsigned int checksum(spe_program_handle_t *program, unsigned long count) {
  unsigned int entry = SPE_DEFAULT_ENTRY, result = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_program_load(spe, program) || spe_context_run(spe, &entry, 0, text, (void *)count, NULL)) return 0;
  spe_out_mbox_read(spe, &result, 1);
  spe_context_destroy(spe);
  return result;
}

int main(void) {
  unsigned long i, sizes[] = {9, 1000, 8192};
  sprintf((char *)text, "123456789");
  for (i = 9; i < sizeof text; i++) text[i] = i * i >> 3;
  for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    printf("%4lu bytes: crc %08x adler %08x\n", sizes[i], checksum(&spe_crc32, sizes[i]), checksum(&spe_adler32, sizes[i]));
  }
  return 0;
}
