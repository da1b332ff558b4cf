/* The same arithmetic by AltiVec and by an SPE; a permutation that takes bytes apart; a variable named vector. */
#include <altivec.h>
#include <libspe2.h>
#include <ppu_intrinsics.h>
#include <stdio.h>
#include <string.h>

extern spe_program_handle_t kernel;

static vector float mine[64] __attribute__((aligned(128)));
static vector float theirs[64] __attribute__((aligned(128)));

int main(void) {
  const vector unsigned char reverse = {15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  vector float half = (vector float){0.5f, 0.5f, 0.5f, 0.5f};
  vector unsigned int bits;
  vector unsigned char text;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  unsigned long long begin = __mftb();
  char word[17] = "ABCDEFGHIJKLMNOP";
  int vector = 0, i;

  for (i = 0; i < 256; i++) ((float *)mine)[i] = ((float *)theirs)[i] = i * 0.25f;
  for (i = 0; i < 64; i++) mine[i] = vec_madd(mine[i], mine[i], half);
  if (spe_program_load(spe, &kernel) || spe_context_run(spe, &entry, 0, theirs, NULL, NULL)) return 1;
  vector += memcmp(mine, theirs, sizeof mine) == 0;
  memcpy(&text, word, 16);
  text = vec_perm(text, text, reverse);
  memcpy(word, &text, 16);
  bits = (vector signed int)half; /* signed or not: old compilers took it lightly */
  __sync();
  printf("%s %s %08x %s %d bits\n", vector ? "equal" : "DIFFERENT", word, ((unsigned int *)&bits)[3],
         __mftb() > begin ? "later" : "never", (int)sizeof(long) * 8);
  return 0;
}
