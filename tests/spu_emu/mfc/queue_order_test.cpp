// The order in which late transfers land: exactly the orders that fences and barriers allow.
#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "test_spu.h"

namespace spu_emu {
namespace {

/// One command of a test program: its tag and variant, or the barrier for all tags.
struct Step {
  enum class Kind { plain, fence, tag_barrier, queue_barrier };
  Kind kind = Kind::plain;
  std::uint32_t tag = 0;
};

using Order = std::vector<int>;

/// The rule as HARDWARE documents it, written independently of the queue: may `later` overtake `earlier`?
bool may_overtake(const Step& later, const Step& earlier) {
  if (later.kind == Step::Kind::queue_barrier || earlier.kind == Step::Kind::queue_barrier) return false;
  if (later.tag != earlier.tag) return true;
  return later.kind == Step::Kind::plain && earlier.kind != Step::Kind::tag_barrier;
}

bool is_legal(const std::vector<Step>& steps, const Order& order) {
  for (std::size_t a = 0; a < order.size(); ++a) {
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const int first = order[a];
      const int second = order[b];
      if (second < first &&
          !may_overtake(steps[static_cast<std::size_t>(first)], steps[static_cast<std::size_t>(second)])) {
        return false;
      }
    }
  }
  return true;
}

/// Notes each transfer as it lands; barriers move nothing and so cannot be seen to land elsewhere.
class Recorder : public ActivityLog {
 public:
  void transfer(const Command& command, std::uint64_t, TraceTime, TraceTime) override {
    order.push_back(static_cast<int>(command.where.line));
  }
  void wait(const char*, TraceTime) override {}
  Order order;
};

Order run(const std::vector<Step>& steps, std::uint64_t seed) {
  TestSpu spu;
  Recorder recorder;
  CommandQueue queue(spu.store, {Issuer::spu, DmaMode::late, seed, nullptr, &recorder});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Command command{MFC_PUT_CMD,
                    steps[i].tag,
                    16,
                    static_cast<std::uint32_t>(0x1000 + i * 16),
                    spu.ea(i * 16),
                    {"", static_cast<int>(i)}};
    if (steps[i].kind == Step::Kind::fence) command.opcode = MFC_PUTF_CMD;
    if (steps[i].kind == Step::Kind::tag_barrier) command.opcode = MFC_PUTB_CMD;
    if (steps[i].kind == Step::Kind::queue_barrier) command.opcode = MFC_BARRIER_CMD;
    queue.issue(command);
  }
  queue.land_all();
  return recorder.order;
}

std::vector<Step> random_steps(std::mt19937& random, std::size_t count) {
  std::vector<Step> steps(count);
  for (Step& step : steps) {
    const unsigned pick = random() % 8;
    step.kind = pick < 4   ? Step::Kind::plain
                : pick < 6 ? Step::Kind::fence
                : pick < 7 ? Step::Kind::tag_barrier
                           : Step::Kind::queue_barrier;
    step.tag = random() % 3;
  }
  return steps;
}

TEST(QueueOrder, every_observed_order_is_legal) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 400; ++trial) {
    const auto steps = random_steps(random, 1 + random() % 16);
    const Order order = run(steps, random());
    ASSERT_EQ(order.size(), steps.size());
    EXPECT_TRUE(is_legal(steps, order)) << "trial " << trial;
  }
}

// Ten thousand queues take a minute under a sanitizer.
#ifdef SPU_EMU_SANITIZED_TESTS
constexpr int kTrialsOfAllOrders = 5;
#else
constexpr int kTrialsOfAllOrders = 25;
#endif

TEST(QueueOrder, every_legal_order_of_four_commands_happens_for_some_seed) {
  std::mt19937 random(11);
  for (int trial = 0; trial < kTrialsOfAllOrders; ++trial) {
    const auto steps = random_steps(random, 4);
    std::set<Order> legal;
    Order order{0, 1, 2, 3};
    do {
      if (is_legal(steps, order)) legal.insert(order);
    } while (std::next_permutation(order.begin(), order.end()));
    std::set<Order> seen;
    for (std::uint64_t seed = 0; seed < 400; ++seed) seen.insert(run(steps, seed));
    EXPECT_EQ(seen, legal) << "trial " << trial;
  }
}

TEST(QueueOrder, the_same_seed_gives_the_same_order) {
  const std::vector<Step> steps(16);
  EXPECT_EQ(run(steps, 77), run(steps, 77));
  EXPECT_NE(run(steps, 77), run(steps, 78));
}

TEST(QueueOrder, a_wait_for_one_tag_keeps_the_order_of_a_queue_barrier) {
  TestSpu spu;
  Recorder recorder;
  CommandQueue queue(spu.store, {Issuer::spu, DmaMode::late, 3, nullptr, &recorder});
  queue.issue({MFC_GET_CMD, 1, 16, 0x1000, spu.ea(), {"", 0}});
  queue.issue({MFC_BARRIER_CMD, 2, 0, 0, 0, {"", 1}});
  queue.issue({MFC_GET_CMD, 3, 16, 0x2000, spu.ea(), {"", 2}});
  queue.issue({MFC_GET_CMD, 4, 16, 0x3000, spu.ea(), {"", 3}});
  queue.land_tags(1U << 3);
  EXPECT_EQ(recorder.order, (Order{0, 1, 2}));
  EXPECT_EQ(queue.pending_tags(), 1U << 4);
}

TEST(QueueOrder, eager_mode_keeps_the_order_of_issue) {
  TestSpu spu;
  for (std::uint32_t i = 0; i < 8; ++i) {
    spu.local->bytes[0x1000 + i * 16] = static_cast<std::byte>(i);
    spu.dma(MFC_PUT_CMD, 0x1000 + i * 16, spu.ea(), 16, i);
    EXPECT_EQ(spu.main->bytes[0], static_cast<std::byte>(i));
  }
}

TEST(QueueOrder, eieio_and_sync_order_their_tag_like_barriers) {
  for (const std::uint32_t opcode : {MFC_EIEIO_CMD, MFC_SYNC_CMD}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      TestSpu spu;
      Recorder recorder;
      CommandQueue queue(spu.store, {Issuer::spu, DmaMode::late, seed, nullptr, &recorder});
      queue.issue({MFC_GET_CMD, 1, 16, 0x1000, spu.ea(), {"", 0}});
      queue.issue({opcode, 1, 0, 0, 0, {"", 1}});
      queue.issue({MFC_GET_CMD, 1, 16, 0x2000, spu.ea(), {"", 2}});
      queue.land_all();
      EXPECT_EQ(recorder.order, (Order{0, 1, 2}));
    }
  }
}

}  // namespace
}  // namespace spu_emu
