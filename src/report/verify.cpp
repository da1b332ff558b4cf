#include "report/verify.h"

#include <algorithm>

#include "report/interrupt.h"
#include "report/oracle.h"
#include "report/progress.h"

namespace cellsweep::report {
namespace {

// By id, the boxes that an engine made of the bodies that are there.
Result<std::vector<Aabb>> handed_out_boxes(const Broadphase& engine, const FrameSource& source) {
  std::vector<Aabb> boxes(source.bodies().size());
  if (Status status = engine.boxes(source.bodies(), boxes); !status.ok()) return status;
  std::vector<Aabb> by_id(source.boxes().size());
  for (std::size_t i = 0; i < boxes.size(); ++i) by_id[source.bodies()[i]] = boxes[i];
  return by_id;
}

/// Engines and their judges, from frame to frame.
class Trial {
 public:
  Trial(std::span<FedEngine> engines, FrameSource& source) : engines_(engines), source_(source) {
    for (const FedEngine& fed : engines) judges_.emplace_back(fed.engine.name());
  }

  Status insert() {
    for (FedEngine& fed : engines_) {
      if (Status status = insert_all(fed.engine, source_, fed.shape); !status.ok()) return status;
    }
    return {};
  }

  Status change() {
    for (FedEngine& fed : engines_) {
      if (Status status = hand_over_changes(fed.engine, source_, fed.shape); !status.ok()) return status;
    }
    return {};
  }

  Status judge_frame() {
    const bool anyone_takes_boxes = std::any_of(
        engines_.begin(), engines_.end(), [](const FedEngine& fed) { return fed.shape == Shape::boxes; });
    std::vector<Pair> truth;
    if (anyone_takes_boxes) truth = oracle_pairs(source_);
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      if (Status status = judge(engines_[i], judges_[i], truth); !status.ok()) return status;
    }
    return {};
  }

  std::vector<VerifyReport> reports() const {
    std::vector<VerifyReport> reports;
    for (const Judge& judge : judges_) reports.push_back(judge.report());
    return reports;
  }

 private:
  Status judge(FedEngine& fed, Judge& judge, const std::vector<Pair>& truth) const {
    const auto changes = fed.engine.update();
    if (!changes) return changes.status();
    if (fed.shape == Shape::boxes) {
      judge.compare(fed.engine.pairs(), *changes, truth, source_.boxes());
      return {};
    }
    const auto boxes = handed_out_boxes(fed.engine, source_);
    if (!boxes) return boxes.status();
    judge.compare(fed.engine.pairs(), *changes, oracle_pairs(source_.bodies(), *boxes, source_.filters()),
                  *boxes);
    return {};
  }

  std::span<FedEngine> engines_;
  FrameSource& source_;
  std::vector<Judge> judges_;
};

}  // namespace

Result<std::vector<VerifyReport>> verify_engines(std::span<FedEngine> engines, FrameSource& source,
                                                 std::size_t updates) {
  if (Status status = source.status(); !status.ok()) return status;
  Trial trial(engines, source);
  if (Status status = trial.insert(); !status.ok()) return status;
  Progress progress("verify", updates);
  for (std::size_t frame = 0;; ++frame) {
    if (Status status = trial.judge_frame(); !status.ok()) return status;
    progress.show(frame);
    if (frame == updates || is_interrupted() || !source.advance()) break;
    if (Status status = trial.change(); !status.ok()) return status;
  }
  if (Status status = source.status(); !status.ok()) return status;
  return trial.reports();
}

}  // namespace cellsweep::report
