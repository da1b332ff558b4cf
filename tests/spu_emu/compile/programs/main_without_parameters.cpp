#include <spu_mfcio.h>

int main() {
  spu_write_out_mbox(40);
}
