/// @file
/// One broadphase behind the face that the suite of peers measures them all by.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"
#include "cellsweep/statistics.h"

namespace cellsweep::bench {

inline constexpr std::size_t kAnyNumber = 100'000'000;

/// What a peer may know before the clock starts.
struct Stage {
  Aabb world;                   ///< no body ever leaves it, but for a giant
  std::span<const Aabb> boxes;  ///< the boxes of frame 0, by id
};

/// What is new in a frame. Bodies by their numbers, each in one list at most.
struct PeerChanges {
  std::span<const BodyId> moved;
  std::span<const BodyId> inserted{};
  std::span<const BodyId> removed{};

  bool any() const { return !moved.empty() || !inserted.empty() || !removed.empty(); }
};

/// A broadphase, and what its user has to do to get from boxes to pairs. One thread calls it; it may have
/// more of its own. The clock runs in insert(), update() and list_pairs(). Nothing is reported as an error:
/// the suite compares the pairs with the oracle's.
class Peer {
 public:
  virtual ~Peer() = default;

  /// Before insert(), not timed: devices, threads, the user's own objects that are no part of the broadphase.
  virtual void prepare(const Stage&) {}

  /// Enters all bodies and finds their pairs. The boxes stay there, and are current, as long as the peer
  /// lives.
  virtual void insert(std::span<const Aabb> boxes) = 0;

  /// Takes what is new and finds the pairs of all that are there. Boxes are by id. Bodies come and go only
  /// for a peer that PeerInfo::removes.
  virtual void update(std::span<const Aabb> boxes, const PeerChanges& changes) = 0;

  /// Writes the pairs of the last insert() or update() into a list of the caller's, over what is in it:
  /// exactly those whose closed boxes overlap, each once, in any order.
  virtual void list_pairs(std::vector<Pair>& pairs) = 0;

  /// What it counted since it was made, where it counts. Not timed.
  virtual Work work() const { return {}; }

  /// The body that the peer lists by this id, for one that gives them ids of its own. Not timed.
  virtual BodyId body_of(BodyId id) const { return id; }
};

/// One row of the table of peers: how to make one, and what its times must be read with. The texts are
/// literals.
struct PeerInfo {
  std::string_view name;
  std::string_view threads;
  std::string_view margin;      ///< what is added to the boxes by default or by choice
  std::string_view settings;    ///< how it is built and called
  std::string_view exactness;   ///< what it finds beyond the pairs, and who drops that
  std::size_t most_bodies = 0;  ///< more would take minutes, or does not fit
  std::size_t most_in_wall =
      kAnyNumber;  ///< the same for scene `wall`: a million bodies have 12 million pairs
  /// False for one that starts anew in each frame: it has no row for a frame in which it is told that
  /// nothing moved, since its user would keep the pairs.
  bool remembers = true;
  /// Whether bodies can be taken out and entered singly. To one that cannot, all are given anew in each frame
  /// in which bodies may come and go.
  bool removes = false;
  /// Scenes that it is not run through; `settings` says why.
  std::span<const std::string_view> left_out{};
  bool finds_pairs = true;  ///< false for the limit that memory sets
  std::function<std::unique_ptr<Peer>()> make{};
};

}  // namespace cellsweep::bench
