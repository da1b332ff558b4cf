/// @file
/// A random world lives through the face for C, its arrays in structs of the caller's, and through the
/// handle: the changes, pairs, boxes and filters are the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "bindings/c/c_world.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/pair_history.h"
#include "contract/box_kinds.h"
#include "contract/random.h"

namespace cellsweep::c {
namespace {

using contract::BoxKind;
using contract::Random;

/// As a program might have them, with bytes between that are none of the library's business.
struct Record {
  std::uint16_t odd = 0xabcd;
  BodyId id = 0;
  Aabb box;
  std::byte more[3] = {};
  cellsweep_filter filter{1, 0xffffffff, false};
};

class TwoWorlds {
 public:
  TwoWorlds(const BoxKind& kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  void live() {
    for (int step = 0; step < 30; ++step) {
      change();
      update();
      if (testing::Test::HasFailure()) return;
    }
    expect_same_history();
  }

 private:
  cellsweep_ids ids(const std::vector<Record>& records) {
    return {records.empty() ? nullptr : &records[0].id, sizeof(Record), records.size()};
  }
  cellsweep_boxes boxes(const std::vector<Record>& records) {
    if (records.empty()) return cellsweep_boxes_of(nullptr, 0);
    return cellsweep_boxes_apart(CELLSWEEP_FLOAT, 3, records[0].box.min.data(), records[0].box.max.data(),
                                 sizeof(Record), records.size());
  }
  cellsweep_filters filters(const std::vector<Record>& records) {
    return {records.empty() ? nullptr : &records[0].filter, sizeof(Record), records.size()};
  }

  /// Some records, new ones or of bodies that are there.
  std::vector<Record> some(bool are_new) {
    std::vector<Record> records(random_.below(12));
    for (Record& record : records) {
      record.box = contract::make_boxes(kind_, random_, 1)[0];
      record.filter = {1U << random_.below(2), static_cast<std::uint32_t>(random_.whole(1, 3)),
                       random_.one_in(4)};
      if (are_new)
        record.id = next_id_ += 7;
      else if (!held_.empty())
        record.id = random_.pick(held_);
    }
    if (!are_new && held_.empty()) records.clear();
    return records;
  }

  struct Split {
    explicit Split(const std::vector<Record>& records) {
      for (const Record& record : records) {
        ids.push_back(record.id);
        boxes.push_back(record.box);
        filters.push_back({record.filter.category, record.filter.mask, record.filter.is_static});
      }
    }
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    std::vector<BodyFilter> filters;
  };

  void change() {
    const std::vector<Record> fresh = some(true);
    const Split inserted(fresh);
    const bool with_filters = random_.one_in(2);
    expect_same(cellsweep_insert(world_.get(), ids(fresh), boxes(fresh),
                                 with_filters ? filters(fresh) : cellsweep_no_filters(), nullptr),
                with_filters ? handle_.insert(inserted.ids, inserted.boxes, inserted.filters)
                             : handle_.insert(inserted.ids, inserted.boxes));
    held_.insert(held_.end(), inserted.ids.begin(), inserted.ids.end());
    const std::vector<Record> moved = some(false);
    expect_same(cellsweep_move(world_.get(), ids(moved), boxes(moved), nullptr),
                handle_.move(Split(moved).ids, Split(moved).boxes));
    const std::vector<Record> filtered = some(false);
    expect_same(cellsweep_set_filters(world_.get(), ids(filtered), filters(filtered), nullptr),
                handle_.set_filters(Split(filtered).ids, Split(filtered).filters));
    // One body twice is refused, by both.
    const std::vector<Record> removed = some(false);
    const Status was_removed = handle_.remove(Split(removed).ids);
    expect_same(cellsweep_remove(world_.get(), ids(removed), nullptr), was_removed);
    if (!was_removed.ok()) return;
    std::erase_if(held_, [&](BodyId id) { return !handle_.contains(id); });
  }

  static void expect_same(cellsweep_status status, const Status& expected) {
    EXPECT_EQ(static_cast<int>(status), static_cast<int>(expected.code)) << expected.message;
  }

  void update() {
    cellsweep_changes changes;
    ASSERT_EQ(cellsweep_update(world_.get(), &changes, nullptr), CELLSWEEP_OK);
    const auto expected = handle_.update();
    ASSERT_TRUE(expected.ok());
    EXPECT_EQ(copied(changes.began, changes.began_count),
              std::vector(expected->began.begin(), expected->began.end()));
    EXPECT_EQ(copied(changes.ended, changes.ended_count),
              std::vector(expected->ended.begin(), expected->ended.end()));
    const std::uint64_t number = cellsweep_statistics_of(world_.get()).updates;
    EXPECT_EQ(number, handle_.statistics().updates);
    ASSERT_EQ(cellsweep_history_record(history_.get(), number, &changes, nullptr), CELLSWEEP_OK);
    ASSERT_TRUE(expected_history_.record(number, *expected).ok());
    expect_same_state();
  }

  void expect_same_state() {
    const auto pairs = handle_.pairs();
    EXPECT_EQ(pairs_of(world_), std::vector(pairs.begin(), pairs.end()));
    EXPECT_EQ(cellsweep_size(world_.get()), handle_.size());
    std::vector<Aabb> read(held_.size());
    std::vector<Aabb> expected(held_.size());
    ASSERT_EQ(cellsweep_read_boxes(world_.get(), ids_in(held_),
                                   reinterpret_cast<cellsweep_aabb*>(read.data()), nullptr),
              CELLSWEEP_OK);
    ASSERT_TRUE(handle_.boxes(held_, expected).ok());
    EXPECT_EQ(read, expected);
    for (const BodyId id : held_) {
      cellsweep_filter filter;
      ASSERT_TRUE(cellsweep_contains(world_.get(), id));
      ASSERT_EQ(cellsweep_filter_of(world_.get(), id, &filter, nullptr), CELLSWEEP_OK);
      EXPECT_EQ((BodyFilter{filter.category, filter.mask, filter.is_static}), handle_.filter(id));
    }
  }

  void expect_same_history() {
    cellsweep_changes changes;
    ASSERT_EQ(cellsweep_history_since(history_.get(), 5, &changes, nullptr), CELLSWEEP_OK);
    const auto expected = expected_history_.since(5);
    ASSERT_TRUE(expected.ok());
    EXPECT_EQ(copied(changes.began, changes.began_count),
              std::vector(expected->began.begin(), expected->began.end()));
    EXPECT_EQ(copied(changes.ended, changes.ended_count),
              std::vector(expected->ended.begin(), expected->ended.end()));
  }

  static History make_history() {
    cellsweep_history* made = nullptr;
    EXPECT_EQ(cellsweep_history_create(100000, &made, nullptr), CELLSWEEP_OK);
    return History(made);
  }

  const BoxKind& kind_;
  Random random_;
  World world_ = make_world();
  Broadphase handle_;
  History history_ = make_history();
  PairHistory expected_history_{100000};
  std::vector<BodyId> held_;
  BodyId next_id_ = 0;
};

TEST(CWorlds, LiveAsTheyDoInCpp) {
  std::uint64_t seed = 0;
  for (const BoxKind& kind : contract::box_kinds()) {
    SCOPED_TRACE(kind.name);
    TwoWorlds(kind, ++seed).live();
  }
}

TEST(CWorlds, OfDoublesAndInTwoDimensionsPairWhatTouches) {
  const World world = make_world();
  // x and y of the minimum, then of the maximum: the second touches the first but for less than a float.
  const double boxes[] = {0, 0, 1, 1, 1 + 1e-12, 0, 2, 1, 3, 0, 4, 1};
  const cellsweep_boxes view =
      cellsweep_boxes_apart(CELLSWEEP_DOUBLE, 2, boxes, boxes + 2, 4 * sizeof(double), 3);
  uint32_t ids[3];
  ASSERT_EQ(cellsweep_add(world.get(), view, ids, nullptr), CELLSWEEP_OK);
  ASSERT_EQ(cellsweep_update(world.get(), nullptr, nullptr), CELLSWEEP_OK);
  EXPECT_EQ(pairs_of(world), (std::vector<Pair>{{0, 1}}));
  cellsweep_aabb box;
  ASSERT_EQ(cellsweep_read_boxes(world.get(), cellsweep_ids_of(ids + 1, 1), &box, nullptr), CELLSWEEP_OK);
  EXPECT_EQ(box.min[0], 1);
  EXPECT_EQ(box.max[2], 0);
}

TEST(CWorlds, OfEachEngineOfTheTableWork) {
  EXPECT_GE(cellsweep_engine_count(), 3U);
  for (std::size_t i = 0; i < cellsweep_engine_count(); ++i) {
    cellsweep_broadphase* made = nullptr;
    ASSERT_EQ(cellsweep_create_engine(cellsweep_engine_at(i), nullptr, 0, &made, nullptr), CELLSWEEP_OK);
    const World world(made);
    EXPECT_STREQ(cellsweep_engine_name(made), cellsweep_engine_at(i));
    EXPECT_GT(cellsweep_capacity(made), 1000U);
    EXPECT_NE(std::string(cellsweep_engine_summary(i)), "");
    uint32_t ids[2];
    const cellsweep_aabb boxes[2] = {kCube, kCube};
    ASSERT_EQ(cellsweep_add(made, cellsweep_boxes_of(boxes, 2), ids, nullptr), CELLSWEEP_OK);
    ASSERT_EQ(cellsweep_update(made, nullptr, nullptr), CELLSWEEP_OK);
    EXPECT_EQ(pairs_of(world), (std::vector<Pair>{{0, 1}}));
  }
}

TEST(CWorlds, TellTheirStepsAndCountersUntilThereAreNoMore) {
  const World world = make_cubes(10);
  const cellsweep_statistics of = cellsweep_statistics_of(world.get());
  EXPECT_GT(of.bytes, 0U);
  EXPECT_GT(of.boxes_compared, 0U);
  ASSERT_GT(of.phase_count, 0U);
  ASSERT_GT(of.counter_count, 0U);
  for (std::size_t i = 0; i < of.phase_count; ++i) EXPECT_STRNE(cellsweep_phase_at(world.get(), i).name, "");
  for (std::size_t i = 0; i < of.counter_count; ++i)
    EXPECT_STRNE(cellsweep_counter_at(world.get(), i).name, "");
  EXPECT_EQ(cellsweep_phase_at(world.get(), of.phase_count).name, nullptr);
  EXPECT_EQ(cellsweep_counter_at(world.get(), of.counter_count).name, nullptr);
}

}  // namespace
}  // namespace cellsweep::c
