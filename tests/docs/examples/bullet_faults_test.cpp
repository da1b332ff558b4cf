/// @file
/// The broadphase for Bullet of docs/examples where memory ends.
#include <LinearMath/btAabbUtil2.h>
#include <LinearMath/btAlignedAllocator.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <vector>

#include "cellsweep_broadphase.h"
#include "contract/faults/starved_call.h"

namespace cellsweep::contract {
namespace {

/// Bullet goes on without asking whether it got what it asked for: its own memory does not fail. No call that
/// a fault stands in for.
void* memory_for_bullet(std::size_t bytes, int alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit);
}

/// Boxes in a row, each of which overlaps the next.
class Row {
 public:
  explicit Row(btScalar margin) : broadphase_({}, margin) {
    proxies_.reserve(200);  // for all that tests create: the list's own memory does not fail either
    for (int i = 0; i < 40; ++i) create();
  }

  void create() {
    const auto x = static_cast<btScalar>(next_++);
    proxies_.push_back(broadphase_.createProxy({x, 0, 0}, {x + btScalar(1.5), 1, 1}, BOX_SHAPE_PROXYTYPE,
                                               nullptr, 1, -1, nullptr));
  }

  void move_all() {
    for (btBroadphaseProxy* const proxy : proxies_) {
      const btVector3 step(0, btScalar(proxy->m_uniqueId % 3) * btScalar(0.6), 0);
      broadphase_.setAabb(proxy, proxy->m_aabbMin + step, proxy->m_aabbMax + step, nullptr);
    }
  }

  void destroy() {
    broadphase_.destroyProxy(proxies_.front(), nullptr);
    proxies_.erase(proxies_.begin());
  }

  Status find_pairs() {
    broadphase_.calculateOverlappingPairs(nullptr);
    return broadphase_.status();
  }

  int pairs() { return broadphase_.getOverlappingPairCache()->getNumOverlappingPairs(); }

  /// What `pairs()` must be for the boxes that the proxies say they have.
  int overlaps() const {
    int overlaps = 0;
    for (std::size_t i = 0; i < proxies_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        overlaps += TestAabbAgainstAabb2(proxies_[i]->m_aabbMin, proxies_[i]->m_aabbMax,
                                         proxies_[j]->m_aabbMin, proxies_[j]->m_aabbMax);
    }
    return overlaps;
  }

 private:
  CellsweepBroadphase broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
  int next_ = 0;
};

/// With a margin that is too small for more pairs, and without.
class BulletBroadphaseStarved : public testing::TestWithParam<float> {
 protected:
  BulletBroadphaseStarved() { btAlignedAllocSetCustomAligned(memory_for_bullet, std::free); }
  ~BulletBroadphaseStarved() override { btAlignedAllocSetCustomAligned(nullptr, nullptr); }

  /// Whatever became of `call(row)`: the next step has the pairs of the boxes that the proxies have.
  template <class Call>
  std::uint64_t starve(const Call& call) {
    std::optional<Row> row;
    const auto begin = [&] {
      row.emplace(GetParam());
      EXPECT_TRUE(row->find_pairs().ok());
    };
    const auto look = [&](bool) { return row->find_pairs().ok() && row->pairs() == row->overlaps(); };
    return starve_each(
        Scarce::memory, Lasts::once, begin, [&] { return call(*row); }, look);
  }
};

TEST_P(BulletBroadphaseStarved, AddsAProxyOrNone) {
  EXPECT_GT(starve([](Row& row) {
              for (int i = 0; i < 100; ++i) row.create();
              return Status();
            }),
            3);
}

TEST_P(BulletBroadphaseStarved, MovesAndForgetsProxiesWithoutAskingForMemory) {
  EXPECT_EQ(starve([](Row& row) {
              row.move_all();
              row.destroy();
              row.move_all();
              return Status();
            }),
            0);
}

TEST_P(BulletBroadphaseStarved, FindsPairsWhenItIsAskedAgain) {
  EXPECT_GT(starve([](Row& row) {
              row.create();
              row.move_all();
              row.destroy();
              return row.find_pairs();
            }),
            3);
}

INSTANTIATE_TEST_SUITE_P(Margins, BulletBroadphaseStarved, testing::Values(0.0F, 0.01F),
                         [](const auto& of) { return of.param > 0 ? "Some" : "None"; });

}  // namespace
}  // namespace cellsweep::contract
