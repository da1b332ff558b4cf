#include "engines/cell/spu/resident/resident_spu.h"

#include <malloc_align.h>

#include "engines/cell/spu/resident/sort_network.h"
#include "engines/cell/spu/resident/sweep.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kRecordTag = 2;

template <class T>
T* allocate(unsigned int count) {
  return static_cast<T*>(_malloc_align(count * sizeof(T), kLog2Align));
}

/// Vectors of the smallest network for so many keys.
unsigned int network_vectors(unsigned int keys) {
  unsigned int vectors = 1;
  while (4 * vectors < keys) vectors *= 2;
  return vectors;
}

}  // namespace

ResidentSpu::ResidentSpu(const ResidentJob& job)
    : job_(job),
      axis_{job.axis, 0, allocate<BoxBlock>(job.bodies / 4), allocate<vec_float4>(job.bodies / 16),
            allocate<std::uint16_t>(job.bodies)},
      records_(allocate<BodyBox>(job.changes)),
      old_boxes_(allocate<BodyBox>(job.changes)),
      keys_(allocate<vec_int4>(job.changes / 4)),
      list_(allocate<vec_int4>(job.changes / 4)),
      pieces_(allocate<unsigned int>(2 * kResidentEventChunk)),
      box_maker_(job) {}

unsigned int ResidentSpu::obey(ResidentOrder order, unsigned int records) {
  if (order == ResidentOrder::bound) {
    box_maker_.enclose_all(records);
    return 0;
  }
  EventStream events(pieces_, ea_of(job_.events));
  fetch(records);
  if (order == ResidentOrder::insert) {
    list_by_key(records);
    insert_marked();
    sweep_share(records_, nullptr, kResidentBegan, events);
    unmark();
    return events.finish();
  }
  list_by_place(records);
  mark_old_boxes();
  if (order == ResidentOrder::remove) {
    sweep_share(old_boxes_, nullptr, 0, events);
    remove_marked(axis_);
    return events.finish();
  }
  sweep_share(old_boxes_, records_, 0, events);
  move_marked();
  sweep_share(records_, old_boxes_, kResidentBegan, events);
  unmark();
  return events.finish();
}

// The steps are not inlined, so that the program's symbols tell what each took.

void ResidentSpu::fetch(unsigned int records) {
  get_all(records_, ea_of(job_.records), records * sizeof(ResidentRecord), kRecordTag);
  wait_for_tag(kRecordTag);
}

// The record's number is the lower half of its key, so that all SPUs keep the same record of a body that is
// listed twice, whatever its place on their axes.
void ResidentSpu::list_by_place(unsigned int records) {
  auto* keys = (int*)keys_;
  for (unsigned int i = 0; i < records; ++i) {
    keys[i] = static_cast<int>((static_cast<unsigned int>(axis_.place[slot_of(records_[i])]) << 16) | i);
  }
  const unsigned int vectors = sort_list(records);
  listed_ = remove_duplicates(keys_, list_, vectors);
}

[[gnu::noinline]] void ResidentSpu::list_by_key(unsigned int records) {
  auto* keys = (int*)keys_;
  for (unsigned int i = 0; i < records; ++i) {
    keys[i] = spu_extract(ordered_bits(records_[i].low), static_cast<int>(axis_.axis));
  }
  sort_list(records);
  listed_ = records;
}

// Sorts the records' numbers by key; returns the vectors that they and what fills them up take.
[[gnu::noinline]] unsigned int ResidentSpu::sort_list(unsigned int records) {
  auto* keys = (int*)keys_;
  const unsigned int vectors = network_vectors(records);
  for (unsigned int i = records; i < 4 * vectors; ++i) keys[i] = kLastKey;
  vec_int4 numbers = {0, 1, 2, 3};
  for (unsigned int i = 0; i < vectors; ++i) {
    list_[i] = numbers;
    numbers = spu_add(numbers, 4);
  }
  sort_network(keys_, list_, vectors);
  return vectors;
}

void ResidentSpu::mark_old_boxes() {
  const auto* list = (const int*)list_;
  for (unsigned int i = 0; i < listed_; ++i) {
    const auto record = static_cast<unsigned int>(list[i]);
    const unsigned int slot = slot_of(records_[record]);
    const unsigned int tag = marked_tag(slot, record);
    set_tag_at(axis_, axis_.place[slot], tag);
    set_tag(records_[record], tag);
    old_boxes_[record] = box_at(axis_, axis_.place[slot]);
  }
}

[[gnu::noinline]] void ResidentSpu::insert_marked() {
  for (unsigned int i = 0; i < listed_; ++i) set_tag(records_[i], marked_tag(slot_of(records_[i]), i));
  merge_bodies(axis_, records_, (const int*)list_, listed_);
}

[[gnu::noinline]] void ResidentSpu::move_marked() {
  const auto* list = (const int*)list_;
  unsigned int lowest = axis_.count;
  for (unsigned int i = 0; i < listed_; ++i) {
    const BodyBox& box = records_[list[i]];
    const unsigned int changed = move_body(axis_, axis_.place[slot_of(box)], box);
    if (changed < lowest) lowest = changed;
  }
  refresh_reach(axis_, lowest);
}

// SPUs take turns in the records, so that the shares are alike wherever the bodies are.
[[gnu::noinline]] void ResidentSpu::sweep_share(const BodyBox* own, const BodyBox* elsewhere,
                                                unsigned int flag, EventStream& events) const {
  Sweep state(axis_, elsewhere, flag, events);
  const auto* list = (const int*)list_;
  for (unsigned int i = 0; i < listed_; ++i) {
    const auto record = static_cast<unsigned int>(list[i]);
    if (record % job_.spus == job_.spu) state.sweep(own[record], record);
  }
}

[[gnu::noinline]] void ResidentSpu::unmark() {
  for (unsigned int i = 0; i < listed_; ++i) {
    const unsigned int slot = slot_of(records_[((const int*)list_)[i]]);
    set_tag_at(axis_, axis_.place[slot], slot);
  }
}

}  // namespace cellsweep::cell
