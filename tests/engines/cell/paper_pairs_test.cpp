/// @file
/// The pair manager of cell-paper (C15).
#include "engines/cell/ppu/paper_pairs.h"

#include <gmock/gmock.h>

#include "engines/cell/wire.h"

namespace cellsweep::cell {
namespace {

/// Three bodies and a way to say what one axis reports.
class PaperPairsTest : public testing::Test {
 protected:
  PaperPairsTest() {
    for (std::uint32_t id = 1; id <= 3; ++id) pairs_.add_body(id);
  }

  void overlap_on(std::size_t axis, const std::vector<std::uint32_t>& keys) {
    pairs_.apply(axis, keys, true);
  }

  /// The pairs that changed, as (smaller, larger, colliding now).
  std::vector<std::tuple<int, int, bool>> commit() {
    PaperPairs::Changed changed;
    pairs_.commit(changed);
    std::vector<std::tuple<int, int, bool>> list;
    for (const auto& pair : changed) list.emplace_back(pair.aID, pair.bID, pair.colliding());
    return list;
  }

  PaperPairs pairs_;
  const std::uint32_t key_12_ = pair_key_of_ids(1, 2);
  const std::uint32_t key_13_ = pair_key_of_ids(1, 3);
};

using Changes = std::vector<std::tuple<int, int, bool>>;

TEST_F(PaperPairsTest, APairCollidesWhenAllThreeAxesOverlap) {
  overlap_on(0, {key_12_});
  overlap_on(1, {key_12_});
  EXPECT_EQ(commit(), Changes{});
  overlap_on(2, {key_12_});
  EXPECT_EQ(commit(), (Changes{{1, 2, true}}));
}

TEST_F(PaperPairsTest, ClearingAChangedIdEndsItsPairsUnlessTheirKeysComeAgain) {
  for (std::size_t axis = 0; axis < 3; ++axis) overlap_on(axis, {key_12_, key_13_});
  EXPECT_EQ(commit().size(), 2U);
  const std::vector<std::uint32_t> changed = {1};
  pairs_.clear_earlier(1, changed);
  overlap_on(1, {key_13_});
  EXPECT_EQ(commit(), (Changes{{1, 2, false}}));
}

TEST_F(PaperPairsTest, KeysOfPairsApartEndThem) {
  for (std::size_t axis = 0; axis < 3; ++axis) overlap_on(axis, {key_12_});
  commit();
  pairs_.apply(0, std::vector<std::uint32_t>{key_12_}, false);
  EXPECT_EQ(commit(), (Changes{{1, 2, false}}));
}

TEST_F(PaperPairsTest, ARemovedBodyTakesItsPairsAlongAndComesBackWithoutThem) {
  for (std::size_t axis = 0; axis < 3; ++axis) overlap_on(axis, {key_12_, key_13_});
  commit();
  PaperPairs::Changed ended;
  pairs_.remove_body(2, ended);
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_EQ(pairs_.size(), 1U);
  pairs_.add_body(2);
  EXPECT_EQ(pairs_.size(), 3U);
  overlap_on(0, {key_12_});
  EXPECT_EQ(commit(), Changes{}) << "the other axes were forgotten";
}

}  // namespace
}  // namespace cellsweep::cell
