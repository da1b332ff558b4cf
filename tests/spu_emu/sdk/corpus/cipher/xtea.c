#include <spu_mfcio.h>

void encipher(vec_uint4 *a, vec_uint4 *b, const unsigned int key[4], int rounds);

static struct {
  unsigned int key[4];
  vec_uint4 text[30];
} block __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long rounds) {
  const vec_uchar16 even = {0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27};
  const vec_uchar16 odd = {4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31};
  const vec_uchar16 low = {0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23};
  const vec_uchar16 high = {8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31};
  int i;
  (void)spe;
  mfc_get(&block, ea, sizeof block, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 30; i += 2) {
    vec_uint4 a = spu_shuffle(block.text[i], block.text[i + 1], even), b = spu_shuffle(block.text[i], block.text[i + 1], odd);
    encipher(&a, &b, block.key, (int)rounds);
    block.text[i] = spu_shuffle(a, b, low);
    block.text[i + 1] = spu_shuffle(a, b, high);
  }
  mfc_put(&block, ea, sizeof block, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
