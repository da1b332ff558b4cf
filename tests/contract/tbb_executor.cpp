#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "contract/executors.h"

namespace cellsweep::contract {
namespace {

class TbbExecutor : public Executor {
 public:
  unsigned concurrency() const override { return kConcurrency; }
  void run(unsigned count, Task task, void* context) override {
    arena_.execute([&] { tbb::parallel_for(0U, count, [&](unsigned i) { task(context, i); }); });
  }

 private:
  // TBB says so on the terminal when there are fewer cores.
  tbb::global_control threads_{tbb::global_control::max_allowed_parallelism, kConcurrency};
  tbb::task_arena arena_{static_cast<int>(kConcurrency)};
};

}  // namespace

std::shared_ptr<Executor> make_tbb_executor() {
  return std::make_shared<TbbExecutor>();
}

}  // namespace cellsweep::contract
