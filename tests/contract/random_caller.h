/// @file
/// A random user of an engine: inserts, adds, moves, filters and removes bodies, one at a time and in bulk.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "contract/box_kinds.h"
#include "contract/checked_engine.h"
#include "contract/random.h"

namespace cellsweep::contract {

/// Makes calls on one engine, chosen by a seed: the same seed makes the same calls on every engine of the
/// same capacity. The number of bodies stays around `bodies`, never above the capacity.
class RandomCaller {
 public:
  RandomCaller(CheckedEngine& engine, const BoxKind& kind, std::size_t bodies, std::uint64_t seed);

  /// Inserts all `bodies` at once.
  testing::AssertionResult fill();

  /// Up to six calls, or none.
  testing::AssertionResult calls();

  /// calls() and an update, after which pairs() is called or is not.
  testing::AssertionResult step();

 private:
  testing::AssertionResult call();
  testing::AssertionResult insert(const std::vector<BodyId>& ids);
  testing::AssertionResult insert_some(std::size_t most);
  testing::AssertionResult add_some(std::size_t most);
  testing::AssertionResult move_some(std::size_t most);
  testing::AssertionResult remove_some(std::size_t most);
  testing::AssertionResult replace_some(std::size_t most);
  testing::AssertionResult filter_some(std::size_t most);
  testing::AssertionResult insert_and_remove();
  testing::AssertionResult remove_all();
  testing::AssertionResult nothing_in_bulk();

  std::size_t room() const;
  std::vector<BodyId> some_present(std::size_t most);
  std::vector<BodyId> some_absent(std::size_t most);
  std::vector<Aabb> next_boxes(const std::vector<BodyId>& ids);
  std::vector<BodyFilter> some_filters(std::size_t count);

  CheckedEngine& engine_;
  const BoxKind& kind_;
  std::size_t bodies_;
  Random random_;
  bool filters_ = false;       ///< whether this run gives any
  std::vector<BodyId> names_;  ///< the ids that this run gives: twice as many as bodies
};

/// What a failure message says about a run.
std::string story_of(const BoxKind& kind, std::size_t bodies, std::uint64_t seed);

}  // namespace cellsweep::contract
