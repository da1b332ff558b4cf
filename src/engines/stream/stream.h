/// @file
/// Engine `stream`: worlds of any size, cut into cells that are compared in vectors, by as many threads as
/// pay.
#pragma once

#include <cstdint>
#include <memory>

#include "cellsweep/engines.h"
#include "engines/stream/body_store.h"
#include "engines/stream/cell_tree.h"
#include "engines/stream/pair_list.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// Costs follow changes: nothing when nothing changed; the known candidates are tested again while all bodies
/// stay inside of their hulls; the cells of those that left them are looked at when few did; everything is
/// found anew when that is expected to take less time. Memory is linear in bodies and pairs.
class Stream final : public Broadphase {
 public:
  /// `threads` of 0: as many as the machine has, where they pay.
  Stream(unsigned threads, const Kernels& kernels);

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
  PairChanges update_pairs(Kind kind);
  PairChanges update_all();
  PairChanges update_changed();
  void plan_ahead();
  void refresh_counters();

  bool threads_are_given_;
  const Kernels& kernels_;
  Pool pool_;
  BodyStore bodies_;
  CellTree tree_;
  PairList candidates_;  // pairs of overlapping hulls
  PairList pairs_;       // of overlapping boxes, from when on these are not the same
  bool hulls_are_boxes_ = true;
  Cost full_cost_;     // of a body
  Cost partial_cost_;  // of a changed body
  std::uint64_t updates_[kKinds] = {};
  std::uint64_t changed_ = 0;
  std::uint64_t built_copies_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::stream

namespace cellsweep {

/// Makes an empty `stream`. Errors: bad_option for an instruction set that this machine or build does not
/// have.
Result<std::unique_ptr<Broadphase>> make_stream(const EngineOptions& options);

}  // namespace cellsweep
