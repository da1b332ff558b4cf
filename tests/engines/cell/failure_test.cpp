/// @file
/// What becomes of an engine whose SPEs fail: a status, the state of the update before, and new SPEs at the
/// next update.
#include <gmock/gmock.h>

#include <functional>

#include "cellsweep/engine/engine.h"
#include "engines/cell/cell_world.h"
#include "engines/cell/passing_emulation.h"
#include "engines/cell/ppu/brute.h"
#include "engines/cell/ppu/paper.h"
#include "engines/cell/ppu/resident.h"
#include "engines/cell/ppu/stream_spes.h"
#include "engines/oracle/brute_force.h"
#include "engines/stream/make_stream.h"

namespace cellsweep::cell {
namespace {

using contract::Random;
using testing::HasSubstr;
using testing::IsEmpty;

/// SPEs with so much local store, of which twice as much is promised; the second time as they should be.
class BoastsOnce {
 public:
  explicit BoastsOnce(std::uint64_t local_store) : local_store_(local_store) {}

  std::shared_ptr<Emulation> next() {
    if (times_++ > 0) return *make_emulation({});
    return std::make_shared<Boaster>(*make_emulation({.local_store = local_store_}));
  }

  int times() const { return times_; }

 private:
  std::uint64_t local_store_;
  int times_ = 0;
};

struct Failing {
  std::string name;
  std::uint64_t local_store;  // with twice as much there is more room than bodies
  Result<Broadphase> (*make)(std::shared_ptr<BoastsOnce> spes);
};

void PrintTo(const Failing& failing, std::ostream* out) {
  *out << failing.name;
}

template <class Engine_, class Options>
Result<Broadphase> make_engine(std::shared_ptr<BoastsOnce> spes) {
  return EngineAccess::make("tested", [spes] { return Engine_::make(Options{}, spes->next()); });
}

Result<Broadphase> make_stream(std::shared_ptr<BoastsOnce> spes) {
  const auto maker = [spes] { return StreamSpes::make({}, spes->next()); };
  return stream::make_stream_broadphase({}, "tested", maker, "tested");
}

const Failing kFailing[] = {{"paper", 128 << 10, make_engine<Paper, CellPaperOptions>},
                            {"brute", 96 << 10, make_engine<Brute, CellBruteOptions>},
                            {"stream", 80 << 10, make_stream}};

class SpeFailure : public testing::TestWithParam<Failing> {
 protected:
  std::shared_ptr<BoastsOnce> spes_ = std::make_shared<BoastsOnce>(GetParam().local_store);
};

TEST_P(SpeFailure, LeavesTheUpdateBeforeAndIsMendedByTheNextOne) {
  Broadphase engine = std::move(*GetParam().make(spes_));
  Random random(1);
  const std::vector<Aabb> boxes = random_boxes(random, 2000);
  const std::vector<BodyId> ids = ids_up_to(boxes.size());
  ASSERT_TRUE(engine.insert(ids, boxes).ok());
  const Status failed = engine.update().status();
  EXPECT_EQ(failed.code, StatusCode::spe_failed);
  EXPECT_THAT(failed.message, HasSubstr("local store"));
  EXPECT_THAT(engine.pairs(), IsEmpty());
  EXPECT_EQ(engine.size(), boxes.size());
  EXPECT_EQ(spes_->times(), 1);
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_EQ(spes_->times(), 2);
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(ids, boxes));
  EXPECT_EQ(changes->began.size(), engine.pairs().size());
  EXPECT_EQ(engine.statistics().updates, 1U);
}

INSTANTIATE_TEST_SUITE_P(Engines, SpeFailure, testing::ValuesIn(kFailing),
                         [](const auto& test) { return test.param.name; });

/// Of engines whose SPEs can do a little work before they fail.
using LateSpeFailure = SpeFailure;

TEST_P(LateSpeFailure, KeepsWhatWasFoundBefore) {
  Broadphase engine = std::move(*GetParam().make(spes_));
  ASSERT_TRUE(engine.insert(ids_up_to(2), std::vector<Aabb>{cube(0), cube(0.5F)}).ok());
  ASSERT_TRUE(engine.update().ok());
  Random random(2);
  std::vector<BodyId> more = ids_up_to(2000);
  more.erase(more.begin(), more.begin() + 2);
  std::vector<Aabb> boxes = random_boxes(random, more.size());
  ASSERT_TRUE(engine.insert(more, boxes).ok());
  ASSERT_TRUE(engine.remove(0).ok());
  ASSERT_EQ(engine.update().status().code, StatusCode::spe_failed);
  EXPECT_THAT(engine.pairs(), testing::ElementsAre(Pair{0, 1}));
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_THAT(changes->ended, testing::ElementsAre(Pair{0, 1}));
  more.insert(more.begin(), 1);
  boxes.insert(boxes.begin(), cube(0.5F));
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(more, boxes));
}

INSTANTIATE_TEST_SUITE_P(Engines, LateSpeFailure, testing::Values(kFailing[0], kFailing[1]),
                         [](const auto& test) { return test.param.name; });

/// cell-resident on SPEs that can be told to end.
class ResidentFailure : public testing::Test {
 protected:
  ResidentFailure()
      : engine_(std::move(*EngineAccess::make("cell-resident", [this] {
          spes_ = std::make_shared<KnownSpes>(*make_emulation({}));
          ++times_;
          return Resident::make({.spu_boxes = true}, spes_);
        }))) {}

  void SetUp() override {
    ASSERT_TRUE(engine_.insert(ids_up_to(3), std::vector<Aabb>{cube(0), cube(0.5F), cube(9)}).ok());
    ASSERT_TRUE(engine_.update().ok());
  }

  // As if its program had ended by itself.
  void end_a_program() {
    unsigned word = resident_word(ResidentOrder::stop, 0);
    ASSERT_EQ(spe_in_mbox_write(spes_->context(1), &word, 1, SPE_MBOX_ALL_BLOCKING), 1);
  }

  void expect_a_mend(std::size_t pairs) {
    const auto changes = engine_.update();
    ASSERT_TRUE(changes.ok()) << changes.status().message;
    EXPECT_EQ(times_, 2);
    EXPECT_EQ(engine_.pairs().size(), pairs);
  }

  std::shared_ptr<KnownSpes> spes_;
  int times_ = 0;
  Broadphase engine_;
};

TEST_F(ResidentFailure, OfAnUpdateIsMendedByTheNextOne) {
  end_a_program();
  ASSERT_TRUE(engine_.move(2, cube(0.25F)).ok());
  const Status failed = engine_.update().status();
  EXPECT_EQ(failed.code, StatusCode::spe_failed);
  EXPECT_THAT(failed.message, HasSubstr("SPE 1 ended without an answer"));
  EXPECT_EQ(failed.number, 1U);
  EXPECT_THAT(engine_.pairs(), testing::ElementsAre(Pair{0, 1}));
  expect_a_mend(3);
}

TEST_F(ResidentFailure, OfBoxesMadeFromPosesFailsTheNextUpdateSoThatTheOneAfterItHasNewSpes) {
  end_a_program();
  const BodyId id = 7;
  const BodyPose pose{{0.5F, 0.5F, 0.5F}, {0.25F, 0.25F, 0.25F}};
  EXPECT_EQ(insert_poses(engine_, {&id, 1}, {&pose, 1}).code, StatusCode::spe_failed);
  EXPECT_EQ(insert_poses(engine_, {&id, 1}, {&pose, 1}).code, StatusCode::spe_failed);
  EXPECT_FALSE(engine_.contains(id));
  EXPECT_EQ(engine_.update().status().code, StatusCode::spe_failed);
  expect_a_mend(1);
  ASSERT_TRUE(insert_poses(engine_, {&id, 1}, {&pose, 1}).ok());
  expect_a_mend(3);
}

TEST_F(ResidentFailure, IsNoMatterWhenNothingIsAskedOfTheSpes) {
  end_a_program();
  EXPECT_TRUE(engine_.update().ok());
}

TEST(SpesThatAreNotThere, AreAStatusAndNoHang) {
  for (int few = 0; few < 3; ++few) {
    const auto spes = [few] { return std::make_shared<FewSpes>(*make_emulation({}), few); };
    EXPECT_EQ(Paper::make({}, spes()).status().code, StatusCode::spe_failed);
    EXPECT_EQ(Brute::make({}, spes()).status().code, StatusCode::spe_failed);
    EXPECT_EQ(Resident::make({}, spes()).status().code, StatusCode::spe_failed);
    EXPECT_EQ(StreamSpes::make({}, spes()).status().code, StatusCode::spe_failed);
  }
}

TEST(SpesThatFailAtOnce, AreAStatusWithTheRuleThatTheyBroke) {
  const auto engine = Resident::make({}, std::make_shared<Boaster>(*make_emulation({})));
  ASSERT_FALSE(engine.ok());
  EXPECT_EQ(engine.status().code, StatusCode::spe_failed);
  EXPECT_THAT(engine.status().message, HasSubstr("local store"));
}

}  // namespace
}  // namespace cellsweep::cell
