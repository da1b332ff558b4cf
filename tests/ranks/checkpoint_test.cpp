// A world that was written and read, on as many ranks or others, goes on as one engine does that was not
// stopped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "cellsweep/checkpoint.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

using testing::HasSubstr;
constexpr Aabb kBox{{0, 0, 0}, {1, 1, 1}};
namespace fs = std::filesystem;

class Checkpoints : public testing::Test {
 protected:
  Checkpoints() {
    std::array<char, 64> name{"/tmp/cellsweep-checkpoints-XXXXXX"};
    if (own_rank() == 0) static_cast<void>(::mkdtemp(name.data()));
    MPI_Bcast(name.data(), name.size(), MPI_CHAR, 0, MPI_COMM_WORLD);
    folder_ = name.data();
    path_ = folder_ + "/world.h5";
  }
  ~Checkpoints() override {
    MPI_Barrier(MPI_COMM_WORLD);
    if (own_rank() == 0) fs::remove_all(folder_);
  }

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }

  Aabb box() {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(below(25) - 12);
      box.max[axis] = box.min[axis] + static_cast<float>(below(4));
    }
    return box;
  }

  /// Some bodies move, some come, some go, some get another filter; all ranks know of it.
  void make_calls(Twins& twins) {
    std::vector<BodyId> moved;
    std::vector<BodyId> gone;
    std::vector<BodyId> kept;
    std::vector<Aabb> boxes;
    for (const BodyId id : bodies_) {
      const int choice = below(20);
      if (choice == 0) {
        gone.push_back(id);
        continue;
      }
      kept.push_back(id);
      if (choice > 10) continue;
      moved.push_back(id);
      boxes.push_back(box());
    }
    twins.move(below(all_ranks()), moved, boxes);
    twins.remove(below(all_ranks()), gone);
    std::vector<BodyId> come;
    std::vector<BodyFilter> filters;
    boxes.clear();
    for (int count = below(30); count > 0; --count) {
      come.push_back(next_++);
      boxes.push_back(box());
      filters.push_back({1U << below(3), 5, below(9) == 0});
    }
    twins.insert(below(all_ranks()), come, boxes, filters);
    kept.insert(kept.end(), come.begin(), come.end());
    bodies_ = kept;
  }

  std::string live(Twins& twins, int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      make_calls(twins);
      if (const std::string words = twins.update_and_compare(); !words.empty()) return words;
    }
    return {};
  }

  /// What all refuse.
  void expect_refused(const std::string& words) {
    const auto read = load_checkpoint(MPI_COMM_WORLD, path_);
    ASSERT_TRUE(on_all_ranks(!read.ok())) << words;
    EXPECT_EQ(read.status().code, StatusCode::bad_input);
    EXPECT_THAT(read.status().message, HasSubstr(words));
  }

  std::string bytes() {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void overwrite(const std::string& bytes) {
    MPI_Barrier(MPI_COMM_WORLD);
    if (own_rank() == 0) std::ofstream(path_, std::ios::binary) << bytes;
    MPI_Barrier(MPI_COMM_WORLD);
  }

  std::mt19937 random_{11};
  std::vector<BodyId> bodies_;
  BodyId next_ = 0;
  std::string folder_;
  std::string path_;
};

TEST_F(Checkpoints, GoOnAsIfNothingHadHappened) {
  Twins twins;
  ASSERT_EQ(live(twins, 6), "");
  for (int stop = 0; stop < 3; ++stop) {
    ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "frame " + std::to_string(stop)).ok()));
    auto read = load_checkpoint(MPI_COMM_WORLD, path_, {.recut_every = 2});
    ASSERT_TRUE(on_all_ranks(read.ok())) << read.status().message;
    EXPECT_EQ(read->note, "frame " + std::to_string(stop));
    twins.world() = std::move(read->world);
    ASSERT_EQ(twins.compare_pairs(), "");
    ASSERT_EQ(live(twins, 4), "");
  }
}

// Ranks 0 to N - 1 write it, all read it; and the other way round.
TEST_F(Checkpoints, AreReadByMoreAndByFewerRanks) {
  const int few = (all_ranks() + 1) / 2;
  MPI_Comm some = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, own_rank() < few ? 0 : MPI_UNDEFINED, 0, &some);
  Twins twins;
  ASSERT_EQ(live(twins, 5), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_).ok()));
  bool good = true;
  if (some != MPI_COMM_NULL) {
    auto read = load_checkpoint(some, path_);
    good = read.ok();
    if (good) {
      const auto pairs = read->world.gather_pairs();
      good = pairs && (own_rank() != 0 || pairs->size() == twins.whole().pairs().size()) &&
             save_checkpoint(read->world, path_, "by fewer").ok();
    }
  }
  ASSERT_TRUE(on_all_ranks(good));
  auto read = load_checkpoint(MPI_COMM_WORLD, path_);
  ASSERT_TRUE(on_all_ranks(read.ok())) << read.status().message;
  EXPECT_EQ(read->note, "by fewer");
  twins.world() = std::move(read->world);
  ASSERT_EQ(twins.compare_pairs(), "");
  ASSERT_EQ(live(twins, 4), "");
  if (some != MPI_COMM_NULL) MPI_Comm_free(&some);
}

TEST_F(Checkpoints, OfAnEmptyWorldAreReadAsOne) {
  Twins twins;
  ASSERT_EQ(twins.update_and_compare(), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "").ok()));
  auto read = load_checkpoint(MPI_COMM_WORLD, path_);
  ASSERT_TRUE(on_all_ranks(read.ok())) << read.status().message;
  EXPECT_EQ(read->note, "");
  twins.world() = std::move(read->world);
  ASSERT_EQ(live(twins, 3), "");
}

// Calls that wait are not in it, nor what an update did that was refused.
TEST_F(Checkpoints, HoldTheWorldAsOfTheLastUpdate) {
  Twins twins;
  ASSERT_EQ(live(twins, 4), "");
  const GlobalId nobody = 12345;
  std::vector<GlobalId> mine = twins.world().owned();
  mine.resize(mine.size() / 2);
  std::vector<Aabb> boxes(mine.size(), kBox);
  ASSERT_TRUE(twins.world().move(mine, boxes).ok());
  for (const bool after_refusal : {false, true}) {
    if (after_refusal) {
      if (own_rank() == 0) {
        EXPECT_TRUE(twins.world().move({&nobody, 1}, {&kBox, 1}).ok());
      }
      ASSERT_TRUE(on_all_ranks(!twins.world().update().ok()));
    }
    ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_).ok()));
    auto read = load_checkpoint(MPI_COMM_WORLD, path_);
    ASSERT_TRUE(on_all_ranks(read.ok())) << read.status().message;
    if (!after_refusal) continue;
    twins.world() = std::move(read->world);
    ASSERT_EQ(twins.compare_pairs(), "");
    ASSERT_EQ(live(twins, 3), "");
  }
}

TEST_F(Checkpoints, OfOneWorldAreTheSameFile) {
  Twins twins;
  ASSERT_EQ(live(twins, 3), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "note").ok()));
  const std::string first = bytes();
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "note").ok()));
  EXPECT_EQ(bytes(), first);
}

TEST_F(Checkpoints, ThatWereChangedInAnyByteAreRefused) {
  Twins twins;
  ASSERT_EQ(live(twins, 3), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "note").ok()));
  const std::string good = bytes();
  // Few of them on many ranks, which take their time.
  const std::size_t step = all_ranks() > 4 ? good.size() / 6 : good.size() / 60;
  for (std::size_t at = 0; at < good.size(); at += at < 512 && all_ranks() <= 4 ? 37 : 1 + step) {
    std::string changed = good;
    changed[at] = static_cast<char>(changed[at] ^ 1 << at % 8);
    overwrite(changed);
    expect_refused(path_);
  }
  overwrite(good);
  EXPECT_TRUE(on_all_ranks(load_checkpoint(MPI_COMM_WORLD, path_).ok()));
}

TEST_F(Checkpoints, OfAnotherLengthAreRefusedWithBothLengths) {
  Twins twins;
  ASSERT_EQ(live(twins, 3), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_).ok()));
  const std::string good = bytes();
  for (const std::size_t size : {good.size() - 1, good.size() / 2, std::size_t{512}}) {
    overwrite(good.substr(0, size));
    expect_refused("was cut short since it was written: it has " + std::to_string(size) + " bytes, not " +
                   std::to_string(good.size()));
  }
  overwrite(good + "x");
  expect_refused("was made longer");
  for (const std::size_t size : {0, 20}) {
    overwrite(good.substr(0, size));
    expect_refused("is no checkpoint of cellsweep");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (own_rank() == 0) fs::remove(path_);
  MPI_Barrier(MPI_COMM_WORLD);
  expect_refused("Cannot read");
}

TEST_F(Checkpoints, ThatCannotBeWrittenLeaveTheOneBefore) {
  Twins twins;
  ASSERT_EQ(live(twins, 3), "");
  ASSERT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "first").ok()));
  const std::string first = bytes();
  const auto refused = [&](const std::string& path, std::string_view note) {
    const Status status = save_checkpoint(twins.world(), path, note);
    EXPECT_TRUE(on_all_ranks(!status.ok()));
    return status;
  };
  EXPECT_EQ(refused(folder_, "").code, StatusCode::bad_input);
  EXPECT_THAT(refused(folder_ + "/none/world.h5", "").message, HasSubstr("No such file or directory"));
  EXPECT_EQ(refused(path_, std::string(kMostCheckpointNote + 1, 'x')).setting, "note");
  EXPECT_EQ(bytes(), first);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
  EXPECT_TRUE(on_all_ranks(save_checkpoint(twins.world(), path_, "second").ok()));
}

}  // namespace
}  // namespace cellsweep::ranks
