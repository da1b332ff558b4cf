/// @file
/// The face of every broadphase engine: bodies in, overlapping pairs and their changes out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"
#include "cellsweep/pose.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// What changed between two updates, each list in ascending order of (a, b).
/// The memory is the engine's and stays valid until its next update().
struct PairChanges {
  std::span<const Pair> began;  ///< overlap now, did not at the update before
  std::span<const Pair> ended;  ///< overlapped at the update before, do not now (or a body of them is gone)
};

/// The time one step of the last update() took.
struct Phase {
  std::string_view name;
  double milliseconds = 0;
  /// True for work that is done once per body ever inserted and that reports show apart from the frame
  /// (control's filling of the pair map, X1).
  bool setup = false;
};

/// A number an engine counts, over its whole life unless the name says otherwise.
struct Counter {
  std::string_view name;
  std::uint64_t value = 0;
};

/// What one SPE of a Cell would take for an update, in microseconds, by the steps of the document's chapter
/// 4.2. Waits for mailboxes are not in it.
struct SpeTime {
  double sort = 0;
  double change_detection = 0;
  double compaction = 0;
  double overlap = 0;
  double dma_wait = 0;  ///< in any step
  double other = 0;     ///< start-up, allocation, bookkeeping

  double total() const { return sort + change_detection + compaction + overlap + dma_wait + other; }
};

/// The last update() on a Cell's clock, and what belongs to the host of it.
struct CellTime {
  std::vector<SpeTime> spes;  ///< one an SPE; they work at the same time
  /// CPU time, measured here, of the calling thread in update() that is no work of the frame: set-up phases,
  /// starting SPEs and waiting for them.
  double set_aside_ms = 0;
  bool threads_started = false;
};

/// What an engine tells about itself. Names are stable within an engine.
struct Statistics {
  std::uint64_t updates = 0;
  std::vector<Phase> phases;  ///< of the last update(), in the order they ran
  std::vector<Counter> counters;
  std::optional<CellTime> cell{};  ///< when EngineOptions::cycles asks for it
};

/// How many bodies an engine takes with the options it was made with, and what sets that limit.
struct Capacity {
  std::uint64_t bodies = 0;
  std::string setting;  ///< the option that raises it; empty when nothing does
  std::string reason;   ///< a phrase for a person: what fills up
};

/// A set of bodies with boxes, and the exact set of their overlapping pairs as of the last update().
///
/// Exactness: after update() the current pairs are those that comparing all boxes with all boxes would find,
/// each once with a < b, on any input and at any thread count; and every list comes in the same order
/// whatever the thread count. Boxes are closed: touching counts.
///
/// Input: a call is checked whole before anything is applied. When it returns a status that is not ok,
/// nothing has changed. −0 and denormal values become +0 on the way in; then a box must be finite with min <=
/// max on every axis. An id may occur once in a call.
///
/// Threads: one object belongs to one thread at a time; different objects are independent.
/// The library never prints, aborts or exits; std::bad_alloc is the one exception that may leave a call.
class Broadphase {
 public:
  virtual ~Broadphase() = default;

  /// The name in the engine table.
  virtual std::string_view name() const = 0;

  /// The number of bodies this engine can hold; more is refused with StatusCode::capacity before any work.
  virtual Capacity capacity() const = 0;

  /// Adds bodies. Errors: bad_input (spans of different length), invalid_box, duplicate_body, capacity.
  virtual Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) = 0;

  /// Gives bodies new boxes. Errors: bad_input, invalid_box, unknown_body, duplicate_body.
  virtual Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes) = 0;

  /// Removes bodies; their pairs end at the next update(). Errors: unknown_body, duplicate_body.
  virtual Status remove(std::span<const BodyId> ids) = 0;

  Status insert(BodyId id, const Aabb& box) { return insert(std::span(&id, 1), std::span(&box, 1)); }
  Status move(BodyId id, const Aabb& box) { return move(std::span(&id, 1), std::span(&box, 1)); }
  Status remove(BodyId id) { return remove(std::span(&id, 1)); }

  /// insert() and move() with boxes that the engine makes itself (F3): each encloses its pose's box, is a few
  /// float steps wider at most, and of a body that is not turned it is c − h to c + h, rounded outwards. A
  /// body may be given boxes and poses in turn. Errors: those of insert() and move(), invalid_box for a pose
  /// that breaks the rules of BodyPose, bad_option from an engine that makes no boxes
  /// (EngineOptions::spu_boxes).
  virtual Status insert_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses);
  virtual Status move_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses);

  /// Copies the boxes that the last update() compared into the caller's `boxes`. Errors: bad_input (spans of
  /// different length), unknown_body for one that no update() has seen, bad_option as insert_poses().
  virtual Status boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const;

  /// Brings the pairs up to date with all calls since the last update and says what changed. A pair that
  /// began and ended in between is not mentioned. A failure leaves the pairs of the update before in place.
  virtual Result<PairChanges> update() = 0;

  /// The pairs as of the last update(), in an order that depends on the calls made, not on threads. Valid
  /// until the next update().
  virtual std::span<const Pair> pairs() const = 0;

  /// Bodies held now, whether or not update() has seen them.
  virtual std::size_t size() const = 0;

  /// What the engine measured and counted; valid until the next update().
  virtual const Statistics& statistics() const = 0;
};

}  // namespace cellsweep
