// One rank gets no memory while a checkpoint is written or read: the file of before is there, and the same
// call again writes or reads it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "cellsweep/checkpoint.h"
#include "contract/effort.h"
#include "ranks/starved_rank.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

namespace fs = std::filesystem;

class CheckpointsWithoutMemory : public testing::Test {
 protected:
  CheckpointsWithoutMemory() {
    std::array<char, 64> name{"/tmp/cellsweep-starved-checkpoints-XXXXXX"};
    if (own_rank() == 0) static_cast<void>(::mkdtemp(name.data()));
    MPI_Bcast(name.data(), name.size(), MPI_CHAR, 0, MPI_COMM_WORLD);
    folder_ = name.data();
    path_ = folder_ + "/world.h5";
    move_all(0);
  }
  ~CheckpointsWithoutMemory() override {
    MPI_Barrier(MPI_COMM_WORLD);
    if (own_rank() == 0) fs::remove_all(folder_);
  }

  /// To places that depend on `frame`.
  void move_all(std::uint32_t frame) {
    std::mt19937 random(frame);
    const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (BodyId id = 0; id < 40; ++id) {
      Aabb box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = static_cast<float>(below(17) - 8);
        box.max[axis] = box.min[axis] + static_cast<float>(1 + below(3));
      }
      ids.push_back(id);
      boxes.push_back(box);
    }
    if (frame == 0) {
      twins_.insert(0, ids, boxes);
    } else {
      twins_.move(all_ranks() - 1, ids, boxes);
    }
    ASSERT_EQ(twins_.update_and_compare(), "");
  }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// What the file holds is the world of now.
  void expect_written(const std::string& note) {
    auto read = load_checkpoint(MPI_COMM_WORLD, path_);
    ASSERT_TRUE(on_all_ranks(read.ok())) << read.status().message;
    EXPECT_EQ(read->note, note);
    twins_.world() = std::move(read->world);
    ASSERT_EQ(twins_.compare_pairs(), "");
  }

  /// HDF5 and the disk take their time.
  static contract::Places places() {
    return {contract::repeated<std::uint64_t>(60, 8), contract::repeated(3U, 11U)};
  }

  Twins twins_;
  std::string folder_;
  std::string path_;
};

TEST_F(CheckpointsWithoutMemory, ArePublishedWholeOrLeaveTheOneOfBefore) {
  std::uint32_t frame = 0;
  const std::uint64_t failures = for_each_starved_rank([&](StarvedRank& starved) {
    move_all(++frame);
    const std::string before = bytes();
    const std::vector<GlobalPair> pairs(twins_.world().pairs().begin(), twins_.world().pairs().end());
    const auto is_kept = [&] {
      return bytes() == before && std::ranges::equal(twins_.world().pairs(), pairs);
    };
    const std::string note = "frame " + std::to_string(frame) + " of a note that no string holds in itself";
    starved.call_all(
        "save_checkpoint", [&] { return save_checkpoint(twins_.world(), path_, note); }, is_kept, places());
    expect_written(note);
  });
  EXPECT_GT(failures, 30U);
}

TEST_F(CheckpointsWithoutMemory, AreReadByAllRanksOrByNone) {
  ASSERT_TRUE(
      on_all_ranks(save_checkpoint(twins_.world(), path_, "a note that no string holds in itself").ok()));
  const std::uint64_t failures = for_each_starved_rank([&](StarvedRank& starved) {
    std::optional<RestoredWorld> restored;
    starved.call_all(
        "load_checkpoint",
        [&] {
          auto read = load_checkpoint(MPI_COMM_WORLD, path_);
          contract::count_calls(false);
          if (read) restored.emplace(std::move(*read));
          return read.status();
        },
        [&] { return !restored; }, places());
    ASSERT_TRUE(on_all_ranks(restored.has_value()));
    EXPECT_EQ(restored->note, "a note that no string holds in itself");
    twins_.world() = std::move(restored->world);
    ASSERT_EQ(twins_.compare_pairs(), "");
  });
  EXPECT_GT(failures, 30U);
}

}  // namespace
}  // namespace cellsweep::ranks
