/* Variables of a function, small ones between others, to which words are transferred as to any buffer. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

typedef unsigned short u16;

static int is_placed(const volatile void* variable) {
  return ((unsigned int)(unsigned long)variable & 15) == 0;
}

int main(unsigned long long speid, unsigned long long argp) {
  char first = 1;
  volatile unsigned int word = 0;
  u16 middle = 2;
  (void)speid;
  if (argp != 0) {
    unsigned char last = 3;
    volatile unsigned int again;
    mfc_get(&word, argp, sizeof word, 1, 0, 0);
    mfc_write_tag_mask(1 << 1);
    mfc_read_tag_status_all();
    again = word;
    mfc_put(&again, argp, sizeof again, 1, 0, 0);
    mfc_read_tag_status_all();
    if (!is_placed(&last) || !is_placed(&again)) return 2;
  }
  if (!is_placed(&first) || !is_placed(&middle)) return 3;
  return word == 0x1234 ? 42 : 4;
}
