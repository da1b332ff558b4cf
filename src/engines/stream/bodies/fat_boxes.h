/// @file
/// The fat boxes of engine `stream`, and how those of an update differ from those before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/memory/slot_blocks.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/function_ref.h"
#include "engines/stream/bodies/course.h"
#include "engines/stream/bodies/fat_box.h"
#include "engines/stream/bodies/growth.h"

namespace cellsweep {
struct BodyChanges;
}  // namespace cellsweep

namespace cellsweep::stream {

/// A body whose fat box changed: where it was when the cells were last brought up to date, and where it is.
struct FatBoxChange {
  Slot slot = 0;
  bool was = false;
  bool is = false;
  Aabb old_box{};
  Aabb new_box{};
};

/// When changes of fat boxes are listed one by one.
struct ListLimit {
  std::size_t most_listed = 0;  ///< up to so many
  float left_soon = 0;          ///< none, when most will be left within so many updates; 0: all the same
};

/// Every body has two boxes: its own, and a fat box around it in which it may move about. Fat boxes are what
/// the cells hold; while a body stays inside of its own, no cell changes. It is the box itself until the body
/// moves, and from then on covers where the body would be some updates later if it kept its course, and, for
/// one that trembles, as much to either side as makes it last. While few bodies move, only these have one in
/// memory.
class FatBoxes {
 public:
  /// `margin` is StreamOptions::margin.
  explicit FatBoxes(float margin = 0) : margin_(margin) {}

  /// That of fat boxes that are made from now on.
  void use_growth(const Growth& growth) { growth_ = growth; }

  /// What an update did to them.
  enum class Extent {
    inside,  ///< all bodies that moved stayed inside of their fat boxes
    listed,  ///< few changed: changes()
    all      ///< more changed than should be listed
  };

  /// Takes changes in, of which there are some.
  Extent take(Crew& crew, const BodyChanges& changes, const ListLimit& limit);
  /// The same, and those of all bodies that moved are made anew, as small as they may turn out to last.
  [[gnu::cold]] void refit(Crew& crew, const BodyChanges& changes);

  /// Each slot once; after Extent::listed. Valid until the next take().
  std::span<const FatBoxChange> changes() const { return changes_.view(); }

  /// Fat boxes for later: prepared(), by slot. prepare() makes those of some bodies, by place in the list of
  /// moved ones, for those who use them `from` updates ahead, to last for so many from then on; others keep
  /// those that they have. As long as no body came or went, use_prepared() puts them in the place of those
  /// that there are, before a take().
  void begin_prepared(std::span<const Aabb> boxes);
  void prepare(Crew& crew, const BodyChanges& changes, Share places, float from, float updates);
  std::span<const Aabb> prepared() const { return prepared_.view(); }
  /// Makes those of these bodies anew in which they will not be `from` updates ahead if they keep their
  /// course, and lists what changed: valid until the next call.
  [[gnu::cold]] std::span<const FatBoxChange> mend_prepared(Crew& crew, const BodyChanges& changes,
                                                            Share places, float from, float updates);
  void use_prepared() { std::swap(fat_.all(), prepared_); }
  /// Whether most of the bodies that moved have left the fat boxes that there are, or will within so many
  /// updates if they keep their course: some tell.
  [[gnu::cold]] bool are_being_left(const BodyChanges& changes, float updates) const;
  /// Whether most of the bodies that moved are known to tremble, or creep: some tell.
  [[gnu::cold]] bool do_most_settle(const BodyChanges& changes) const;
  /// Forgets them, and their memory.
  [[gnu::cold]] void drop_prepared() {
    prepared_ = List<Aabb>();
    mended_ = List<FatBoxChange>();
  }

  /// Gives memory back that the next update may ask for again; changes() may lie there no longer.
  [[gnu::cold]] void give_back();

  /// Some fat box may be larger than its box.
  bool have_slack() const { return slack_; }

  /// Every fat box is its box again; for a new start.
  void drop_slack();

  /// That of a body that moved in the last take().
  const Aabb& operator[](Slot slot) const { return fat_[slot]; }
  /// That of any slot, which had this box in the last take(); kNobody where there is no body.
  const Aabb& of(Slot slot, const Aabb& box) const { return has(slot) ? fat_[slot] : box; }
  /// All, by slot, for the boxes that the last take() was given. Puts them in that order, which may throw
  /// std::bad_alloc.
  const Aabb* by_slot(std::span<const Aabb> boxes);

  [[gnu::cold]] std::size_t bytes() const;

 private:
  LaterOutlook later_outlook(float from, float updates) const;
  bool has(Slot slot) const { return slack_ && fat_.has(slot); }
  [[gnu::cold]] void lay_by_slot(List<Aabb> boxes);
  void add_moved(const BodyChanges& changes);
  Aabb grown(Slot slot, const Aabb& before, const Aabb& now, bool escaped, float updates);
  std::size_t note_escapes(Crew& crew, std::size_t moved, Share places, FunctionRef<std::size_t(Share)> note);
  std::size_t find_escapes(Crew& crew, const BodyChanges& changes);
  std::size_t find_escapes_from_prepared(Crew& crew, const BodyChanges& changes, Share places, float from);
  [[gnu::noinline]] void begin_update(const BodyChanges& changes);
  void renew_all(Crew& crew, const BodyChanges& changes);
  void list(const BodyChanges& changes, std::size_t count);
  void list_removed(Slot slot, const Aabb& before);
  void list_moved(Slot slot, const Aabb& before, const Aabb& now);
  void list_inserted(Slot slot, const Aabb& now);

  SlotBlocks<Aabb> fat_;         // a body without one has its box for a fat box
  SlotBlocks<Course> courses_;   // of the same bodies
  List<Aabb> prepared_;          // by slot
  Array<std::uint8_t> escapes_;  // by place in the list of moved bodies: it left its fat box
  List<FatBoxChange> changes_;
  List<FatBoxChange> mended_;  // of prepared_
  float margin_;
  Growth growth_;
  bool slack_ = false;
  std::uint32_t updates_ = 0;
};

}  // namespace cellsweep::stream
