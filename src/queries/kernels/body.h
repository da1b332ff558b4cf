/// @file
/// The kernels of queries for any vector.
#pragma once

#include "cellsweep/engine/cell_boxes.h"
#include "queries/kernels/distances.h"
#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"
#include "queries/kernels/rank.h"
#include "queries/kernels/tree_walk.h"

namespace cellsweep::queries {
namespace {

inline bool is_tagged(const BoxRow& row) {
  return row.step == sizeof(stream::TaggedBox);
}

/// `Tagged` are the lanes for boxes of cells, `Plain` for others, `Nodes` for those of a tree's nodes.
template <class Tagged, class Plain, class Nodes>
constexpr QueryKernels make_query_kernels(VectorIsa isa) {
  static_assert(Tagged::kCount <= kMostLanes && kRowBoxes % Tagged::kCount == 0);
  return {isa,
          [](const BoxRow& row, const Aabb& box, std::uint32_t* places) {
            return is_tagged(row) ? find_overlaps<Tagged>(row, box, places)
                                  : find_overlaps<Plain>(row, box, places);
          },
          find_overlaps<Nodes>,
          [](const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
            return is_tagged(row) ? find_on_path<Tagged>(row, path, places)
                                  : find_on_path<Plain>(row, path, places);
          },
          [](const BoxRow& row, const NearNumbers& question, std::uint64_t* keys) {
            return is_tagged(row) ? find_near<Tagged>(row, question, keys)
                                  : find_near<Plain>(row, question, keys);
          },
          walk_tree_for_overlaps<Nodes>,
          [](const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
            if (path.is_flat) {
              walk_tree_on_path<Nodes, true>(nodes, path, take);
            } else {
              walk_tree_on_path<Nodes, false>(nodes, path, take);
            }
          },
          walk_tree_for_near<Nodes>,
          distances<Nodes>,
          node_distances<Nodes>,
          rank<Nodes::kCount>};
}

}  // namespace
}  // namespace cellsweep::queries
