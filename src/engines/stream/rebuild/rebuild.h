/// @file
/// Everything found anew a part at a time: while all bodies move, no update of engine `stream` has to do it
/// all.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/threads/crew.h"
#include "base/threads/work_cost.h"
#include "base/tuning.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/bodies/watch.h"
#include "engines/stream/pairs/overlaps.h"
#include "engines/stream/rebuild/rebuild_pace.h"
#include "engines/stream/rebuild/rebuild_shares.h"
#include "engines/stream/search/search.h"

namespace cellsweep::stream {

/// Fat boxes last for some updates. In the meantime the next ones, for where bodies will be by then, their
/// cells and their candidates are prepared, a part in each update; then they are put in the place of
/// those that there are. That is done as long as nobody comes or goes and most bodies move; where it is not,
/// or is not done in time, everything is found anew at once when that is cheaper.
class Rebuild {
 public:
  Rebuild(Crew& crew, FatBoxes& fat_boxes, Search& search, Overlaps& overlaps)
      : crew_(crew), fat_boxes_(fat_boxes), search_(search), overlaps_(overlaps) {}

  /// An update begins. True when it is to use what was prepared; of that, fat boxes are in their place
  /// already.
  bool begin_update(const BodyChanges& changes, WorkCost::Clock::time_point now);

  /// Does the next part, in an update that found nothing anew and in which so many bodies left their fat
  /// boxes. Returns how many fat boxes it prepared.
  std::size_t go_on(const BodyChanges& changes, std::size_t escaped);

  /// Whether some of it is prepared, or room for it held.
  bool is_under_way() const { return holds_memory_; }

  /// An update used what was prepared.
  [[gnu::cold]] void note_used(std::size_t bodies);
  /// An update has found everything anew: what was prepared is of no use. It may hold the candidates that the
  /// update compared with, so not before that.
  [[gnu::cold]] void note_full();

  /// Forgets what was prepared, and its memory.
  [[gnu::cold]] void drop();

 private:
  [[gnu::cold]] bool begin(const BodyChanges& changes);
  std::uint32_t parts() const { return used_at_ - first_part_; }
  /// Until what is prepared is used.
  float updates_left() const { return static_cast<float>(used_at_ - age_); }
  std::uint32_t updates_for_next(const BodyChanges& changes) const;
  void go_to(RebuildStage stage);
  template <class Work>
  void do_part(RebuildStage stage, const Work& work);
  [[gnu::cold]] void prepare_until(double due, const BodyChanges& changes);
  [[gnu::cold]] bool prepare_fat_boxes(double due, const BodyChanges& changes);
  [[gnu::cold]] bool fill_cells(double due, const Boxes& boxes);
  bool prepare_cells(double due);
  [[gnu::cold]] bool mend_fat_boxes(double due, const BodyChanges& changes);
  bool prepare_order(double due);
  void begin_anew();

  Crew& crew_;
  FatBoxes& fat_boxes_;
  Search& search_;
  Overlaps& overlaps_;
  Watch watch_;
  RebuildStage stage_ = kNothing;
  RebuildPace pace_;
  RebuildShares shares_;
  WorkCost cost_{tuning::kFullGuess};    // of a whole one, for each body
  unsigned workers_ = 1;                 // in all its parts
  WorkCost::Clock::time_point started_;  // this update
  bool holds_memory_ = false;
  bool may_begin_ = false;    // the next one, when most fat boxes are going to be left
  double stage_done_ = 0;     // the share of the fat boxes that are made in this stage, or looked at again
  std::size_t placed_ = 0;    // boxes in this update
  std::uint64_t copies_ = 0;  // boxes placed in the next cells,
  std::uint64_t built_ = 0;   // and so many of them in cells that are made
  std::uint32_t age_ = 0;     // updates since the fat boxes in use were put in their place,
  std::uint32_t first_part_ = 0;  // that age when the next ones were begun,
  std::uint32_t used_at_ = 0;     // and when they will be used,
  std::uint32_t lasts_ = 0;       // which takes so many updates
  std::uint32_t made_for_ = 0;    // so many updates those in use were made for,
  std::uint32_t next_lasts_ = 0;  // and the next ones will be
  std::size_t escaped_ = 0;       // bodies that left theirs since
  std::uint32_t calm_ = 0;        // so many times few did, one after the other,
  std::uint32_t patience_ = 1;    // of so many, after which they are made for more updates
};

}  // namespace cellsweep::stream
