#include <spu_mfcio.h>

#include <cstdlib>

static int keys[512] __attribute__((aligned(128)));

template <class Less>
static void quicksort(int* first, int* last, Less less) {
  if (last - first < 2) return;
  const int middle = first[(last - first) / 2];
  int *i = first, *j = last - 1;
  while (i <= j) {
    while (less(*i, middle)) ++i;
    while (less(middle, *j)) --j;
    if (i <= j) {
      const int kept = *i;
      *i++ = *j;
      *j-- = kept;
    }
  }
  quicksort(first, j + 1, less);
  quicksort(i, last, less);
}

static int up(int n) {
  quicksort(keys, keys + n, [](int a, int b) { return a < b; });
  return 0;
}
static int down(int n) {
  quicksort(keys, keys + n, [](int a, int b) { return a > b; });
  return 0;
}
static int compare(const void* a, const void* b) {
  const int x = *(const int*)a, y = *(const int*)b;
  return std::abs(x) != std::abs(y) ? std::abs(x) - std::abs(y) : x - y;
}
static int by_size(int n) {
  std::qsort(keys, n, sizeof *keys, compare);
  return 0;
}
static int inversions(int n) {
  int count = 0;
  for (int i = 1; i < n; ++i) count += keys[i - 1] > keys[i];
  return count;
}

static int (*const functions[])(int) = {up, down, by_size, inversions};

int main(unsigned long long, unsigned long long ea, unsigned long long) {
  mfc_write_tag_mask(1);
  for (;;) {
    const unsigned int number = spu_read_in_mbox();
    if (number >= sizeof functions / sizeof *functions) return 0;
    mfc_get(keys, ea, sizeof keys, 0, 0, 0);
    mfc_read_tag_status_all();
    const int result = functions[number](512);
    mfc_put(keys, ea, sizeof keys, 0, 0, 0);
    mfc_read_tag_status_all();
    spu_write_out_intr_mbox(result);
  }
}
