// SPU program of the document's first attempt (F5, 4.2.1): the x86 insertion sort with its overlap test,
// unchanged but for endpoints that hold values where the x86 version has pointers.
#include <free_align.h>
#include <malloc_align.h>

#include "engines/cell/spu/common/dma.h"
#include "engines/cell/spu/paper/key_stream.h"
#include "engines/cell/wire.h"

namespace {

using namespace cellsweep::cell;

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kTag = 0;
constexpr unsigned int kEventsTag = 1;  // and 2

bool is_after(const FirstAttemptEndpoint& one, const FirstAttemptEndpoint& other) {
  if (one.value != other.value) return one.value > other.value;
  return (one.id & kMaximumFlag) != 0 && (other.id & kMaximumFlag) == 0;
}

std::uint32_t test_swapped(const FirstAttemptEndpoint& lower, const FirstAttemptEndpoint& upper) {
  const bool now = lower.min <= upper.max && upper.min <= lower.max;
  const std::uint32_t key = pair_key_of_ids(lower.id & ~kMaximumFlag, upper.id & ~kMaximumFlag);
  return now ? key | kOverlapFlag : key;
}

void sort_and_test(FirstAttemptEndpoint* list, std::uint32_t count, paper::KeyStream& events) {
  for (std::uint32_t j = 1; j < count; ++j) {
    const FirstAttemptEndpoint current = list[j];
    for (std::uint32_t i = j; i > 0 && is_after(list[i - 1], current); --i) {
      list[i] = list[i - 1];
      list[i - 1] = current;
      events.add(test_swapped(list[i - 1], list[i]));
    }
  }
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  auto* job = static_cast<FirstAttemptJob*>(_malloc_align(sizeof(FirstAttemptJob), kLog2Align));
  auto* result = static_cast<std::uint32_t*>(_malloc_align(kDmaAlign, kLog2Align));
  get_all(job, argp, sizeof(FirstAttemptJob), kTag);
  wait_for_tag(kTag);
  const auto bytes = static_cast<std::uint32_t>(job->count * sizeof(FirstAttemptEndpoint));
  auto* list = static_cast<FirstAttemptEndpoint*>(_malloc_align(bytes, kLog2Align));
  get_all(list, ea_of(job->endpoints), bytes, kTag);
  wait_for_tag(kTag);
  {
    paper::KeyStream events(ea_of(job->events), false, kEventsTag);
    sort_and_test(list, job->count, events);
    result[0] = events.finish();
  }
  put_all(list, ea_of(job->endpoints), bytes, kTag);
  put_all(result, ea_of(job->result), kDmaAlign, kTag);
  wait_for_tag(kTag);
  _free_align(list);
  _free_align(result);
  _free_align(job);
  return 0;
}
