/// @file
/// The tree of boxes brought up to date: after any changes it is one of the boxes as they are now.
#include "queries/tree/tree_update.h"

#include "base/text.h"
#include "cellsweep/query.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "queries/tree_check.h"

namespace cellsweep::queries {
namespace {

using contract::BoxKind;
using contract::Random;

/// Boxes by slot that change, and a tree of them.
class ChangingBoxes {
 public:
  ChangingBoxes(const BoxKind& kind, std::size_t count, std::uint64_t seed)
      : kind_(kind), random_(seed), boxes_(contract::make_boxes(kind, random_, count)) {
    for (Aabb& box : boxes_) box = random_.one_in(9) ? kNobody : contract::canonical_box(box);
    states_.assign(count, kAtRest);
    tree_.emplace(bodies());
  }

  /// Of a share of the slots; some get a new body that the update has seen, or not.
  void change(double share) {
    if (random_.one_in(3)) add_slots(random_.below(boxes_.size() / 8 + 2));
    for (Slot slot = 0; slot < boxes_.size(); ++slot) {
      if (random_.unit() < share) change_one(slot);
    }
  }
  void lose_all() {
    for (Slot slot = 0; slot < boxes_.size(); ++slot) changed_.push_back(slot);
    boxes_.clear();
    states_.clear();
  }

  /// As the handle does: those that changed since, or all.
  void update(bool all) {
    const bool is_good = all ? tree_->update(bodies()) : tree_->update(bodies(), changed_);
    if (!is_good) tree_.emplace(bodies());
    changed_.clear();
  }

  void expect_right() const {
    std::vector<Aabb> boxes = boxes_;
    boxes.resize(std::max<std::size_t>(boxes.size(), most_), kNobody);
    const TreeCheck check(*tree_, boxes);
    for (Slot slot = 0; slot < boxes.size(); ++slot)
      ASSERT_EQ(check.times()[slot], bodies().has(slot) ? 1 : 0) << "slot " << slot;
    EXPECT_LE(check.depth(), kTreeDepth);
  }

 private:
  BodyBoxes bodies() const { return {boxes_, states_.data()}; }

  void add_slots(std::size_t count) {
    boxes_.resize(boxes_.size() + count, kNobody);
    states_.resize(boxes_.size(), kAtRest);
    most_ = std::max(most_, boxes_.size());
  }

  void change_one(Slot slot) {
    Aabb& box = boxes_[slot];
    const bool is_there = box.min[0] <= box.max[0];
    states_[slot] = kAtRest;
    if (!is_there) {
      box = contract::canonical_box(kind_.make(random_, slot, boxes_.size()));
      states_[slot] = random_.one_in(6) ? kInserted : kAtRest;
    } else if (random_.one_in(8)) {
      box = kNobody;
    } else {
      box = contract::canonical_box(contract::next_box(kind_, random_, box, some_box()));
    }
    changed_.push_back(slot);
    if (random_.one_in(10)) changed_.push_back(slot);
  }

  Aabb some_box() {
    const Aabb box = boxes_[random_.below(boxes_.size())];
    return box.min[0] <= box.max[0] ? box : box_at({0, 0, 0});
  }

  const BoxKind& kind_;
  Random random_;
  std::vector<Aabb> boxes_;
  std::vector<BodyState> states_;
  std::size_t most_ = 0;
  Vector<Slot> changed_;
  std::optional<BoxTree> tree_;
};

TEST(TreeUpdate, GivesATreeOfTheBoxesAsTheyAreNow) {
  for (const BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {1, 16, 17, 300, contract::effort(2000, 700, 700)}) {
      ChangingBoxes world(kind, count, count + 1);
      for (int step = 0; step < 12; ++step) {
        SCOPED_TRACE(testing::Message() << count << " of " << kind << ", step " << step);
        world.change(step % 3 == 0 ? 0.8 : 3.0 / static_cast<double>(count));
        if (step == 9) world.lose_all();
        if (step % 4 != 2) world.update(step % 4 == 3);  // or with the next ones
        if (step % 4 != 2) world.expect_right();
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

/// A tree of nobody, to which each of the boxes comes in turn.
class GrowingTree {
 public:
  /// False: it would become too deep.
  bool add(const Aabb& box) {
    boxes_.push_back(box);
    const Slot slot = static_cast<Slot>(boxes_.size() - 1);
    return tree_.update({boxes_}, {&slot, 1});
  }
  TreeCheck check() const { return {tree_, boxes_}; }
  const BoxTree& tree() const { return tree_; }

 private:
  std::vector<Aabb> boxes_;
  BoxTree tree_{BodyBoxes()};
};

TEST(TreeUpdate, PutsNewBodiesWhereNodesGrowTheLeast) {
  Random random(1);
  GrowingTree growing;
  for (int i = 0; i < 4000; ++i)
    ASSERT_TRUE(growing.add(box_at({random.between(0, 99), random.between(0, 99), random.between(0, 99)})));
  EXPECT_LE(growing.check().depth(), 12U);
  EXPECT_LE(3 * growing.tree().size(), 4000U);
}

// Each around the one before, or all in the same place.
TEST(TreeUpdate, SaysWhenATreeBecomesTooDeep) {
  for (const bool grows : {false, true}) {
    GrowingTree growing;
    bool is_good = true;
    for (int i = 0; i < 3000 && is_good; ++i) {
      const float far = grows ? 1 + static_cast<float>(i) : 1;
      is_good = growing.add({{-far, -far, -far}, {far, far, far}});
      if (is_good) {
        ASSERT_LE(growing.check().depth(), kTreeDepth);
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::queries
