#include "app/ranks/one_engine.h"

#include "app/ranks/all_ranks.h"
#include "base/text.h"
#include "report/hand_over.h"

namespace cellsweep::app {

std::string OneEngine::compare(const FrameSource& source, bool is_first, const DistributedBroadphase& world,
                               const RankChanges& said) {
  const PairSum pairs = sum_of(world.pairs());
  const PairSum began = sum_of(said.began);
  const PairSum ended = sum_of(said.ended);
  if (!engine_) return {};
  const Status status = is_first ? report::insert_all(*engine_, source, report::Shape::boxes)
                                 : report::hand_over_changes(*engine_, source, report::Shape::boxes);
  const auto truth = engine_->update();
  const bool same = status.ok() && truth && pairs == sum_of(engine_->pairs()) &&
                    began == sum_of(truth->began) && ended == sum_of(truth->ended);
  if (same) return {};
  return text("the ranks have ", pairs.count, " pairs, ", began.count, " began and ", ended.count,
              " ended; one engine says ", engine_->pairs().size(), ", ", truth ? truth->began.size() : 0,
              " and ", truth ? truth->ended.size() : 0, ".");
}

std::string OneEngine::compare_restored(const FrameSource& source, const DistributedBroadphase& world) {
  const PairSum pairs = sum_of(world.pairs());
  if (!engine_) return {};
  const Status status = report::insert_all(*engine_, source, report::Shape::boxes);
  if (status.ok() && engine_->update() && pairs == sum_of(engine_->pairs())) return {};
  return text("the ranks have ", pairs.count, " pairs; one engine says ", engine_->pairs().size(), ".");
}

}  // namespace cellsweep::app
