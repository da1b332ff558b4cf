/// @file
/// What one SPU of cell-resident keeps in its local store, and what it does with an order.
#pragma once

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/resident/box_maker.h"
#include "engines/cell/spu/resident/event_stream.h"
#include "engines/cell/spu/resident/sorted_axis.h"

namespace cellsweep::cell {

/// Lives as long as the program; its buffers are those that the host's map of the local store lists. Of a
/// pair it keeps no bit: the boxes of the last order stay here, and two compares tell from them whether a
/// pair overlapped. So the status of all pairs (F1) takes the room of the bodies, and the three axes are
/// combined without asking another SPU.
class ResidentSpu {
 public:
  explicit ResidentSpu(const ResidentJob& job);

  /// Carries out an order; returns how many events were sent.
  unsigned int obey(ResidentOrder order, unsigned int records);

 private:
  void fetch(unsigned int records);
  void list_by_place(unsigned int records);
  void list_by_key(unsigned int records);
  unsigned int sort_list(unsigned int records);
  void mark_old_boxes();
  void insert_marked();
  void move_marked();
  void sweep_share(const BodyBox* own, const BodyBox* elsewhere, unsigned int flag,
                   EventStream& events) const;
  void unmark();

  ResidentJob job_;
  SortedAxis axis_;
  BodyBox* records_;
  BodyBox* old_boxes_;  // by number of record, as they were before the order
  vec_int4* keys_;      // of the records, to sort them by
  vec_int4* list_;      // numbers of records, each body once, in the order of the axis
  unsigned int listed_ = 0;
  unsigned int* pieces_;
  BoxMaker box_maker_;
};

}  // namespace cellsweep::cell
