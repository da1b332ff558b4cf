/// @file
/// What an engine is, for those who write one: boxes by slot and what changed go in, pairs of slots come out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/status.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep {

namespace stream {
struct Node;
}  // namespace stream

/// The cells of engine `stream`, or of one that shares them, for queries to walk through.
struct CellsToQuery {
  const stream::Node* root = nullptr;  ///< null: there are none, and queries look at all boxes
  VectorIsa isa = VectorIsa::best;     ///< what the engine was made with
  bool are_exact = false;              ///< boxes in cells are those of the bodies, and not larger
};

/// What happened since the last update that succeeded. A slot is in one list at most, and there once.
struct BodyChanges {
  std::span<const Aabb> boxes;    ///< as they are now, by slot; kNobody where nobody is
  SlotBoxes before;               ///< of the removed and the moved: what they had
  std::span<const Slot> removed;  ///< given to nobody else before the next update
  std::span<const Slot> moved;    ///< the box may be the one before again
  std::span<const Slot> inserted;
  std::size_t bodies = 0;  ///< held now
  /// By slot, empty while all bodies have the default; slots behind the end have it, too. What a slot has
  /// stays as it is until the slot was removed and inserted again.
  std::span<const BodyFilter> filters{};
  bool ids_ascend = false;  ///< with their slots: pairs in the order of slots need not be sorted again

  bool none() const { return removed.empty() && moved.empty() && inserted.empty(); }
};

/// Of a slot, among the filters of BodyChanges.
inline BodyFilter filter_of(std::span<const BodyFilter> filters, Slot slot) {
  return slot < filters.size() ? filters[slot] : BodyFilter{};
}

/// What an engine found. The memory is the engine's until its next update.
struct FoundPairs {
  /// Ascending. Those of bodies that are gone are among `ended`.
  std::span<const SlotPair> began{};
  std::span<const SlotPair> ended{};
  /// More that began, as pair_key(), in any order.
  std::span<const std::span<const std::uint64_t>> more_began{};
  /// Everything is in `began` and `more_began`: all pairs that there are now, whatever was before.
  bool is_whole_set = false;
  /// Pairs that filters do not allow were left out. If not, the handle does that.
  bool is_filtered = false;

  bool none() const { return began.empty() && ended.empty() && more_began.empty() && !is_whole_set; }
};

/// An engine behind a Broadphase, which owns the boxes, knows the ids, checks the input and keeps the pairs.
/// One thread at a time.
///
/// An engine whose update() failed or threw is thrown away: the next update makes a new one and inserts all
/// bodies into it. So an engine need not repair itself.
class CELLSWEEP_API Engine {
 public:
  virtual ~Engine();

  /// Always the same.
  virtual Capacity capacity() const = 0;

  /// Finds the pairs as they are with these changes. Fills the phases and counters of `statistics` and adds
  /// to its bytes.
  virtual Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) = 0;

  /// Fills in what would take time in each update though hardly anybody asks. Called when somebody does, once
  /// after an update that succeeded. Must not throw: an update makes room for counters.
  virtual void count(Statistics& /*statistics*/) const {}

  /// Whether it ran out of memory behind the last update, in a thread of its own: nobody was told, and it is
  /// thrown away before the next update, too.
  virtual bool ran_out_of_memory() const { return false; }

  /// As of the last update, valid until the next one. From any number of threads between updates.
  virtual CellsToQuery cells() const { return {}; }
};

/// Makes an engine, again after one has failed. Errors become those of make_broadphase() and update().
using EngineMaker = std::function<Result<std::unique_ptr<Engine>>()>;

struct HandleParts;
struct LastUpdate;

/// How a Broadphase gets its engine, and how an engine's own functions get at it again.
struct CELLSWEEP_API EngineAccess {
  /// `name` is a literal. A `trace` file that is not empty gets a row `row_name` of its calls and phases.
  static Result<Broadphase> make(std::string_view name, EngineMaker maker, const std::string& trace = {},
                                 std::string row_name = {});

  /// The same for engines of this library, which share threads with their Broadphase.
  static Result<Broadphase> make(HandleParts parts);

  /// Broadphase::update() in two steps, for those who must agree with others before it counts: what would be
  /// returned and when it cannot be. After a success comes one of the other two and nothing before it;
  /// neither can fail. An update that was abandoned is one that failed. Both lists stay where they are in
  /// commit_update().
  static Result<PairChanges> prepare_update(Broadphase& broadphase);
  static void commit_update(Broadphase& broadphase);
  static void abandon_update(Broadphase& broadphase);

  /// The boxes that bodies which are held now will have after the next update. Errors: as
  /// Broadphase::boxes().
  static Status next_boxes(const Broadphase& broadphase, std::span<const BodyId> ids, std::span<Aabb> boxes);

  static Engine& engine_of(Broadphase& broadphase);
  static const Engine& engine_of(const Broadphase& broadphase);

  /// By slot, as of the last update.
  static std::span<const Aabb> boxes_of(const Broadphase& broadphase);

  /// What queries read: valid as long as the Broadphase, and kept up to date.
  static const LastUpdate& last_update(const Broadphase& broadphase);
};

}  // namespace cellsweep
