/// @file
/// The tree of boxes: whole and shallow for any boxes; made, and brought up to date after bodies have
/// changed, when questions have paid for it, or asked for.
#include "queries/tree/box_tree.h"

#include "base/memory/starved.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "queries/random_questions.h"
#include "queries/tree_check.h"
#include "queries/tree_price.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

void expect_whole_and_shallow(std::vector<Aabb> boxes) {
  for (std::size_t i = 3; i < boxes.size(); i += 7) boxes[i] = kNobody;
  const BoxTree tree({boxes});
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
      const BoxTree tree({boxes});
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
  explicit Row(std::size_t count = 300) { insert(count); }

  Broadphase& broadphase() { return broadphase_; }
  Queries queries() const { return broadphase_.queries(); }
  bool has_tree() const { return tree().get() != nullptr; }
  bool keeps_tree() const { return tree().outdated() != nullptr; }
  double wear() const { return tree().get()->wear(); }
  std::uint64_t bytes() const { return broadphase_.statistics().bytes; }
  bool answers_are_right(std::uint64_t seed) const {
    return static_cast<bool>(queries::answers_are_right(queries(), truth_, seed));
  }

  /// Along the whole row, so many times.
  void ask(int times) const {
    std::vector<Touch> found;
    for (int i = 0; i < times; ++i)
      ASSERT_TRUE(queries().find_touches(Ray{{-1, 0.5F, 0.5F}, {1, 0, 0}}, found).ok());
  }

  /// Behind the others.
  void insert(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = static_cast<float>(3 * next_);
      truth_.boxes[next_] = {{at, 0, 0}, {at + 1, 1, 1}};
      ASSERT_TRUE(broadphase_.insert(next_, truth_.boxes[next_]).ok());
      ++next_;
    }
    update();
  }
  /// The first ones.
  void remove(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(broadphase_.remove(truth_.boxes.begin()->first).ok());
      truth_.boxes.erase(truth_.boxes.begin());
    }
    update();
  }
  void move(BodyId body, const Aabb& box) {
    truth_.boxes[body] = box;
    ASSERT_TRUE(broadphase_.move(body, box).ok());
    update();
  }
  void move_all(float way) {
    for (auto& [body, box] : truth_.boxes) {
      box.max[1] += way;
      ASSERT_TRUE(broadphase_.move(body, box).ok());
    }
    update();
  }
  /// Of some bodies.
  void swap_places(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 30; ++i) {
      Aabb& one = truth_.boxes[static_cast<BodyId>(random.below(next_))];
      std::swap(one, truth_.boxes[static_cast<BodyId>(random.below(next_))]);
    }
    for (const auto& [body, box] : truth_.boxes) ASSERT_TRUE(broadphase_.move(body, box).ok());
    update();
  }
  void update() { ASSERT_TRUE(broadphase_.update().ok()); }

 private:
  KeptTree& tree() const { return EngineAccess::last_update(broadphase_).tree; }

  Broadphase broadphase_ = std::move(*make_broadphase(OracleOptions{}));
  Reference truth_;
  BodyId next_ = 0;
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

TEST(TreeOfQueries, IsOfTheLastUpdate) {
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
  EXPECT_FALSE(row.has_tree()) << "it is not up to date";
}

TEST(TreeOfQueries, IsBroughtUpToDateForLess) {
  Row row;
  row.queries().prepare();
  for (int i = 0; i < 300; ++i) {
    row.move(BodyId{7}, {{21, 0, 0}, {22, 1, static_cast<float>(2 + i % 3)}});
    EXPECT_FALSE(row.has_tree());
    row.ask(1);
    ASSERT_TRUE(row.has_tree());
  }
  EXPECT_TRUE(row.answers_are_right(5));
}

// Updates in which little changes do not make questions pay for a whole tree again and again.
TEST(TreeOfQueries, IsPaidForOverUpdatesWhereFewBodiesChange) {
  Row row;
  int updates = 0;
  for (; updates < 100 && !row.has_tree(); ++updates) {
    row.move(BodyId{7}, {{21, 0, 0}, {22, 1, static_cast<float>(2 + updates)}});
    row.ask(20);
  }
  EXPECT_GT(updates, 5);
  EXPECT_LT(updates, 100);
}

TEST(TreeOfQueries, IsNotMadeWhereToBringItUpToDateWouldTakeLonger) {
  Row row;
  for (int i = 0; i < 500; ++i) {
    row.move_all(0.01F);
    row.ask(2);
    ASSERT_FALSE(row.has_tree());
  }
}

TEST(TreeOfQueries, IsGivenUpWhenNobodyAsks) {
  constexpr std::size_t kBodies = 4000;
  Row row(kBodies);
  row.move(BodyId{7}, {{21, 0, 0}, {22, 1, 0.5F}});
  const std::uint64_t without_tree = row.bytes();
  row.queries().prepare();
  row.update();
  EXPECT_GE(row.bytes(), without_tree + kBodies * sizeof(Aabb)) << "it holds all boxes";
  int updates = 0;
  for (; updates < 1000 && row.keeps_tree(); ++updates)
    row.move(BodyId{7}, {{21, 0, 0}, {22, 1, static_cast<float>(2 + updates)}});
  EXPECT_GT(updates, 10);
  EXPECT_LT(updates, 1000);
  EXPECT_LE(row.bytes(), without_tree + 1000);
  EXPECT_TRUE(row.answers_are_right(6));
}

// Who settles far from where he was at first makes nodes long.
TEST(TreeOfQueries, IsMadeAnewOnceItIsWorn) {
  Row row;
  row.queries().prepare();
  for (int i = 0; i < 40; ++i) {
    row.swap_places(static_cast<std::uint64_t>(i));
    row.queries().prepare();
    ASSERT_TRUE(row.has_tree());
    ASSERT_LT(row.wear(), 1.6);
    ASSERT_TRUE(row.answers_are_right(7));
  }
}

TEST(TreeOfQueries, FollowsBodiesThatComeAndGo) {
  Row row(600);
  row.queries().prepare();
  for (const std::size_t gone : {1, 100, 480, 19}) {
    row.remove(gone);
    row.queries().prepare();
    ASSERT_TRUE(row.answers_are_right(gone)) << gone << " went";
  }
  for (const std::size_t more : {1, 3, 300, 30, 2000}) {
    row.insert(more);
    row.ask(300);
    ASSERT_TRUE(row.answers_are_right(more)) << more << " came";
  }
}

TEST(TreeOfQueries, OutlivesThatAllBodiesGo) {
  Row row;
  row.queries().prepare();
  row.insert(50);
  row.remove(350);
  EXPECT_TRUE(row.answers_are_right(8));
  row.queries().prepare();
  EXPECT_TRUE(row.answers_are_right(9));
  row.insert(20);
  row.queries().prepare();
  EXPECT_TRUE(row.answers_are_right(10));
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

// More than fit into the nodes that there are.
TEST(TreeOfQueries, WithoutMemoryToBringItUpToDateThereIsNoneAndAnotherTryMakesIt) {
  const auto make = [] {
    Row row;
    row.queries().prepare();
    row.insert(400);
    return row;
  };
  const auto places = starve(
      make, [](const Row& row) { row.queries().prepare(); },
      [](const Row& row) {
        EXPECT_FALSE(row.has_tree());
        EXPECT_TRUE(row.answers_are_right(11));
      },
      [](const Row& row) {
        EXPECT_TRUE(row.has_tree());
        EXPECT_TRUE(row.answers_are_right(12));
      });
  EXPECT_GE(places, 2U);
}

TEST(TreeOfQueries, WithoutMemoryQuestionsAreAnsweredAllTheSame) {
  Row row;
  {
    const FailingMemory memory(1);
    row.ask(700);
    EXPECT_FALSE(row.has_tree());
  }
  row.ask(1500);
  EXPECT_TRUE(row.has_tree()) << "it must be paid for once more, and is made then";
}

}  // namespace
}  // namespace cellsweep::queries
