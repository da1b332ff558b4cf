#include "base/memory/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <new>

#include "engines/oracle/brute_force.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// An engine that runs out of memory once, at the n-th time that it asks for some, and is then asked again.
class StarvedEngine {
 public:
  StarvedEngine(const EngineOptions& options, std::size_t bodies)
      : ids_(ids_below(bodies)), boxes_(uniform_boxes(bodies, 1)) {
    engine_ = engine_with(boxes_, options);
    EXPECT_TRUE(engine_->update().ok());
    move_all(0.05F, 2);
    EXPECT_TRUE(engine_->update().ok());
    pairs_.assign(engine_->pairs().begin(), engine_->pairs().end());
  }
  ~StarvedEngine() { let_memory_fail(0); }

  /// Does everything that there is; true when memory failed.
  bool run(std::uint64_t n) {
    let_memory_fail(n);
    add(300);
    update();
    try_twice([&] { move_all(0.05F, 3); });
    update();
    try_twice([&] { move_all(3, 4); });
    update();
    remove_all_but(60);
    update();
    add(1'000'000);
    update();
    let_memory_fail(0);
    return failures_ > 0;
  }

 private:
  void try_twice(const std::function<void()>& call) {
    try {
      return call();
    } catch (const std::bad_alloc&) {
      ++failures_;
    }
    EXPECT_TRUE(std::ranges::equal(engine_->pairs(), pairs_));
    call();
  }

  void update() {
    try_twice([&] {
      const auto changes = engine_->update();
      ASSERT_TRUE(changes.ok());
      std::vector<Pair> old;
      std::ranges::set_difference(pairs_, changes->ended, std::back_inserter(old));
      pairs_.clear();
      std::ranges::merge(old, changes->began, std::back_inserter(pairs_));
    });
    EXPECT_TRUE(std::ranges::equal(engine_->pairs(), pairs_));
    std::vector<Pair> truth;
    for (const auto [a, b] : brute_force_pairs(boxes_)) truth.push_back(make_pair_of(ids_[a], ids_[b]));
    std::ranges::sort(truth);
    EXPECT_TRUE(std::ranges::equal(pairs_, truth));
  }

  void move_all(float step, std::uint64_t seed) {
    std::vector<Aabb> moved = boxes_;
    shake(moved, step, seed);
    ASSERT_TRUE(engine_->move(ids_, moved).ok());
    boxes_ = moved;
  }

  void add(BodyId first) {
    const std::vector<Aabb> more = uniform_boxes(100, first);
    std::vector<BodyId> ids = ids_below(more.size());
    for (BodyId& id : ids) id = first + 7 * id;
    try_twice([&] { ASSERT_TRUE(engine_->insert(ids, more).ok()); });
    ids_.insert(ids_.end(), ids.begin(), ids.end());
    boxes_.insert(boxes_.end(), more.begin(), more.end());
  }

  void remove_all_but(std::size_t kept) {
    const std::vector<BodyId> ids(ids_.begin() + static_cast<std::ptrdiff_t>(kept), ids_.end());
    try_twice([&] { ASSERT_TRUE(engine_->remove(ids).ok()); });
    ids_.resize(kept);
    boxes_.resize(kept);
  }

  std::unique_ptr<Broadphase> engine_;
  std::vector<BodyId> ids_;
  std::vector<Aabb> boxes_;
  std::vector<Pair> pairs_;
  int failures_ = 0;
};

TEST(StreamOutOfMemory, LeavesAllAsItWasWhereverItHappens) {
  for (const unsigned threads : {1U, 3U}) {
    std::uint64_t n = 1;
    while (StarvedEngine({.threads = threads}, 240).run(n)) ++n;
    EXPECT_GT(n, 20U) << "memory is asked for in fewer places than there are";
  }
}

}  // namespace
}  // namespace cellsweep::stream
