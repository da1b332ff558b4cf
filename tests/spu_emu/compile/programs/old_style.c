/* clang-format off */
/* C as it was written before 1989: main without a type, parameters declared behind it, functions without prototypes,
   a variable called vector, a shuffle pattern that is a cast of words, and comments of one kind. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

typedef vector unsigned char pattern_t;
typedef vector unsigned int words_t;

/* Each lies at a multiple of 16 bytes, as the SPU's compiler places it. */
char flag;
unsigned int counter;
static short halves = 7;
struct point {
  float vector[3];
} place;
unsigned int counter;

static struct point *move();

static vector unsigned char bytes_of(words)
words_t words;
{
  return (vector unsigned char)words;
}

main(speid, argp, envp)
unsigned long long speid, argp, envp;
{
  vector unsigned int words = {0x00010203, 0x04050607, 0x18191a1b, 0x0c0d0e0f};
  vector unsigned int mixed;
  vector float f = spu_splats(1.5f);
  int vector = 3;

  if (speid == 0 || envp != 0) return 10;
  mixed = spu_shuffle(words, ((vec_uint4){1, 2, 3, 4}), (pattern_t)words);
  if (spu_extract(mixed, 0) != 0x00010203 || spu_extract(mixed, 2) != 3) return 1;
  if (spu_extract(bytes_of(words), 5) != 5) return 2;
  if (spu_extract((vector unsigned short)words, 3) != 0x0607) return 3;
  if (spu_extract((__typeof__(bytes_of(words)))words, 6) != 6 || (__typeof__(vector))3.75f != 3) return 9;
  if (si_to_uint(si_ai((qword)words, 4)) != 0x00010207) return 4;
  f = spu_sel(f, spu_madd(f, f, f), spu_cmpgt(f, spu_splats(1.0f)));
  if (spu_extract(f, vector) != 3.75f) return 5;
  if (spu_extract(spu_rlmask(spu_splats(256), -vector), 0) != 32) return 6;
  if ((((unsigned long)&flag | (unsigned long)&counter | (unsigned long)&halves | (unsigned long)&place) & 15) != 0)
    return 7;
  if (move(&place)->vector[1] != 2) return 8;

  /* Four bytes to a scalar, from an address that is a multiple of 16. */
  mfc_get(&counter, argp, sizeof counter, 5, 0, 0);
  mfc_write_tag_mask(1 << 5);
  mfc_read_tag_status_all();
  spu_write_out_mbox(counter);
  return counter == 0x1234 && halves == 7 ? 42 : 9;
}

static struct point *move(p)
struct point *p;
{
  p->vector[1] += 2;
  return p;
}
