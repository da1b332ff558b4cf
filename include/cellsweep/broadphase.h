/// @file
/// The face of the library: bodies in, overlapping pairs and their changes out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/options.h"
#include "cellsweep/pair.h"
#include "cellsweep/statistics.h"
#include "cellsweep/status.h"

namespace cellsweep {

class Queries;

/// What changed between two updates, each list in ascending order of (a, b). The memory is the Broadphase's
/// and stays valid until its next update().
struct PairChanges {
  std::span<const Pair> began;  ///< overlap now, did not at the update before
  std::span<const Pair> ended;  ///< overlapped at the update before, do not now (or a body of them is gone)
};

/// How many bodies there may be, and what sets that limit.
struct Capacity {
  std::uint64_t bodies = 0;
  std::string setting;  ///< the option that raises it; empty when nothing does
  std::string reason;   ///< a phrase for a person: what fills up
};

/// A set of bodies with boxes, and the exact set of their overlapping pairs as of the last update().
///
/// Exactness: after update() the current pairs are those that comparing all boxes with all boxes would find,
/// each once with a < b, on any input; and every list is ascending, whatever the engine, its threads and the
/// machine. Boxes are closed: touching counts. Filters leave pairs out.
///
/// Input: a call is checked whole before anything is applied; when it returns a status that is not ok,
/// nothing has changed. -0 and denormal values become +0 on the way in; then a box must be finite with min <=
/// max on every axis.
///
/// Between updates: insert(), move(), set_filters() and remove() are remembered and take effect together in
/// the next update(). Until then pairs() and boxes() are those of the update before. When update() fails, by
/// its status or by std::bad_alloc, they still are, and what was remembered still is: calling it again tries
/// again.
///
/// A body that is removed and inserted again before an update is a new body: its pairs are in `ended`, and
/// those that it has now in `began`.
///
/// Threads: one object belongs to one thread at a time, but any number of threads may call const functions
/// while none calls another; different objects are independent. The library never prints, aborts or exits;
/// std::bad_alloc is the one exception that may leave a call, and it changes nothing either.
class CELLSWEEP_API Broadphase final {
 public:
  /// Engine `stream` with default settings. make_broadphase() makes others.
  Broadphase();
  /// What was moved from may be assigned to or destroyed, and nothing else.
  Broadphase(Broadphase&& other) noexcept;
  Broadphase& operator=(Broadphase&& other) noexcept;
  ~Broadphase();

  /// The name of its engine.
  std::string_view name() const;

  /// The number of bodies that there may be; more is refused with StatusCode::capacity before any work.
  Capacity capacity() const;

  /// Adds bodies; an id may occur once in a call. Errors: bad_input (spans of different length), invalid_box,
  /// duplicate_body, capacity.
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status insert(BodyId id, const Aabb& box);
  /// The same for bodies that do not meet all others: a filter for each, or none for the default. Further
  /// errors: bad_input when there are more or fewer.
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes,
                std::span<const BodyFilter> filters);

  /// Adds bodies whose ids the library hands out, into the caller's `ids`: none that is in use, none whose
  /// pairs have not been reported as ended, and all below the most bodies that there were at a time, those
  /// that wait for the update which ends their pairs among them; below twice that where the caller chose ids
  /// or changed filters, too. Errors: those of insert().
  Status add(std::span<const Aabb> boxes, std::span<BodyId> ids);
  Result<BodyId> add(const Aabb& box);

  /// Gives bodies new boxes. Of several boxes for one body, in one call or several before an update, the last
  /// counts. Errors: bad_input, invalid_box, unknown_body.
  Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status move(BodyId id, const Aabb& box);

  /// Gives bodies other filters: pairs that these do not allow end at the next update(), and those that they
  /// allow begin; pairs that both allow are not mentioned. Of several filters for one body the last counts.
  /// Errors: bad_input (spans of different length), unknown_body.
  Status set_filters(std::span<const BodyId> ids, std::span<const BodyFilter> filters);
  Status set_filter(BodyId id, const BodyFilter& filter);
  /// The filter that counts from the next update() on; nothing for an id that is not held now.
  std::optional<BodyFilter> filter(BodyId id) const;

  /// Removes bodies; an id may occur once in a call. Their pairs end at the next update(). Errors:
  /// unknown_body, duplicate_body.
  Status remove(std::span<const BodyId> ids);
  Status remove(BodyId id);

  /// Brings the pairs up to date with all calls since the last update and says what changed. A pair that
  /// began and ended in between is not mentioned. Errors: those that the engine's options name.
  Result<PairChanges> update();

  /// The pairs as of the last update(), ascending. Valid until the next one. The first call after an update
  /// brings the list up to date, at a cost that follows the number of pairs; nothing is done for a caller who
  /// only looks at what changed. May throw std::bad_alloc.
  std::span<const Pair> pairs() const;

  /// Copies the boxes as of the last update() into the caller's `boxes`: what was given, made canonical; also
  /// of bodies removed since. Errors: bad_input (spans of different length), unknown_body for one that the
  /// last update() did not see.
  Status boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const;

  /// Questions about the world as of the last update(): query.h.
  Queries queries() const;

  /// Bodies held now, whether or not update() has seen them.
  std::size_t size() const;
  /// Whether a body is held now.
  bool contains(BodyId id) const;

  /// What was measured and counted; valid until the next update().
  const Statistics& statistics() const;

 private:
  friend struct EngineAccess;
  class Impl;
  explicit Broadphase(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

/// An empty broadphase. Errors: bad_option for a setting out of its range, an instruction set that this
/// machine or build does not have, or a trace file that cannot be written. Safe to call from any thread.
CELLSWEEP_API Result<Broadphase> make_broadphase(const StreamOptions& options);
CELLSWEEP_API Result<Broadphase> make_broadphase(const ControlOptions& options);
CELLSWEEP_API Result<Broadphase> make_broadphase(const OracleOptions& options);

}  // namespace cellsweep
