/// @file
/// The bodies of a broadphase: their ids, their boxes as of the last update, and what waits for the next one.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "base/memory/list.h"
#include "base/threads/crew.h"
#include "broadphase/bodies/id_choice.h"
#include "broadphase/bodies/id_table.h"
#include "broadphase/bodies/move_check.h"
#include "broadphase/bodies/slot_filters.h"
#include "broadphase/bodies/staged_boxes.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// Checks every call whole and remembers it. begin_update() puts what was remembered into the boxes; then
/// either commit() forgets it or undo() takes it out again, and neither can fail. A call that throws
/// std::bad_alloc has changed nothing.
class Bodies {
 public:
  /// The input calls of Broadphase; no filters are the default for all. `engine` and `capacity` are for the
  /// sentence that refuses one.
  Status insert(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                std::span<const BodyFilter> filters, std::string_view engine, const Capacity& capacity);
  Status add(Crew& crew, std::span<const Aabb> boxes, std::span<BodyId> ids, std::string_view engine,
             const Capacity& capacity);
  Status set_filters(std::span<const BodyId> ids, std::span<const BodyFilter> filters);
  Status move(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status remove(std::span<const BodyId> ids);

  /// Boxes as of the last update.
  Status boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const;

  /// Boxes of bodies that are held, as the next update will have them.
  Status next_boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const;

  /// Of a body that is held: what counts from the next update on.
  BodyFilter filter(Slot slot) const { return filters_.of(slot); }
  const SlotFilters& filters() const { return filters_; }

  /// By slot.
  std::span<const Aabb> all_boxes() const { return boxes_.boxes(); }
  const StagedBoxes& staged() const { return boxes_; }

  BodyChanges begin_update();
  void undo();
  void commit();

  /// All bodies that an update has seen, and those that wait, as new ones: for an engine that knows none.
  /// Between begin_update() and its end.
  [[gnu::cold]] BodyChanges all_as_new();

  /// Of the bodies of the last update that are gone, ascending; one whose filter changed is not.
  [[gnu::cold]] std::vector<BodyId> removed_ids() const;

  /// Numbers slots anew when most are free; true when it did. All engines must begin anew then. Between
  /// updates, and only when nothing waits.
  bool tidy();

  /// StagedBoxes::has_come_to_rest().
  bool have_come_to_rest() const { return boxes_.has_come_to_rest(); }

  const IdTable& table() const { return table_; }
  std::size_t size() const { return table_.size(); }
  [[gnu::cold]] std::size_t bytes() const;

 private:
  Status insert_all(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                    std::span<const BodyFilter> filters, std::string_view engine, const Capacity& capacity);
  Status check_room(std::string_view engine, const Capacity& capacity, std::size_t more) const;
  bool check_moves(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes);
  [[gnu::cold]] void set_filter(Slot slot, const BodyFilter& filter);
  MovedBodies checked_moves(const Crew& crew, std::span<const Aabb> boxes) const;

  IdTable table_;
  IdChoice choice_;
  StagedBoxes boxes_;
  SlotFilters filters_;
  List<Slot> inserted_;
  bool some_unseen_ = false;       // some of the inserted were removed again, and are kGone
  List<Slot> moved_;               // slots of the last call of move(), and whatever was behind them before
  List<Slot> slots_;               // of a call of add(), or of all_as_new()
  std::vector<MoveCheck> checks_;  // by worker
};

}  // namespace cellsweep
