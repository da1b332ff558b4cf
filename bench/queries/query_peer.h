/// @file
/// What answers queries, behind the face that the suite of queries measures them all by.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bench/queries/question.h"
#include "cellsweep/query.h"

namespace cellsweep::bench {

/// The answers to a list of questions: bodies, with the time or the distance where there is one, else 0. To
/// whether there is any: body 0, or nothing.
using Answers = BatchAnswers<Neighbor>;

/// Answers queries about a world of boxes. One thread calls it. Only those kinds are asked for that
/// QueryPeerInfo::answers. Lists are overwritten, and come in any order. Nothing is reported as an error: the
/// suite compares the answers.
class QueryPeer {
 public:
  virtual ~QueryPeer() = default;

  /// Enters all bodies. The boxes stay there as long as the peer lives; body i has the i-th.
  virtual void build(std::span<const Aabb> boxes) = 0;

  /// After some of these boxes, the same as build() was given, have changed: those of these bodies.
  virtual void move(std::span<const BodyId> bodies) = 0;

  virtual void find_overlaps(const Aabb& /*box*/, std::vector<BodyId>& /*found*/) {}
  virtual void find_within(const Point& /*center*/, float /*radius*/, std::vector<BodyId>& /*found*/) {}
  virtual std::optional<Touch> first_touch(const Ray& /*ray*/) { return std::nullopt; }
  virtual bool any_touch(const Ray& /*ray*/) { return false; }
  virtual void find_touches(const Ray& /*ray*/, std::vector<Touch>& /*found*/) {}
  virtual void find_nearest(const Point& /*point*/, std::size_t /*count*/, std::vector<Neighbor>& /*found*/) {
  }

  /// All questions of a list in one call, where QueryPeerInfo::in_batches.
  virtual void answer_batch(const Questions& /*questions*/) {}
  /// What it answered last in a batch. Not timed.
  virtual Answers batch() const { return {}; }
};

/// One row of the table of those who answer queries. The texts are literals.
struct QueryPeerInfo {
  std::string_view name;
  std::string_view settings;  ///< how it is built and called
  std::vector<QuestionKind> answers;
  bool only_points = false;      ///< answers where all boxes are points
  bool only_when_moved = false;  ///< only of interest where bodies have moved
  bool is_own = false;
  bool in_batches = false;  ///< all questions in one call
  bool many_threads = false;
  /// Whether its pairs come with move(), so that this takes no time for the queries' sake.
  bool moves_for_pairs = false;
  std::function<std::unique_ptr<QueryPeer>()> make{};

  bool does_answer(QuestionKind kind) const;
};

/// All of this build, the project's own first, and of these the one that the others are compared with.
std::span<const QueryPeerInfo> query_peer_table();

void add_own_query_peers(std::vector<QueryPeerInfo>& peers);
void add_bullet_query_peers(std::vector<QueryPeerInfo>& peers);
void add_embree_query_peers(std::vector<QueryPeerInfo>& peers);
void add_fcl_query_peers(std::vector<QueryPeerInfo>& peers);
void add_nanoflann_query_peers(std::vector<QueryPeerInfo>& peers);

}  // namespace cellsweep::bench
