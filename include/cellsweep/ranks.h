/// @file
/// A world over the ranks of an MPI job: bodies on the rank that has them, every pair on one of them.
#pragma once

#include <mpi.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/query.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A name that the caller gives to a body of the whole job: any 64-bit number.
using GlobalId = std::uint64_t;

/// Two overlapping bodies, always with `a < b`.
struct GlobalPair {
  GlobalId a = 0;
  GlobalId b = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): the comparison that is generated has no pointer in it.
  friend auto operator<=>(const GlobalPair&, const GlobalPair&) = default;
};

/// The hash of a set of pairs, by which two are compared: XOR over its pairs, so that those of the ranks of a
/// job make that of the job. Of ids below 2^32 it is pair_set_hash().
CELLSWEEP_API std::uint64_t global_pair_set_hash(std::span<const GlobalPair> pairs);

/// As Touch and Neighbor.
struct GlobalTouch {
  GlobalId body = 0;
  double time = 0;

  friend bool operator==(const GlobalTouch&, const GlobalTouch&) = default;
};
struct GlobalNeighbor {
  GlobalId body = 0;
  double distance = 0;

  friend bool operator==(const GlobalNeighbor&, const GlobalNeighbor&) = default;
};

/// A body that has another owner since an update.
struct Handover {
  GlobalId id = 0;
  int rank = 0;  ///< which it went to, or came from
};

/// What changed between two updates, as far as it belongs to this rank; each pair is in the list of one rank.
/// Lists ascend. The memory is the DistributedBroadphase's and stays valid until its next update().
struct RankChanges {
  std::span<const GlobalPair> began;   ///< overlap now, did not at the update before
  std::span<const GlobalPair> ended;   ///< overlapped at the update before, do not now
  std::span<const Handover> departed;  ///< owned here before, by `rank` now
  std::span<const Handover> arrived;  ///< owned here now, by `rank` before; bodies that are new are not there
};

/// The time that one step of the last update() took on this rank.
struct RankPhase {
  std::string_view name;
  double milliseconds = 0;      ///< on the wall
  double cpu_milliseconds = 0;  ///< of all threads of the process
  bool is_wait = false;  ///< for other ranks; MPI looks again and again meanwhile, which is CPU time, too
};

/// What a rank did in the last update(), counted, and the time that it took.
struct RankStatistics {
  std::uint64_t updates = 0;        ///< that succeeded
  std::uint64_t cuts = 0;           ///< how often the world was cut anew, over the whole life
  std::size_t owned = 0;            ///< bodies that belong to this rank
  std::size_t ghosts = 0;           ///< bodies of other ranks that reach its region
  double imbalance = 1;             ///< bodies of the rank that owns most / the mean over all ranks
  std::uint64_t messages = 0;       ///< sent by this rank, without those of MPI's own collective calls
  std::uint64_t bytes = 0;          ///< in these
  std::uint64_t rounds = 0;         ///< of messages, 1 unless bodies were inserted or named on other ranks
  std::uint64_t moves = 0;          ///< told to other ranks: bodies that they had already, 32 bytes each
  std::uint64_t enters = 0;         ///< bodies that they had not
  std::uint64_t leaves = 0;         ///< bodies that they have no more
  std::uint64_t adoptions = 0;      ///< bodies that they own from now on
  std::vector<RankPhase> phases{};  ///< in the order in which they ran
};

struct RankOptions {
  /// Makes this rank's engine, an empty Broadphase; called once on each rank. None: `stream` with one thread.
  std::function<Result<Broadphase>()> make_engine{};
  /// The world is cut anew when the rank that owns most bodies has so many times the mean, 1 or more; but not
  /// unless that is 1.1 times what the last cut could do, so that a world which cannot be cut better is left
  /// alone. Infinity: it is cut once.
  double recut_above = 1.25;
  /// Where the world is cut anew in any case: every so many updates; 0 never.
  unsigned recut_every = 0;
};

class DistributedBroadphase;
class DistributedQueries;

/// Collective over `communicator`, of which it takes a copy. Errors, the same on all ranks: bad_option for
/// recut_above, those of make_engine.
CELLSWEEP_API Result<DistributedBroadphase> make_distributed_broadphase(MPI_Comm communicator,
                                                                        const RankOptions& options = {});

/// A set of bodies with boxes that is spread over the ranks of an MPI job, and the exact set of their
/// overlapping pairs as of the last update(). The world is cut into a region for each rank, by recursive
/// bisection of the bodies' lower corners (Zoltan); a rank has, in an engine of its own, every body that
/// reaches its region. A pair belongs to the rank whose region holds the lower corner of what its two boxes
/// share; nobody has to say how far bodies reach.
///
/// Exactness: pairs, `began` and `ended` of all ranks together are those that a Broadphase with all bodies
/// would say, each once, for any number of ranks and wherever the cuts are.
///
/// Collective calls must be made by all ranks in the same order: make_distributed_broadphase(), update(), the
/// queries, gather_pairs() and the destructor. All others are local.
///
/// Input: any rank may name any body, also one that another rank owns or has inserted; only one rank may name
/// a body between two updates. What a rank can see by itself is refused at once, as a Broadphase does; then
/// that call is forgotten, and so that no rank goes on without knowing, the next update() is refused by all
/// with the same sentence, the rank in front. What only all together can see (an id that nobody has, or that
/// somebody else has already) is refused by update(), and the calls at fault are forgotten. After a refused
/// update() all is as it was after the one before; what was not at fault is still remembered, and calling it
/// again goes on.
///
/// Bodies that a rank owns are the quickest to move. A body is owned where it was inserted while it reaches
/// that rank's region, and is handed over when it does not any more: RankChanges::departed and
/// RankChanges::arrived, by which a simulation can send its own data after it.
///
/// Failures: errors, and want of memory in collective calls, are agreed on by all ranks; no such call throws,
/// and a rank without memory for the sentence has "No memory left." in its place. std::bad_alloc may leave a
/// local call, which has changed nothing then and refuses no update. A rank that ends takes the job with it:
/// MPI's own way. Threads: one at a time; MPI must have been initialised with what the caller needs of
/// threads, MPI_THREAD_FUNNELED where the engine has threads of its own.
class CELLSWEEP_API DistributedBroadphase final {
 public:
  DistributedBroadphase(DistributedBroadphase&& other) noexcept;
  DistributedBroadphase& operator=(DistributedBroadphase&& other) noexcept;
  ~DistributedBroadphase();

  /// Of its own communicator, a copy of the one that it was made with.
  int rank() const;
  int ranks() const;
  /// Not for messages of the caller's own: to make another copy of.
  MPI_Comm communicator() const;

  /// Adds bodies. Errors: bad_input (spans of different length), invalid_box, duplicate_body (as far as this
  /// rank sees it). `filters` has one for each body, or none: the default.
  Status insert(std::span<const GlobalId> ids, std::span<const Aabb> boxes,
                std::span<const BodyFilter> filters = {});
  /// Gives bodies new boxes; the last one counts. Errors: bad_input, invalid_box, unknown_body.
  Status move(std::span<const GlobalId> ids, std::span<const Aabb> boxes);
  /// Gives bodies other filters. Errors: bad_input, unknown_body.
  Status set_filters(std::span<const GlobalId> ids, std::span<const BodyFilter> filters);
  /// Removes bodies. Errors: unknown_body, duplicate_body.
  Status remove(std::span<const GlobalId> ids);

  /// Collective. Brings the pairs up to date with all calls of all ranks since the last update, and says what
  /// changed. Errors, the same on all ranks: a call refused since (above), unknown_body, duplicate_body,
  /// bad_input for a body that two ranks named, capacity (memory included), and those of the engines.
  Result<RankChanges> update();

  /// This rank's pairs as of the last update(), ascending; every pair is on one rank. May throw
  /// std::bad_alloc. The memory is valid until the next update().
  std::span<const GlobalPair> pairs() const;

  /// Collective. The pairs of all ranks, ascending, on rank `root`; empty on the others. Errors: capacity
  /// where that rank has no memory for them.
  Result<std::vector<GlobalPair>> gather_pairs(int root = 0) const;

  /// Questions to the bodies of all ranks as of the last update: below.
  DistributedQueries queries() const;

  /// The bodies that this rank owns as of the last update, ascending. May throw std::bad_alloc.
  std::vector<GlobalId> owned() const;
  /// Their boxes and filters; bodies must be owned here. Errors: bad_input, unknown_body.
  Status boxes(std::span<const GlobalId> ids, std::span<Aabb> boxes) const;
  Status filters(std::span<const GlobalId> ids, std::span<BodyFilter> filters) const;
  /// Bodies of all ranks, as of the last update.
  std::uint64_t size() const;

  /// The part of space that belongs to a rank: points with min < x <= max on each axis, infinite at the edge
  /// of the world; min equal to max where the rank has none.
  Aabb region(int rank) const;

  const RankStatistics& statistics() const;
  /// This rank's engine, with bodies of its own numbers: for what it measured, and for nothing else.
  const Broadphase& engine() const;

 private:
  class Impl;
  explicit DistributedBroadphase(std::unique_ptr<Impl> impl);
  friend class DistributedQueries;
  friend Result<DistributedBroadphase> make_distributed_broadphase(MPI_Comm communicator,
                                                                   const RankOptions& options);

  std::unique_ptr<Impl> impl_;
};

/// Asks the bodies of all ranks, as of the last update. Each call is collective: every rank asks questions of
/// its own, none or many, and gets the answers to these. Answers, their order and the errors are those of
/// Queries (query.h) with all bodies in one Broadphase; what one rank may not ask is refused to all, its
/// number in front. Two rounds of messages, four for find_nearest(), to ranks whose regions are concerned.
/// Holds nothing but the address of the DistributedBroadphase, which must not be moved while it is used.
class CELLSWEEP_API DistributedQueries {
 public:
  explicit DistributedQueries(const DistributedBroadphase& broadphase) : broadphase_(&broadphase) {}

  /// Only bodies that a body with the filter `as` may form a pair with; none: all bodies.
  using Filter = std::optional<BodyFilter>;

  /// Bodies that overlap each region, ascending.
  Status find_overlaps(std::span<const Region> regions, BatchAnswers<GlobalId>& found,
                       const Filter& as = {}) const;
  /// Bodies that each path touches, by (time, body).
  Status find_touches(std::span<const Path> paths, BatchAnswers<GlobalTouch>& found,
                      const Filter& as = {}) const;
  /// The first of each of these; `first` has one for each path.
  Status first_touches(std::span<const Path> paths, std::span<std::optional<GlobalTouch>> first,
                       const Filter& as = {}) const;
  /// The `count` bodies nearest to each box, no further than `most`, by (distance, body).
  Status find_nearest(std::span<const Aabb> boxes, std::size_t count, BatchAnswers<GlobalNeighbor>& found,
                      double most = Queries::kAnyDistance, const Filter& as = {}) const;
  /// Bodies within a distance of each region's box, that of the region, by (distance, body).
  Status find_within(std::span<const Region> regions, BatchAnswers<GlobalNeighbor>& found,
                     const Filter& as = {}) const;

 private:
  const DistributedBroadphase* broadphase_;
};

inline DistributedQueries DistributedBroadphase::queries() const {
  return DistributedQueries(*this);
}

}  // namespace cellsweep
