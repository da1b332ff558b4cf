#include <spu_mfcio.h>

#include "queue.h"

namespace {

/// Takes numbers from the queue that all workers share, each once.
class Queue {
 public:
  explicit Queue(unsigned long long ea) : ea_(ea) {}

  bool take(unsigned int& index) {
    do {
      mfc_getllar(&line_, ea_, 0, 0);
      mfc_read_atomic_status();
      if (line_.next == line_.items) return false;
      index = line_.next++;
      mfc_putllc(&line_, ea_, 0, 0);
    } while ((mfc_read_atomic_status() & MFC_PUTLLC_STATUS) != 0);
    return true;
  }
  unsigned long long item(unsigned int index) const { return line_.item_ea + index * sizeof(item_t); }

 private:
  unsigned long long ea_;
  static queue_t line_ __attribute__((aligned(128)));
};
queue_t Queue::line_ __attribute__((aligned(128)));

item_t item __attribute__((aligned(128)));

void wait() {
  mfc_write_tag_mask(1 << 2);
  mfc_read_tag_status_all();
}

unsigned int steps_of(unsigned int number) {
  unsigned int steps = 0;
  for (; number != 1; ++steps) number = number % 2 != 0 ? 3 * number + 1 : number / 2;
  return steps;
}

}  // namespace

int main(unsigned long long spe, unsigned long long queue_ea, unsigned long long worker) {
  (void)spe;
  Queue queue(queue_ea);
  unsigned int index = 0;
  while (queue.take(index)) {
    mfc_get(&item, queue.item(index), sizeof item, 2, 0, 0);
    wait();
    item.steps = steps_of(item.number);
    item.by = worker + 1;
    mfc_put(&item, queue.item(index), sizeof item, 2, 0, 0);
    wait();
  }
  return 0;
}
