/// @file
/// Engine `stream`: worlds of any size, cut into cells that are compared in vectors, by as many threads as
/// pay.
#pragma once

#include <cstdint>
#include <memory>

#include "cellsweep/engines.h"
#include "engines/stream/bodies/body_store.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/pairs/overlap_list.h"
#include "engines/stream/pairs/pair_list.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// Costs follow changes: nothing when nothing changed; the known candidates are tested again while all bodies
/// stay inside of their hulls; the cells of those that left them are looked at when few did; everything is
/// found anew when that is expected to take less time. Memory is linear in bodies and pairs.
class Stream final : public Broadphase {
 public:
  /// `threads` of 0: as many as the machine has, where they pay. `max_pairs` of 0: any number.
  /// With a `finder`, everything is found anew by it where not all bodies stayed inside of their hulls.
  Stream(unsigned threads, std::uint64_t max_pairs, const Kernels& kernels,
         std::unique_ptr<PieceFinder> finder);

  using Broadphase::insert;
  using Broadphase::move;
  using Broadphase::remove;
  std::string_view name() const override { return "stream"; }
  Capacity capacity() const override;
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) override;
  Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes) override;
  Status remove(std::span<const BodyId> ids) override;
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override {
    return hulls_are_boxes_ ? candidates_.pairs() : pairs_.pairs();
  }
  std::size_t size() const override { return bodies_.size(); }
  const Statistics& statistics() const override { return statistics_; }

 private:
  /// The kinds of update, counted in the statistics.
  enum Kind { kFull, kPartial, kInPlace, kIdle, kKinds };

  /// What one kind of update takes for each body it handles, in seconds of one thread.
  struct Cost {
    double seconds = 0;
    void learn(double sample);
  };

  void choose_workers(std::size_t items, double seconds_of_item);
  Kind kind_of_update();
  PairChanges update_or_start_anew(Kind& kind);
  PairChanges update_pairs(Kind kind);
  void build_tree();
  Status too_many_pairs() const;
  PairChanges update_all();
  PairChanges update_changed();
  PairChanges test_candidates(Kind kind, const PairChanges& of_candidates);
  void plan_ahead();
  void refresh_counters();

  bool threads_are_given_;
  const Kernels& kernels_;
  std::size_t max_pairs_;
  std::unique_ptr<PieceFinder> finder_;
  Pool pool_;
  BodyStore bodies_;
  CellTree tree_;
  PairList candidates_;  // pairs of overlapping hulls
  OverlapList pairs_;    // of overlapping boxes, from when on these are not the same
  bool hulls_are_boxes_ = true;
  double missed_ = 0;  // seconds that threads would have saved, had there been any
  Cost full_cost_;     // of a body
  Cost partial_cost_;  // of a changed body
  std::uint64_t updates_[kKinds] = {};
  std::uint64_t changed_ = 0;
  std::uint64_t built_copies_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::stream

namespace cellsweep {

/// Makes an empty `stream` that finds pairs by itself or by a `finder`. Errors: bad_option for an instruction
/// set that this machine or build does not have.
Result<std::unique_ptr<Broadphase>> make_stream(const EngineOptions& options,
                                                std::unique_ptr<stream::PieceFinder> finder = nullptr);

}  // namespace cellsweep
