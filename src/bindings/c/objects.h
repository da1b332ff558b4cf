/// @file
/// What the opaque types of cellsweep/c.h are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/c/find_pairs.h"
#include "cellsweep/c/history.h"
#include "cellsweep/c/query.h"
#include "cellsweep/find_pairs.h"
#include "cellsweep/pair_history.h"
#include "cellsweep/query.h"

struct cellsweep_broadphase {
  explicit cellsweep_broadphase(cellsweep::Broadphase made)
      : handle(std::move(made)), engine(handle.name()), capacity(handle.capacity().bodies) {}

  cellsweep::Broadphase handle;
  std::string engine;
  std::uint64_t capacity;
};

struct cellsweep_history {
  explicit cellsweep_history(std::size_t most_pairs) : history(most_pairs) {}

  cellsweep::PairHistory history;
};

// Of one set or between two: the one that was written last; the other is empty.
struct cellsweep_pair_list {
  std::vector<cellsweep::Pair> pairs;
  std::vector<cellsweep::CrossPair> cross_pairs;
};

struct cellsweep_answers {
  enum class Kind { none, bodies, touches, neighbors };

  Kind kind = Kind::none;
  cellsweep::BatchAnswers<cellsweep::BodyId> bodies;
  cellsweep::BatchAnswers<cellsweep::Touch> touches;
  cellsweep::BatchAnswers<cellsweep::Neighbor> neighbors;
};
