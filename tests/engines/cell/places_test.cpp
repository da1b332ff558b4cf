/// @file
/// Bodies that take each other's places: an engine that is full loses bodies and gets as many within one
/// update.
#include <gmock/gmock.h>

#include <iterator>
#include <map>

#include "engines/cell/cell_world.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::cell {
namespace {

using contract::Random;

#ifdef CELLSWEEP_SANITIZED_TESTS
constexpr int kUpdates = 6;
#else
constexpr int kUpdates = 20;
#endif

/// A full engine and what it must know.
class FullEngine {
 public:
  explicit FullEngine(Broadphase engine) : engine_(std::move(engine)) {
    const auto count = static_cast<std::size_t>(engine_.capacity().bodies);
    while (boxes_.size() < count) insert(next_++);
  }

  /// So many bodies go, and as many come: under new names, or under those of bodies that just went.
  void exchange(std::size_t count, bool same_names) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto body = std::next(boxes_.begin(), static_cast<std::ptrdiff_t>(random_.below(boxes_.size())));
      const BodyId id = body->first;
      boxes_.erase(body);
      ASSERT_TRUE(engine_.remove(id).ok());
      renamed_.push_back(id);
      insert(same_names ? id : next_++);
    }
  }

  void move_some() {
    for (auto& [id, box] : boxes_) {
      if (!random_.one_in(3)) continue;
      box = random_box(random_);
      ASSERT_TRUE(engine_.move(id, box).ok());
    }
  }

  /// Compares the pairs and the changes with all against all.
  void update() {
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (const auto& [id, box] : boxes_) {
      ids.push_back(id);
      boxes.push_back(box);
    }
    const std::vector<Pair> before = pairs_of(engine_);
    const auto changes = engine_.update();
    ASSERT_TRUE(changes.ok()) << changes.status().message;
    const std::vector<Pair> now = pairs_of(engine_);
    ASSERT_EQ(now, brute_force_pairs(ids, boxes));
    EXPECT_THAT(changes->began, testing::ElementsAreArray(difference(now, before)));
    EXPECT_THAT(changes->ended, testing::ElementsAreArray(difference(before, now)));
    renamed_.clear();
  }

  Broadphase& engine() { return engine_; }
  std::size_t size() const { return boxes_.size(); }

 private:
  void insert(BodyId id) {
    boxes_[id] = random_box(random_);
    ASSERT_TRUE(engine_.insert(id, boxes_[id]).ok());
  }

  bool is_of_a_new_body(const Pair& pair) const {
    return std::ranges::find(renamed_, pair.a) != renamed_.end() ||
           std::ranges::find(renamed_, pair.b) != renamed_.end();
  }

  // Pairs that the others have not; those of a body that went and came back are others, though of one name.
  std::vector<Pair> difference(const std::vector<Pair>& some, const std::vector<Pair>& others) const {
    std::vector<Pair> only;
    for (const Pair& pair : some) {
      if (is_of_a_new_body(pair) || !std::ranges::binary_search(others, pair)) only.push_back(pair);
    }
    return only;
  }

  Random random_{5};
  Broadphase engine_;
  std::map<BodyId, Aabb> boxes_;
  std::vector<BodyId> renamed_;  // bodies that went since the last update
  BodyId next_ = 1'000'000;
};

struct Small {
  std::string name;
  Result<Broadphase> (*make)(const SpeOptions& spes);
  std::uint64_t local_store;  // with room for some dozens of bodies
};

void PrintTo(const Small& engine, std::ostream* out) {
  *out << engine.name;
}

Result<Broadphase> make_paper_with_method_2(const SpeOptions& spes) {
  return make_broadphase(CellPaperOptions{.spes = spes, .method = 2});
}

const Small kSmall[] = {{"paper", make_on<CellPaperOptions>, 108 << 10},
                        {"paper_with_method_2", make_paper_with_method_2, 140 << 10},
                        {"brute", make_on<CellBruteOptions>, 80 << 10},
                        {"resident", make_on<CellResidentOptions>, 88 << 10}};

using PlacesOfBodies = testing::TestWithParam<Small>;

TEST_P(PlacesOfBodies, PassFromThoseThatGoToThoseThatComeInOneUpdate) {
  const auto& [name, make_engine, local_store] = GetParam();
  FullEngine full(std::move(*make_engine({.local_store = local_store})));
  ASSERT_GT(full.size(), 16U);
  EXPECT_EQ(full.engine().insert(1, cube(0)).code, StatusCode::capacity);
  ASSERT_NO_FATAL_FAILURE(full.update());
  for (int update = 0; update < kUpdates; ++update) {
    full.exchange(update % 5 == 4 ? full.size() : full.size() / 4, update % 2 == 1);
    if (update % 3 == 0) full.move_some();
    EXPECT_EQ(full.engine().insert(1, cube(0)).code, StatusCode::capacity);
    ASSERT_NO_FATAL_FAILURE(full.update()) << name << ", update " << update;
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, PlacesOfBodies, testing::ValuesIn(kSmall),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace cellsweep::cell
