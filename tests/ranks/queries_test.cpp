// What all ranks answer together is what one engine answers.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "cellsweep/query.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Questions on a coarse grid, so that they touch, tie, and meet the cuts. Each rank asks others.
class Asker {
 public:
  explicit Asker(std::uint32_t seed)
      : random_(seed * 1000 + static_cast<std::uint32_t>(own_rank())), questions_(below(3) == 0 ? 0 : 12) {}

  std::size_t questions() const { return questions_; }
  float place() { return static_cast<float>(below(31)) - 15; }
  Aabb box() {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = place();
      box.max[axis] = box.min[axis] + static_cast<float>(below(4));
    }
    return box;
  }
  double reach() {
    const std::size_t kind = below(8);
    return kind == 0 ? kInfinite : static_cast<double>(kind - 1);
  }
  Path path() {
    std::array<double, 3> direction{};
    while (direction == std::array<double, 3>{}) {
      for (double& x : direction) x = static_cast<double>(below(5)) - 2;
    }
    Path path(MovingBox{box(), direction, reach()});
    if (below(2) == 0) path.box.max = path.box.min;
    return path;
  }
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

 private:
  std::mt19937 random_;
  std::size_t questions_;
};

class QueriesOfAllRanks : public testing::Test {
 protected:
  QueriesOfAllRanks() {
    std::mt19937 random(7);
    const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    std::vector<BodyFilter> filters;
    for (BodyId id = 0; id < 200; ++id) {
      Aabb box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = static_cast<float>(below(25) - 12);
        box.max[axis] = box.min[axis] + static_cast<float>(below(id == 50 ? 30 : 3));
      }
      ids.push_back(id);
      boxes.push_back(box);
      filters.push_back({1U << below(3), 0xffffffffU, false});
    }
    twins_.insert(all_ranks() / 2, ids, boxes, filters);
    EXPECT_EQ(twins_.update_and_compare(), "");
  }

  Queries whole() { return twins_.whole().queries(); }
  DistributedQueries all() { return twins_.world().queries(); }

  Twins twins_;
};

template <class Mine, class Truth, class Same>
bool same_answers(const BatchAnswers<Mine>& mine, const BatchAnswers<Truth>& truth, const Same& same) {
  if (mine.first != truth.first) return false;
  return std::ranges::equal(mine.answers, truth.answers, same);
}

bool same_touch(const GlobalTouch& mine, const Touch& truth) {
  return mine.body == global_id(truth.body) && mine.time == truth.time;
}

bool same_neighbor(const GlobalNeighbor& mine, const Neighbor& truth) {
  return mine.body == global_id(truth.body) && mine.distance == truth.distance;
}

TEST_F(QueriesOfAllRanks, AnswerWhatOneEngineAnswers) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Asker asker(seed);
    std::vector<Region> regions;
    std::vector<Path> paths;
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < asker.questions(); ++i) {
      regions.emplace_back(asker.box(), asker.reach());
      paths.push_back(asker.path());
      boxes.push_back(asker.box());
    }
    const QueryFilter filter{.as = seed % 2 == 0 ? std::optional<BodyFilter>({1, 5, false}) : std::nullopt};
    const std::size_t count = seed % 7;
    const double most = seed % 3 == 0 ? 4 : kInfinite;

    BatchAnswers<GlobalId> overlaps;
    BatchAnswers<BodyId> true_overlaps;
    ASSERT_TRUE(all().find_overlaps(regions, overlaps, filter.as).ok());
    ASSERT_TRUE(whole().find_overlaps(regions, true_overlaps, filter).ok());
    bool same = same_answers(overlaps, true_overlaps,
                             [](GlobalId mine, BodyId truth) { return mine == global_id(truth); });
    ASSERT_TRUE(on_all_ranks(same)) << "overlaps, seed " << seed;

    BatchAnswers<GlobalTouch> touches;
    BatchAnswers<Touch> true_touches;
    ASSERT_TRUE(all().find_touches(paths, touches, filter.as).ok());
    ASSERT_TRUE(whole().find_touches(paths, true_touches, filter).ok());
    ASSERT_TRUE(on_all_ranks(same_answers(touches, true_touches, same_touch))) << "touches, seed " << seed;

    std::vector<std::optional<GlobalTouch>> first(paths.size());
    std::vector<std::optional<Touch>> true_first(paths.size());
    ASSERT_TRUE(all().first_touches(paths, first, filter.as).ok());
    ASSERT_TRUE(whole().first_touches(paths, true_first, filter).ok());
    same = std::ranges::equal(first, true_first, [](const auto& mine, const auto& truth) {
      return mine.has_value() == truth.has_value() && (!mine || same_touch(*mine, *truth));
    });
    ASSERT_TRUE(on_all_ranks(same)) << "first touches, seed " << seed;

    BatchAnswers<GlobalNeighbor> nearest;
    BatchAnswers<Neighbor> true_nearest;
    ASSERT_TRUE(all().find_nearest(boxes, count, nearest, most, filter.as).ok());
    ASSERT_TRUE(whole().find_nearest(boxes, count, true_nearest, most, filter).ok());
    ASSERT_TRUE(on_all_ranks(same_answers(nearest, true_nearest, same_neighbor))) << "nearest, seed " << seed;

    ASSERT_TRUE(all().find_within(regions, nearest, filter.as).ok());
    ASSERT_TRUE(whole().find_within(regions, true_nearest, filter).ok());
    ASSERT_TRUE(on_all_ranks(same_answers(nearest, true_nearest, same_neighbor))) << "within, seed " << seed;
  }
}

TEST_F(QueriesOfAllRanks, AreRefusedByAllWhereOneMayNotBeAsked) {
  std::vector<Region> regions;
  if (own_rank() == all_ranks() - 1) regions.emplace_back(Aabb{{1, 0, 0}, {0, 0, 0}});
  BatchAnswers<GlobalId> found;
  found.answers = {42};
  const Status status = all().find_overlaps(regions, found);
  EXPECT_EQ(status.code, StatusCode::invalid_box);
  EXPECT_TRUE(status.message.starts_with("Rank " + std::to_string(all_ranks() - 1) + ": "));
  EXPECT_EQ(found.answers.size(), 1U);
}

}  // namespace
}  // namespace cellsweep::ranks
