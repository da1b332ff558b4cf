#include "engines/cell/spu/paper/axis_store.h"

#include <free_align.h>
#include <malloc_align.h>

#include <cstring>

#include "engines/cell/spu/common/dma.h"

namespace cellsweep::cell::paper {
namespace {

constexpr unsigned int kLog2Align = 7;

template <class T>
T* allocate(std::uint32_t count) {
  return static_cast<T*>(
      _malloc_align(round_up(count * static_cast<std::uint32_t>(sizeof(T)), kDmaAlign), kLog2Align));
}

}  // namespace

AxisStore::AxisStore(const PaperJob& job)
    : values(allocate<float>(job.endpoints)),
      ids(allocate<std::uint32_t>(job.endpoints)),
      values_before(allocate<float>(job.endpoints)),
      ids_before(allocate<std::uint32_t>(job.endpoints)),
      body_values(nullptr),
      places(nullptr),
      count_(job.endpoints) {
  if ((job.flags & kPaperMethod2) != 0) {
    body_values = allocate<float>(2 * job.largest_id);
  } else if ((job.flags & kPaperLiteral) == 0) {
    places = allocate<Place>(job.largest_id + 1);
  }
}

AxisStore::~AxisStore() {
  if (places != nullptr) _free_align(places);
  if (body_values != nullptr) _free_align(body_values);
  _free_align(ids_before);
  _free_align(values_before);
  _free_align(ids);
  _free_align(values);
}

void AxisStore::get(const PaperJob& job, unsigned int tag) {
  get_all(values, ea_of(job.values), count_ * 4, tag);
  get_all(ids, ea_of(job.ids), count_ * 4, tag);
  if (body_values != nullptr)
    get_all(body_values, ea_of(job.body_values), round_up(2 * job.largest_id * 4, 16), tag);
  wait_for_tag(tag);
}

void AxisStore::keep_copies() {
  std::memcpy(values_before, values, count_ * sizeof(float));
  std::memcpy(ids_before, ids, count_ * sizeof(std::uint32_t));
}

}  // namespace cellsweep::cell::paper
