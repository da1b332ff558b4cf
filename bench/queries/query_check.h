/// @file
/// Asks questions, and holds the answers against each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/queries/query_peer.h"

namespace cellsweep::bench {

/// What a peer writes its answers into; of use for the next question again.
struct AnswerRoom {
  std::vector<BodyId> bodies;
  std::vector<Touch> touches;
  std::vector<Neighbor> neighbors;
  std::optional<Touch> first;
  bool any = false;
};

/// Asks one question of a list; how many answers there are.
std::size_t ask(QueryPeer& peer, const Questions& questions, std::size_t question, AnswerRoom& room);

/// The answers to all of them.
Answers ask_all(QueryPeer& peer, const QueryPeerInfo& info, const Questions& questions);

/// The answers to the first few, found by looking at each box, in double.
Answers answer_by_looking_at_all(const Questions& questions, std::span<const Aabb> boxes, std::size_t some);

/// What is wrong with the answers to as many questions as there are expected answers to: the first thing, as
/// a sentence; empty if nothing is.
///
/// Which bodies overlap a box must be the same. Else what rounding to floats may change is let pass: times
/// and distances may differ by `slack`, a ray may miss a box that would be missed if it were smaller by
/// `slack` on each side, and touch one that it would if it were larger, and a body may be within a radius
/// that is larger by so much.
std::string find_fault(const Answers& answers, const Answers& expected, const Questions& questions,
                       std::span<const Aabb> boxes, double slack);

/// What floats may be off by in a world.
double slack_of(const Aabb& bounds);

/// Of which body was an answer to which question, in any order.
std::uint64_t hash_of(const Answers& answers);

}  // namespace cellsweep::bench
