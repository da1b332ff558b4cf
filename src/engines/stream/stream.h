/// @file
/// Engine `stream`: worlds of any size, cut into cells that are compared in vectors, by as many threads as
/// pay.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "base/threads/crew.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/engine/phase_timer.h"
#include "cellsweep/engine/piece_finder.h"
#include "cellsweep/stream_view.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/choices/fat_box_choice.h"
#include "engines/stream/choices/growth_choice.h"
#include "engines/stream/choices/slack_cost.h"
#include "engines/stream/choices/spare_memory.h"
#include "engines/stream/choices/update_costs.h"
#include "engines/stream/pairs/overlaps.h"
#include "engines/stream/rebuild/rebuild.h"
#include "engines/stream/search/search.h"

namespace cellsweep::stream {

struct StreamParts {
  std::shared_ptr<Crew> crew;
  std::size_t max_pairs = 0;  ///< 0: any number
  const Kernels* kernels = nullptr;
  float margin = 0;                       ///< StreamOptions::margin
  std::unique_ptr<PieceFinder> finder{};  ///< finds pairs anew in the kernels' place; null for them
};

/// Costs follow changes: nothing when nothing changed; the known candidates are tested again while all bodies
/// stay inside of their fat boxes; the cells of those that left them are looked at when few did; everything
/// is found anew when that is expected to take less time, as in every update of a small world in which most
/// bodies move, or of one whose fat boxes do not last. Memory is linear in bodies and pairs.
class Stream final : public Engine, public HasFinder {
 public:
  [[gnu::cold]] explicit Stream(StreamParts parts);
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  [[gnu::cold]] ~Stream() override;

  Capacity capacity() const override;
  Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) override;
  [[gnu::cold]] void count(Statistics& statistics) const override;
  /// A look inside; `boxes` are those of the last update, by slot.
  [[gnu::cold]] StreamView view(std::span<const Aabb> boxes) const;
  const PieceFinder* finder() const override { return parts_.finder.get(); }
  CellsToQuery cells() const override {
    return {search_.has_cells() ? &search_.cells().root() : nullptr, parts_.kernels->isa,
            !fat_boxes_.have_slack()};
  }

 private:
  /// The kinds of update, counted in the statistics.
  enum Kind { kFull, kPartial, kInPlace, kIdle, kKinds };

  Kind take(const BodyChanges& changes, WorkCost::Clock::time_point now);
  [[gnu::cold]] FoundPairs find_prepared(const BodyChanges& changes, Kind& kind, PhaseTimer& timer);
  FoundPairs find(const BodyChanges& changes, Kind& kind, PhaseTimer& timer);
  [[gnu::cold]] FoundPairs find_none(const BodyChanges& changes);
  bool find_of_few(const BodyChanges& changes, PhaseTimer& timer, FoundPairs& found);
  FoundPairs find_in_place(const BodyChanges& changes, PhaseTimer& timer);
  bool find_changed(const BodyChanges& changes, PhaseTimer& timer, FoundPairs& found);
  FoundPairs find_all(const BodyChanges& changes, std::size_t most_swept, PhaseTimer& timer);
  FoundPairs find_anew(const BodyChanges& changes, std::size_t most_swept, PhaseTimer& timer);
  FoundPairs counted(const FoundPairs& found);
  [[gnu::cold]] void give_back();
  [[gnu::cold]] void forget_all();
  std::size_t bytes_held() const { return fat_boxes_.bytes() + search_.bytes() + overlaps_.bytes(); }
  [[gnu::cold]] std::size_t most_bytes() const;
  [[gnu::cold]] void count_bytes();
  [[gnu::cold]] void list_counters(Statistics& statistics) const;
  void note_full();
  void note_fat_boxes(const BodyChanges& changes, const FatBoxWork& work);
  FatBoxWork work_of(const BodyChanges& changes, Kind kind) const;
  ListLimit list_limit(const BodyChanges& changes) const;
  [[gnu::noinline]] bool refit(const BodyChanges& changes);
  [[gnu::noinline]] void note_slack(const BodyChanges& changes);
  void note_idle(Statistics& statistics);

  StreamParts parts_;
  Crew& crew_;
  FatBoxes fat_boxes_;
  Search search_;
  Overlaps overlaps_;
  Rebuild rebuild_;
  FatBoxChoice fat_box_choice_;
  UpdateCosts costs_;
  SlackCost slack_cost_;
  GrowthChoice growth_choice_;
  SpareMemory spare_memory_;
  bool is_anew_ = false;           // this update finds everything, without fat boxes
  bool uses_prepared_ = false;     // this update
  bool was_full_ = false;          // the last update
  std::size_t pairs_ = 0;          // how many there are,
  std::size_t changed_pairs_ = 0;  // and began or ended in the last update
  std::size_t bodies_ = 0;         // held now
  std::size_t most_listed_ = 0;    // changes of fat boxes that the next update looks at one by one
  std::array<std::uint64_t, kKinds> updates_{};
  std::uint64_t changed_ = 0;
  std::uint64_t compared_ = 0;  // boxes of cells with those that changed, in this update
  bool is_of_few_ = false;      // this update looked at the bodies that changed alone
};

}  // namespace cellsweep::stream
