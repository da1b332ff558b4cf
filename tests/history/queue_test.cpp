#include "history/queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;

bool holds(const Queue<int>& queue, const std::deque<int>& truth) {
  return queue.size() == truth.size() && std::ranges::equal(queue.view(), truth);
}

TEST(Queue, HasWhatWasPushedAndNotPopped) {
  Random random(1);
  Queue<int> queue;
  std::deque<int> truth;
  int next = 0;
  for (int step = 0; step < 3000; ++step) {
    const std::size_t more = random.below(9);
    queue.make_room(more);
    for (std::size_t i = 0; i < more; ++i) {
      queue.push(next);
      truth.push_back(next++);
    }
    const std::size_t gone =
        random.one_in(20) ? truth.size() : random.below(std::min<std::size_t>(truth.size(), 9) + 1);
    queue.pop(gone);
    truth.erase(truth.begin(), truth.begin() + static_cast<std::ptrdiff_t>(gone));
    ASSERT_TRUE(holds(queue, truth)) << "after " << step << " steps";
  }
}

TEST(Queue, IsAsItWasWhenThereIsNoMemoryForMore) {
  const auto make = [] {
    auto queue = std::make_unique<Queue<int>>();
    queue->make_room(4);
    for (int i = 0; i < 4; ++i) queue->push(i);
    queue->pop(3);
    return queue;
  };
  const auto is_kept = [](const auto& queue) { EXPECT_TRUE(holds(*queue, {3})); };
  EXPECT_GE(starve(
                make, [](const auto& queue) { queue->make_room(1000); }, is_kept, is_kept),
            1U);
}

}  // namespace
}  // namespace cellsweep
