/// @file
/// The tree of boxes: whole and shallow for any boxes; made when questions have paid for it, or asked for;
/// gone when bodies change.
#include "queries/tree/box_tree.h"

#include <cfloat>

#include "base/memory/starved.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "queries/random_questions.h"
#include "queries/tree/tree_price.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

/// Walks through all of a tree.
class TreeCheck {
 public:
  TreeCheck(const BoxTree& tree, std::span<const Aabb> boxes) : tree_(tree), boxes_(boxes) {
    times_.assign(boxes.size(), 0);
    check(0, 1);
  }

  const std::vector<int>& times() const { return times_; }
  std::size_t nodes() const { return nodes_; }
  unsigned depth() const { return depth_; }

 private:
  static Aabb box_in(const TreeNode& node, unsigned place) {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = node.faces[axis][place];
      box.max[axis] = node.faces[axis + 3][place];
    }
    return box;
  }

  // Returns the box around the node.
  Aabb check(std::uint32_t number, unsigned depth) {
    ++nodes_;
    depth_ = std::max(depth_, depth);
    const TreeNode& node = tree_.nodes()[number];
    Aabb around = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (unsigned place = 0; place < TreeNode::kBoxes; ++place) {
      const Aabb box = box_in(node, place);
      if (!(box.min[0] <= box.max[0])) continue;
      if ((node.bodies >> place & 1) != 0) {
        ++times_[node.content[place]];
        EXPECT_EQ(box, boxes_[node.content[place]]);
      } else {
        EXPECT_EQ(box, check(node.content[place], depth + 1));
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        around.min[axis] = std::min(around.min[axis], box.min[axis]);
        around.max[axis] = std::max(around.max[axis], box.max[axis]);
      }
    }
    return around;
  }

  const BoxTree& tree_;
  std::span<const Aabb> boxes_;
  std::vector<int> times_;
  std::size_t nodes_ = 0;
  unsigned depth_ = 0;
};

void expect_whole_and_shallow(const std::vector<Aabb>& boxes) {
  const BoxTree tree(boxes, [](Slot slot) { return slot % 7 != 3; });
  const TreeCheck check(tree, boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(check.times()[i], i % 7 != 3 ? 1 : 0) << i;
  EXPECT_EQ(check.nodes(), tree.size());
  EXPECT_LE(tree.size(), std::max<std::size_t>(boxes.size(), 1));
  EXPECT_LE(check.depth(), kTreeDepth);
}

TEST(BoxTree, HoldsEachBodyOnceWhateverTheBoxes) {
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {0, 1, 2, 8, 9, 10, 16, 17, 65, 400, 5000}) {
      SCOPED_TRACE(testing::Message() << count << " of " << kind);
      Random random(count + 1);
      std::vector<Aabb> boxes = contract::make_boxes(kind, random, count);
      for (Aabb& box : boxes) box = contract::canonical_box(box);
      expect_whole_and_shallow(boxes);
      if (testing::Test::HasFailure()) return;
    }
  }
}

// Also where bodies lie in lines or all in one place, and no surface says how they are cut best.
TEST(BoxTree, FillsItsNodesWhateverTheBoxes) {
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {400, 5000}) {
      SCOPED_TRACE(testing::Message() << count << " of " << kind);
      Random random(count + 1);
      std::vector<Aabb> boxes = contract::make_boxes(kind, random, count);
      for (Aabb& box : boxes) box = contract::canonical_box(box);
      const BoxTree tree(boxes, [](Slot) { return true; });
      EXPECT_LE(8 * tree.size(), count);
    }
  }
}

// Each half as far as the one before, or twice as large: a cut takes off one of them.
TEST(BoxTree, IsShallowWhereEachCutTakesOffLittle) {
  std::vector<Aabb> points;
  std::vector<Aabb> nested;
  for (int copy = 0; copy < 40; ++copy) {
    for (int exponent = -125; exponent < 127; ++exponent) {
      const float far = std::ldexp(1 + 0.01F * static_cast<float>(copy), exponent);
      points.push_back(box_at({far, far, -far}));
      nested.push_back({{-far, -far, -far}, {far, far, far}});
    }
  }
  expect_whole_and_shallow(points);
  expect_whole_and_shallow(nested);
  points.insert(points.end(), nested.begin(), nested.end());
  points.insert(points.end(), 3000, {{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}});
  expect_whole_and_shallow(points);
}

/// A row of boxes, in any engine.
class Row {
 public:
  explicit Row(std::size_t count = 300) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = static_cast<float>(3 * i);
      truth_.boxes[static_cast<BodyId>(i)] = {{at, 0, 0}, {at + 1, 1, 1}};
      EXPECT_TRUE(broadphase_.insert(static_cast<BodyId>(i), {{at, 0, 0}, {at + 1, 1, 1}}).ok());
    }
    EXPECT_TRUE(broadphase_.update().ok());
  }

  Broadphase& broadphase() { return broadphase_; }
  Queries queries() const { return broadphase_.queries(); }
  bool has_tree() const { return EngineAccess::last_update(broadphase_).tree.get() != nullptr; }
  bool answers_are_right(std::uint64_t seed) const {
    return static_cast<bool>(queries::answers_are_right(queries(), truth_, seed));
  }

  /// Along the whole row, so many times.
  void ask(int times) const {
    std::vector<Touch> found;
    for (int i = 0; i < times; ++i) {
      ASSERT_TRUE(queries().find_touches(Ray{{-1, 0.5F, 0.5F}, {1, 0, 0}}, found).ok());
      ASSERT_EQ(found.size(), truth_.boxes.size());
    }
  }

 private:
  Broadphase broadphase_ = std::move(*make_broadphase(OracleOptions{}));
  Reference truth_;
};

TEST(TreeOfQueries, IsMadeOnceQuestionsHavePaidForIt) {
  Row row;
  EXPECT_FALSE(row.has_tree());
  row.ask(20);
  EXPECT_FALSE(row.has_tree()) << "a few questions made one";
  row.ask(2000);
  EXPECT_TRUE(row.has_tree());
  EXPECT_TRUE(row.answers_are_right(1));
}

TEST(TreeOfQueries, IsGoneWhenBodiesChangeAndOnlyThen) {
  Row row;
  row.queries().prepare();
  EXPECT_TRUE(row.has_tree());
  row.queries().prepare();
  ASSERT_TRUE(row.broadphase().update().ok());
  EXPECT_TRUE(row.has_tree()) << "nothing has changed";
  ASSERT_TRUE(row.broadphase().move(BodyId{7}, {{0, 5, 0}, {1, 6, 1}}).ok());
  EXPECT_TRUE(row.has_tree()) << "queries answer as of the last update";
  EXPECT_TRUE(row.answers_are_right(2));
  ASSERT_TRUE(row.broadphase().update().ok());
  EXPECT_FALSE(row.has_tree());
}

TEST(TreeOfQueries, ForgetsWhatWasPaidWhenBodiesChange) {
  Row row;
  for (int i = 0; i < 20; ++i) {
    row.ask(100);
    ASSERT_TRUE(row.broadphase().move(BodyId{7}, {{21, 0, 0}, {22, 1, static_cast<float>(1 + i)}}).ok());
    ASSERT_TRUE(row.broadphase().update().ok());
  }
  EXPECT_FALSE(row.has_tree());
}

TEST(TreeOfQueries, MovesWithItsBroadphase) {
  Row row;
  row.queries().prepare();
  Broadphase moved = std::move(row.broadphase());
  std::vector<Touch> found;
  EXPECT_TRUE(moved.queries().find_touches(Ray{{-1, 0.5F, 0.5F}, {1, 0, 0}}, found).ok());
  EXPECT_EQ(found.size(), 300U);
}

TEST(TreeOfQueries, WithoutMemoryThereIsNoneAndAnotherTryMakesIt) {
  const auto places = starve([] { return Row(); }, [](const Row& row) { row.queries().prepare(); },
                             [](const Row& row) {
                               EXPECT_FALSE(row.has_tree());
                               EXPECT_TRUE(row.answers_are_right(3));
                             },
                             [](const Row& row) {
                               EXPECT_TRUE(row.has_tree());
                               EXPECT_TRUE(row.answers_are_right(4));
                             });
  EXPECT_GE(places, 2U);
}

TEST(TreeOfQueries, WithoutMemoryQuestionsAreAnsweredAllTheSame) {
  Row row;
  {
    const FailingMemory memory(1);
    row.ask(1500);
    EXPECT_FALSE(row.has_tree());
  }
  row.ask(1500);
  EXPECT_TRUE(row.has_tree()) << "it must be paid for once more, and is made then";
}

}  // namespace
}  // namespace cellsweep::queries
