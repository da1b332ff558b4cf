/// @file
/// Engine `stream`: worlds of any size, cut into cells that are compared in vectors, by as many threads as
/// pay.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>

#include "base/crew.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/engine/phase_timer.h"
#include "cellsweep/engine/piece_finder.h"
#include "cellsweep/stream_view.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/pairs/candidate_list.h"
#include "engines/stream/pairs/overlap_marks.h"
#include "engines/stream/pairs/pairs_of_few.h"
#include "engines/stream/sweep/sweep.h"

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
/// is found anew when that is expected to take less time. Memory is linear in bodies and pairs.
class Stream final : public Engine, public HasFinder {
 public:
  explicit Stream(StreamParts parts);

  Capacity capacity() const override;
  Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) override;
  /// A look inside; `boxes` are those of the last update, by slot.
  StreamView view(std::span<const Aabb> boxes) const;
  const PieceFinder* finder() const override { return parts_.finder.get(); }

 private:
  using Clock = std::chrono::steady_clock;

  /// The kinds of update, counted in the statistics.
  enum Kind { kFull, kPartial, kInPlace, kIdle, kKinds };

  /// What one kind of update takes for each body it handles, in seconds of one thread.
  struct Cost {
    double seconds = 0;
    void learn(double sample);
  };

  Kind take(const BodyChanges& changes);
  FoundPairs find(const BodyChanges& changes, Kind& kind, PhaseTimer& timer);
  FoundPairs find_none(const BodyChanges& changes);
  FoundPairs find_all(const BodyChanges& changes, bool with_cells, Clock::time_point start,
                      PhaseTimer& timer);
  FoundPairs find_changed(const BodyChanges& changes, Clock::time_point start, PhaseTimer& timer);
  bool change_cells();
  bool wants_cells(Kind kind) const;
  FoundPairs test_all(const BodyChanges& changes, PhaseTimer& timer);
  FoundPairs test_candidates(const BodyChanges& changes, const SlotPairChanges& of_candidates,
                             PhaseTimer& timer);
  SlotPairChanges refresh_marks(const BodyChanges& changes, const SlotPairChanges& of_candidates);
  bool are_few(const BodyChanges& changes) const;
  FoundPairs find_of_few(const BodyChanges& changes, PhaseTimer& timer);
  void repair_marks(const BodyChanges& changes);
  void list_pairs_before(const BodyChanges& changes);
  FoundPairs compare_with_before(std::span<const SlotPair> now);
  void find_candidates(const BodyChanges& changes, bool with_cells);
  void find_among(std::span<const Aabb> boxes, std::size_t most, bool with_cells);
  bool sweep(std::span<const Aabb> boxes, std::size_t most);
  FoundPairs counted(const FoundPairs& found);
  void mark_fresh(const BodyChanges& changes, std::uint8_t mark);
  std::size_t generous_limit() const;
  void plan_ahead();
  void note_idle(Statistics& statistics);
  void refresh_counters(Statistics& statistics);

  StreamParts parts_;
  Crew& crew_;
  FatBoxes fat_boxes_;
  CellTree cells_;
  bool have_cells_ = false;  // when not, there are few bodies, and they are swept
  bool was_full_ = false;    // the last update
  Sweep sweep_;
  Keys swept_;
  std::span<const std::uint64_t> swept_view_;
  CandidateList candidates_;  // pairs of overlapping fat boxes
  OverlapMarks marks_;        // which of them are pairs, from when on not all are
  bool candidates_are_pairs_ = true;
  /// What the marks say of the update before.
  enum class Marks { true_of_it, all_are_pairs, stale };
  Marks marks_say_ = Marks::true_of_it;
  PairsOfFew few_;
  std::size_t pairs_ = 0;   // how many there are
  Array<SlotPair> before_;  // the pairs of the update before, when everything is found anew
  Array<SlotPair> now_;     // and those of this one
  Array<SlotPair> began_;
  Array<SlotPair> ended_;
  Vector<std::uint8_t> fresh_;  // by slot, 0 between updates
  std::size_t bodies_ = 0;
  std::size_t most_listed_ = 0;  // changes of fat boxes that the next update looks at one by one
  Cost full_cost_;               // of a body
  Cost partial_cost_;            // of a changed body
  std::array<std::uint64_t, kKinds> updates_{};
  std::uint64_t changed_ = 0;
  std::uint64_t built_copies_ = 0;
  std::uint64_t tested_ = 0;  // candidates
  std::size_t bytes_ = 0;
};

}  // namespace cellsweep::stream
