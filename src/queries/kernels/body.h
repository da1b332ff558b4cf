/// @file
/// The kernels of queries for any vector.
#pragma once

#include "cellsweep/engine/cell_boxes.h"
#include "queries/kernels/distances.h"
#include "queries/kernels/in_cell.h"
#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"
#include "queries/kernels/rank.h"
#include "queries/kernels/tree_near.h"
#include "queries/kernels/tree_paths.h"
#include "queries/kernels/tree_walk.h"

namespace cellsweep::queries {
namespace {

inline bool is_tagged(const BoxRow& row) {
  return row.step == sizeof(stream::TaggedBox);
}

template <class Lanes>
constexpr TreeKernels make_tree_kernels() {
  return {walk_tree_for_overlaps<Lanes>, walk_tree_on_path<Lanes>, walk_tree_on_whole_path<Lanes>,
          walk_tree_for_near<Lanes>,     walk_tree_within<Lanes>,  node_distances<Lanes>};
}

/// `Tagged` are the lanes for boxes of cells, `Plain` for others, `Few` for what is quicker in few lanes;
/// `InCell` tests boxes of a cell for overlaps.
template <class Tagged, class Plain, class Few, class InCell = TestInCell<Few>>
constexpr QueryKernels make_query_kernels(VectorIsa isa, const TreeKernels& trees) {
  static_assert(Tagged::kCount <= kMostLanes && kRowBoxes % Tagged::kCount == 0);
  return {isa,
          find_overlaps<Plain>,
          find_overlaps_in_cell<InCell>,
          [](const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
            return is_tagged(row) ? find_on_path<Tagged>(row, path, places)
                                  : find_on_path<Plain>(row, path, places);
          },
          [](const BoxRow& row, const NearNumbers& question, std::uint64_t* keys) {
            return is_tagged(row) ? find_near<Tagged>(row, question, keys)
                                  : find_near<Plain>(row, question, keys);
          },
          distances<Few>,
          rank<Few::kCount>,
          &trees,
          walk_tree_to_any<Plain>};
}

}  // namespace
}  // namespace cellsweep::queries
