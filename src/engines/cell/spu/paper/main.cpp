// SPU program of cell-paper: one axis, one frame, in the steps of chapter 4.2.
#include <free_align.h>
#include <malloc_align.h>

#include "engines/cell/spu/common/dma.h"
#include "engines/cell/spu/paper/axis_store.h"
#include "engines/cell/spu/paper/change_detection.h"
#include "engines/cell/spu/paper/compaction.h"
#include "engines/cell/spu/paper/intervector_sort.h"
#include "engines/cell/spu/paper/intravector_sort.h"
#include "engines/cell/spu/paper/key_stream.h"
#include "engines/cell/spu/paper/overlap_all.h"
#include "engines/cell/spu/paper/overlap_walk.h"
#include "engines/cell/wire.h"

namespace {

using namespace cellsweep::cell;
using namespace cellsweep::cell::paper;

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kInTag = 0;
constexpr unsigned int kOutTag = 1;
constexpr unsigned int kKeysTag = 2;   // and 3
constexpr unsigned int kApartTag = 4;  // and 5

bool has(const PaperJob& job, PaperFlags flag) {
  return (job.flags & flag) != 0;
}

// The steps are not inlined, so that the program's symbols tell what each took.

// C5-C8: the values come into order, the IDs with them.
[[gnu::noinline]] void sort_axis(const PaperJob& job, AxisStore& axis) {
  intervector_sort(axis.values, axis.ids, axis.vectors());
  intravector_sort(axis.values, axis.ids, axis.vectors());
  if (!has(job, kPaperLiteral)) order_equal_values(axis.values, axis.ids, axis.count());
}

// C9: the array of IDs from before the sort becomes the array of changed IDs.
[[gnu::noinline]] void detect_changes(const PaperJob& job, AxisStore& axis) {
  if (has(job, kPaperLiteral)) {
    compare_changes_literal(axis.before_and_after(), axis.ids_before);
  } else if (has(job, kPaperInitial)) {
    mark_all_changed(axis.ids_before, axis.count());
  } else {
    compare_changes(axis.before_and_after(), axis.ids_before);
  }
}

// C10: returns the number of changed IDs.
[[gnu::noinline]] std::uint32_t compact(AxisStore& axis) {
  auto* changed = reinterpret_cast<std::int32_t*>(axis.ids_before);
  reverse_quicksort(changed, axis.count());
  return remove_duplicates(changed, axis.count(), static_cast<std::int32_t>(kUnchanged));
}

// C11, C13.
[[gnu::noinline]] void method_1(const PaperJob& job, AxisStore& axis, PaperResult& result) {
  const auto* changed = reinterpret_cast<const std::int32_t*>(axis.ids_before);
  KeyStream keys(ea_of(job.keys), has(job, kPaperListDma), kKeysTag);
  if (has(job, kPaperLiteral)) {
    walk_overlaps_literal(axis.ids, axis.count(), changed, result.changed, keys);
  } else {
    build_place_table(axis.ids, axis.count(), axis.places);
    walk_overlaps(axis.ids, axis.places, changed, result.changed, keys);
  }
  result.keys = keys.finish();
  result.apart_keys = 0;
}

// C12, C13.
[[gnu::noinline]] void method_2(const PaperJob& job, const AxisStore& axis, PaperResult& result) {
  const auto* changed = reinterpret_cast<const std::int32_t*>(axis.ids_before);
  KeyStream keys(ea_of(job.keys), has(job, kPaperListDma), kKeysTag);
  KeyStream apart(ea_of(job.apart_keys), has(job, kPaperListDma), kApartTag);
  test_all(axis.body_values, job.largest_id, changed, result.changed, keys, apart);
  result.keys = keys.finish();
  result.apart_keys = apart.finish();
}

// A whole frame. Results leave as soon as they are known.
void run(const PaperJob& job, PaperResult& result) {
  AxisStore axis(job);
  axis.get(job, kInTag);
  axis.keep_copies();
  sort_axis(job, axis);
  put_all(axis.ids, ea_of(job.sorted_ids), axis.count() * 4, kOutTag);
  detect_changes(job, axis);
  result.changed = compact(axis);
  put_all(axis.ids_before, ea_of(job.changed), round_up(result.changed * 4, 16), kOutTag);
  if (has(job, kPaperMethod2)) {
    method_2(job, axis, result);
  } else {
    method_1(job, axis, result);
  }
  put_all(&result, ea_of(job.result), sizeof(PaperResult), kOutTag);
  wait_for_tag(kOutTag);
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  auto* job = static_cast<PaperJob*>(_malloc_align(sizeof(PaperJob), kLog2Align));
  auto* result = static_cast<PaperResult*>(_malloc_align(sizeof(PaperResult), kLog2Align));
  get_all(job, argp, sizeof(PaperJob), kInTag);
  wait_for_tag(kInTag);
  run(*job, *result);
  _free_align(result);
  _free_align(job);
  return 0;
}
