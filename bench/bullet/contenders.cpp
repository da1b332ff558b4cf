#include "bench/bullet/contenders.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <utility>

#include "cellsweep_broadphase.h"

namespace cellsweep::bench {
namespace {

std::unique_ptr<btBroadphaseInterface> make_stream(unsigned threads, btScalar margin = 0) {
  auto made = make_broadphase(StreamOptions{.threads = threads});
  return std::make_unique<CellsweepBroadphase>(std::move(*made), margin);
}

}  // namespace

const std::vector<Contender>& contenders() {
  static const std::vector<Contender> all = {
      {"bullet_dbvt", [] { return std::make_unique<btDbvtBroadphase>(); }},
      {"stream_1", [] { return make_stream(1); }},
      {"stream_1_margin", [] { return make_stream(1, gDbvtMargin); }},
      {"stream", [] { return make_stream(0); }}};
  return all;
}

void for_each_turn(int turns, const std::function<void(const Contender&)>& register_row) {
  for (int turn = 0; turn < turns; ++turn) {
    for (const Contender& contender : contenders()) register_row(contender);
  }
}

}  // namespace cellsweep::bench
