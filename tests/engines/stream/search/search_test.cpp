/// @file
/// Cells that are prepared for a later update.
#include "engines/stream/search/search.h"

#include <gmock/gmock.h>

#include <vector>

#include "base/threads/thread_pool.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using testing::IsEmpty;
using testing::Not;

class SearchTest : public testing::Test {
 protected:
  void find_all() {
    FatBoxes no_fat_boxes(0);
    search_.find_all(no_fat_boxes, boxes_, 0);
  }

  void prepare() {
    const Boxes boxes(boxes_.data(), boxes_.size());
    search_.begin_prepared(boxes);
    search_.prepared().fill_cells(boxes, 1);
    while (!search_.prepared().is_built()) search_.prepared().go_on(1000);
  }

  const std::vector<Aabb> boxes_ = uniform_boxes(4000 / kScale, 1);
  Crew crew_{std::make_shared<ThreadPool>(1), 1, Crew::Choice::given};
  Search search_{crew_, *find_kernels(VectorIsa::best), nullptr, Search::kAnyNumber};
};

TEST_F(SearchTest, PreparedCellsFindWhatOthersFind) {
  find_all();
  const std::size_t pairs = count_keys(search_.found());
  prepare();
  EXPECT_EQ(count_keys(search_.prepared().found()), pairs);
  search_.use_prepared();
  EXPECT_EQ(count_keys(search_.found()), pairs);
}

// Also when nobody allows anything after they were begun.
TEST_F(SearchTest, PreparedCellsLeaveOutWhatFiltersDoNotAllow) {
  const std::vector<BodyFilter> all_static(boxes_.size(), BodyFilter{.is_static = true});
  find_all();
  EXPECT_THAT(search_.found(), Not(IsEmpty()));
  search_.allow(all_static);
  prepare();
  EXPECT_EQ(count_keys(search_.prepared().found()), 0U);
}

}  // namespace
}  // namespace cellsweep::stream
