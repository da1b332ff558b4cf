/// @file
/// The tree of cells: all pairs when it is built, and those of the bodies that changed when some do.
#include "engines/stream/cells/cell_tree.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "engines/oracle/brute_force.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

constexpr std::size_t kUnlimited = ~std::size_t{0};

using Keys64 = std::multiset<std::uint64_t>;

Keys64 keys_in(KeyParts parts) {
  Keys64 keys;
  for (const auto part : parts) keys.insert(part.begin(), part.end());
  return keys;
}

/// A slot without a body has a box that overlaps nothing.
Keys64 truth_of(const std::vector<Aabb>& boxes) {
  Keys64 keys;
  for (const Pair& pair : brute_force_pairs(boxes)) keys.insert(pair_key(pair));
  return keys;
}

/// A tree, the boxes that it holds, and their pairs.
class CellTreeTest : public testing::TestWithParam<unsigned> {
 protected:
  void build(const std::vector<Aabb>& boxes) {
    boxes_ = boxes;
    tree_.build({boxes_.data(), boxes_.size()});
    ASSERT_EQ(keys_in(tree_.found()), truth_of(boxes_));
  }

  /// The same of boxes of a kind, with nobody in each ninth slot.
  void build_some(const contract::BoxKind& kind, Random& random, std::size_t count) {
    std::vector<Aabb> boxes = make_boxes(kind, random, count);
    for (Aabb& box : boxes) box = random.one_in(9) ? kNobody : contract::canonical_box(box);
    build(boxes);
  }

  /// A body gets another box, comes or goes; kNobody is none.
  void change(Slot slot, const Aabb& box) {
    const bool was = boxes_[slot].min[0] <= boxes_[slot].max[0];
    const bool is = box.min[0] <= box.max[0];
    if (was || is) changes_.push_back({slot, was, is, boxes_[slot], box});
    boxes_[slot] = box;
  }

  /// Brings the changes in, each slot once; expects the pairs of these bodies.
  void take_changes() {
    tree_.change(changes_);
    std::set<Slot> changed;
    for (const FatBoxChange& change : changes_) changed.insert(change.slot);
    changes_.clear();
    Keys64 expected;
    for (const std::uint64_t key : truth_of(boxes_)) {
      const bool has_changed =
          changed.contains(static_cast<Slot>(key >> 32)) || changed.contains(static_cast<Slot>(key));
      if (has_changed) expected.insert(key);
    }
    ASSERT_EQ(keys_in(tree_.touched()), expected);
  }

  /// Expects that the tree finds whoever overlaps a box.
  void ask(const Aabb& box) {
    Keys slots;
    tree_.find_partners(box, slots);
    Keys64 expected;
    for (Slot slot = 0; slot < boxes_.size(); ++slot) {
      if (overlap(boxes_[slot], box)) expected.insert(slot);
    }
    ASSERT_EQ(Keys64(slots.view().begin(), slots.view().end()), expected);
  }

  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  CellTree tree_{crew_, *find_kernels(VectorIsa::best)};
  std::vector<Aabb> boxes_;
  std::vector<FatBoxChange> changes_;
};

TEST_P(CellTreeTest, OfNobodyHasNoPairs) {
  build({});
  build(std::vector<Aabb>(40, kNobody));
  EXPECT_EQ(tree_.pieces(), 1U);
}

TEST_P(CellTreeTest, FindsEachPairOnceOnEveryKindOfBoxes) {
  Random random(1);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {1, 2, 7, 8, 9, 100, 700}) {
      SCOPED_TRACE(testing::Message() << count << " of kind " << kind);
      ASSERT_NO_FATAL_FAILURE(build_some(kind, random, count));
    }
  }
}

TEST_P(CellTreeTest, MayBeBuiltAPartAtATimeByDifferentlyManyWorkers) {
  Random random(9);
  boxes_ = uniform_boxes(6000 / kScale, 9);
  const Boxes boxes(boxes_.data(), boxes_.size());
  const auto use_some = [&] { crew_.use(1 + static_cast<unsigned>(random.below(crew_.workers()))); };
  for (const std::uint64_t most : {1, 100, 5000, 1'000'000}) {
    use_some();
    tree_.begin_build(boxes);
    use_some();
    const double share = random.unit();
    tree_.fill_cells(boxes, share);
    use_some();
    tree_.fill_cells(boxes, 1);
    std::uint64_t built = 0;
    while (!tree_.is_built()) {
      use_some();
      const std::uint64_t more = tree_.go_on(most);
      EXPECT_GT(more, 0U);
      built += more;
    }
    EXPECT_GE(built, boxes_.size());
    ASSERT_EQ(keys_in(tree_.found()), truth_of(boxes_));
    change(5, boxes_[6]);
    take_changes();
  }
}

TEST_P(CellTreeTest, CutsALargeWorldIntoPieces) {
  build(uniform_boxes(8000, 1));
  EXPECT_GT(tree_.pieces(), 50U);
  EXPECT_GE(tree_.copies(), boxes_.size());
  EXPECT_LE(tree_.copies(), 8 * boxes_.size());
  EXPECT_GT(tree_.bytes(), boxes_.size() * sizeof(Aabb));
}

// A grid is chosen on 128 boxes, here those of every 100th slot.
TEST_P(CellTreeTest, DoesNotMatterWhetherALookAtFewBoxesShowsThePlates) {
  const auto copies_with_plates_at = [&](std::size_t place) {
    std::vector<Aabb> boxes = uniform_boxes(12'800, 8);
    for (std::size_t slot = place; slot < boxes.size(); slot += 5) {
      boxes[slot].min[0] = boxes[slot].min[1] = -1e3F;
      boxes[slot].max[0] = boxes[slot].max[1] = 1e3F;
    }
    tree_.build({boxes.data(), boxes.size()});
    return tree_.copies();
  };
  const std::uint64_t shown = copies_with_plates_at(0);
  EXPECT_LT(copies_with_plates_at(2), 2 * shown);
}

TEST_P(CellTreeTest, GivesMemoryBackWhenItIsBuiltForFew) {
  build(uniform_boxes(8000, 1));
  const std::size_t full = tree_.bytes();
  build(uniform_boxes(20, 1));
  build(uniform_boxes(20, 1));
  EXPECT_LT(tree_.bytes(), full / 2);
}

TEST_P(CellTreeTest, FollowsBodiesThatMoveComeAndGo) {
  Random random(2);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    SCOPED_TRACE(testing::Message() << kind);
    ASSERT_NO_FATAL_FAILURE(build_some(kind, random, 400));
    for (int round = 0; round < 8; ++round) {
      const std::size_t seldom = round % 4 == 0 ? 2 : 30;
      for (Slot slot = 0; slot < boxes_.size(); ++slot) {
        if (!random.one_in(seldom)) continue;
        const bool is_nobody = !(boxes_[slot].min[0] <= boxes_[slot].max[0]);
        const Aabb next = is_nobody ? kind.make(random, slot, 400)
                                    : contract::next_box(kind, random, boxes_[slot], boxes_[slot]);
        change(slot, random.one_in(5) ? kNobody : contract::canonical_box(next));
      }
      ASSERT_NO_FATAL_FAILURE(take_changes());
    }
  }
}

// Whatever changed before.
TEST_P(CellTreeTest, HasAllPairsThatThereAreOnceSomeBodiesChanged) {
  Random random(6);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    SCOPED_TRACE(testing::Message() << kind);
    ASSERT_NO_FATAL_FAILURE(build_some(kind, random, 400));
    std::vector<std::uint8_t> changed(boxes_.size(), 0);
    for (int round = 0; round < 4; ++round) {
      for (Slot slot = 0; slot < boxes_.size(); ++slot) {
        if (!random.one_in(10)) continue;
        change(slot, random.one_in(9) ? kNobody : contract::canonical_box(kind.make(random, slot, 400)));
      }
      for (const FatBoxChange& one : changes_) changed[one.slot] = 1;
      tree_.change_found(changes_, changed.data());
      for (const FatBoxChange& one : changes_) changed[one.slot] = 0;
      changes_.clear();
      ASSERT_EQ(keys_in(tree_.found()), truth_of(boxes_));
    }
  }
}

TEST_P(CellTreeTest, FollowsBodiesOneByOne) {
  Random random(3);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    SCOPED_TRACE(testing::Message() << kind);
    ASSERT_NO_FATAL_FAILURE(build_some(kind, random, 300));
    for (int round = 0; round < 200; ++round) {
      const auto slot = static_cast<Slot>(random.below(300));
      change(slot, random.one_in(5) ? kNobody : contract::canonical_box(kind.make(random, slot, 300)));
      for (const FatBoxChange& one : changes_) tree_.change_one(one);
      changes_.clear();
      ASSERT_NO_FATAL_FAILURE(ask(contract::canonical_box(kind.make(random, 0, 300))));
    }
  }
}

TEST_P(CellTreeTest, HasRoomForNewBodiesInCellsThatWereFull) {
  build(uniform_boxes(2000 / kScale, 3));
  const std::vector<Aabb> others = uniform_boxes(500, 4);
  boxes_.resize(boxes_.size() + 500, kNobody);
  for (std::size_t i = 0; i < 500; ++i)
    change(static_cast<Slot>(boxes_.size() - 500 + i), i % 2 == 0 ? others[i] : Aabb{{3, 3, 3}, {4, 4, 4}});
  take_changes();
}

TEST_P(CellTreeTest, ChangesNothingWhenNothingChanges) {
  build(uniform_boxes(500, 5));
  take_changes();
  change(3, boxes_[3]);
  take_changes();
}

TEST_P(CellTreeTest, StopsAtMorePairsThanThereMayBe) {
  const std::vector<Aabb> heap(3000, Aabb{{1, 1, 1}, {2, 2, 2}});
  tree_.limit_pairs(10'000);
  EXPECT_THROW(tree_.build({heap.data(), heap.size()}), TooManyPairs);
  tree_.limit_pairs(kUnlimited);
  build(uniform_boxes(500, 6));
  boxes_.resize(1700, kNobody);
  tree_.limit_pairs(10'000);
  for (Slot slot = 500; slot < 1700; ++slot) change(slot, {{1, 1, 1}, {2, 2, 2}});
  EXPECT_THROW(tree_.change(changes_), TooManyPairs);
  changes_.clear();
  tree_.limit_pairs(kUnlimited);
  build(uniform_boxes(500, 7));
}

TEST_P(CellTreeTest, StopsAtChangesThatTakeMoreThanToBeMadeAnew) {
  // Points, among which sheets would come into a thousand cells each.
  Random random(8);
  constexpr std::size_t kPoints = contract::effort(20'000, 3000, 3000);
  std::vector<Aabb> points(kPoints);
  for (Aabb& point : points) point = cube_in(random, 1e-4F, 1);
  build(points);
  for (Slot slot = 0; slot < 2000; ++slot) {
    const float z = random.unit();
    change(slot, {{0, 0, z}, {1, 1, z}});
  }
  EXPECT_THROW(tree_.change(changes_), TooMuchWork);
  build(points);
  tree_.begin_changes();
  const auto change_all = [&] {
    for (const FatBoxChange& one : changes_) tree_.change_one(one);
  };
  EXPECT_THROW(change_all(), TooMuchWork);
  changes_.clear();
  // And one cell that is asked again and again.
  points.assign(500, Aabb{{0, 0, 0}, {0, 0, 0}});
  build(points);
  tree_.begin_changes();
  Keys slots;
  const auto ask_often = [&] {
    for (int time = 0; time < 20'000; ++time) tree_.find_partners({{0, 0, 0}, {0, 0, 0}}, slots);
  };
  EXPECT_THROW(ask_often(), TooMuchWork);
}

INSTANTIATE_TEST_SUITE_P(Workers, CellTreeTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
