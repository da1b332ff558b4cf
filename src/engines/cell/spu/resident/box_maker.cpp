#include "engines/cell/spu/resident/box_maker.h"

#include <malloc_align.h>

#include "engines/cell/spu/common/dma.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kAxes = 3;
constexpr unsigned int kFirstTag = 3;

template <class T>
T* allocate_pieces() {
  return static_cast<T*>(_malloc_align(2 * kPosePiece * sizeof(T), kLog2Align));
}

}  // namespace

BoxMaker::BoxMaker(const ResidentJob& job)
    : poses_ea_(ea_of(job.poses)),
      intervals_ea_(ea_of(job.intervals)),
      axis_(job.axis),
      first_piece_(job.spu / kAxes),
      piece_step_((job.spus - job.axis + kAxes - 1) / kAxes) {
  if (poses_ea_ == 0) return;
  poses_ = allocate_pieces<PoseVectors>();
  intervals_ = allocate_pieces<IntervalVectors>();
}

void BoxMaker::enclose_all(unsigned int bodies) {
  blocks_ = (bodies + kLanes - 1) / kLanes;
  unsigned int turn = 0;
  unsigned int piece = first_piece_;
  fetch(piece, turn);
  for (; blocks_of(piece) != 0; piece += piece_step_, turn ^= 1U) {
    fetch(piece + piece_step_, turn ^ 1U);
    wait_for_tag(kFirstTag + turn);
    for (unsigned int i = turn * kPosePiece; i < turn * kPosePiece + blocks_of(piece); ++i)
      intervals_[i] = enclose(poses_[i], axis_);
    send(piece, turn);
  }
  wait_for_tags(3U << kFirstTag);
}

void BoxMaker::fetch(unsigned int piece, unsigned int turn) {
  const unsigned int offset = piece * kPosePiece * static_cast<unsigned int>(sizeof(PoseBlock));
  get_all(poses_ + turn * kPosePiece, poses_ea_ + offset,
          blocks_of(piece) * static_cast<unsigned int>(sizeof(PoseBlock)), kFirstTag + turn);
}

// Under the tag of this half's next fetch, whose wait comes before the intervals are overwritten.
void BoxMaker::send(unsigned int piece, unsigned int turn) {
  const unsigned int offset = piece * kPosePiece * static_cast<unsigned int>(sizeof(IntervalBlock));
  put_all(intervals_ + turn * kPosePiece, intervals_ea_ + offset,
          blocks_of(piece) * static_cast<unsigned int>(sizeof(IntervalBlock)), kFirstTag + turn);
}

unsigned int BoxMaker::blocks_of(unsigned int piece) const {
  const unsigned int before = piece * kPosePiece;
  if (before >= blocks_) return 0;
  return blocks_ - before < kPosePiece ? blocks_ - before : kPosePiece;
}

}  // namespace cellsweep::cell
