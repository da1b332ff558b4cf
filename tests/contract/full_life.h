/// @file
/// One after the other, everything that a broadphase can be asked to do.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "contract/box_kinds.h"
#include "contract/checked_engine.h"
#include "contract/random.h"

namespace cellsweep::contract {

/// All calls, on few bodies and on all of `bodies`, on dense ids and on scattered ones. Expects good answers.
inline void full_life(CheckedEngine& checked, std::size_t bodies) {
  const BoxKind& kind = box_kind("uniform");
  Random random(5);
  const std::size_t most = std::min(bodies, checked.capacity());
  const auto boxes = [&](std::size_t count) { return make_boxes(kind, random, count); };
  std::vector<BodyId> dense(most / 2);
  std::iota(dense.begin(), dense.end(), BodyId{0});
  std::vector<BodyId> scattered;
  for (BodyId i = 0; i < most / 4; ++i) scattered.push_back(0xffffffffU - 0x00100001U * i);
  const std::vector<BodyId> few(dense.begin(), dense.begin() + dense.size() / 8);

  ASSERT_TRUE(checked.insert(dense, boxes(dense.size())));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move(few, boxes(few.size())));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert(scattered, boxes(scattered.size())));
  ASSERT_TRUE(checked.move(dense, boxes(dense.size())));
  ASSERT_TRUE(checked.move({few[0], few[0]}, boxes(2)));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(few));
  ASSERT_TRUE(checked.insert(few, boxes(few.size())));
  ASSERT_TRUE(checked.update());
  std::vector<BodyId> added;
  ASSERT_TRUE(checked.add(boxes(most / 4), added));
  ASSERT_TRUE(checked.remove(few));
  checked.look_at_pairs(false);
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move(added, boxes(added.size())));
  ASSERT_TRUE(checked.update());
  checked.look_at_pairs(true);
  ASSERT_TRUE(checked.remove(checked.model().ids()));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert({0xffffffff}, boxes(1)));
  ASSERT_TRUE(checked.update());
}

}  // namespace cellsweep::contract
