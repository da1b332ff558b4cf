/// @file
/// The inner loops of queries: one question against as many boxes at a time as a vector holds.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cellsweep/aabb.h"
#include "cellsweep/engine/cell_boxes.h"
#include "cellsweep/vector_isa.h"
#include "queries/kernels/tree_node.h"

namespace cellsweep::queries {

/// At most so many boxes are looked at in one call.
inline constexpr std::uint32_t kRowBoxes = 256;

/// What roundings may do: lanes.h.
inline constexpr float kSmaller = 1 - 0x1p-19F;
inline constexpr float kLarger = 1 + 0x1p-19F;

/// The largest vector of any kernel, in boxes.
inline constexpr std::uint32_t kMostLanes = 16;

/// Of more numbers, four at a time take as long as std::sort. EPYC: 64 take 230, 120 and 120 ns by SSE2, AVX2
/// and AVX-512, and std::sort takes 1,080.
inline constexpr std::uint32_t kMostRanked = 512;
inline constexpr std::uint32_t kRankedAtOnce = 32;

/// So many distances are computed at a time.
inline constexpr std::uint32_t kDistancesAtOnce = 4;

/// Boxes `step` bytes apart. Behind the last one a whole vector of boxes can be read.
struct BoxRow {
  const std::byte* first = nullptr;
  std::size_t step = 0;
  std::uint32_t count = 0;  ///< at most kRowBoxes
};

/// A Path in floats, its direction scaled so that the largest component is at least a half and at most 1;
/// times are in lengths of that. None is shorter than the way on an axis: where a gap is too large for a
/// float, so is the time that it takes. Which way it goes is known beforehand: nobody could foretell a branch
/// at each box. By axis; a fourth lane means nothing.
struct CastNumbers {
  std::int32_t near[4];  ///< the face of boxes that it comes to first: of TreeNode::faces, in bytes
  std::int32_t far[4];   ///< and the one at which it leaves them
  float front[4];   ///< its own side that comes to the first face; where flat, the highest that it ever is
  float back[4];    ///< its own side that leaves a box at the other one; or the lowest
  float sooner[4];  ///< less the inverse of the direction, made a little smaller; infinite where flat
  float later[4];   ///< and larger
  float end;
  float certain_end;    ///< not after the end, as `end` is not before it
  bool can_be_certain;  ///< whether kernels can tell that it touches a box
  bool is_flat;         ///< on an axis it does not move, or hardly
};

/// A box in floats and the square of a distance.
struct NearNumbers {
  float min[3];
  float max[3];
  float most;      ///< a number for a square that is more belongs to a distance that is more
  float certain;   ///< one that is no more than this belongs to a distance that is less
  bool wants_one;  ///< and no other body, however many are as near
};

/// Who gets what a walk through a tree finds: bodies of a node, a bit for each. False ends the walk. The
/// question may become smaller in the call.
struct TakeBodies {
  bool (*take)(void* self, const TreeNode& node, std::uint32_t bodies);
  void* self;
};
/// The same with keys, whose lower half is a body's place in the node.
struct TakeNearBodies {
  bool (*take)(void* self, const TreeNode& node, const std::uint64_t* keys, std::uint32_t count);
  void* self;
};

/// The same of bodies that may be near enough, and a bit for each that is so for certain.
struct TakeBodiesWithin {
  bool (*take)(void* self, const TreeNode& node, std::uint32_t bodies, std::uint32_t certain);
  void* self;
};

/// Those for the tree of boxes, which are as quick with eight lanes as with more. Each gives bodies that may
/// be answers, and some more, as the kernels below.
struct TreeKernels {
  void (*overlap)(const TreeNode* nodes, const Aabb& box, const TakeBodies& take);

  /// Of the nodes in a node that which the path comes to first, or that is nearest, comes before the others.
  void (*cast)(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take);
  /// In no order: those on all of the path, which does not become shorter.
  void (*cast_all)(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take);
  /// In order again.
  void (*near)(const TreeNode* nodes, const NearNumbers& question, const TakeNearBodies& take);

  /// All that are near enough, in no order.
  void (*within)(const TreeNode* nodes, const NearNumbers& question, const TakeBodiesWithin& take);

  /// How far all boxes of a node are from one: distance_of() of each.
  void (*distances)(const TreeNode& node, const Aabb& from, double* distances);
};

/// The kernels of one instruction set. Each of the first four writes the places in the row of all boxes that
/// may be answers and some more, which rounding made look like some, or their slots, and returns how many
/// these are. A box of NaN is none. There is room for a whole vector behind kRowBoxes places.
struct QueryKernels {
  VectorIsa isa;

  /// Boxes that overlap one: exactly those.
  std::uint32_t (*overlap)(const BoxRow& row, const Aabb& box, std::uint32_t* places);

  /// Of at most kRowBoxes boxes of a cell, those that overlap one where the cell owns the pair, as
  /// stream::Kernels says: with `flags`, where the one starts in the cell, their tags have all. Exactly
  /// those; writes their slots.
  std::uint32_t (*overlap_in_cell)(const stream::TaggedBox* boxes, std::uint32_t count, const Aabb& box,
                                   std::uint32_t flags, std::uint32_t* slots);

  /// Boxes that a path touches.
  std::uint32_t (*cast)(const BoxRow& row, const CastNumbers& path, std::uint32_t* places);

  /// Boxes that are near enough. Above the place stand the bits of a float for the square of the distance,
  /// off by up to 2^-21 of it: keys ascend as these do.
  std::uint32_t (*near)(const BoxRow& row, const NearNumbers& question, std::uint64_t* keys);

  /// How far boxes by slot are from one: distance_of() of each. Behind the last distance there is room for
  /// kDistancesAtOnce.
  void (*distances)(const Aabb* boxes, const std::uint32_t* slots, std::uint32_t count, const Aabb& from,
                    double* distances);

  /// The place of each of at most kMostRanked numbers in their order. No two of them are the same; behind the
  /// last number and the last place there is room for kRankedAtOnce.
  void (*rank)(const std::int32_t* numbers, std::uint32_t count, std::uint32_t* places);

  const TreeKernels* trees;
  /// A walk through the tree for paths that can be certain, where every body is an answer. True: the path
  /// touches one for certain, and nobody need be asked. Else as TreeKernels::cast_all. EPYC, AVX-512: with
  /// sixteen lanes 0.81 to 1.0 of the time of eight, where paths to the first body take 1.04.
  bool (*any)(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take);
};

/// Those of an instruction set that the machine has, or the widest below it that there are.
const QueryKernels& query_kernels(VectorIsa isa);

}  // namespace cellsweep::queries
