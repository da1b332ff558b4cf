/// @file
/// The bodies of an SPU, sorted along its axis from frame to frame.
#pragma once

#include "engines/cell/spu/resident/body_box.h"

namespace cellsweep::cell {

/// Four boxes, for four tests at once.
struct BoxBlock {
  vec_float4 low[3];
  vec_float4 high[3];
  vec_uint4 tag;
};
static_assert(sizeof(BoxBlock) == 112);

/// All bodies in ascending order of their lower ends on one axis. The arrays belong to the caller, who also
/// gives them room. On the axis the boxes that fill up the last block go from +infinity (C2) to the lowest
/// number, and the last vector of `reach` is filled up with +infinity.
struct SortedAxis {
  unsigned int axis;
  unsigned int count;
  BoxBlock* blocks;      ///< four places each
  vec_float4* reach;     ///< for each block, the largest upper end up to there: ascending
  std::uint16_t* place;  ///< by slot

  unsigned int block_count() const { return (count + 3) / 4; }
  unsigned int reach_vectors() const { return (count + 15) / 16; }
};

/// The box at a place, with its tag.
BodyBox box_at(const SortedAxis& axis, unsigned int place);

void set_tag_at(const SortedAxis& axis, unsigned int place, unsigned int tag);

/// Brings `reach` up to date for the places from `first` on.
void refresh_reach(SortedAxis& axis, unsigned int first);

/// Moves the body at `place` to where its new box belongs, by insertion: bodies that moved a little pass few
/// others (temporal coherence). Returns the lowest place that changed. `reach` is not up to date after it.
unsigned int move_body(SortedAxis& axis, unsigned int place, const BodyBox& box);

/// Takes out all marked bodies: compaction in SIMD (F2).
void remove_marked(SortedAxis& axis);

/// Merges new bodies, boxes[order[0]], boxes[order[1]] …, ascending on the axis, into the sorted ones.
void merge_bodies(SortedAxis& axis, const BodyBox* boxes, const int* order, unsigned int count);

}  // namespace cellsweep::cell
