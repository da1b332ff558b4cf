/// @file
/// What becomes of an engine whose SPEs fail: a status, the state of the update before, and new SPEs at the
/// next update.
#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "cellsweep/engine/engine.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/cell/cell_world.h"
#include "engines/cell/passing_emulation.h"
#include "engines/cell/ppu/brute.h"
#include "engines/cell/ppu/paper.h"
#include "engines/cell/ppu/resident.h"
#include "engines/cell/ppu/stream_spes.h"
#include "engines/oracle/brute_force.h"

extern "C" spe_program_handle_t cell_failing_spu;

namespace cellsweep::cell {
namespace {

using contract::Random;
using testing::HasSubstr;
using testing::IsEmpty;

/// SPEs that are none the first time, and the second time as they should be.
class MendedSpes {
 public:
  explicit MendedSpes(std::shared_ptr<Emulation> first) : first_(std::move(first)) {}

  std::shared_ptr<Emulation> next() { return times_++ == 0 ? first_ : *make_emulation({}); }
  int times() const { return times_; }

 private:
  std::shared_ptr<Emulation> first_;
  int times_ = 0;
};

struct Failing {
  std::string name;
  Result<Broadphase> (*make)(std::shared_ptr<MendedSpes> spes);
};

void PrintTo(const Failing& failing, std::ostream* out) {
  *out << failing.name;
}

template <class TestedEngine, class Options>
Result<Broadphase> make_engine(std::shared_ptr<MendedSpes> spes) {
  return EngineAccess::make("tested", [spes] { return TestedEngine::make(Options{}, spes->next()); });
}

Result<Broadphase> make_stream(std::shared_ptr<MendedSpes> spes) {
  const auto maker = [spes] { return StreamSpes::make({}, spes->next()); };
  return stream::make_stream_broadphase({}, "tested", maker, "tested");
}

const Failing kPaper = {"paper", make_engine<Paper, CellPaperOptions>};
const Failing kBrute = {"brute", make_engine<Brute, CellBruteOptions>};
const Failing kStream = {"stream", make_stream};

using SpeFailure = testing::TestWithParam<Failing>;

TEST_P(SpeFailure, LeavesNothingBehindAndIsMendedByTheNextUpdate) {
  const auto spes =
      std::make_shared<MendedSpes>(std::make_shared<WrongProgram>(*make_emulation({}), cell_failing_spu));
  Broadphase engine = std::move(*GetParam().make(spes));
  Random random(1);
  const std::vector<Aabb> boxes = random_boxes(random, 300);
  const std::vector<BodyId> ids = ids_up_to(boxes.size());
  ASSERT_TRUE(engine.insert(ids, boxes).ok());
  const Status failed = engine.update().status();
  EXPECT_EQ(failed.code, StatusCode::spe_failed);
  EXPECT_THAT(failed.message, HasSubstr("its program ended with code 7"));
  EXPECT_THAT(engine.pairs(), IsEmpty());
  EXPECT_EQ(engine.size(), boxes.size());
  EXPECT_EQ(spes->times(), 1);
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_EQ(spes->times(), 2);
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(ids, boxes));
  EXPECT_EQ(changes->began.size(), engine.pairs().size());
  EXPECT_EQ(engine.statistics().updates, 1U);
}

INSTANTIATE_TEST_SUITE_P(Engines, SpeFailure, testing::Values(kPaper, kBrute, kStream),
                         [](const auto& test) { return test.param.name; });

/// Of SPEs that can do a little work before they fail.
using LateSpeFailure = testing::TestWithParam<Failing>;

TEST_P(LateSpeFailure, KeepsWhatWasFoundBefore) {
  const auto spes = std::make_shared<MendedSpes>(
      std::make_shared<Boaster>(*make_emulation({.local_store = std::uint64_t{112} << 10})));
  Broadphase engine = std::move(*GetParam().make(spes));
  ASSERT_TRUE(engine.insert(ids_up_to(2), std::vector<Aabb>{cube(0), cube(0.5F)}).ok());
  ASSERT_TRUE(engine.update().ok());
  Random random(2);
  const auto seemingly_fit = static_cast<std::size_t>(engine.capacity().bodies);
  std::vector<BodyId> ids = ids_up_to(seemingly_fit);
  std::vector<Aabb> boxes = random_boxes(random, seemingly_fit);
  boxes[1] = cube(0.5F);
  ASSERT_TRUE(engine.insert(std::span(ids).subspan(2), std::span(boxes).subspan(2)).ok());
  ASSERT_TRUE(engine.remove(0).ok());
  const Status failed = engine.update().status();
  ASSERT_EQ(failed.code, StatusCode::spe_failed);
  EXPECT_THAT(failed.message, HasSubstr("local store"));
  EXPECT_THAT(engine.pairs(), testing::ElementsAre(Pair{0, 1}));
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_THAT(changes->ended, testing::ElementsAre(Pair{0, 1}));
  ids.erase(ids.begin());
  boxes.erase(boxes.begin());
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(ids, boxes));
}

INSTANTIATE_TEST_SUITE_P(Engines, LateSpeFailure, testing::Values(kPaper, kBrute),
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

// An update that had been answered is not the one to be told, and to the next one there is memory again.
TEST(ResidentSpesWithoutMemory, AreReplacedBeforeTheNextUpdate) {
  std::vector<std::shared_ptr<SpeechlessSpes>> made;
  Broadphase engine = std::move(*EngineAccess::make("cell-resident", [&] {
    made.push_back(std::make_shared<SpeechlessSpes>(*make_emulation({})));
    return Resident::make({}, made.back());
  }));
  ASSERT_TRUE(engine.insert(ids_up_to(3), std::vector<Aabb>{cube(0), cube(0.5F), cube(9)}).ok());
  ASSERT_TRUE(engine.update().ok());
  const Engine& inside = EngineAccess::engine_of(engine);
  EXPECT_FALSE(inside.ran_out_of_memory());
  unsigned poses_that_nobody_gave = resident_word(ResidentOrder::bound, kLanes);
  ASSERT_EQ(spe_in_mbox_write(made[0]->context(1), &poses_that_nobody_gave, 1, SPE_MBOX_ALL_BLOCKING), 1);
  while (!inside.ran_out_of_memory()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(engine.move(2, cube(0.25F)).ok());
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_EQ(made.size(), 2U);
  EXPECT_EQ(engine.pairs().size(), 3U);
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

TEST(SpesThatFailAtOnce, AreAStatusWithTheirCode) {
  const auto wrong = std::make_shared<WrongProgram>(*make_emulation({}), cell_failing_spu);
  const Status status = Resident::make({}, wrong).status();
  EXPECT_EQ(status.code, StatusCode::spe_failed);
  EXPECT_THAT(status.message, HasSubstr("its program ended with code 7"));
}

TEST(SpesThatFailAtOnce, AreAStatusWithTheRuleThatTheyBroke) {
  const auto engine = Resident::make({}, std::make_shared<Boaster>(*make_emulation({})));
  ASSERT_FALSE(engine.ok());
  EXPECT_EQ(engine.status().code, StatusCode::spe_failed);
  EXPECT_THAT(engine.status().message, HasSubstr("local store"));
}

}  // namespace
}  // namespace cellsweep::cell
