/// @file
/// Candidates for later follow the fat boxes for later, or say that they cannot.
#include "engines/stream/pairs/overlaps.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <span>
#include <vector>

#include "base/threads/thread_pool.h"
#include "cellsweep/engine/engine.h"
#include "engines/oracle/brute_force.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using Keys64 = std::multiset<std::uint64_t>;

class PreparedOverlaps : public testing::Test {
 protected:
  PreparedOverlaps() { tree_.build({boxes_.data(), boxes_.size()}); }

  /// These bodies get the box of the first one.
  bool gather(std::span<const Slot> slots) {
    std::vector<FatBoxChange> fat_changes;
    for (const Slot slot : slots) {
      fat_changes.push_back({slot, true, true, boxes_[slot], boxes_[slots[0]]});
      boxes_[slot] = boxes_[slots[0]];
    }
    const BodyChanges changes{boxes_, {}, {}, {}, {}, boxes_.size()};
    return overlaps_.change_prepared(changes, fat_changes, tree_);
  }

  Keys64 found() const {
    Keys64 keys;
    for (const auto part : tree_.found()) keys.insert(part.begin(), part.end());
    return keys;
  }
  Keys64 expected() const {
    Keys64 keys;
    for (const Pair& pair : brute_force_pairs(boxes_)) keys.insert(pair_key(pair));
    return keys;
  }

  std::vector<Aabb> boxes_ = uniform_boxes(300, 4);
  Crew crew_{std::make_shared<ThreadPool>(1), 1, Crew::Choice::given};
  CellTree tree_{crew_, *find_kernels(VectorIsa::best)};
  Overlaps overlaps_{crew_};
};

TEST_F(PreparedOverlaps, AreThoseOfFatBoxesThatChanged) {
  EXPECT_TRUE(gather({{7, 3, 200}}));
  EXPECT_EQ(found(), expected());
  EXPECT_TRUE(gather({{3, 9, 11}}));
  EXPECT_EQ(found(), expected());
}

// What was marked for the changes is not any more: other cells can follow theirs.
TEST_F(PreparedOverlaps, SayThatThereAreTooManyAndLeaveNoMarks) {
  std::vector<Slot> slots(100);
  for (Slot slot = 0; slot < slots.size(); ++slot) slots[slot] = slot;
  tree_.limit_pairs(1500);
  EXPECT_FALSE(gather(slots));
  tree_.limit_pairs(~std::size_t{0});
  tree_.build({boxes_.data(), boxes_.size()});
  EXPECT_TRUE(gather({{150, 160}}));
  EXPECT_EQ(found(), expected());
}

}  // namespace
}  // namespace cellsweep::stream
