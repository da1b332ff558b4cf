/// @file
/// Makes a trace of what a program tells its broadphase, whichever that is.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"
#include "cellsweep/world/trace.h"

namespace cellsweep {

/// Takes notes of bodies that come, move and go, and at the end of a frame adds it to the trace. Ids may be
/// any numbers, and free again at once; in the trace bodies have small ones, the lowest that is free. Of
/// several boxes in a frame the last counts; who came and went within one leaves no trace. One thread at a
/// time. std::bad_alloc, and nothing has changed.
class CELLSWEEP_API TraceRecorder {
 public:
  /// Errors: bad_input, and nothing noted, for a body that is there.
  Status insert(BodyId id, const Aabb& box, const BodyFilter& filter = {});
  /// Errors of these: bad_input, and nothing noted, for a body that is not there.
  Status move(BodyId id, const Aabb& box);
  Status set_filter(BodyId id, const BodyFilter& filter);
  Status remove(BodyId id);

  void end_frame();

  /// The frames that ended.
  const Trace& trace() const { return trace_; }

 private:
  struct Body {
    Aabb box;   // at the end of the frame before
    Aabb next;  // now
    BodyFilter filter;
    bool is_there = false;
    bool is_new = false;
    bool is_noted = false;  // in noted_
  };

  Body* find(BodyId id);
  void make_room();
  void enter(BodyId number, const Aabb& box, const BodyFilter& filter);
  void note(BodyId number);
  void leave(BodyId number);
  void list_frame();
  void forget_frame();

  Trace trace_;
  std::unordered_map<BodyId, BodyId> numbers_;  // by the caller's id
  std::vector<Body> bodies_;                    // by number
  std::vector<BodyId> noted_;                   // numbers that may be in this frame's lists
  std::vector<BodyId> removed_;
  std::vector<BodyId> free_;  // descending
};

}  // namespace cellsweep
